// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces that are broken in each way that files are broken, and what the ladder makes of them.
#include "geometry/repair_surface.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include <gmock/gmock.h>

#include "geometry/repair_solids.hpp"
#include "geometry/surface_edges.hpp"
#include "geometry/winding_number.hpp"
#include "tests/modules.hpp"
#include "tests/unit/geometry/surface_shapes.hpp"
#include "tests/unit/thrown.hpp"

namespace dmp::tests::repair_surface_tests {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

RepairedSurface repaired(const TriangleSurface& surface, double spacing = 0.5) {
    return repair_surface(surface, {.spacing = spacing}, "solid 'heart'", {"heart.stl", 0, 0});
}

/// Closed, and with the volume of the unit cube.
void expect_cube(const RepairedSurface& found) {
    EXPECT_TRUE(count_edges(found.surface).closed());
    EXPECT_FALSE(found.surface.has_holes);
    EXPECT_NEAR(found.surface.enclosed_volume(), 1, 1e-12);
    EXPECT_EQ(found.report.pieces, 1U);
    EXPECT_EQ(found.report.self_intersections, 0U);
}

/// What repair says, and which triangles it blames.
std::pair<std::string, TriangleSurface> refusal(const TriangleSurface& surface, const RepairLimits& limits) {
    try {
        repair_surface(surface, limits, "solid 'heart'", {"heart.stl", 0, 0});
    } catch (const UnusableSurface& error) {
        return {error.what(), error.bad_triangles()};
    }
    return {"nothing was thrown", {}};
}

TriangleSurface sheet() {
    TriangleSurface surface;
    surface.corners = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    surface.triangles = {{0, 1, 2}, {0, 2, 3}};
    return surface;
}

TEST(Repair, leaves_alone_what_is_in_order) {
    for (const TriangleSurface& surface : {cube(), ball(8)}) {
        const RepairedSurface found = repaired(surface, 0.1);
        EXPECT_EQ(found.surface.triangles, surface.triangles);
        EXPECT_EQ(found.surface.corners, surface.corners);
        EXPECT_THAT(found.report.lines(), IsEmpty());
        EXPECT_EQ(found.report.by, RepairedBy::nothing);
        EXPECT_FALSE(found.report.changed());
    }
}

TEST(Repair, joins_a_soup) {
    const RepairedSurface found = repaired(soup_of(cube()));
    expect_cube(found);
    EXPECT_EQ(found.report.equal_corners, 28U);
    EXPECT_EQ(found.report.welded_corners, 0U);
    EXPECT_THAT(found.report.lines(), ElementsAre("28 corners made one with another at the same place"));
}

TEST(Repair, welds_corners_that_rounding_has_moved) {
    TriangleSurface soup = soup_of(cube());
    std::mt19937 random(5);
    std::uniform_real_distribution<double> noise(-1e-4, 1e-4);
    for (Vec& corner : soup.corners) corner += Vec(noise(random), noise(random), noise(random));
    const RepairedSurface found = repaired(soup);
    EXPECT_TRUE(count_edges(found.surface).closed());
    EXPECT_NEAR(found.surface.enclosed_volume(), 1, 1e-3);
    EXPECT_EQ(found.report.welded_corners, 28U);
    EXPECT_THAT(found.report.lines(), ElementsAre("28 corners welded to another within 0.001 spacings"));
}

TEST(Repair, turns_one_half_or_all_of_the_triangles) {
    for (const std::size_t count : {1U, 6U, 12U}) {
        TriangleSurface surface = cube();
        for (std::size_t t = 0; t < count; ++t) flip(surface, t);
        const RepairedSurface found = repaired(surface);
        expect_cube(found);
        EXPECT_EQ(found.report.turned, count);
        EXPECT_EQ(found.report.by, RepairedBy::closing);
    }
}

TEST(Repair, drops_duplicates_and_triangles_without_area) {
    TriangleSurface surface = cube();
    surface.triangles.push_back(surface.triangles[3]);
    surface.triangles.push_back(surface.triangles[7]);
    flip(surface, 13);
    surface.triangles.push_back({0, 0, 5});
    surface.left_out = 2;  // the reader's
    const RepairedSurface found = repaired(surface);
    expect_cube(found);
    EXPECT_EQ(found.report.duplicates, 2U);
    EXPECT_EQ(found.report.without_area, 3U);
    EXPECT_EQ(found.report.triangles_before, 17U);
    EXPECT_EQ(found.report.triangles, 12U);
}

TEST(Repair, closes_the_slit_that_a_triangle_without_area_leaves) {
    TriangleSurface surface = cube();
    surface.corners.emplace_back(0.5, 0, 0);
    surface.triangles[4] = {0, 8, 4};
    surface.triangles.push_back({8, 1, 4});
    surface.triangles.push_back({0, 1, 8});
    ASSERT_TRUE(count_edges(surface).closed());
    const RepairedSurface found = repaired(surface);
    expect_cube(found);
    EXPECT_THAT(found.report.lines(), ElementsAre("1 triangle without area dropped",
                                                  "1 corner put on edges of other triangles (T-junctions)"));
}

TEST(Repair, divides_at_t_junctions) {
    TriangleSurface surface = cube();
    surface.corners.emplace_back(0.25, 0, 0);
    surface.triangles[4] = {0, 8, 4};
    surface.triangles.push_back({8, 1, 4});
    const RepairedSurface found = repaired(surface);
    expect_cube(found);
    EXPECT_EQ(found.report.t_junctions, 1U);
    EXPECT_EQ(found.report.triangles, 14U);
}

TEST(Repair, fills_a_small_hole) {
    TriangleSurface surface = cube();
    surface.triangles.pop_back();
    const RepairedSurface found = repaired(surface);
    expect_cube(found);
    ASSERT_EQ(found.report.holes.size(), 1U);
    EXPECT_EQ(found.report.holes[0].triangles, 1U);
    EXPECT_NEAR(found.report.holes[0].perimeter, 2 + std::numbers::sqrt2, 1e-14);
    EXPECT_THAT(found.report.lines(), ElementsAre("a hole of 3 edges around (1, 0.66667, 0.66667) m, 6.82843 "
                                                  "spacings around, filled with 1 triangle"));
    EXPECT_EQ(found.report.turned, 0U);
}

TEST(Repair, goes_no_further_than_asked) {
    TriangleSurface hole = cube();
    hole.triangles.pop_back();
    for (const RepairRung below : {RepairRung::none, RepairRung::weld}) {
        const auto [text, bad] = refusal(hole, {.spacing = 0.5, .highest = below});
        EXPECT_THAT(text, HasSubstr("is not closed and not to be repaired any further: 3 edges with one triangle"));
        EXPECT_THAT(text, HasSubstr("the largest hole is 6.82843 spacings around"));
        EXPECT_THAT(text, HasSubstr("or let geometry.repair go further"));
        EXPECT_EQ(bad.triangles.size(), 3U);
    }
    const auto repaired_up_to = [](const TriangleSurface& surface, RepairRung highest) {
        return repair_surface(surface, {.spacing = 0.5, .highest = highest}, "solid 'cube'", {}).report.by;
    };
    EXPECT_EQ(repaired_up_to(hole, RepairRung::fill), RepairedBy::closing);
    // A corner that is off by rounding.
    TriangleSurface cracked = cube();
    cracked.corners.push_back(cracked.corners[0] + Vec(1e-9, 0, 0));
    *std::ranges::find(cracked.triangles[0], 0) = 8;
    EXPECT_THAT(refusal(cracked, {.spacing = 0.5, .highest = RepairRung::none}).first, HasSubstr("any further"));
    EXPECT_EQ(repaired_up_to(cracked, RepairRung::weld), RepairedBy::closing);
    // What is closed needs no rung, whichever side it faces.
    TriangleSurface turned = cube();
    flip(turned, 3);
    EXPECT_EQ(repaired_up_to(turned, RepairRung::none), RepairedBy::closing);
}

TEST(Repair, turns_a_body_inside_out_with_a_hole) {
    TriangleSurface surface = cube();
    for (std::size_t t = 0; t < 12; ++t) flip(surface, t);
    surface.triangles.erase(surface.triangles.begin());
    const RepairedSurface found = repaired(surface);
    expect_cube(found);
    EXPECT_EQ(found.report.turned, 11U);
}

TEST(Repair, takes_inner_walls_out_of_bodies_that_touch) {
    TriangleSurface surface = cube();
    append(surface, box({1, 0, 0}, {3, 1, 1}));
    const RepairedSurface found = repaired(surface);
    EXPECT_NEAR(found.surface.enclosed_volume(), 3, 1e-12);
    EXPECT_EQ(found.report.inner_walls, 4U);
    EXPECT_EQ(found.report.equal_corners, 4U);
    EXPECT_EQ(found.report.pieces, 1U);
}

TEST(Repair, separates_bodies_that_touch_in_an_edge) {
    TriangleSurface surface = cube();
    append(surface, box({1, 1, 0}, {2, 2, 1}));
    for (std::size_t t = 12; t < 24; ++t) flip(surface, t);
    const RepairedSurface found = repaired(surface);
    EXPECT_TRUE(count_edges(found.surface).closed());
    EXPECT_NEAR(found.surface.enclosed_volume(), 2, 1e-12);
    EXPECT_EQ(found.report.separated_edges, 1U);
    EXPECT_EQ(found.report.turned, 12U);
    EXPECT_EQ(found.report.pieces, 2U);
}

TEST(Repair, keeps_hollows_and_joins_solids_that_cross) {
    TriangleSurface hollow = box({0, 0, 0}, {3, 3, 3});
    append(hollow, box({1, 1, 1}, {2, 2, 2}));
    EXPECT_NEAR(repaired(hollow).surface.enclosed_volume(), 26, 1e-12);

    // Both face outward, whatever side the crossing is looked at from: places in both count twice.
    for (const bool swapped : {false, true}) {
        TriangleSurface first = box({0, 0, 0}, {2, 2, 2}), second = box({1, 0.9, 0.8}, {4, 1.5, 1.6});
        if (swapped) std::swap(first, second);
        append(first, second);
        const RepairedSurface found = repaired(first);
        EXPECT_NEAR(found.surface.enclosed_volume(), 8 + 3 * 0.6 * 0.8, 1e-12);
        EXPECT_NEAR(winding_number(found.surface, Vec(1.5, 1.2, 1.2)), 2, 1e-12);
        EXPECT_GT(found.report.self_intersections, 0U);
        EXPECT_THAT(found.report.lines().back(), HasSubstr("it meets itself in "));
    }
}

TEST(Repair, turns_what_crosses_itself_by_what_it_encloses) {
    TriangleSurface surface;  // found by fuzzing: the triangle that is seen largest along x faces into the smaller part
    surface.corners = {{0, 0, 0}, {8, 0, 0}, {9, 2, 2}, {3, 3, 7}, {2, 0, 3}, {6, 8, 5}, {4, 7, 7}, {5, 8, 0}};
    surface.triangles = {{7, 3, 2}, {0, 2, 1}, {4, 5, 6}, {4, 6, 7}, {0, 1, 5}, {0, 5, 4},
                         {1, 2, 6}, {1, 6, 5}, {2, 3, 7}, {2, 7, 6}, {3, 0, 4}, {3, 4, 7}};
    EXPECT_GT(repair_surface(surface, {.spacing = 4, .highest = RepairRung::vote}, "it", {}).surface.enclosed_volume(),
              0);
}

TEST(Repair, throws_crumbs_away_and_says_so) {
    TriangleSurface surface = cube();
    append(surface, box({2, 2, 2}, {2.1, 2.1, 2.1}));
    append(surface, sheet());
    for (std::size_t k = 16; k < 20; ++k) surface.corners[k] = Vec(5, 5, 5) + 0.05 * surface.corners[k];
    const RepairedSurface found = repaired(surface);
    expect_cube(found);
    ASSERT_EQ(found.report.thrown.size(), 2U);
    EXPECT_EQ(found.report.thrown[0].triangles, 12U);
    EXPECT_NEAR(found.report.thrown[0].area, 0.06, 1e-14);
    EXPECT_LT((found.report.thrown[0].position - Vec(2.05, 2.05, 2.05)).norm(), 1e-14);
    EXPECT_EQ(found.report.thrown[1].triangles, 2U);
    EXPECT_THAT(found.report.lines().at(0),
                HasSubstr("a piece of 12 triangles at (2.05, 2.05, 2.05) m thrown away: it is 0.34641 spacings large"));
}

TEST(Repair, throws_a_piece_without_volume_away) {
    TriangleSurface surface = cube();
    TriangleSurface flat = box({2, 2, 2}, {3, 3, 2});  // its upper and lower side divided in different ways
    flat.triangles[0] = {0, 2, 3};
    flat.triangles[1] = {0, 3, 1};
    append(surface, flat);
    const RepairedSurface found = repaired(surface);
    expect_cube(found);
    ASSERT_EQ(found.report.thrown.size(), 1U);
    EXPECT_FALSE(found.report.thrown[0].is_small);
    EXPECT_NEAR(found.report.thrown[0].area, 2, 1e-14);
    EXPECT_EQ(found.report.without_area, 8U);
}

TEST(Repair, lets_the_winding_number_vote_on_a_body_with_holes_that_are_not_small) {
    TriangleSurface surface = ball(32);
    std::erase_if(surface.triangles, [&](const auto& triangle) {
        return surface.corners[static_cast<std::size_t>(triangle[0])].z() > 0.99;
    });
    for (std::size_t t = 0; t < surface.triangles.size(); t += 3) flip(surface, t);
    const RepairedSurface found = repaired(surface, 0.02);
    EXPECT_EQ(found.report.by, RepairedBy::vote);
    EXPECT_TRUE(found.surface.has_holes);
    EXPECT_LT(found.report.doubt, 0.02);
    ASSERT_EQ(found.report.holes.size(), 1U);
    EXPECT_EQ(found.report.holes[0].triangles, 0U);
    EXPECT_EQ(found.report.turned, (surface.triangles.size() + 2) / 3);
    EXPECT_GT(winding_number(found.surface, Vec(0, 0, 0)), 0.98);
    EXPECT_THAT(found.report.lines().back(), HasSubstr("the winding number says what is inside"));
}

/// A ball whose triangles share nothing: each is a little smaller than the gap it lies in.
TriangleSurface shrunk_ball() {
    TriangleSurface surface = soup_of(ball(16));
    for (const auto& [a, b, c] : surface.triangles) {
        const auto at = [&](int k) -> Vec& { return surface.corners[static_cast<std::size_t>(k)]; };
        const Vec middle = (at(a) + at(b) + at(c)) / 3;
        for (const int corner : {a, b, c}) at(corner) = middle + 0.9 * (at(corner) - middle);
    }
    return surface;
}

TEST(Repair, wraps_what_is_in_pieces) {
    const RepairedSurface found = repaired(shrunk_ball(), 0.2);
    EXPECT_EQ(found.report.by, RepairedBy::wrap);
    EXPECT_TRUE(count_edges(found.surface).closed());
    EXPECT_NEAR(found.report.wrap_offset, 0.02, 1e-15);
    const double radius = std::cbrt(found.surface.enclosed_volume() * 3 / (4 * std::numbers::pi));
    EXPECT_LT(radius, 1.02);
    EXPECT_GT(radius, 1.02 - 0.2 * 0.2 / 2) << "the height of facets as wide as alpha";
    EXPECT_THAT(
        found.report.lines().back(),
        HasSubstr("another surface wrapped around it, 0.1 spacings outside of it and across what is narrower than "
                  "1 spacings"));
}

TEST(Repair, refuses_a_large_hole_with_its_place) {
    TriangleSurface surface = cube();
    surface.triangles.resize(10);  // without the side x = 1
    const auto [text, bad] = refusal(surface, {.spacing = 0.125});
    EXPECT_THAT(text,
                HasSubstr("heart.stl: solid 'heart' is not closed and cannot be repaired: 4 edges with one triangle, "
                          "0 with more than two, 0 whose triangles face different sides, the first from (1, 0, 0) "
                          "m to (1, 1, 0) m"));
    EXPECT_THAT(text, HasSubstr("the largest hole is 32 spacings around, at (1, 0.5, 0.5) m"));
    EXPECT_EQ(bad.triangles.size(), 4U);
    EXPECT_NEAR(bad.area(), 2, 1e-14);
}

TEST(Repair, refuses_inner_walls_that_bound_nothing) {
    TriangleSurface surface = cube();
    append(surface, box({1, 0, 0}, {3, 1, 1}));
    surface.triangles.erase(surface.triangles.begin() + 20, surface.triangles.begin() + 22);  // one of two at x = 1
    const auto [text, bad] = refusal(surface, {.spacing = 0.5, .highest = RepairRung::vote});
    EXPECT_THAT(text, HasSubstr("0 edges with one triangle, 4 with more than two, "));
    EXPECT_THAT(text, HasSubstr("triangles of sheets, which have no inside: 2"));
    EXPECT_GT(bad.triangles.size(), 2U);
}

TEST(Repair, refuses_a_fin_and_throws_a_small_one_away) {
    TriangleSurface surface = cube();
    surface.corners.emplace_back(-1, -2, 0.3);
    surface.triangles.push_back({0, 1, 8});
    const auto [text, bad] = refusal(surface, {.spacing = 0.01, .highest = RepairRung::vote});
    EXPECT_THAT(text, HasSubstr("triangles of sheets, which have no inside: 1"));
    EXPECT_EQ(bad.triangles.size(), 1U);
    surface = cube();
    surface.corners.emplace_back(0.9, 0, 0);
    surface.corners.emplace_back(0.95, -0.05, -0.05);
    surface.triangles.push_back({1, 8, 9});
    const RepairedSurface found = repaired(surface, 0.2);
    expect_cube(found);
    EXPECT_EQ(found.report.thrown.size(), 1U);
}

TEST(Repair, refuses_sheets_and_bands) {
    const auto [text, bad] = refusal(sheet(), {.spacing = 0.01});
    EXPECT_THAT(text, HasSubstr("4 edges with one triangle"));
    EXPECT_THAT(text, HasSubstr("triangles of sheets, which have no inside: 2"));
    EXPECT_EQ(bad.triangles.size(), 2U);
    TriangleSurface band;  // a Moebius band
    for (int k = 0; k < 5; ++k)
        band.corners.emplace_back(std::cos(0.4 * k * std::numbers::pi), std::sin(0.4 * k * std::numbers::pi), 0.1 * k);
    for (int k = 0; k < 5; ++k) band.triangles.push_back({k, (k + 1) % 5, (k + 2) % 5});
    EXPECT_THAT(refusal(band, {.spacing = 0.01, .highest = RepairRung::vote}).first, HasSubstr("is not closed"));
}

TEST(Repair, refuses_bodies_without_volume) {
    EXPECT_THAT(refusal(box({0, 0, 0}, {1, 1, 0}), {.spacing = 0.01}).first,
                HasSubstr("solid 'heart' has no volume: its triangles lie back to back at ("));
    TriangleSurface flat = box({0, 0, 0}, {1, 1, 0});
    flat.triangles[0] = {0, 2, 3};
    flat.triangles[1] = {0, 3, 1};
    const auto [text, bad] = refusal(flat, {.spacing = 0.01});
    EXPECT_THAT(text, HasSubstr("has no volume: its triangles lie back to back at (500, 500, 0) mm"));
    EXPECT_EQ(bad.triangles.size(), 4U);
    EXPECT_THAT(refusal(TriangleSurface{}, {.spacing = 0.01}).first, HasSubstr("has no triangle with an area"));
}

TEST(Repair, refuses_what_is_smaller_than_a_particle) {
    EXPECT_THAT(refusal(cube(), {.spacing = 2}).first,
                HasSubstr("is smaller than a particle: it is 1.732 m across, at (500, 500, 500) mm, and the spacing 2 "
                          "m\n  check its unit, or choose a smaller spacing"));
    TriangleSurface two = cube();
    append(two, box({9, 9, 9}, {10, 10, 10}));
    EXPECT_THAT(refusal(two, {.spacing = 2}).first,
                HasSubstr("falls into 2 bodies smaller than a particle, the first at "
                          "(500, 500, 500) mm"));
}

TEST(Repair, refuses_numbers_that_are_none) {
    TriangleSurface surface = cube();
    surface.corners[7].y() = std::numeric_limits<double>::quiet_NaN();
    const auto [text, bad] = refusal(surface, {.spacing = 0.1});
    EXPECT_THAT(text, HasSubstr("has a corner that is not finite, of triangle 3"));
    EXPECT_EQ(bad.triangles.size(), 1U);
    surface = cube();
    surface.triangles[5][2] = 8;
    EXPECT_THAT(refusal(surface, {.spacing = 0.1}).first, HasSubstr("has a triangle, number 5, with corner 8 of 8"));
    EXPECT_THROW(repair_surface(cube(), {}, "solid 'heart'", {}), std::invalid_argument);
}

TEST(RepairSolids, makes_solids_of_surfaces_that_are_to_be_solids) {
    Geometry geometry;
    geometry.file = "valve.stl";
    TriangleSurface torn = cube();
    torn.triangles.pop_back();
    geometry.solids.push_back({"frame", cube()});
    geometry.surfaces.push_back({"wall", sheet()});
    geometry.surfaces.push_back({"blood", torn});
    const RepairLimits limits{.spacing = 0.5};
    EXPECT_THAT(repair_solids(geometry, {"frame", "blood", "elsewhere"}, limits),
                ElementsAre(HasSubstr("blood: a hole of 3 edges around (1, 0.66667, 0.66667) m, ")));
    ASSERT_NE(geometry.solid("blood"), nullptr);
    EXPECT_NEAR(geometry.solid("blood")->volume(), 1, 1e-12);
    EXPECT_EQ(geometry.surface_set("blood"), nullptr);
    EXPECT_THAT(text_thrown<UnusableSurface>([&] { repair_solids(geometry, {"wall"}, limits); }),
                HasSubstr("valve.stl: solid 'wall' is not closed and cannot be repaired: 4 edges with one triangle"));
}

TEST(Repair, of_a_million_triangles) {
    TriangleSurface soup = soup_of(ball(354));
    ASSERT_EQ(soup.triangles.size(), 1002528U);
    for (std::size_t t = 0; t < soup.triangles.size(); t += 2) flip(soup, t);
    const RepairedSurface found =
        repair_surface(std::move(soup), {.spacing = 0.02, .meets_itself = false}, "solid 'ball'", {});
    EXPECT_EQ(found.report.equal_corners, 3U * 1002528U - 501266U);  // Euler: corners = triangles / 2 + 2
    EXPECT_EQ(found.report.turned, 501264U);
    EXPECT_NEAR(found.surface.enclosed_volume(), 4.0 / 3 * std::numbers::pi, 1e-4);
}

}  // namespace
}  // namespace dmp::tests::repair_surface_tests
