// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/scene.hpp"

namespace dmp::scene {

/// Checks that each elastic solid has exactly one set of stiffnesses: of a strip (2-D) or of a material. Throws
/// InputError.
void check_elastic(const Scene& scene);

}  // namespace dmp::scene
