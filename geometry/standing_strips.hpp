// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "geometry/triangle_surface.hpp"

namespace dmp::geometry {

/// A straight piece of a curve of the plane.
using PlaneSegment = std::array<Vec, 2>;

/// Upright strips on segments of the plane, from z = 0 to `height` [m], in pieces at most as long, a thousand a segment
/// at most. They face the right of the segments' direction, out of an area on their left: local_thickness
/// (geometry/local_thickness.hpp) of them is the distance in 2-D to what is opposite.
[[nodiscard]] TriangleSurface standing_strips(const std::vector<PlaneSegment>& segments, double height);

}  // namespace dmp::geometry
