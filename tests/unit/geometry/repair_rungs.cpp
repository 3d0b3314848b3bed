// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Each rung of the repair of surfaces by itself.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "geometry/fill_holes.hpp"
#include "geometry/orient_surface.hpp"
#include "geometry/split_edges.hpp"
#include "geometry/surface_edges.hpp"
#include "geometry/surface_pieces.hpp"
#include "geometry/triangle_tree.hpp"
#include "geometry/weld_corners.hpp"
#include "geometry/wrap_surface.hpp"
#include "tests/modules.hpp"
#include "tests/unit/geometry/surface_shapes.hpp"

namespace dmp::tests::repair_rungs_tests {
namespace {

TEST(SurfaceEdges, are_counted_by_what_meets_in_them) {
    EdgeCounts counts = count_edges(cube());
    EXPECT_TRUE(counts.closed());
    EXPECT_EQ(edges_of(cube()).size(), 36U);
    TriangleSurface changed = cube();
    flip(changed, 3);
    counts = count_edges(changed);
    EXPECT_EQ(counts.unlike, 3U);
    changed.triangles.pop_back();
    EXPECT_EQ(count_edges(changed).open, 3U);
    changed = cube();
    changed.triangles.push_back({0, 7, 1});
    EXPECT_EQ(count_edges(changed).many_fold, 1U);
    EXPECT_EQ(count_edges(changed).open, 2U);
    EXPECT_TRUE(count_edges(TriangleSurface{}).closed());
}

TEST(WeldCorners, makes_the_corners_of_a_soup_one_and_moves_none_further_than_it_may) {
    TriangleSurface soup = soup_of(cube());
    EXPECT_EQ(weld_corners(soup, 0), 28U);
    EXPECT_EQ(soup.corners.size(), 8U);
    EXPECT_TRUE(count_edges(soup).closed());
    // Three corners in a row, each near the next one only: they do not creep together.
    TriangleSurface row;
    row.corners = {{0, 0, 0}, {0.6, 0, 0}, {1.2, 0, 0}, {5, 0, 0}, {5, 5, 0}};
    row.triangles = {{0, 3, 4}, {1, 3, 4}, {2, 3, 4}};
    EXPECT_EQ(weld_corners(row, 1), 1U);
    EXPECT_EQ(row.corners[1], Vec(1.2, 0, 0));
    // What no triangle has goes too.
    TriangleSurface loose = cube();
    loose.corners.emplace_back(7, 7, 7);
    EXPECT_EQ(weld_corners(loose, 0), 1U);
}

TEST(DropUselessTriangles, counts_each_kind) {
    TriangleSurface surface = cube();
    surface.corners.emplace_back(0.5, 0, 0);
    surface.triangles.push_back({0, 1, 1});
    surface.triangles.push_back({0, 8, 1});
    surface.triangles.push_back({2, 1, 0});  // the first one, with another corner in front
    const DroppedTriangles dropped = drop_useless_triangles(surface);
    EXPECT_EQ(dropped.without_area, 2U);
    EXPECT_EQ(dropped.duplicates, 1U);
    EXPECT_EQ(dropped.inner_walls, 0U);
    EXPECT_EQ(surface.triangles, cube().triangles);
}

TEST(DropUselessTriangles, keeps_one_of_a_pair_that_faces_both_ways_where_the_surface_needs_it) {
    TriangleSurface surface = cube();
    surface.triangles.push_back(surface.triangles[5]);
    flip(surface, 12);
    const DroppedTriangles dropped = drop_useless_triangles(surface);
    EXPECT_EQ(dropped.duplicates, 1U);
    EXPECT_EQ(dropped.inner_walls, 0U);
    EXPECT_EQ(surface.triangles, cube().triangles);
}

TEST(DropUselessTriangles, takes_the_wall_out_between_bodies_that_touch) {
    TriangleSurface surface = cube();
    append(surface, box({1, 0, 0}, {3, 1, 1}));
    weld_corners(surface, 0);
    const DroppedTriangles dropped = drop_useless_triangles(surface);
    EXPECT_EQ(dropped.inner_walls, 4U);
    EXPECT_EQ(dropped.duplicates, 0U);
    EXPECT_TRUE(count_edges(surface).closed());
    EXPECT_NEAR(surface.enclosed_volume(), 3, 1e-14);
}

TEST(SplitAtTJunctions, closes_a_surface_whose_neighbours_have_more_corners) {
    // The edge from 0 to 1 is whole on one side and has two corners on the other.
    TriangleSurface surface = cube();
    surface.corners.emplace_back(0.25, 0, 0);
    surface.corners.emplace_back(0.5, 1e-9, 0);
    surface.triangles[4] = {0, 8, 4};  // was 0 1 4
    surface.triangles.push_back({8, 9, 4});
    surface.triangles.push_back({9, 1, 4});
    EXPECT_EQ(count_edges(surface).open, 4U);
    EXPECT_EQ(split_at_t_junctions(surface, 1e-6), 2U);
    EXPECT_TRUE(count_edges(surface).closed());
    EXPECT_EQ(surface.triangles.size(), 16U);
    EXPECT_NEAR(surface.enclosed_volume(), 1, 1e-9);
    EXPECT_EQ(split_at_t_junctions(surface, 1e-6), 0U);
}

TEST(SplitAtTJunctions, divides_a_triangle_at_all_its_sides) {
    TriangleSurface surface;
    surface.corners = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    surface.triangles = {{0, 1, 2}, {0, 3, 5}, {3, 1, 4}, {5, 4, 2}, {3, 4, 5}};
    for (std::size_t t = 1; t < 5; ++t) flip(surface, t);
    EXPECT_EQ(split_at_t_junctions(surface, 1e-6), 3U);
    EXPECT_EQ(surface.triangles.size(), 8U);
    const EdgeCounts counts = count_edges(surface);
    EXPECT_EQ(counts.open, 0U);
}

TEST(FillHoles, fills_what_is_small_with_the_least_area) {
    TriangleSurface surface = cube();
    surface.triangles.erase(surface.triangles.begin(), surface.triangles.begin() + 2);
    const auto holes = fill_holes(surface, 4);
    ASSERT_EQ(holes.size(), 1U);
    EXPECT_EQ(holes[0].edges, 4U);
    EXPECT_EQ(holes[0].triangles, 2U);
    EXPECT_NEAR(holes[0].perimeter, 4, 1e-15);
    EXPECT_LT((holes[0].position - Vec(0.5, 0.5, 0)).norm(), 1e-15);
    EXPECT_TRUE(count_edges(surface).closed());
    EXPECT_NEAR(surface.enclosed_volume(), 1, 1e-15);
}

TEST(FillHoles, leaves_large_ones_and_the_rims_of_sheets) {
    TriangleSurface surface = cube();
    surface.triangles.erase(surface.triangles.begin(), surface.triangles.begin() + 2);
    EXPECT_EQ(fill_holes(surface, 3.99).at(0).triangles, 0U);
    EXPECT_EQ(surface.triangles.size(), 10U);
    TriangleSurface sheet;
    sheet.corners = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    sheet.triangles = {{0, 1, 2}, {0, 2, 3}};
    EXPECT_EQ(fill_holes(sheet, 100).at(0).triangles, 0U);
    EXPECT_TRUE(fill_holes(sheet, 100).size() == 1 && sheet.triangles.size() == 2);
}

TEST(FillHoles, tells_holes_apart_that_touch_in_a_corner) {
    // Of the top of an octahedron's four triangles, two that only touch.
    TriangleSurface surface = ball(1);
    surface.triangles.erase(surface.triangles.begin() + 3);
    surface.triangles.erase(surface.triangles.begin());
    const auto holes = fill_holes(surface, 100);
    ASSERT_EQ(holes.size(), 2U);
    for (const SurfaceHole& hole : holes) {
        EXPECT_EQ(hole.edges, 3U);
        EXPECT_EQ(hole.triangles, 1U);
        EXPECT_NEAR(hole.perimeter, 3 * std::numbers::sqrt2, 1e-14);
    }
    EXPECT_TRUE(count_edges(surface).closed());
    EXPECT_NEAR(surface.enclosed_volume(), 4.0 / 3, 1e-14);
}

TEST(FillHoles, goes_around_the_middle_of_long_rims) {
    TriangleSurface surface = ball(40);  // without its upper half: a rim of 160 edges
    surface.triangles.resize(surface.triangles.size() / 2);
    const auto holes = fill_holes(surface, 7);
    ASSERT_EQ(holes.size(), 1U);
    EXPECT_EQ(holes[0].edges, 160U);
    EXPECT_EQ(holes[0].triangles, 160U);
    EXPECT_TRUE(count_edges(surface).closed());
    EXPECT_NEAR(surface.enclosed_volume(), 0.5 * ball(40).enclosed_volume(), 1e-12);
}

TEST(SurfacePieces, are_separated_where_closed_ones_touch) {
    TriangleSurface surface = cube();
    append(surface, box({1, 1, 0}, {2, 2, 1}));
    weld_corners(surface, 0);
    EXPECT_EQ(surface.corners.size(), 14U);
    EXPECT_EQ(count_edges(surface).many_fold, 1U);
    EXPECT_EQ(separate_closed_pieces(surface), 1U);
    EXPECT_TRUE(count_edges(surface).closed());
    EXPECT_EQ(surface.corners.size(), 16U);
    const SurfacePieces pieces(surface);
    ASSERT_EQ(pieces.all().size(), 2U);
    for (const SurfacePiece& piece : pieces.all()) {
        EXPECT_TRUE(piece.closed);
        EXPECT_NEAR(piece.volume, 1, 1e-14);
        EXPECT_NEAR(piece.area, 6, 1e-14);
        EXPECT_FALSE(piece.has_no_volume());
    }
}

TEST(TriangleTree, finds_what_a_look_at_all_finds) {
    const TriangleSurface surface = ball(20);
    const TriangleTree tree(surface);
    EXPECT_EQ(tree.order().size(), 3200U);
    const auto any = [](int) { return true; };
    const auto hit = tree.first_hit(Vec(0.01, 0.02, -3), Vec(0, 0, 1), any);
    ASSERT_TRUE(hit.has_value());
    EXPECT_NEAR(hit->distance, 2, 0.01);
    EXPECT_FALSE(tree.first_hit(Vec(0.01, 0.02, -3), Vec(0, 0, -1), any).has_value());
    EXPECT_FALSE(tree.first_hit(Vec(2, 0, -3), Vec(0, 0, 1), any).has_value());
    const auto through = tree.first_hit(Vec(0.01, 0.02, -3), Vec(0, 0, 1), [&](int t) { return t != hit->triangle; });
    EXPECT_NEAR(through->distance, 4, 0.01);
    // Rays along the sides of flat boxes.
    const TriangleTree flat(cube());
    EXPECT_NEAR(flat.first_hit(Vec(0.3, 0.3, 0), Vec(0, 0, 1), any)->distance, 1, 0);
    const Vec low(0.1, 0.2, 0.3), high(0.5, 0.6, 1);
    std::size_t expected = 0, found = 0;
    for (const auto& [a, b, c] : surface.triangles) {
        const auto at = [&](int k) { return surface.corners[static_cast<std::size_t>(k)]; };
        const Vec from = at(a).cwiseMin(at(b)).cwiseMin(at(c)), to = at(a).cwiseMax(at(b)).cwiseMax(at(c));
        expected += (from.array() <= high.array()).all() && (to.array() >= low.array()).all() ? 1 : 0;
    }
    tree.visit_box(low, high, [&](int) { ++found; });
    EXPECT_EQ(found, expected);
    EXPECT_GT(found, 50U);
    EXPECT_FALSE(TriangleTree(TriangleSurface{}).first_hit(low, high, any).has_value());
}

TEST(WrapSurface, is_closed_and_outside_by_the_offset) {
    TriangleSurface surface = cube();
    surface.triangles.pop_back();
    surface = soup_of(surface);
    const double alpha = 2, offset = 0.05;  // no hole of a unit cube is as wide
    TriangleSurface wrapped = wrap_surface(surface, alpha, offset);
    EXPECT_TRUE(count_edges(wrapped).closed());
    EXPECT_GT(wrapped.enclosed_volume(), 1);
    for (const Vec& corner : wrapped.corners) {
        const Vec outside = (corner - Vec::Constant(0.5)).cwiseAbs() - Vec::Constant(0.5);
        EXPECT_GT(outside.cwiseMax(0).norm(), 0.9 * offset);   // chords cut the offset's round edges
        EXPECT_LT(outside.cwiseMax(0).norm(), 1.01 * offset);  // CGAL finds it to 1 %
    }
    EXPECT_EQ(orient_outward(wrapped).turned, 0U);
    EXPECT_THROW(wrap_surface(surface, 0, 1), std::invalid_argument);
}

}  // namespace
}  // namespace dmp::tests::repair_rungs_tests
