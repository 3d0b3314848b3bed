// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/select_faces.hpp"

#include <numbers>

#include <gmock/gmock.h>

#include "temporary_geometry.hpp"
#include "tests/modules.hpp"
#include "tests/unit/thrown.hpp"

namespace dmp::tests::select_faces_tests {
namespace {

using ::testing::HasSubstr;

class SelectFaces : public GeometryFileTest {
  protected:
    /// A pipe of radius 1 along x, from 0 to 4.
    void SetUp() override {
        GeometryFileTest::SetUp();
        auto options = options_for(write("pipe.geo",
                                         "SetFactory(\"OpenCASCADE\");\nCylinder(1) = {0, 0, 0, 4, 0, 0, 1};\n"
                                         "Physical Volume(\"blood\") = {1};\n"));
        options.chord_error = 0.01;
        pipe_ = read_geometry(options);
    }

    Geometry pipe_;

    double area(const FaceSelection& selection) {
        select_faces(pipe_, {selection});
        return pipe_.surface_set(selection.name)->surface.area();
    }
};

TEST_F(SelectFaces, ByPlaneBoxNormalAndWhatIsLeft) {
    const double disc = std::numbers::pi;  // less what its edge of chords leaves out
    FaceSelection inlet{.name = "inlet", .of = "blood"};
    inlet.in_plane[0] = 0;
    EXPECT_NEAR(area(inlet), disc, 0.06);
    FaceSelection outlet{.name = "outlet", .of = "blood"};
    outlet.normal = Vec(2, 0, 0);
    outlet.angle = 0.1;
    EXPECT_NEAR(area(outlet), disc, 0.06);
    EXPECT_NEAR(pipe_.surface_set("outlet")->surface.corners[0].x(), 4, 1e-9);
    FaceSelection boxed{.name = "boxed", .of = "blood"};
    boxed.in_box = Box{.low = Vec(5, 2, 2), .high = Vec(3.9, -2, -2)};  // corners in any order
    EXPECT_NEAR(area(boxed), disc, 0.06);
    FaceSelection wall{.name = "wall", .of = "blood"};
    wall.except = {"inlet", "outlet"};
    const double ends = pipe_.surface_set("inlet")->surface.area() + pipe_.surface_set("outlet")->surface.area();
    EXPECT_NEAR(area(wall), pipe_.solid("blood")->surface.area() - ends, 1e-9);
    EXPECT_NEAR(area(wall = {.name = "both", .of = "wall"}), 2 * std::numbers::pi * 4, 0.1);
}

TEST_F(SelectFaces, WhatIsNotThereIsAnError) {
    const auto fault = [&](const FaceSelection& selection) {
        return text_thrown<InputError>([&] { select_faces(pipe_, {selection}); });
    };
    FaceSelection selection{.name = "lid", .of = "blod", .location = {"scene.toml", 9, 1}};
    EXPECT_THAT(fault(selection),
                HasSubstr("scene.toml:9:1: selection 'lid': the geometry has no volume or surface 'blod'"));
    EXPECT_THAT(fault(selection), HasSubstr("did you mean 'blood'?"));
    selection.of = "blood";
    selection.in_plane[0] = 3;
    EXPECT_THAT(fault(selection), HasSubstr("no face of 'blood' is like that\n  'blood' has x from"));
    selection.except = {"rim"};
    EXPECT_THAT(fault(selection), HasSubstr("there is no surface 'rim' to except"));
    selection.name = "blood";
    EXPECT_THAT(fault(selection), HasSubstr("the geometry has a 'blood' already"));
}

using SelectCurves = GeometryFileTest;

TEST_F(SelectCurves, ByPlaceDirectionAndWhatIsLeft) {
    Geometry square = read(unit_square + "Physical Surface(\"water\") = {1};\nPhysical Curve(\"floor\") = {1};\n");
    FaceSelection left{.name = "left", .of = "water"};
    left.in_plane[0] = 0;
    FaceSelection up{.name = "lid", .of = "water"};
    up.normal = Vec(0, 3, 0);
    up.angle = 0.2;
    FaceSelection boxed{.name = "boxed", .of = "water"};
    boxed.in_box = Box{.low = Vec(0.9, -1, 0), .high = Vec(2, 2, 0)};
    FaceSelection rest{.name = "rest", .of = "water", .except = {"left", "lid", "floor"}};
    FaceSelection both{.name = "both", .of = "water", .except = {"left"}};
    select_faces(square, {left, up, boxed, rest, both});
    EXPECT_EQ(square.curve_set("left")->length(), 1);
    EXPECT_EQ(square.curve_set("left")->nearest(Vec(0, 0.5, 0)).distance, 0);
    EXPECT_EQ(square.curve_set("lid")->nearest(Vec(0.5, 1, 0)).distance, 0);
    EXPECT_EQ(square.curve_set("lid")->length(), 1);
    for (const char* right : {"boxed", "rest"}) {
        EXPECT_EQ(square.curve_set(right)->length(), 1) << right;
        EXPECT_EQ(square.curve_set(right)->nearest(Vec(1, 0.5, 0)).distance, 0) << right;
    }
    ASSERT_EQ(square.curve_set("both")->pieces.size(), 1U);  // one chain
    EXPECT_EQ(square.curve_set("both")->length(), 3);
    const auto fault = [&](const FaceSelection& selection) {
        return text_thrown<InputError>([&] { select_faces(square, {selection}); });
    };
    FaceSelection wrong{.name = "rim", .of = "wter", .location = {"scene.toml", 9, 1}};
    EXPECT_THAT(fault(wrong), HasSubstr("scene.toml:9:1: selection 'rim': the geometry has no area or curve 'wter'"));
    EXPECT_THAT(fault(wrong), HasSubstr("did you mean 'water'?"));
    wrong.of = "water";
    wrong.in_plane[1] = 0.5;
    EXPECT_THAT(fault(wrong), HasSubstr("no curve of 'water' is like that\n  'water' has x from 0 m to 1 m, y from"));
    wrong.except = {"hole"};
    EXPECT_THAT(fault(wrong), HasSubstr("there is no curve 'hole' to except"));
}

}  // namespace
}  // namespace dmp::tests::select_faces_tests
