// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/surface_intersections.hpp"

#include <gtest/gtest.h>

#include "tests/modules.hpp"
#include "tests/unit/geometry/surface_shapes.hpp"

namespace dmp::tests::surface_intersections_tests {
namespace {

using Pairs = std::vector<std::pair<int, int>>;

TriangleSurface surface_of(std::vector<Vec> corners, std::vector<std::array<int, 3>> triangles) {
    TriangleSurface surface;
    surface.corners = std::move(corners);
    surface.triangles = std::move(triangles);
    return surface;
}

TEST(SelfIntersections, of_bodies_in_order_are_none) {
    EXPECT_TRUE(self_intersections(cube()).empty());
    EXPECT_TRUE(self_intersections(ball(10)).empty());
    TriangleSurface nested = box({0, 0, 0}, {3, 3, 3});
    append(nested, box({1, 1, 1}, {2, 2, 2}));
    EXPECT_TRUE(self_intersections(nested).empty());
}

TEST(SelfIntersections, of_two_triangles_by_how_many_corners_they_share) {
    const std::vector<Vec> flat{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};
    const auto pair_with = [&](std::vector<Vec> more, std::array<int, 3> second) {
        std::vector<Vec> corners = flat;
        corners.insert(corners.end(), more.begin(), more.end());
        return self_intersections(surface_of(corners, {{0, 1, 2}, second}));
    };
    const Pairs both{{0, 1}};
    EXPECT_EQ(pair_with({{1, 1, -1}, {1, 1, 1}, {9, 9, 0}}, {3, 4, 5}), both) << "through each other";
    EXPECT_EQ(pair_with({{1, 1, 1}, {1, 2, 2}, {9, 9, 1}}, {3, 4, 5}), Pairs{}) << "apart";
    EXPECT_EQ(pair_with({{1, 1, 0}, {1, 2, 2}, {9, 9, 1}}, {3, 4, 5}), both) << "touching without a common corner";
    EXPECT_EQ(pair_with({{1, 2, 2}, {9, 9, 1}}, {0, 3, 4}), Pairs{}) << "with a common corner";
    EXPECT_EQ(pair_with({{2, 1, 1}, {1, 2, -1}}, {0, 3, 4}), both) << "with a common corner, through each other";
    EXPECT_EQ(pair_with({{-1, 0, 0}, {0, -1, 0}}, {0, 3, 4}), Pairs{}) << "in one plane, with a common corner";
    EXPECT_EQ(pair_with({{1, 1, 2}}, {1, 0, 3}), Pairs{}) << "with a common edge";
    EXPECT_EQ(pair_with({{1, -1, 0}}, {1, 0, 3}), Pairs{}) << "in one plane, with a common edge";
    EXPECT_EQ(pair_with({{1, 1, 0}}, {1, 0, 3}), both) << "folded back onto itself";
    EXPECT_EQ(pair_with({}, {0, 2, 1}), both) << "back to back";
    EXPECT_EQ(pair_with({}, {0, 1, 1}), Pairs{}) << "without area";
}

TEST(SelfIntersections, of_boxes_that_cross_are_where_edges_go_through_sides) {
    TriangleSurface surface = box({0, 0, 0}, {4, 4, 4});
    append(surface, box({1.1, 1.3, 3}, {1.9, 1.8, 5}));  // through the top, in one of its two triangles
    const auto pairs = self_intersections(surface);
    // The eight triangles of its sides go through the top's triangle with the corners (0, 0), (4, 0) and (0, 4).
    EXPECT_EQ(pairs.size(), 8U);
    for (const auto& [one, other] : pairs) {
        EXPECT_EQ(one, 2);
        EXPECT_GE(other, 16);
    }
}

TEST(SolidOverlap, of_boxes_is_their_common_volume) {
    const SolidOverlap half = overlap_of(box({0, 0, 0}, {2, 1, 1}), box({1, 0.25, 0.25}, {3, 0.75, 0.75}), 1e-6);
    EXPECT_TRUE(half.any());
    EXPECT_NEAR(half.volume, 0.25, 1e-12);
    const SolidOverlap within = overlap_of(box({0, 0, 0}, {3, 3, 3}), box({1, 1, 1}, {2, 2, 2}), 1e-6);
    EXPECT_EQ(within.crossings, 0U);
    EXPECT_NEAR(within.volume, 1, 1e-12);
    const SolidOverlap same = overlap_of(cube(), cube(), 1e-6);
    EXPECT_EQ(same.crossings, 0U);
    EXPECT_NEAR(same.volume, 1, 1e-12);
    const SolidOverlap cross =
        overlap_of(box({-5, 0.1, 0.2}, {5, 0.7, 0.8}), box({0.15, -5, 0.25}, {0.85, 5, 0.75}), 1e-6);
    EXPECT_NEAR(cross.volume, 0.6 * 0.5 * 0.7, 1e-12);
}

TEST(SolidOverlap, of_a_thin_blade_is_seen_by_its_edges) {
    const SolidOverlap blade = overlap_of(cube(), box({0.4, 0.4301, 0.9}, {0.6, 0.4302, 3}), 1e-6);
    EXPECT_TRUE(blade.any());
    EXPECT_GE(blade.crossings, 4U);
    EXPECT_NEAR(blade.first->z(), 1, 1e-12);
}

TEST(SolidOverlap, of_bodies_that_touch_is_none) {
    EXPECT_FALSE(overlap_of(cube(), box({1, 0, 0}, {2, 1, 1}), 1e-6).any());
    EXPECT_FALSE(overlap_of(cube(), box({1, 0.2, -1}, {2, 0.8, 3}), 1e-6).any());
    EXPECT_FALSE(overlap_of(cube(), box({1 - 1e-9, 0.2, -1}, {2, 0.8, 3}), 1e-6).any());
    EXPECT_FALSE(overlap_of(cube(), box({5, 0, 0}, {6, 1, 1}), 1e-6).any());
    EXPECT_FALSE(overlap_of(cube(), TriangleSurface{}, 1e-6).any());
}

}  // namespace
}  // namespace dmp::tests::surface_intersections_tests
