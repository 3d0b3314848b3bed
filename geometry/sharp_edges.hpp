// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "geometry/triangle_surface.hpp"

namespace dmp::geometry {

/// What has to stay where a surface is remeshed.
struct SharpEdges {
    std::vector<std::array<int, 2>> edges;  ///< their corners, in ascending order
    std::vector<int> corners;               ///< where they end, meet or turn, in ascending order
};

/// The open edges of a surface and those where it turns by more than 30 degrees; and the corners where one of them
/// ends, more than two meet, or two turn by more than 30 degrees. Slivers, whose normal is due to rounding, face as the
/// triangle beyond their longest edge does.
SharpEdges sharp_edges(const TriangleSurface& surface);

/// The same triangles with corners of their own on both sides of edges that more than two triangles share, or two that
/// face different sides, or that have the same three corners. What is left is a manifold. Triangles with a corner twice
/// are left out.
TriangleSurface cut_at_unlike_edges(const TriangleSurface& surface);

}  // namespace dmp::geometry
