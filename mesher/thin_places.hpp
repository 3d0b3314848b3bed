// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "geometry/geometry.hpp"
#include "scene/scene.hpp"

namespace dmp {

/// What of a 3-D scene is too thin for its particles, one line a part, with the thinnest place: gaps between walls, or
/// between a body in the fluid and anything else, of fewer than 3 fluid particles; rigid bodies thinner than 2.
/// Periodic sides and planes of symmetry are no walls.
std::vector<std::string> thin_places(const Geometry& geometry, const Scene& scene);

}  // namespace dmp
