// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "geometry/geometry.hpp"
#include "mesher/uses.hpp"
#include "scene/scene.hpp"

namespace dmp::mesher {

/// What of a scene is too thin for its particles, one line a part, with the thinnest place: gaps between walls, or
/// between a body in the fluid and anything else, of fewer than 3 fluid particles; in 3-D rigid bodies thinner than
/// 2, and gaps beside shells, which take a spacing, and at their free edges; in 2-D gaps between the end of a
/// flexible curve and what is next to it. Periodic sides and planes of symmetry are no walls.
std::vector<std::string> thin_regions(const Geometry& geometry, const Scene& scene);

}  // namespace dmp::mesher
