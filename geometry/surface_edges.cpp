// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/surface_edges.hpp"

#include <algorithm>
#include <utility>

namespace dmp::geometry {

std::vector<SurfaceEdge> edges_of(const TriangleSurface& surface) {
    // A bucket for each lower corner; what is left to sort in one is short.
    std::vector<std::size_t> begin(surface.corners.size() + 1, 0);
    const auto sides = [&](const auto& visit) {
        for (std::size_t t = 0; t < surface.triangles.size(); ++t)
            for (std::size_t k = 0; k < 3; ++k) {
                const int a = surface.triangles[t].at(k), b = surface.triangles[t].at((k + 1) % 3);
                visit(SurfaceEdge{std::min(a, b), std::max(a, b), static_cast<int>(t), a < b});
            }
    };
    sides([&](const SurfaceEdge& edge) { ++begin[static_cast<std::size_t>(edge.low) + 1]; });
    for (std::size_t corner = 0; corner + 1 < begin.size(); ++corner) begin[corner + 1] += begin[corner];
    std::vector<SurfaceEdge> edges(3 * surface.triangles.size());
    std::vector<std::size_t> next(begin.begin(), begin.end() - 1);
    sides([&](const SurfaceEdge& edge) { edges[next[static_cast<std::size_t>(edge.low)]++] = edge; });
    for (std::size_t corner = 0; corner + 1 < begin.size(); ++corner)
        std::sort(edges.begin() + static_cast<std::ptrdiff_t>(begin[corner]),
                  edges.begin() + static_cast<std::ptrdiff_t>(begin[corner + 1]),
                  [](const SurfaceEdge& a, const SurfaceEdge& b) {
                      return std::pair{a.high, a.triangle} < std::pair{b.high, b.triangle};
                  });
    return edges;
}

EdgeCounts count_edges(const TriangleSurface& surface) {
    EdgeCounts counts;
    const std::vector<SurfaceEdge> edges = edges_of(surface);
    for_each_edge(edges, [&](std::span<const SurfaceEdge> sides) {
        if (sides.size() == 1) ++counts.open;
        if (sides.size() > 2) ++counts.many_fold;
        if (sides.size() == 2 && sides[0].forward == sides[1].forward) ++counts.unlike;
    });
    return counts;
}

std::vector<int> triangles_at_faults(const TriangleSurface& surface) {
    std::vector<int> found;
    const std::vector<SurfaceEdge> edges = edges_of(surface);
    for_each_edge(edges, [&](std::span<const SurfaceEdge> sides) {
        if (sides.size() == 2 && sides[0].forward != sides[1].forward) return;
        for (const SurfaceEdge& side : sides) found.push_back(side.triangle);
    });
    std::ranges::sort(found);
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
}

}  // namespace dmp::geometry
