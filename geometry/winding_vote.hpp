// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "geometry/triangle_surface.hpp"

namespace dmp::geometry {

/// What the winding number says about a surface in 20000 places of its box.
struct WindingVote {
    double volume = 0;  ///< where it exceeds one half [m^3]
    /// The share of places without a clear answer, from 1/4 to 3/4, among those where it exceeds 1/4.
    double doubt = 1;
};
WindingVote vote_on(const TriangleSurface& surface);

/// Turns the pieces of a surface that are open so that the winding number is 1 where most of each piece has its inside,
/// or its outside if the piece lies within others. Returns the triangles of pieces that have no inside: sheets.
std::vector<int> turn_open_pieces(TriangleSurface& surface);

}  // namespace dmp::geometry
