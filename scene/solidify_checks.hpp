// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/scene.hpp"

namespace dmp::scene {

/// What [[solidify]] and [[break]] name must be there, and fit. Throws InputError with the key's place.
void check_solidify(const Scene& scene);

/// Throws InputError unless the name is that of a [[solidify]] or an enabled elastic solid; `what` and `whose` say who
/// asks.
void need_solid(const Scene& scene, const Value<std::string>& name, const std::string& what, const std::string& whose);

}  // namespace dmp::scene
