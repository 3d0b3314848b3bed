// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/solids_that_meet.hpp"

#include <cmath>
#include <numbers>

#include <gmock/gmock.h>

#include "tests/modules.hpp"
#include "tests/unit/geometry/surface_shapes.hpp"

namespace dmp::tests::solids_that_meet_tests {
namespace {

using ::testing::IsEmpty;

Geometry solids(std::vector<Solid> all) {
    Geometry geometry;
    geometry.solids = std::move(all);
    return geometry;
}

/// A cylinder around z from z = 0 to 1, of a polygon of `sides` that is turned by `angle`.
TriangleSurface prism(int sides, double angle) {
    TriangleSurface surface;
    for (const double z : {0.0, 1.0}) {
        surface.corners.emplace_back(0, 0, z);
        for (int k = 0; k < sides; ++k) {
            const double at = angle + 2 * std::numbers::pi * k / sides;
            surface.corners.emplace_back(std::cos(at), std::sin(at), z);
        }
    }
    const int top = sides + 1;
    for (int k = 0; k < sides; ++k) {
        const int a = 1 + k, b = 1 + (k + 1) % sides;
        surface.triangles.push_back({0, b, a});
        surface.triangles.push_back({top, top + a, top + b});
        surface.triangles.push_back({a, b, top + a});
        surface.triangles.push_back({b, top + b, top + a});
    }
    return surface;
}

/// A box of 2 with a round hole of radius 1 along z.
TriangleSurface box_with_a_hole(int sides) {
    TriangleSurface surface = box({-2, -2, 0}, {2, 2, 1});
    TriangleSurface hole = prism(sides, 0.1);
    for (std::size_t t = 0; t < hole.triangles.size(); ++t) flip(hole, t);
    append(surface, hole);
    return surface;
}

TEST(SolidsThatMeet, themselves_are_named_with_the_place) {
    TriangleSurface through = box({0, 0, 0}, {2, 2, 2});
    for (Vec& corner : through.corners)
        if (corner == Vec(2, 2, 2)) corner = Vec(0.9, 0.8, -1);
    const Geometry geometry = solids({{"whole", cube()}, {"through", through}, {"other", through}});
    EXPECT_THAT(solids_that_meet_themselves(geometry, {"whole", "elsewhere"}), IsEmpty());
    const auto found = solids_that_meet_themselves(geometry, {"through", "whole"});
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].one, "through");
    EXPECT_EQ(found[0].other, "");
    EXPECT_GT(found[0].crossings, 0U);
    EXPECT_LT((found[0].position - Vec(1, 1, 0)).norm(), 1.8);
    EXPECT_THAT(
        found[0].text(1e-3, "mm"),
        ::testing::MatchesRegex("'through' meets itself in [0-9]+ pairs of triangles, the first at \\(.*\\) mm"));
}

TEST(SolidsThatMeet, share_a_volume_or_cross_each_other) {
    const Geometry geometry = solids({{"a", box({0, 0, 0}, {2, 1, 1})},
                                      {"b", box({1, 0.25, 0.25}, {3, 0.75, 0.75})},
                                      {"blade", box({0.4, 0.4301, 0.9}, {0.6, 0.4302, 3})},
                                      {"far", box({7, 0, 0}, {8, 1, 1})}});
    const auto found = solids_that_overlap(geometry, {"a", "b", "blade", "far"}, 1e-6);
    ASSERT_EQ(found.size(), 2U);
    EXPECT_EQ(found[0].one + found[0].other, "ab");
    EXPECT_NEAR(found[0].volume, 0.25, 1e-12);
    EXPECT_EQ(found[0].text(1, "m").substr(0, 36), "'a' and 'b' share 0.25 m^3, around (");
    EXPECT_EQ(found[0].text(0.5, "ells").substr(0, 35), "'a' and 'b' share 2 ells^3, around ");
    EXPECT_EQ(found[1].one + found[1].other, "ablade");
    EXPECT_GE(found[1].crossings, 4U);
    EXPECT_NEAR(found[1].position.z(), 1, 1e-12);
    const SolidMeeting thin{.one = "a", .other = "blade", .crossings = 4, .position = Vec(1e-3, 2e-3, 0)};
    EXPECT_EQ(thin.text(1e-3, "mm"), "'a' and 'blade' cross each other in 4 places, the first at (1, 2, 0) mm");
    EXPECT_THAT(solids_that_overlap(geometry, {"b", "far"}, 1e-6), IsEmpty());
}

TEST(SolidsThatMeet, do_not_where_round_surfaces_are_of_other_triangles) {
    // A pin in its hole, each with its own facets: 24 sides are 1 - cos(pi / 24) = 0.0086 off the circle.
    const Geometry geometry = solids({{"pin", prism(24, 0)}, {"block", box_with_a_hole(24)}});
    EXPECT_THAT(solids_that_overlap(geometry, {"pin", "block"}, 0.02), IsEmpty());
    const auto deeper = solids_that_overlap(geometry, {"pin", "block"}, 1e-4);
    ASSERT_EQ(deeper.size(), 1U);
    EXPECT_NEAR(deeper[0].position.head<2>().norm(), 1, 0.01);
}

}  // namespace
}  // namespace dmp::tests::solids_that_meet_tests
