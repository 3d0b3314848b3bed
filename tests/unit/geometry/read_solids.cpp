// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numbers>

#include "temporary_geometry.hpp"
#include "tests/modules.hpp"

namespace dmp::tests::read_solids_tests {
namespace {

using ReadSolids = GeometryFileTest;

const std::string occ = "SetFactory(\"OpenCASCADE\");\n";

TEST_F(ReadSolids, ABoxWithANamedSide) {
    auto options = options_for(write("box.geo", occ + "Box(1) = {0, 0, 0, 3, 2, 1};\n"
                                                      "Physical Volume(\"water\") = {1};\n"
                                                      "Physical Surface(\"wall\") = {5, 6};\n"
                                                      "Physical Point(\"corner\") = {1};\n"));
    options.unit = 0.001;
    const Geometry geometry = read_geometry(options);
    EXPECT_EQ(geometry.dimension, 3);
    EXPECT_EQ(geometry.names(), (std::vector<std::string>{"corner", "wall", "water"}));
    ASSERT_NE(geometry.solid("water"), nullptr);
    EXPECT_NEAR(geometry.solid("water")->volume(), 6e-9, 1e-20);
    ASSERT_NE(geometry.surface_set("wall"), nullptr);
    EXPECT_NEAR(geometry.surface_set("wall")->surface.area(), 12e-6, 1e-15);  // z = 0 and z = 1
    EXPECT_LT((geometry.box.high - Vec(0.003, 0.002, 0.001)).norm(), 1e-12);
    EXPECT_EQ(geometry.solid("wall"), nullptr);
    EXPECT_EQ(geometry.region("water"), nullptr);
}

TEST_F(ReadSolids, ARoundPipeFollowsItsCircleWithinTheChordError) {
    auto options = options_for(write("pipe.geo", occ + "Cylinder(1) = {0, 0, 0, 4, 0, 0, 1};\n"
                                                       "Physical Volume(\"blood\") = {1};\n"
                                                       "Physical Surface(\"wall\") = {1};\n"));
    options.chord_error = 0.002;
    const Geometry geometry = read_geometry(options);
    const TriangleSurface& wall = geometry.surface_set("wall")->surface;
    double deepest = 0;
    for (const auto& [a, b, c] : wall.triangles)
        for (const auto& [from, to] : {std::pair{a, b}, std::pair{b, c}, std::pair{c, a}}) {
            const Vec middle =
                0.5 * (wall.corners[static_cast<std::size_t>(from)] + wall.corners[static_cast<std::size_t>(to)]);
            deepest = std::max(deepest, 1 - std::hypot(middle.y(), middle.z()));
        }
    EXPECT_LT(deepest, options.chord_error);
    EXPECT_NEAR(geometry.solid("blood")->volume() / (4 * std::numbers::pi), 1, 0.003);
}

TEST_F(ReadSolids, WhatLiesBetweenTwoVolumesOfOneNameIsNoSurface) {
    const Geometry geometry = read_geometry(
        options_for(write("two.geo", occ + "Box(1) = {0, 0, 0, 1, 1, 1};\nBox(2) = {1, 0, 0, 1, 1, 1};\n"
                                           "BooleanFragments{ Volume{1}; Delete; }{ Volume{2}; Delete; }\n"
                                           "Physical Volume(\"water\") = {1, 2};\n")));
    EXPECT_NEAR(geometry.solid("water")->volume(), 2, 1e-12);
    EXPECT_NEAR(geometry.solid("water")->surface.area(), 10, 1e-12);
}

TEST_F(ReadSolids, AHollowBodyAndTheBuiltInKernel) {
    const Geometry hollow = read_geometry(
        options_for(write("hollow.geo", occ + "Box(1) = {0, 0, 0, 3, 3, 3};\nBox(2) = {1, 1, 1, 1, 1, 1};\n"
                                              "BooleanDifference(3) = { Volume{1}; Delete; }{ Volume{2}; Delete; };\n"
                                              "Physical Volume(\"shell\") = {3};\n")));
    EXPECT_NEAR(hollow.solid("shell")->volume(), 26, 1e-12);

    const Geometry prism = read_geometry(options_for(write(
        "prism.geo", unit_square + "out[] = Extrude {0, 0, 2} { Surface{1}; };\n"
                                   "Physical Volume(\"prism\") = {out[1]};\nPhysical Surface(\"lid\") = {out[0]};\n")));
    EXPECT_NEAR(prism.solid("prism")->volume(), 2, 1e-12);
    EXPECT_NEAR(prism.surface_set("lid")->surface.area(), 1, 1e-12);
}

TEST_F(ReadSolids, AMeshIsTakenAsItIs) {
    const std::string script = write("box.geo", occ +
                                                    "Box(1) = {0, 0, 0, 1, 1, 1};\nPhysical Volume(\"water\") = {1};\n"
                                                    "Physical Surface(\"wall\") = {1, 2};\nMesh.SaveAll = 1;\n"
                                                    "Mesh 2;\nSave \"" +
                                                    path("box.msh") + "\";\n");
    GeometryOptions trusted = options_for(script);
    trusted.trust = Trust::full;
    (void)read_geometry(trusted);
    const Geometry geometry = read_geometry(options_for(path("box.msh")));
    EXPECT_NEAR(geometry.solid("water")->volume(), 1, 1e-12);
    EXPECT_NEAR(geometry.surface_set("wall")->surface.area(), 2, 1e-12);
}

}  // namespace
}  // namespace dmp::tests::read_solids_tests
