// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>
#include <vector>

#include "geometry/triangle_surface.hpp"

namespace dmp::geometry {

/// Turns closed pieces of a surface that cross other pieces and face inward: a body that crosses another is no hollow
/// in it, on whichever side of the other's surface orient_outward looked at it. Returns the pairs of triangles in which
/// the surface meets itself (self_intersections).
std::vector<std::pair<int, int>> turn_crossing_pieces(TriangleSurface& surface);

}  // namespace dmp::geometry
