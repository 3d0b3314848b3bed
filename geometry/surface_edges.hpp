// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "geometry/triangle_surface.hpp"

namespace dmp::geometry {

/// A side of a triangle; forward: the triangle runs through it from the corner with the lower number.
struct SurfaceEdge {
    int low, high;  ///< its corners
    int triangle;
    bool forward;

    [[nodiscard]] int from() const { return forward ? low : high; }
    [[nodiscard]] int to() const { return forward ? high : low; }
};

/// The sides of all triangles, by ascending low, high, triangle. Time grows with their number.
std::vector<SurfaceEdge> edges_of(const TriangleSurface& surface);

/// Calls visit(std::span<const SurfaceEdge>) with the sides that lie on each edge: one at an open edge, two inside a
/// surface, more where the surface is not a manifold.
template <class Visit>
void for_each_edge(std::span<const SurfaceEdge> edges, const Visit& visit) {
    for (std::size_t begin = 0, end = 0; begin < edges.size(); begin = end) {
        while (end < edges.size() && edges[end].low == edges[begin].low && edges[end].high == edges[begin].high) ++end;
        visit(edges.subspan(begin, end - begin));
    }
}

/// What a surface's edges say about it.
struct EdgeCounts {
    std::size_t open = 0;       ///< with one triangle
    std::size_t many_fold = 0;  ///< with more than two
    std::size_t unlike = 0;     ///< with two triangles that face different sides

    [[nodiscard]] bool closed() const { return open == 0 && many_fold == 0 && unlike == 0; }
};
EdgeCounts count_edges(const TriangleSurface& surface);

/// The triangles at the edges that count_edges counts, ascending.
std::vector<int> triangles_at_faults(const TriangleSurface& surface);

}  // namespace dmp::geometry
