// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces in triangles of one size, and the division that stands in where they cannot be.
#include "geometry/even_triangles.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "geometry/divide_long_edges.hpp"
#include "geometry/nearest_triangle.hpp"
#include "geometry/sharp_edges.hpp"
#include "geometry/surface_edges.hpp"
#include "surface_shapes.hpp"
#include "tests/modules.hpp"

namespace dmp::tests::even_triangles_tests {
namespace {

struct Lengths {
    double shortest = std::numeric_limits<double>::infinity(), longest = 0;
};

Lengths lengths_of(const TriangleSurface& surface) {
    Lengths lengths;
    for (const SurfaceEdge& edge : edges_of(surface)) {
        const double length = (surface.corners[edge.low] - surface.corners[edge.high]).norm();
        lengths.shortest = std::min(lengths.shortest, length);
        lengths.longest = std::max(lengths.longest, length);
    }
    return lengths;
}

bool has_corner(const TriangleSurface& surface, const Vec& place) {
    return std::ranges::any_of(surface.corners, [&](const Vec& corner) { return (corner - place).norm() < 1e-12; });
}

/// How far the corners are from another surface, at most.
double distance_from(const TriangleSurface& other, const TriangleSurface& surface) {
    const NearestTriangle nearest(other, 100);
    double farthest = 0;
    for (const Vec& corner : surface.corners) farthest = std::max(farthest, nearest.nearest(corner)->distance);
    return farthest;
}

/// A tube of radius 1 and this length, open at both ends, of two slivers on each of its sides.
TriangleSurface tube(int sides, double length) {
    TriangleSurface surface;
    for (int k = 0; k < sides; ++k) {
        const double angle = 2 * std::numbers::pi * k / sides;
        for (const double z : {0.0, length}) surface.corners.emplace_back(std::cos(angle), std::sin(angle), z);
    }
    for (int k = 0; k < sides; ++k) {
        const int here = 2 * k, next = 2 * ((k + 1) % sides);
        surface.triangles.push_back({here, next, next + 1});
        surface.triangles.push_back({here, next + 1, here + 1});
    }
    return surface;
}

TEST(EvenTriangles, of_a_ball_are_on_it_and_close_it) {
    constexpr double edge = 0.075;
    for (const int parts : {30, 80}) {  // as fine as the triangles, and finer
        const TriangleSurface drawn = ball(parts), even = even_triangles(drawn, edge);
        EXPECT_TRUE(count_edges(even).closed());
        EXPECT_LT(distance_from(drawn, even), 1e-12);
        const auto [shortest, longest] = lengths_of(even);
        EXPECT_LE(longest, 1.1 * edge / 0.75);
        EXPECT_GT(shortest, 0.4 * edge);
        EXPECT_NEAR(even.area() / drawn.area(), 1, 0.01);
        EXPECT_NEAR(even.enclosed_volume() / drawn.enclosed_volume(), 1, 0.01) << "it faces outward";
        EXPECT_NEAR(static_cast<double>(even.triangles.size()), drawn.area() / (std::sqrt(3.0) / 4 * edge * edge),
                    0.3 * static_cast<double>(even.triangles.size()));
    }
}

TEST(EvenTriangles, of_a_box_keep_its_edges_and_corners) {
    const TriangleSurface drawn = box({0, 0, 0}, {1, 2, 3}), even = even_triangles(drawn, 0.2);
    EXPECT_TRUE(count_edges(even).closed());
    EXPECT_NEAR(even.area(), 22, 1e-11);
    EXPECT_NEAR(even.enclosed_volume(), 6, 1e-11);
    for (const Vec& corner : drawn.corners) EXPECT_TRUE(has_corner(even, corner));
    EXPECT_LE(lengths_of(even).longest, 4.0 / 3 * 0.2 * (1 + 1e-9));
    EXPECT_GT(lengths_of(even).shortest, 0.4 * 0.2);
    for (const auto& [a, b, c] : even.triangles) {
        const Vec normal =
            (even.corners[b] - even.corners[a]).cross(even.corners[c] - even.corners[a]).normalized().cwiseAbs();
        EXPECT_NEAR(normal.maxCoeff(), 1, 1e-9) << "none bevels an edge";
    }
}

TEST(EvenTriangles, of_slivers_are_none_and_borders_stay) {
    const TriangleSurface drawn = tube(60, 4), even = even_triangles(drawn, 0.3);
    const EdgeCounts edges = count_edges(even);
    EXPECT_EQ(edges.many_fold + edges.unlike, 0U);
    EXPECT_NEAR(static_cast<double>(edges.open), 2 * 2 * std::numbers::pi / 0.3, 8);
    EXPECT_GT(lengths_of(even).shortest, 0.25 * 0.3);
    EXPECT_LT(distance_from(drawn, even), 1e-12);
    EXPECT_NEAR(even.area() / drawn.area(), 1, 0.01);
    for (const SurfaceEdge& edge : edges_of(even))
        EXPECT_LE((even.corners[edge.low] - even.corners[edge.high]).norm(), 0.4 * (1 + 1e-6));
}

TEST(EvenTriangles, of_something_round_and_small_are_smaller) {
    const TriangleSurface drawn = ball(20), even = even_triangles(drawn, 1.2);
    EXPECT_TRUE(count_edges(even).closed());
    EXPECT_GT(even.enclosed_volume(), 0.85 * drawn.enclosed_volume());
    const TriangleSurface too_small = even_triangles(drawn, 20);
    EXPECT_EQ(too_small.triangles.size(), drawn.triangles.size()) << "as drawn, not a point";
}

TEST(EvenTriangles, of_two_boxes_that_share_an_edge_close_both) {
    TriangleSurface both = box({0, 0, 0}, {1, 1, 1});
    TriangleSurface other = box({1, 1, 0}, {2, 2, 1});
    // Corners 0 and 4 of the other one are corners 3 and 7 of the first: four triangles share that edge.
    const auto number = [](int corner) { return corner == 0 ? 3 : corner == 4 ? 7 : 8 + corner; };
    both.corners.insert(both.corners.end(), other.corners.begin(), other.corners.end());
    for (const auto& [a, b, c] : other.triangles) both.triangles.push_back({number(a), number(b), number(c)});
    ASSERT_EQ(count_edges(both).many_fold, 1U);
    const TriangleSurface even = even_triangles(both, 0.15);
    EXPECT_TRUE(count_edges(even).closed());
    EXPECT_NEAR(even.area(), 12, 1e-11);
    EXPECT_NEAR(even.enclosed_volume(), 2, 1e-11);
}

TEST(EvenTriangles, of_three_sheets_on_an_edge_meet_in_it) {
    TriangleSurface pages;
    pages.corners = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {-1, 1, 0}, {-1, -1, 0}};
    pages.triangles = {{0, 1, 2}, {0, 1, 3}, {1, 0, 4}};
    const TriangleSurface even = even_triangles(pages, 0.1);
    EXPECT_NEAR(even.area(), pages.area(), 1e-12);
    EXPECT_LE(lengths_of(even).longest, 4.0 / 3 * 0.1 * (1 + 1e-9));
    for (const Vec& corner : pages.corners) EXPECT_TRUE(has_corner(even, corner));
}

TEST(EvenTriangles, of_what_is_no_surface_are_divided_ones) {
    std::mt19937 random(7);
    for (int round = 0; round < 60; ++round) {
        TriangleSurface soup;
        const int places = round % 2 == 0 ? 3 : 1000;  // many corners in one place, or none
        const auto place = [&] { return static_cast<double>(random() % places) / places; };
        for (int k = 0; k < 12; ++k) soup.corners.emplace_back(place(), place(), place());
        for (int k = 0; k < 40; ++k)
            soup.triangles.push_back(
                {static_cast<int>(random() % 12), static_cast<int>(random() % 12), static_cast<int>(random() % 12)});
        const TriangleSurface even = even_triangles(soup, 0.3);
        EXPECT_TRUE(std::ranges::all_of(even.corners, [](const Vec& corner) { return corner.allFinite(); }));
        EXPECT_NEAR(even.area() / soup.area(), 1, 0.2);
        EXPECT_LE(lengths_of(even).longest, 0.4 * (1 + 0.1));
        EXPECT_EQ(even.triangles, even_triangles(soup, 0.3).triangles);
    }
}

TEST(EvenTriangles, have_a_length) {
    EXPECT_THROW((void)even_triangles(cube(), 0), std::invalid_argument);
    EXPECT_THROW((void)divide_long_edges(cube(), -1), std::invalid_argument);
    EXPECT_TRUE(even_triangles({}, 1).triangles.empty());
}

TEST(DivideLongEdges, keeps_what_is_short_and_shares_new_corners) {
    EXPECT_EQ(divide_long_edges(cube(), 1.5).triangles, cube().triangles);
    const TriangleSurface divided = divide_long_edges(cube(), 0.3);
    EXPECT_TRUE(count_edges(divided).closed());
    EXPECT_LE(lengths_of(divided).longest, 0.3);
    EXPECT_NEAR(divided.area(), 6, 1e-12);
    EXPECT_NEAR(divided.enclosed_volume(), 1, 1e-12);
}

TEST(SharpEdges, of_a_box_are_its_twelve_and_its_corners) {
    const SharpEdges sharp = sharp_edges(box({0, 0, 0}, {1, 2, 3}));
    EXPECT_EQ(sharp.edges.size(), 12U);
    EXPECT_EQ(sharp.corners.size(), 8U);
    EXPECT_TRUE(sharp_edges(ball(20)).edges.empty());
    const SharpEdges rims = sharp_edges(tube(60, 4));
    EXPECT_EQ(rims.edges.size(), 120U);
    EXPECT_TRUE(rims.corners.empty()) << "a rim turns by six degrees";
}

TEST(SharpEdges, are_not_hidden_by_a_sliver) {
    // A roof of two triangles with a sliver along its ridge, that is bent out by rounding.
    TriangleSurface roof;
    roof.corners = {{0, 0, 0}, {1, 0, 0}, {0.5, 1, -1}, {0.5, -1, -1}, {0.5, 1e-7, 3e-7}};
    roof.triangles = {{0, 1, 4}, {0, 4, 2}, {4, 1, 2}, {1, 0, 3}};
    const SharpEdges sharp = sharp_edges(roof);
    EXPECT_EQ(sharp.edges.size(), 4U + 2) << "the border, and the ridge once: on the far side of the sliver";
}

}  // namespace
}  // namespace dmp::tests::even_triangles_tests
