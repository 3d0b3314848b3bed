// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/scene.hpp"

namespace dmp::scene {

/// Checks that the terms and steppings of [numerics] go together. Throws InputError.
void check_numerics(const Scene& scene);

/// 0 for a term of [numerics] that another one replaces, where the scene leaves it open.
void set_dependent_defaults(Scene& scene);

}  // namespace dmp::scene
