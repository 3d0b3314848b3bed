// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Corners and edges, where particles are pinned.
#include "mesher/features.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gmock/gmock.h>

#include "meshed_text.hpp"
#include "mesher/searchable_particles.hpp"
#include "tests/modules.hpp"

namespace dmp::tests::features_tests {
namespace {

/// Distance of the nearest place on that side [m].
double nearest_of(const std::vector<FeaturePosition>& positions, const Vec& point, bool in_fluid) {
    double nearest = HUGE_VAL;
    for (const FeaturePosition& position : positions)
        if (position.in_fluid == in_fluid) nearest = std::min(nearest, (position.point - point).norm());
    return nearest;
}

TEST(CornerPositions, are_half_a_spacing_from_both_lines) {
    for (const double degrees : {60.0, 90.0, 120.0}) {
        const double angle = degrees * std::numbers::pi / 180;
        const CurveSet wall{"wall", {{{Vec(2, 0, 0), Vec(0, 0, 0), Vec(2 * std::cos(angle), 2 * std::sin(angle), 0)}}}};
        const auto in_wedge = [&](const Vec& p) {
            const double at = std::atan2(p.y(), p.x());
            return at > 0 && at < angle;
        };
        const auto positions = corner_positions({&wall}, in_wedge, 0.2);
        ASSERT_EQ(positions.size(), 2U);
        const Vec middle(std::cos(angle / 2), std::sin(angle / 2), 0);
        const Vec wanted = 0.1 / std::sin(angle / 2) * middle;
        EXPECT_LT(nearest_of(positions, wanted, true), 1e-12) << degrees;
        EXPECT_LT(nearest_of(positions, -wanted, false), 1e-12) << degrees;
        // The same with the fluid on the other side.
        const auto outside = corner_positions(
            {&wall}, [&](const Vec& p) { return !in_wedge(p); }, 0.2);
        EXPECT_LT(nearest_of(outside, -wanted, true), 1e-12) << degrees;
    }
}

TEST(CornerPositions, are_at_sharp_corners_beside_fluid_only) {
    const auto below = [](const Vec& p) { return p.y() < 0; };
    const CurveSet bent{"bent", {{{Vec(-1, 0, 0), Vec(0, 0, 0), Vec(1, 0.8, 0)}}}};  // by 39 degrees
    EXPECT_TRUE(corner_positions({&bent}, below, 0.1).empty());
    const CurveSet corner{"corner", {{{Vec(-1, 0, 0), Vec(0, 0, 0), Vec(1, 1, 0)}}}};
    EXPECT_EQ(corner_positions({&corner}, below, 0.1).size(), 2U);
    EXPECT_TRUE(corner_positions(
                    {&corner}, [](const Vec&) { return true; }, 0.1)
                    .empty());
    // Curves of several parts, each with a piece of its own, in any direction.
    const CurveSet first{"first", {{{Vec(0, 0, 0), Vec(-1, 0, 0)}}}},
        second{"second", {{{Vec(0, 0, 0), Vec(1, 1, 0)}}}};
    EXPECT_EQ(corner_positions({&first, &second}, below, 0.1).size(), 2U);
}

/// The box from the origin to this corner, in twelve triangles.
TriangleSurface box_surface(const Vec& high) {
    TriangleSurface box;
    for (int k = 0; k < 8; ++k)
        box.corners.emplace_back((k & 1) != 0 ? high.x() : 0, (k & 2) != 0 ? high.y() : 0, (k & 4) != 0 ? high.z() : 0);
    box.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                     {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
    return box;
}

TEST(EdgePositions, of_a_box_are_at_its_corners_and_along_its_edges) {
    const TriangleSurface box = box_surface(Vec(1, 1, 1));
    const auto inside = [](const Vec& p) { return p.minCoeff() > 0 && p.maxCoeff() < 1; };
    const auto positions = edge_positions({&box}, inside, 0.1);
    // Inside lines of 0.9 m: 9 steps; outside ones of 1.1 m: 11 steps.
    EXPECT_EQ(positions.size(), 2U * 8 + 12 * (8 + 10));
    for (int k = 0; k < 8; ++k) {
        const Vec sign((k & 1) != 0 ? 1 : -1, (k & 2) != 0 ? 1 : -1, (k & 4) != 0 ? 1 : -1);
        EXPECT_LT(nearest_of(positions, Vec::Constant(0.5) + 0.45 * sign, true), 1e-12);
        EXPECT_LT(nearest_of(positions, Vec::Constant(0.5) + 0.55 * sign, false), 1e-12);
    }
    for (int k = 0; k < 10; ++k) EXPECT_LT(nearest_of(positions, Vec(0.05 + 0.1 * k, 0.05, 0.95), true), 1e-12) << k;
    for (int k = 0; k < 12; ++k) EXPECT_LT(nearest_of(positions, Vec(-0.05 + 0.1 * k, -0.05, 1.05), false), 1e-12) << k;
    // Turned inside out, with faces of two surfaces: the same, as where fluid is decides.
    TriangleSurface low = box, high = box;
    low.triangles.resize(6);
    high.triangles.erase(high.triangles.begin(), high.triangles.begin() + 6);
    for (auto& triangle : high.triangles) std::swap(triangle[0], triangle[1]);
    const auto of_two = edge_positions({&low, &high}, inside, 0.1);
    ASSERT_EQ(of_two.size(), positions.size());
    for (const FeaturePosition& position : positions)
        EXPECT_LT(nearest_of(of_two, position.point, position.in_fluid), 1e-12);
}

TEST(EdgePositions, begin_with_half_a_step_at_open_ends) {
    TriangleSurface tube = box_surface(Vec(1, 1, 1));  // open at both ends along x
    std::erase_if(tube.triangles, [&](const auto& t) {
        const double x = tube.corners[static_cast<std::size_t>(t[0])].x();
        return std::ranges::all_of(t, [&](int k) { return tube.corners[static_cast<std::size_t>(k)].x() == x; });
    });
    const auto inside = [](const Vec& p) { return p.minCoeff() > 0 && p.maxCoeff() < 1; };
    const auto positions = edge_positions({&tube}, inside, 0.1);
    EXPECT_EQ(positions.size(), 2U * 4 * 10);
    for (int k = 0; k < 10; ++k) {
        EXPECT_LT(nearest_of(positions, Vec(0.05 + 0.1 * k, 0.05, 0.05), true), 1e-12) << k;
        EXPECT_LT(nearest_of(positions, Vec(0.05 + 0.1 * k, -0.05, -0.05), false), 1e-12) << k;
    }
}

/// An enclosed room in 2-D, of six corners of which one is re-entrant; no side is a whole number of spacings.
TEST(FittedFeatures, corners_in_the_plane_keep_their_particles) {
    const Texts room = channel.with("periodic = [\"x\"]\n", "")
                           .with("Line(2) = {2, 3};",
                                 "Point(5) = {4, 0.9, 0};\nPoint(6) = {2.1, 0.9, 0};\n"
                                 "Point(7) = {2.1, 2, 0};\nLine(2) = {2, 5};\nLine(5) = {5, 6};\n"
                                 "Line(6) = {6, 7};")
                           .with("Line(3) = {3, 4};", "Line(3) = {7, 4};")
                           .with("{1, 2, 3, 4};", "{1, 2, 5, 6, 3, 4};")
                           .with("Physical Curve(\"wall\") = {1, 3}", "Physical Curve(\"wall\") = {1:6}")
                           .with("spacing = \"0.125 m\"", "spacing = \"0.0411 m\"\nfill = \"relaxed\"");
    const Meshed meshed = mesh_texts(room);
    const ParticleSet& set = meshed.particles;
    EXPECT_THAT(meshed.report.notes, testing::Contains(testing::HasSubstr("11 particles are pinned at corners")));
    const double half = set.spacing / 2;
    const std::vector<std::pair<Vec, Vec>> corners{{{0, 0, 0}, {1, 1, 0}},     {{4, 0, 0}, {-1, 1, 0}},
                                                   {{4, 0.9, 0}, {-1, -1, 0}}, {{2.1, 0.9, 0}, {-1, -1, 0}},
                                                   {{2.1, 2, 0}, {-1, -1, 0}}, {{0, 2, 0}, {1, -1, 0}}};
    for (const auto& [corner, into_fluid] : corners)
        for (const double side : {1.0, -1.0}) {
            const Vec wanted = corner + side * half * into_fluid;
            double nearest = HUGE_VAL;
            for (std::size_t i = 0; i < set.size(); ++i)
                if ((set.kind(i) == PartKind::fluid) == (side > 0))
                    nearest = std::min(nearest, (set.position[i] - wanted).norm());
            if (side > 0 && corner.x() == 2.1 && corner.y() == 0.9) continue;  // fluid lies around this one
            EXPECT_LT(nearest, 1e-12) << wanted.transpose();
        }
    const auto& water = meshed.report.parts.front();
    EXPECT_LT(water.inside.spread, 0.01);
    EXPECT_LT(water.near_walls.spread, 0.03);
    EXPECT_GT(water.nearest, 0.75);
}

/// A cube that lies askew to the lattice: the places of its edges, inside and outside, are all taken.
TEST(FittedFeatures, edges_in_space_keep_their_particles) {
    const Texts cube{channel.with("schema = 1", "schema = 1\ndimension = 3")
                         .with("periodic = [\"x\"]\n", "")
                         .with("spacing = \"0.125 m\"", "spacing = \"0.11 m\"\nfill = \"relaxed\"")
                         .scene,
                     "SetFactory(\"OpenCASCADE\");\nBox(1) = {0, 0, 0, 1, 1, 1};\n"
                     "Rotate {{0, 0, 1}, {0, 0, 0}, 0.4} { Volume{1}; }\nPhysical Volume(\"water\") = {1};\n"
                     "Physical Surface(\"wall\") = {1:6};\n"};
    const Meshed meshed = mesh_texts(cube);
    const ParticleSet& set = meshed.particles;
    const auto inside = [](const Vec& p) {
        const Vec back(std::cos(0.4) * p.x() + std::sin(0.4) * p.y(), std::cos(0.4) * p.y() - std::sin(0.4) * p.x(),
                       p.z());
        return back.minCoeff() > 0 && back.maxCoeff() < 1;
    };
    const auto positions = edge_positions({&meshed.geometry.surface_set("wall")->surface}, inside, set.spacing);
    // Inside 1 / 0.11 - 1 = 8.1 steps between corners, outside 10.1.
    ASSERT_EQ(positions.size(), 2U * 8 + 12 * (7 + 9));
    EXPECT_THAT(meshed.report.notes, testing::Contains(testing::HasSubstr("; 208 particles are pinned at corners")));
    for (const FeaturePosition& position : positions) {
        double nearest = HUGE_VAL;
        for (std::size_t i = 0; i < set.size(); ++i)
            if ((set.kind(i) == PartKind::fluid) == position.in_fluid)
                nearest = std::min(nearest, (set.position[i] - position.point).norm());
        EXPECT_LT(nearest, 1e-12) << position.point.transpose();
    }
    EXPECT_LT(meshed.report.parts.front().near_walls.spread, 0.03);
}

}  // namespace
}  // namespace dmp::tests::features_tests
