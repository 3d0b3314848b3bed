// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "scene/schema.hpp"

namespace dmp::scene {

/// The schema's rows of [[force]] and [[moving_shape]].
std::vector<Key<ForceOnPart>> force_keys();
std::vector<Key<MovingShape>> moving_shape_keys();

/// Checks of them: parts that can be pushed, schedules, forces that leave the plane. Throws InputError.
void check_driving(const Scene& scene);

}  // namespace dmp::scene
