// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "scene/schema.hpp"

namespace dmp::scene {

/// Rows of the schema for [[force]] and [[moving_shape]].
std::vector<Key<ForceOnPart>> force_keys();
std::vector<Key<MovingShape>> moving_shape_keys();

/// Checks the parts, schedules and components of forces and moving shapes. Throws InputError.
void check_driving(const Scene& scene);

}  // namespace dmp::scene
