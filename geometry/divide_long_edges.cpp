// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/divide_long_edges.hpp"

#include <algorithm>
#include <cstddef>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

#include "geometry/surface_edges.hpp"

namespace dmp::geometry {

namespace {

/// By triangle, the new corner on its side from corner k to the next one; -1: none.
using OnSides = std::vector<std::array<int, 3>>;

OnSides halve_long_edges(TriangleSurface& surface, double longest) {
    OnSides on_sides(surface.triangles.size(), {-1, -1, -1});
    const std::vector<SurfaceEdge> edges = edges_of(surface);
    for_each_edge(edges, [&](std::span<const SurfaceEdge> sides) {
        const Vec a = surface.corners[static_cast<std::size_t>(sides.front().low)];
        const Vec b = surface.corners[static_cast<std::size_t>(sides.front().high)];
        if (!((b - a).norm() > longest)) return;
        const auto middle = static_cast<int>(surface.corners.size());
        surface.corners.emplace_back(0.5 * (a + b));
        for (const SurfaceEdge& side : sides) {
            const auto triangle = static_cast<std::size_t>(side.triangle);
            const auto& corners = surface.triangles[triangle];
            on_sides[triangle].at(static_cast<std::size_t>(std::ranges::find(corners, side.from()) - corners.begin())) =
                middle;
        }
    });
    return on_sides;
}

/// A triangle of which one side or more are divided. With two of them the shorter diagonal is no longer than 0.87 times
/// the longest side, with another number all new edges are shorter still: it comes to an end.
void divide(const std::array<int, 3>& corners, const std::array<int, 3>& middles, const std::vector<Vec>& place,
            std::vector<std::array<int, 3>>& to) {
    const auto count = std::ranges::count_if(middles, [](int middle) { return middle >= 0; });
    const auto distance = [&](int a, int b) {
        return (place[static_cast<std::size_t>(a)] - place[static_cast<std::size_t>(b)]).squaredNorm();
    };
    // Turned so that the divided sides come first.
    std::size_t first = 0;
    if (count == 1)
        while (middles.at(first) < 0) ++first;
    if (count == 2)
        while (middles.at((first + 2) % 3) >= 0) ++first;
    const auto corner = [&](std::size_t k) { return corners.at((first + k) % 3); };
    const auto middle = [&](std::size_t k) { return middles.at((first + k) % 3); };
    const int a = corner(0), b = corner(1), c = corner(2), ab = middle(0), bc = middle(1), ca = middle(2);
    if (count == 0) {
        to.push_back(corners);
    } else if (count == 1) {
        to.insert(to.end(), {{a, ab, c}, {ab, b, c}});
    } else if (count == 3) {
        to.insert(to.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    } else if (distance(ab, c) < distance(a, bc)) {
        to.insert(to.end(), {{ab, b, bc}, {a, ab, c}, {ab, bc, c}});
    } else {
        to.insert(to.end(), {{ab, b, bc}, {a, ab, bc}, {a, bc, c}});
    }
}

}  // namespace

TriangleSurface divide_long_edges(TriangleSurface surface, double longest) {
    if (!(longest > 0)) throw std::invalid_argument("divide_long_edges: the length must be positive");
    // A triangle with a corner twice has no area, and edges that are none.
    std::erase_if(surface.triangles, [](const auto& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; });
    for (std::size_t before = 0; before != surface.corners.size();) {
        before = surface.corners.size();
        const OnSides middles = halve_long_edges(surface, longest);
        std::vector<std::array<int, 3>> triangles;
        triangles.reserve(surface.triangles.size());
        for (std::size_t t = 0; t < surface.triangles.size(); ++t)
            divide(surface.triangles[t], middles[t], surface.corners, triangles);
        surface.triangles = std::move(triangles);
    }
    return surface;
}

}  // namespace dmp::geometry
