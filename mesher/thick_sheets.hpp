// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "geometry/geometry.hpp"
#include "mesher/uses.hpp"
#include "scene/scene.hpp"

namespace dmp::mesher {

/// Strips and shells that are thicker than the room they are drawn in: half of their `thickness` reaches into a wall,
/// an elastic area or volume, or the half of another one. One line a part, with the place where it reaches farthest.
/// Where it is held, up to two thicknesses from what it is anchored to or ends on, it may.
std::vector<std::string> thick_sheets(const Geometry& geometry, const Scene& scene);

}  // namespace dmp::mesher
