// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "geometry/triangle_surface.hpp"

namespace dmp::geometry {

/// Which of many points lie inside a closed surface: where the line from -x has entered it more often than left it. On
/// the surface itself, the side that follows counts. Exact as SurfaceCrossings are, for points anywhere; time grows
/// with the number of triangles, of points, and of lines through triangles.
[[nodiscard]] std::vector<bool> points_inside(const TriangleSurface& surface, const std::vector<Vec>& points);

}  // namespace dmp::geometry
