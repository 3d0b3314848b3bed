// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "geometry/geometry.hpp"
#include "mesher/uses.hpp"

namespace dmp::mesher {

/// Where the surfaces half a spacing before and behind a corner or an edge have theirs: a particle's place.
struct FeaturePosition {
    Vec point = Vec::Zero();
    Vec deep = Vec::Zero();  ///< four times as far from the corner or edge, about: what is thick has room there
    bool in_fluid = false;   ///< else in the wall
};

/// Whether a point lies in fluid.
using IsFluid = std::function<bool(const Vec& point)>;

/// The places at the corners of curves, where they turn by more than 40 degrees with fluid on one side: for unit
/// normals m and n of the two segments and a spacing dx, dx/2 (m + n) / (1 + m.n) from the corner, which is dx/2 from
/// both lines, and as far on the other side.
/// @param spacing dx [m]
std::vector<FeaturePosition> corner_positions(const std::vector<const CurveSet*>& curves, const IsFluid& is_fluid,
                                              double spacing);

/// The places at the edges of surfaces, whose triangles may meet across surfaces where they share corners. Edges are
/// where the normals of two triangles differ by more than 40 degrees with fluid on one side; they join to lines, which
/// end where more than two meet or where they turn by as much. Ends come first: the point that is dx/2 from all faces
/// there, by least squares. Then the lines between them, in equal steps of about dx, that run dx/2 from both faces; a
/// line that ends at the rim of a surface, as at a periodic side, begins with half a step. Lines shorter than four
/// spacings are left out.
std::vector<FeaturePosition> edge_positions(const std::vector<const TriangleSurface*>& surfaces,
                                            const IsFluid& is_fluid, double spacing);

}  // namespace dmp::mesher
