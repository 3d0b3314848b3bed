// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "geometry/geometry.hpp"
#include "mesher/uses.hpp"
#include "scene/scene.hpp"

namespace dmp::mesher {

/// Elastic parts that open a wall, one line each, with a place: drawn through it, so that a piece of them lies in a
/// fluid and another more than a quarter of a spacing beyond all fluids; or that end on it and have no anchor, so that
/// fluid passes between. Periodic sides are no walls.
std::vector<std::string> bodies_through_walls(const Geometry& geometry, const Scene& scene);

}  // namespace dmp::mesher
