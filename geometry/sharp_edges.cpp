// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/sharp_edges.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <numeric>
#include <span>
#include <utility>

#include "geometry/surface_edges.hpp"

namespace dmp::geometry {

namespace {

const double cosine_of_sharp = std::cos(30 * std::numbers::pi / 180);
/// A sliver's height is less than this part of its longest edge.
constexpr double sliver = 1e-3;

const Vec& place_of(const TriangleSurface& surface, int corner) {
    return surface.corners[static_cast<std::size_t>(corner)];
}

/// By triangle; zero where it has none.
std::vector<Vec> facing(const TriangleSurface& surface, std::span<const SurfaceEdge> edges) {
    const std::size_t count = surface.triangles.size();
    std::vector<Vec> normal(count);
    std::vector<double> longest(count, 0);
    std::vector<int> beyond(count, -1);  // the triangle beyond the longest edge
    for_each_edge(edges, [&](std::span<const SurfaceEdge> sides) {
        const double length = (place_of(surface, sides.front().low) - place_of(surface, sides.front().high)).norm();
        for (const SurfaceEdge& side : sides) {
            const auto triangle = static_cast<std::size_t>(side.triangle);
            if (length <= longest[triangle]) continue;
            longest[triangle] = length;
            beyond[triangle] = sides.size() == 2 ? sides[0].triangle + sides[1].triangle - side.triangle : -1;
        }
    });
    std::vector<std::size_t> slivers;
    for (std::size_t t = 0; t < count; ++t) {
        const auto& [a, b, c] = surface.triangles[t];
        normal[t] = (place_of(surface, b) - place_of(surface, a)).cross(place_of(surface, c) - place_of(surface, a));
        if (normal[t].norm() <= sliver * longest[t] * longest[t]) slivers.push_back(t);
        normal[t].normalize();
    }
    // They may lie beside each other; a ring of them never ends.
    std::vector<char> is_sliver(count, 0);
    for (const std::size_t t : slivers) is_sliver[t] = 1;
    for (std::size_t before = 0; before != slivers.size();) {
        before = slivers.size();
        std::vector<std::size_t> done;
        for (const std::size_t t : slivers) {
            if (beyond[t] < 0 || is_sliver[static_cast<std::size_t>(beyond[t])] != 0) continue;
            normal[t] = normal[static_cast<std::size_t>(beyond[t])];
            done.push_back(t);
        }
        for (const std::size_t t : done) is_sliver[t] = 0;
        std::erase_if(slivers, [&](std::size_t t) { return is_sliver[t] == 0; });
    }
    return normal;
}

}  // namespace

SharpEdges sharp_edges(const TriangleSurface& surface) {
    const std::vector<SurfaceEdge> edges = edges_of(surface);
    const std::vector<Vec> normal = facing(surface, edges);
    SharpEdges sharp;
    for_each_edge(edges, [&](std::span<const SurfaceEdge> sides) {
        const auto normal_of = [&](const SurfaceEdge& side) { return normal[static_cast<std::size_t>(side.triangle)]; };
        if (sides.size() == 2 && normal_of(sides[0]).dot(normal_of(sides[1])) >= cosine_of_sharp) return;
        sharp.edges.push_back({sides.front().low, sides.front().high});
    });
    std::vector<int> count(surface.corners.size(), 0);
    std::vector<Vec> way(surface.corners.size(), Vec::Zero());  // to the other end of the first edge
    std::vector<char> turns(surface.corners.size(), 0);
    for (const auto& edge : sharp.edges)
        for (const std::size_t end : {0U, 1U}) {
            const auto corner = static_cast<std::size_t>(edge.at(end));
            const Vec there = (place_of(surface, edge.at(1 - end)) - surface.corners[corner]).normalized();
            if (++count[corner] == 2 && -there.dot(way[corner]) < cosine_of_sharp) turns[corner] = 1;
            if (count[corner] == 1) way[corner] = there;
        }
    for (std::size_t corner = 0; corner < count.size(); ++corner)
        if (count[corner] != 0 && (count[corner] != 2 || turns[corner] != 0))
            sharp.corners.push_back(static_cast<int>(corner));
    return sharp;
}

TriangleSurface cut_at_unlike_edges(const TriangleSurface& surface) {
    TriangleSurface cut;
    cut.has_holes = surface.has_holes;
    for (const auto& triangle : surface.triangles)
        if (triangle[0] != triangle[1] && triangle[1] != triangle[2] && triangle[2] != triangle[0])
            cut.triangles.push_back(triangle);
    // Corner k of triangle t is entry 3 t + k. Those that lie on either side of an edge between alike are one.
    std::vector<std::size_t> same(3 * cut.triangles.size());
    std::iota(same.begin(), same.end(), std::size_t{0});
    const auto first_of = [&](std::size_t entry) {
        while (same[entry] != entry) entry = same[entry] = same[same[entry]];
        return entry;
    };
    const auto entry_of = [&](int triangle, int corner) {
        const auto& corners = cut.triangles[static_cast<std::size_t>(triangle)];
        return 3 * static_cast<std::size_t>(triangle) +
               static_cast<std::size_t>(std::ranges::find(corners, corner) - corners.begin());
    };
    const auto sorted = [&](int triangle) {
        auto corners = cut.triangles[static_cast<std::size_t>(triangle)];
        std::ranges::sort(corners);
        return corners;
    };
    cut.corners = surface.corners;
    const std::vector<SurfaceEdge> edges = edges_of(cut);
    for_each_edge(edges, [&](std::span<const SurfaceEdge> sides) {
        if (sides.size() != 2 || sides[0].forward == sides[1].forward) return;
        if (sorted(sides[0].triangle) == sorted(sides[1].triangle)) return;
        for (const int corner : {sides[0].low, sides[0].high}) {
            const std::size_t one = first_of(entry_of(sides[0].triangle, corner));
            const std::size_t other = first_of(entry_of(sides[1].triangle, corner));
            same[std::max(one, other)] = std::min(one, other);
        }
    });
    std::vector<int> number(same.size(), -1);
    std::vector<Vec> corners;
    for (std::size_t t = 0; t < cut.triangles.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k) {
            int& of_first = number[first_of(3 * t + k)];
            if (of_first < 0) {
                of_first = static_cast<int>(corners.size());
                corners.push_back(place_of(surface, cut.triangles[t].at(k)));
            }
            cut.triangles[t].at(k) = of_first;
        }
    cut.corners = std::move(corners);
    return cut;
}

}  // namespace dmp::geometry
