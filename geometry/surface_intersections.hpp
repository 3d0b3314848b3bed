// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "geometry/triangle_surface.hpp"

namespace dmp::geometry {

/// Pairs of triangles of one surface that have more in common than the corners and edges they share, the lower number
/// first, ascending. Exact: decided with CGAL's predicates. Triangles without area are left out.
std::vector<std::pair<int, int>> self_intersections(const TriangleSurface& surface);

/// What two solids have in common.
struct SolidOverlap {
    double volume = 0;          ///< estimated from 8000 places [m^3]
    std::size_t crossings = 0;  ///< edges of one that go through triangles of the other
    std::optional<Vec> first;   ///< a place that both have

    [[nodiscard]] bool any() const { return first.has_value(); }
};

/// How far two closed surfaces that face outward overlap. Those that touch do not: an edge crosses a triangle where its
/// ends are further than `tolerance` [m] from the triangle's plane, and the place that far from its sides; else a place
/// that both have has to be that far from both surfaces. The tolerance must be positive.
SolidOverlap overlap_of(const TriangleSurface& one, const TriangleSurface& other, double tolerance);

}  // namespace dmp::geometry
