// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdlib>
#include <utility>
#include <vector>

#include "geometry/triangle_surface.hpp"
#include "tests/modules.hpp"

namespace dmp::tests {

/// A box of twelve triangles that face outward.
inline TriangleSurface box(const Vec& low, const Vec& high) {
    TriangleSurface surface;
    for (int k = 0; k < 8; ++k)
        surface.corners.emplace_back((k & 1) != 0 ? high.x() : low.x(), (k & 2) != 0 ? high.y() : low.y(),
                                     (k & 4) != 0 ? high.z() : low.z());
    surface.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                         {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    return surface;
}

inline TriangleSurface cube() { return box({0, 0, 0}, {1, 1, 1}); }

inline void append(TriangleSurface& to, const TriangleSurface& more) {
    const auto first = static_cast<int>(to.corners.size());
    to.corners.insert(to.corners.end(), more.corners.begin(), more.corners.end());
    for (const auto& [a, b, c] : more.triangles) to.triangles.push_back({first + a, first + b, first + c});
}

inline void flip(TriangleSurface& surface, std::size_t triangle) {
    std::swap(surface.triangles[triangle][1], surface.triangles[triangle][2]);
}

/// Triangles that share no corners.
inline TriangleSurface soup_of(const TriangleSurface& surface) {
    TriangleSurface soup;
    for (const auto& triangle : surface.triangles) {
        const auto first = static_cast<int>(soup.corners.size());
        for (const int corner : triangle) soup.corners.push_back(surface.corners[static_cast<std::size_t>(corner)]);
        soup.triangles.push_back({first, first + 1, first + 2});
    }
    return soup;
}

/// The unit ball as 8 n^2 triangles: an octahedron with n parts along each edge, blown up.
inline TriangleSurface ball(int n) {
    TriangleSurface surface;
    const auto side = static_cast<std::size_t>(2 * n + 1);
    std::vector<int> upper(side * side, -1), lower(side * side, -1);  // by x and y
    const auto corner = [&](int x, int y, int half) {
        const int z = half * (n - std::abs(x) - std::abs(y));
        auto& numbers = z < 0 ? lower : upper;
        int& number = numbers[static_cast<std::size_t>(x + n) * side + static_cast<std::size_t>(y + n)];
        if (number < 0) {
            number = static_cast<int>(surface.corners.size());
            surface.corners.push_back(Vec(x, y, z).normalized());
        }
        return number;
    };
    for (const int half : {1, -1})
        for (const int sx : {1, -1})
            for (const int sy : {1, -1}) {
                const auto add = [&](std::array<int, 3> triangle) {
                    if (half * sx * sy < 0) std::swap(triangle[1], triangle[2]);
                    surface.triangles.push_back(triangle);
                };
                for (int i = 0; i < n; ++i)
                    for (int j = 0; i + j < n; ++j) {
                        const auto at = [&](int x, int y) { return corner(sx * x, sy * y, half); };
                        add({at(i, j), at(i + 1, j), at(i, j + 1)});
                        if (i + j + 1 < n) add({at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
                    }
            }
    return surface;
}

}  // namespace dmp::tests
