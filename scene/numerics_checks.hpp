// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/scene.hpp"

namespace dmp::scene {

/// Checks that the terms and steppings of [numerics] go together. Throws InputError.
void check_numerics(const Scene& scene);

/// Applies the defaults that depend on other keys of [numerics], where the scene leaves them open: of the scheme, and 0
/// for a term that another one replaces.
void set_dependent_defaults(Scene& scene);

}  // namespace dmp::scene
