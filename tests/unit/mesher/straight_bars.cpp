// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Solids of cells that are drawn as straight bars, and what the report says of them.
#include <array>
#include <string>

#include <gmock/gmock.h>

#include "meshed_text.hpp"
#include "mesher/straight_bar.hpp"
#include "tests/modules.hpp"

namespace dmp::tests::straight_bars_tests {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Not;

Texts solid(const std::string& geometry) {
    return {R"(schema = 1
[geometry]
file = "channel.geo"
[particles]
spacing = "0.0625 m"
[[part]]
name = "bar"
kind = "elastic"
model = "cells"
density = "1000 kg/m^3"
youngs_modulus = "1 MPa"
poisson_ratio = 0.25
[flow]
largest_speed = "1 m/s"
[run]
duration = "1 s"
[output]
every = "1 s"
)",
            geometry};
}

TEST(StraightBars, moments_of_outlines_and_surfaces_are_those_of_their_shapes) {
    // A triangle with its right angle at (1, 2): legs 3 and 6, seen clockwise.
    const Polyline triangle{{Vec(1, 2, 0), Vec(1, 8, 0), Vec(4, 2, 0)}, true};
    const Moments of = moments_of(triangle);
    EXPECT_NEAR(of.volume, 9, 1e-12);
    EXPECT_LT((of.centroid - Vec(2, 4, 0)).norm(), 1e-12);
    EXPECT_NEAR(of.second(0, 0), 9 * 9.0 / 18, 1e-12);
    EXPECT_NEAR(of.second(1, 1), 9 * 36.0 / 18, 1e-12);
    EXPECT_NEAR(of.second(0, 1), -9 * 18.0 / 36, 1e-12);
    const Meshed box = mesh_texts(solid(R"(SetFactory("OpenCASCADE");
Box(1) = {1, 2, 3, 1, 0.25, 0.5};
Physical Volume("bar") = {1};
)")
                                      .with("schema = 1", "schema = 1\ndimension = 3"));
    const Moments solid_of = moments_of(box.geometry.solid("bar")->surface);
    EXPECT_NEAR(solid_of.volume, 0.125, 1e-12);
    EXPECT_LT((solid_of.centroid - Vec(1.5, 2.125, 3.25)).norm(), 1e-12);
    EXPECT_LT((solid_of.second - Eigen::Matrix3d(0.125 / 12 * Vec(1, 0.0625, 0.25).asDiagonal())).norm(), 1e-12);
}

TEST(StraightBars, along_the_lattice_have_the_stiffness_of_what_is_drawn) {
    const auto report = mesh_texts(solid(polygon({{0, 0}, {1, 0}, {1, 0.25}, {0, 0.25}}, "bar"))).report;
    const auto& bar = report.springs.at(0).bar;
    ASSERT_TRUE(bar);
    const double held = 1e6 / (1 - 0.0625);
    EXPECT_NEAR(bar->length, 1, 1e-9);
    EXPECT_NEAR(bar->axial.value, held * 0.25, 1e-6 * held);
    ASSERT_EQ(bar->bending.size(), 1U);
    EXPECT_NEAR(bar->bending[0].value, held * 0.25 * 0.25 * 0.25 / 12, 1e-9 * held);
    EXPECT_NEAR(bar->bending[0].over_drawn, 1, 1e-9);
    EXPECT_THAT(report.text(), HasSubstr("as a straight bar 1 m long: EA = 2.667e+05 N (1.0000 of the drawn one), EI = "
                                         "1389 N m^2 (1.0000)"));
    EXPECT_THAT(report.json(), HasSubstr("axial_stiffness_N"));
}

TEST(StraightBars, at_an_angle_lose_little) {
    const auto report =
        mesh_texts(
            solid(polygon({{0.3, 0.1}, {1.239693, 0.442020}, {1.154186, 0.676943}, {0.214493, 0.334923}}, "bar")))
            .report;
    const auto& bar = report.springs.at(0).bar;
    ASSERT_TRUE(bar);
    EXPECT_NEAR(bar->length, 1, 1e-3);
    EXPECT_NEAR(bar->axial.over_drawn, 1, 0.01);
    EXPECT_NEAR(bar->bending.at(0).over_drawn, 1, 0.02);
}

TEST(StraightBars, in_space_have_two_bending_stiffnesses) {
    const auto bar = mesh_texts(solid(R"(SetFactory("OpenCASCADE");
Box(1) = {0, 0, 0, 1, 0.25, 0.1875};
Physical Volume("bar") = {1};
)")
                                    .with("schema = 1", "schema = 1\ndimension = 3"))
                         .report.springs.at(0)
                         .bar;
    ASSERT_TRUE(bar);
    EXPECT_NEAR(bar->axial.value, 1e6 * 0.25 * 0.1875, 1);
    ASSERT_EQ(bar->bending.size(), 2U);
    EXPECT_NEAR(bar->bending[0].value, 1e6 * 0.25 * std::pow(0.1875, 3) / 12, 0.01);
    EXPECT_NEAR(bar->bending[1].value, 1e6 * 0.1875 * std::pow(0.25, 3) / 12, 0.01);
}

TEST(StraightBars, are_not_found_in_other_shapes) {
    for (const auto& corners : {std::vector<std::array<double, 2>>{{0, 0}, {1, 0}, {1, 0.5}, {0, 0.5}},
                                {{0, 0}, {1, 0}, {1, 1}, {0.75, 1}, {0.75, 0.25}, {0, 0.25}},
                                {{0, 0}, {2, 0}, {2, 0.125}, {0, 0.5}}})
        EXPECT_THAT(mesh_texts(solid(polygon(corners, "bar"))).report.text(), Not(HasSubstr("straight bar")));
}

/// A bar of 1 m x 0.25 m with a slit from its end on, from y to y + width.
Texts slit_bar(double y, double width) {
    return solid(
        polygon({{0, 0}, {1, 0}, {1, y}, {0.25, y}, {0.25, y + width}, {1, y + width}, {1, 0.25}, {0, 0.25}}, "bar"));
}

TEST(Slits, inside_a_cell_are_warned_of_with_their_place) {
    const auto warnings = [](double y, double width) { return mesh_texts(slit_bar(y, width)).report.warnings; };
    EXPECT_THAT(warnings(0.09, 0.01),
                Contains(testing::AllOf(HasSubstr("bar: a cell near (281.25, 93.75) mm closes a slit"),
                                        HasSubstr("particles.spacing"))));
    EXPECT_THAT(warnings(0.12, 0.01), Not(Contains(HasSubstr("slit")))) << "between two rows of cells";
    EXPECT_THAT(warnings(0.09, 0.07), Not(Contains(HasSubstr("slit")))) << "wider than a spacing";
    const Texts slanting = solid(polygon({{0.3, 0.1}, {1.2, 0.4}, {1.1, 0.7}, {0.2, 0.35}}, "bar"));
    EXPECT_THAT(mesh_texts(slanting).report.warnings, Not(Contains(HasSubstr("slit"))));
}

}  // namespace
}  // namespace dmp::tests::straight_bars_tests
