// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/spheres/smooth_edges.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace dmp::solver {

namespace {

/// Corners closer than this part of the box are one across a periodic side; binary STL files have single precision.
constexpr double one_corner = 1e-6;

/// The number of each corner, alike for corners that a period along an axis separates.
std::vector<int> corner_numbers(const ParticleSpace& space) {
    std::vector<int> number(space.wall_corners.size());
    std::iota(number.begin(), number.end(), 0);
    const double tolerance = one_corner * (space.box.high - space.box.low).norm();
    for (int axis = 0; axis < space.dimension; ++axis) {
        if (!space.periodic[axis]) continue;
        const int next = (axis + 1) % 3;
        std::vector<int> low, high;
        for (std::size_t k = 0; k < number.size(); ++k) {
            const double x = space.wall_corners[k][axis];
            if (std::abs(x - space.box.low[axis]) <= tolerance) low.push_back(static_cast<int>(k));
            if (std::abs(x - space.box.high[axis]) <= tolerance) high.push_back(static_cast<int>(k));
        }
        const auto along = [&](int k) { return space.wall_corners[static_cast<std::size_t>(k)][next]; };
        std::ranges::sort(low, {}, along);
        Vec period = Vec::Zero();
        period[axis] = space.box.high[axis] - space.box.low[axis];
        for (const int k : high) {
            const Vec place = space.wall_corners[static_cast<std::size_t>(k)] - period;
            auto other = std::ranges::lower_bound(low, place[next] - tolerance, {}, along);
            for (; other != low.end() && along(*other) <= place[next] + tolerance; ++other)
                if ((space.wall_corners[static_cast<std::size_t>(*other)] - place).norm() <= tolerance)
                    number[static_cast<std::size_t>(k)] = number[static_cast<std::size_t>(*other)];
        }
    }
    return number;
}

struct Side {
    std::array<int, 3> edge;  ///< the part and the edge's corners, the lower number first
    std::size_t triangle;
    Vec inward;  ///< unit vector across the edge, along the triangle; 0 for a triangle without area
};

std::vector<Side> sides_of(const ParticleSpace& space) {
    const std::vector<int> number = corner_numbers(space);
    std::vector<Side> sides;
    for (std::size_t t = 0; t < space.wall_triangles.size(); ++t) {
        const WallTriangle& triangle = space.wall_triangles[t];
        const std::array<int, 3> corners{triangle.a, triangle.b, triangle.c};
        for (std::size_t k = 0; k < 3; ++k) {
            const auto a = static_cast<std::size_t>(corners[k]), b = static_cast<std::size_t>(corners[(k + 1) % 3]),
                       c = static_cast<std::size_t>(corners[(k + 2) % 3]);
            const Vec along = (space.wall_corners[b] - space.wall_corners[a]).normalized();
            const Vec to_third = space.wall_corners[c] - space.wall_corners[a];
            const auto [lower, upper] = std::minmax(number[a], number[b]);
            sides.push_back({{triangle.part, lower, upper}, t, (to_third - to_third.dot(along) * along).normalized()});
        }
    }
    std::ranges::sort(sides, {}, [](const Side& side) { return std::pair(side.edge, side.triangle); });
    return sides;
}

}  // namespace

SmoothEdges::SmoothEdges(const ParticleSpace& space) {
    const std::vector<Side> sides = sides_of(space);
    for (std::size_t i = 0; i < sides.size(); ++i)
        for (std::size_t j = i + 1; j < sides.size() && sides[j].edge == sides[i].edge; ++j)
            if (-sides[i].inward.dot(sides[j].inward) > largest_bend_cosine)
                joined_.push_back({sides[i].triangle, sides[j].triangle});
    std::ranges::sort(joined_);
}

bool SmoothEdges::join(std::size_t a, std::size_t b) const {
    return std::ranges::binary_search(joined_, std::array{std::min(a, b), std::max(a, b)});
}

}  // namespace dmp::solver
