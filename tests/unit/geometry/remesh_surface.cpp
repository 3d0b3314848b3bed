// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/remesh_surface.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <utility>

#include <gtest/gtest.h>

#include "base/errors.hpp"
#include "geometry/surface_pieces.hpp"
#include "surface_shapes.hpp"
#include "tests/modules.hpp"

namespace dmp::tests::remesh_surface_tests {
namespace {

/// By its ends, how many triangles each edge has.
std::map<std::pair<int, int>, int> edges_of_triangles(const TriangleSurface& surface) {
    std::map<std::pair<int, int>, int> edges;
    for (const auto& triangle : surface.triangles)
        for (std::size_t k = 0; k < 3; ++k) {
            const int a = triangle.at(k), b = triangle.at((k + 1) % 3);
            ++edges[std::minmax(a, b)];
        }
    return edges;
}

struct Lengths {
    double mean = 0, spread = 0;
};

Lengths lengths_of(const TriangleSurface& surface) {
    double sum = 0, squares = 0, count = 0;
    for (const auto& [ends, triangles] : edges_of_triangles(surface)) {
        const double length = (surface.corners[ends.first] - surface.corners[ends.second]).norm();
        sum += length;
        squares += length * length;
        ++count;
    }
    return {sum / count, std::sqrt(squares / count - std::pow(sum / count, 2))};
}

TEST(RemeshSurface, twoLargeTrianglesBecomeManyEvenOnes) {
    TriangleSurface plate;
    plate.corners = {{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}};
    plate.triangles = {{0, 1, 2}, {0, 2, 3}};
    const TriangleSurface fine = remesh_surface(plate, 0.1);
    EXPECT_NEAR(fine.area(), 2, 1e-12);  // the corners were kept
    const Lengths found = lengths_of(fine);
    EXPECT_NEAR(found.mean, 0.1, 0.01);
    EXPECT_LT(found.spread, 0.25 * found.mean);
    for (const Vec& corner : fine.corners) EXPECT_NEAR(corner.z(), 0, 1e-12);
    for (const auto& [ends, triangles] : edges_of_triangles(fine)) {
        if (triangles == 2) continue;
        const double length = (fine.corners[ends.first] - fine.corners[ends.second]).norm();
        EXPECT_GT(length, 0.05);
        EXPECT_LT(length, 0.15);
    }
}

/// The upper half of the unit ball.
TriangleSurface dome(int n) {
    TriangleSurface half = ball(n);
    std::erase_if(half.triangles, [&](const std::array<int, 3>& triangle) {
        return std::ranges::any_of(triangle, [&](int corner) { return half.corners[corner].z() < -1e-9; });
    });
    std::vector<int> all(half.triangles.size());
    std::iota(all.begin(), all.end(), 0);
    return part_of(half, all);
}

TEST(RemeshSurface, manySmallTrianglesBecomeFewerEvenOnes) {
    const TriangleSurface fine = remesh_surface(dome(40), 0.1);
    EXPECT_NEAR(fine.area(), 2 * std::numbers::pi, 0.02);
    const Lengths found = lengths_of(fine);
    EXPECT_NEAR(found.mean, 0.1, 0.005);
    EXPECT_LT(found.spread, 0.15 * found.mean);
    for (const Vec& corner : fine.corners) EXPECT_NEAR(corner.norm(), 1, 1e-3);
    for (const auto& [ends, triangles] : edges_of_triangles(fine)) {
        if (triangles == 2) continue;
        EXPECT_NEAR(fine.corners[ends.first].z(), 0, 1e-9);
        EXPECT_NEAR((fine.corners[ends.first] - fine.corners[ends.second]).norm(), 0.1, 0.01);
    }
}

TEST(RemeshSurface, aClosedSurfaceStaysClosedAndFacesOutward) {
    const TriangleSurface fine = remesh_surface(ball(40), 0.15);
    EXPECT_LT(fine.triangles.size(), 2500U);  // of 12800
    EXPECT_NEAR(fine.enclosed_volume() / (4.0 / 3 * std::numbers::pi), 1, 0.02);
    for (const auto& [ends, triangles] : edges_of_triangles(fine)) EXPECT_EQ(triangles, 2);
}

TEST(RemeshSurface, turnsTrianglesAlike) {
    TriangleSurface plate;
    plate.corners = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    plate.triangles = {{0, 1, 2}, {0, 3, 2}};
    const TriangleSurface fine = remesh_surface(plate, 0.25);
    double turned = 0;
    for (const auto& [a, b, c] : fine.triangles)
        turned += (fine.corners[b] - fine.corners[a]).cross(fine.corners[c] - fine.corners[a]).z() / 2;
    EXPECT_NEAR(std::abs(turned), 1, 1e-12);
}

TEST(RemeshSurface, refusesWhatHasOneSideOrBranches) {
    TriangleSurface moebius;
    const int parts = 24;
    for (int k = 0; k < parts; ++k) {
        const double along = 2 * std::numbers::pi * k / parts;
        for (const double across : {-0.3, 0.3}) {
            const double r = 1 + across * std::cos(along / 2);
            moebius.corners.emplace_back(r * std::cos(along), r * std::sin(along), across * std::sin(along / 2));
        }
    }
    for (int k = 0; k < parts; ++k) {
        const int a = 2 * k, b = a + 1;
        const bool last = k + 1 == parts;
        const int c = last ? 1 : a + 2, d = last ? 0 : a + 3;  // half a turn
        moebius.triangles.push_back({a, b, c});
        moebius.triangles.push_back({b, d, c});
    }
    EXPECT_THROW(remesh_surface(moebius, 0.2), InputError);
    TriangleSurface branch;
    branch.corners = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}};
    branch.triangles = {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}};
    EXPECT_THROW(remesh_surface(branch, 0.2), InputError);
    EXPECT_THROW(remesh_surface(cube(), 0), std::invalid_argument);
}

}  // namespace
}  // namespace dmp::tests::remesh_surface_tests
