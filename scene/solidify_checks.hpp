// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/scene.hpp"

namespace dmp::scene {

/// Checks that the parts and regions named by [[solidify]] and [[break]] exist and fit. Throws InputError with the
/// key's location.
void check_solidify(const Scene& scene);

/// Throws InputError unless the name is that of a [[solidify]] or an enabled elastic solid; `what` and `whose` are the
/// table and the name of the item that uses it, for the message.
void need_solid(const Scene& scene, const Value<std::string>& name, const std::string& what, const std::string& whose);

}  // namespace dmp::scene
