// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "base/vec.hpp"
#include "geometry/triangle_surface.hpp"

namespace dmp::geometry {

/// A flat face across a branch of a solid: the walls around it run straight back from it.
struct FlatEnd {
    double area = 0;            ///< [m^2]
    Vec centre = Vec::Zero();   ///< of its area [m]
    Vec outward = Vec::Zero();  ///< its normal
    Box box;                    ///< [m]
};

/// The flat ends of a closed surface whose triangles face outward, the largest first: flat faces with walls at right
/// angles all around that go back, behind which the solid is deeper than 1.2 times the root of their area. The sides of
/// a duct are wider than that, and those of a cube as wide as it is deep. In time proportional to the triangles times
/// the flat faces with walls behind them.
[[nodiscard]] std::vector<FlatEnd> flat_ends(const TriangleSurface& surface);

}  // namespace dmp::geometry
