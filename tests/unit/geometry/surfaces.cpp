// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "base/closest_point.hpp"
#include "geometry/nearest_triangle.hpp"
#include "geometry/orient_surface.hpp"
#include "geometry/points_inside.hpp"
#include "geometry/surface_crossings.hpp"
#include "tests/modules.hpp"
#include "tests/unit/geometry/surface_shapes.hpp"

namespace dmp::tests::surfaces_tests {
namespace {

std::vector<LineRow> rows_over(double low, double step, int count) {
    std::vector<LineRow> rows;
    for (int k = 0; k < count; ++k) rows.push_back({low + k * step, low, step, count});
    return rows;
}

TEST(SurfaceCrossings, of_a_box_are_two_on_each_line_and_exact) {
    const TriangleSurface surface = box({0, 0, 0}, {3, 1, 1});
    // Lines through edges, diagonals and corners too: the box has y and z in [0, 1).
    const SurfaceCrossings crossings(surface, rows_over(-0.25, 0.25, 7));
    for (std::size_t row = 0; row < 7; ++row)
        for (int line = 0; line < 7; ++line) {
            const bool inside = row >= 1 && row < 5 && line >= 1 && line < 5;
            const auto found = crossings.of(row, line);
            ASSERT_EQ(found.size(), inside ? 2U : 0U) << row << " " << line;
            if (!inside) continue;
            EXPECT_EQ(found[0].x, 0);
            EXPECT_EQ(found[0].direction, 1);
            EXPECT_EQ(found[1].x, 3);
            EXPECT_EQ(found[1].direction, -1);
        }
    EXPECT_EQ(crossings.unbalanced(), 0U);
}

TEST(SurfaceCrossings, touching_boxes_share_no_line) {
    const auto rows = rows_over(0.125, 0.125, 24);
    const SurfaceCrossings left(box({0, 0, 0}, {1, 1, 2}), rows), right(box({0, 1, 0}, {1, 2, 2}), rows);
    for (std::size_t row = 0; row < rows.size(); ++row)
        for (int line = 0; line < 24; ++line) {
            const double y = rows[row].first_y + line * rows[row].step_y;
            const std::size_t expected = y < 2 && rows[row].z < 2 ? 2 : 0;
            EXPECT_EQ(left.of(row, line).size() + right.of(row, line).size(), expected) << row << " " << line;
        }
}

TEST(SurfaceCrossings, the_same_with_any_number_of_threads) {
    TriangleSurface surface = box({0, 0, 0}, {1, 2, 1});
    append(surface, box({0.3, 0.5, -1}, {2, 1.7, 3}));
    const auto rows = rows_over(-0.9, 0.11, 40);
    const SurfaceCrossings one(surface, rows), three(surface, rows, 3);
    for (std::size_t row = 0; row < rows.size(); ++row)
        for (int line = 0; line < 40; ++line) {
            const auto a = one.of(row, line), b = three.of(row, line);
            ASSERT_TRUE(std::ranges::equal(a, b, [](const Crossing& x, const Crossing& y) {
                return x.x == y.x && x.triangle == y.triangle && x.direction == y.direction;
            }));
        }
}

TEST(SurfaceCrossings, a_surface_with_a_hole_is_unbalanced) {
    TriangleSurface surface = box({0, 0, 0}, {1, 1, 1});
    surface.triangles.erase(surface.triangles.begin() + 8, surface.triangles.begin() + 10);  // x = 0
    EXPECT_GT(SurfaceCrossings(surface, rows_over(0.05, 0.1, 10)).unbalanced(), 50U);
}

TEST(PointsInside, are_those_of_crossings_on_faces_edges_and_corners_too) {
    TriangleSurface surface = box({0, 0, 0}, {1, 2, 1});
    append(surface, box({0.25, 0.5, -1}, {2, 1.75, 3}));
    std::vector<Vec> points;
    for (int i = -2; i <= 18; ++i)
        for (int j = -2; j <= 18; ++j)
            for (int k = -10; k <= 26; ++k) points.emplace_back(0.125 * i, 0.125 * j, 0.125 * k);
    std::mt19937 random(1);
    std::uniform_real_distribution<double> anywhere(-1.2, 3.2);
    for (int k = 0; k < 5000; ++k) points.emplace_back(anywhere(random), anywhere(random), anywhere(random));
    const std::vector<bool> inside = points_inside(surface, points);
    int found = 0;
    for (std::size_t k = 0; k < points.size(); ++k) {
        const Vec& p = points[k];
        // Of both boxes' lower sides, as the side that follows counts.
        const auto within = [&](const Vec& low, const Vec& high) {
            return ((p - low).array() >= 0).all() && ((high - p).array() > 0).all();
        };
        const bool expected = within({0, 0, 0}, {1, 2, 1}) || within({0.25, 0.5, -1}, {2, 1.75, 3});
        ASSERT_EQ(inside[k], expected) << p.transpose();
        const SurfaceCrossings line(surface, {{p.z(), p.y(), 1, 1}});
        int depth = 0;
        for (const Crossing& crossing : line.of(0, 0))
            if (crossing.x <= p.x()) depth += crossing.direction;
        ASSERT_EQ(inside[k], depth > 0) << p.transpose();
        found += inside[k] ? 1 : 0;
    }
    EXPECT_GT(found, 1000);
}

TEST(PointsInside, none_one_and_many_on_one_line) {
    const TriangleSurface surface = box({0, 0, 0}, {1, 1, 1});
    EXPECT_TRUE(points_inside(surface, {}).empty());
    EXPECT_EQ(points_inside(surface, {Vec(0.5, 0.5, 0.5)}), std::vector<bool>{true});
    EXPECT_EQ(points_inside(surface, {Vec(1.5, 0.5, 0.5)}), std::vector<bool>{false});
    std::vector<Vec> along;
    for (int k = 0; k < 100; ++k) along.emplace_back(0.5, 0.5, 0.02 * k - 0.5 + 0.001);
    const std::vector<bool> inside = points_inside(surface, along);
    for (std::size_t k = 0; k < along.size(); ++k) EXPECT_EQ(inside[k], along[k].z() >= 0 && along[k].z() < 1) << k;
    EXPECT_FALSE(points_inside({}, {Vec(0, 0, 0)}).front());
}

TEST(NearestTriangle, of_all_regions_of_a_triangle) {
    const Vec a(0, 0, 0), b(2, 0, 0), c(0, 2, 0);
    const auto expect = [&](const Vec& point, const Vec& nearest) {
        EXPECT_LT((closest_on_triangle(point, a, b, c) - nearest).norm(), 1e-15) << point.transpose();
    };
    expect({0.5, 0.5, 3}, {0.5, 0.5, 0});
    expect({-1, -1, 1}, a);
    expect({5, -1, 1}, b);
    expect({-1, 5, 1}, c);
    expect({1, -2, 1}, {1, 0, 0});
    expect({-2, 1, 1}, {0, 1, 0});
    expect({3, 3, 1}, {1, 1, 0});
}

TEST(NearestTriangle, is_what_a_look_at_all_triangles_finds) {
    TriangleSurface surface = box({0, 0, 0}, {3, 1, 1});
    append(surface, box({0.5, 0.2, 0.3}, {0.9, 0.4, 0.7}));
    const double reach = 0.3;
    const NearestTriangle search(surface, reach);
    std::mt19937 random(7);
    std::uniform_real_distribution<double> position(-0.5, 3.5);
    int near = 0;
    for (int k = 0; k < 20000; ++k) {
        const Vec point(position(random), position(random) - 0.5, position(random) - 0.5);
        double nearest = HUGE_VAL;
        for (const auto& [a, b, c] : surface.triangles) {
            const auto corner = [&](int n) { return surface.corners[static_cast<std::size_t>(n)]; };
            nearest = std::min(nearest, (closest_on_triangle(point, corner(a), corner(b), corner(c)) - point).norm());
        }
        const auto found = search.nearest(point);
        ASSERT_EQ(found.has_value(), nearest <= reach) << point.transpose();
        if (!found) continue;
        ++near;
        EXPECT_NEAR(found->distance, nearest, 1e-15);
        EXPECT_NEAR((found->point - point).norm(), nearest, 1e-15);
    }
    EXPECT_GT(near, 1000);
    EXPECT_FALSE(search.nearest(Vec(100, 0, 0)).has_value());
    EXPECT_FALSE(search.nearest(Vec(std::nan(""), 0, 0)).has_value());
    EXPECT_THROW(NearestTriangle(surface, 0), std::invalid_argument);
    EXPECT_FALSE(NearestTriangle(TriangleSurface{}, 1).nearest(Vec(0, 0, 0)).has_value());
}

TEST(OrientOutward, whatever_the_triangles_were_like) {
    const TriangleSurface wanted = box({0, 0, 0}, {3, 2, 1});
    for (unsigned mask = 0; mask < 4096; mask += 7) {
        TriangleSurface surface = wanted;
        std::size_t turned = 0;
        for (std::size_t t = 0; t < 12; ++t)
            if ((mask >> t & 1U) != 0) {
                std::swap(surface.triangles[t][1], surface.triangles[t][2]);
                ++turned;
            }
        const Orientation found = orient_outward(surface);
        EXPECT_EQ(found.turned, turned);
        EXPECT_EQ(found.pieces, 1U);
        EXPECT_TRUE(found.closed());
        EXPECT_NEAR(surface.enclosed_volume(), 6, 1e-14);
    }
}

TEST(OrientOutward, the_wall_of_a_hollow_faces_into_it) {
    TriangleSurface surface = box({0, 0, 0}, {3, 3, 3});
    append(surface, box({1, 1, 1}, {2, 2, 2}));
    const Orientation found = orient_outward(surface);
    EXPECT_EQ(found.pieces, 2U);
    EXPECT_EQ(found.turned, 12U);
    EXPECT_NEAR(surface.enclosed_volume(), 26, 1e-13);
}

TEST(OrientOutward, says_what_is_open_or_manifold) {
    TriangleSurface open = box({0, 0, 0}, {1, 1, 1});
    open.triangles.pop_back();
    const Orientation found = orient_outward(open);
    EXPECT_EQ(found.open_edges, 3U);
    ASSERT_TRUE(found.first_open.has_value());
    EXPECT_FALSE(found.closed());

    TriangleSurface fin = box({0, 0, 0}, {1, 1, 1});
    fin.corners.emplace_back(2, 2, 2);
    fin.triangles.push_back({0, 1, 8});
    const Orientation with_fin = orient_outward(fin);
    EXPECT_EQ(with_fin.many_fold, 1U);
    EXPECT_EQ(with_fin.open_edges, 2U);

    TriangleSurface band;  // a Moebius band of five triangles
    for (int k = 0; k < 5; ++k)
        band.corners.emplace_back(std::cos(0.4 * k * std::numbers::pi), std::sin(0.4 * k * std::numbers::pi), 0.1 * k);
    for (int k = 0; k < 5; ++k) band.triangles.push_back({k, (k + 1) % 5, (k + 2) % 5});
    EXPECT_GT(orient_outward(band).contradicted, 0U);
}

}  // namespace
}  // namespace dmp::tests::surfaces_tests
