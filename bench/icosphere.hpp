// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <map>
#include <numbers>
#include <utility>
#include <vector>

#include "geometry/triangle_surface.hpp"

namespace dmp::bench {

/// An icosahedron with each triangle cut in four, `times` times, its corners on a sphere about the origin:
/// 20 * 4^times triangles that face outward.
inline geometry::TriangleSurface icosphere(int times, double radius) {
    const double g = std::numbers::phi;
    geometry::TriangleSurface ball;
    for (const Vec& corner :
         {Vec(-1, g, 0), Vec(1, g, 0), Vec(-1, -g, 0), Vec(1, -g, 0), Vec(0, -1, g), Vec(0, 1, g), Vec(0, -1, -g),
          Vec(0, 1, -g), Vec(g, 0, -1), Vec(g, 0, 1), Vec(-g, 0, -1), Vec(-g, 0, 1)})
        ball.corners.emplace_back(radius * corner.normalized());
    ball.triangles = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                      {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                      {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
    for (int k = 0; k < times; ++k) {
        std::map<std::pair<int, int>, int> middles;
        const auto middle = [&](int a, int b) {
            const auto [found, is_new] =
                middles.try_emplace(std::pair(std::min(a, b), std::max(a, b)), static_cast<int>(ball.corners.size()));
            if (is_new) {
                const Vec sum = ball.corners[static_cast<std::size_t>(a)] + ball.corners[static_cast<std::size_t>(b)];
                ball.corners.emplace_back(radius * sum.normalized());
            }
            return found->second;
        };
        std::vector<std::array<int, 3>> finer;
        for (const auto& [a, b, c] : ball.triangles) {
            const int ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
            finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
        }
        ball.triangles = std::move(finer);
    }
    return ball;
}

}  // namespace dmp::bench
