// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Geometries that are broken and can be used all the same: what was done to them is said.
#include <numbers>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "tests/end_to_end/program.hpp"
#include "tests/end_to_end/triangle_texts.hpp"
#include "tests/unit/geometry/surface_shapes.hpp"

namespace dmp::tests::repaired_geometries_tests {

namespace {

using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;

class RepairedGeometries : public testing::Test {
  protected:
    /// `dmp mesh` of the scene: what it says, and its report.
    std::string mesh(const std::string& scene) {
        folder_.write("scene.toml", scene);
        const Outcome outcome = run_dmp(folder_.path(), {"mesh", ".", "--out", "out"});
        EXPECT_EQ(outcome.code, 0) << outcome.errors;
        if (outcome.code != 0) return {};
        const auto json = nlohmann::json::parse(folder_.read("out/mesh_report.json"));
        notes_ = json["notes"].get<std::vector<std::string>>();
        for (const auto& part : json["parts"])
            if (part["name"] == "body") {
                initial_ = 1e9 * part["drawn"].get<double>();
                filled_ = 1e9 * part["filled"].get<double>();
            }
        for (const std::string& note : notes_) EXPECT_THAT(outcome.output, HasSubstr("note: " + note));
        return outcome.output;
    }
    CaseFolder folder_;
    std::vector<std::string> notes_;
    double initial_ = 0, filled_ = 0;  ///< volume of "body" [mm^3]
};

TEST_F(RepairedGeometries, ABallWithHolesAndFacesThatAreTurnedIsABallAgain) {
    TriangleSurface surface = ball(32);
    const double volume = surface.enclosed_volume();
    std::size_t turned = 0;
    for (std::size_t t = 0; t < surface.triangles.size(); t += 3, ++turned) flip(surface, t);
    // Two neighbours and, on the other side, a single one; none of them is turned.
    surface.triangles.erase(surface.triangles.begin() + 1300);
    surface.triangles.erase(surface.triangles.begin() + 100, surface.triangles.begin() + 102);
    folder_.write("body.stl", stl_text(surface, "body"));
    mesh(scene_of("body.stl", "0.05 mm"));
    EXPECT_THAT(notes_, Contains("body: " + std::to_string(turned) + " triangles turned to face outward"));
    EXPECT_THAT(notes_, Contains(AllOf(HasSubstr("body: a hole of 4 edges around ("), HasSubstr(" spacings around, "),
                                       HasSubstr("filled with 2 triangles"))));
    EXPECT_THAT(notes_,
                Contains(AllOf(HasSubstr("body: a hole of 3 edges around ("), HasSubstr("filled with 1 triangle"))));
    EXPECT_NEAR(initial_, volume, 1e-3 * volume);
    EXPECT_NEAR(filled_, volume, 0.01 * volume) << "40 spacings across";
    EXPECT_NEAR(filled_, 4.0 / 3 * std::numbers::pi, 0.02 * 4.0 / 3 * std::numbers::pi);
}

TEST_F(RepairedGeometries, ABodyInsideOutIsTurned) {
    TriangleSurface surface = ball(8);
    for (std::size_t t = 0; t < surface.triangles.size(); ++t) flip(surface, t);
    folder_.write("body.stl", stl_text(surface, "body"));
    mesh(scene_of("body.stl", "0.2 mm"));
    EXPECT_THAT(notes_, Contains("512 of the 512 triangles of 'body' faced inward and were turned"));
    EXPECT_NEAR(initial_, ball(8).enclosed_volume(), 1e-6);
}

TEST_F(RepairedGeometries, ABinaryFileWhoseHeaderSaysSolidIsRead) {
    folder_.write("body.stl", stl_binary(box({0, 0, 0}, {1, 1, 1})));
    mesh(scene_of("body.stl"));
    EXPECT_EQ(notes_.size(), 0U);
    EXPECT_NEAR(filled_, 1, 1e-9);
}

TEST_F(RepairedGeometries, ASurfaceThatGoesThroughItselfIsSaidWithItsPlace) {
    TriangleSurface surface = box({0, 0, 0}, {2, 2, 2});
    for (std::size_t k = 0; k < 8; ++k)
        if (surface.corners[k] == Vec(2, 2, 2)) surface.corners[k] = Vec(0.9, 0.8, -1);  // through the bottom
    folder_.write("body.stl", stl_text(surface, "body"));
    mesh(scene_of("body.stl"));
    EXPECT_THAT(notes_, Contains(testing::MatchesRegex(
                            "'body' meets itself in [0-9]+ pairs of triangles, the first at \\(.*, .*, .*\\) mm: what "
                            "lies inside any part of it counts as inside")));
    EXPECT_THAT(run_dmp(folder_.path(), {"inspect", "body.stl", "--unit", "mm"}).output,
                HasSubstr("note: 'body' meets itself in "));
}

TEST_F(RepairedGeometries, BodiesOfOneNameThatCrossAreJoined) {
    TriangleSurface surface = box({0, 0, 0}, {2, 2, 2});
    append(surface, box({1, 0.9, 0.8}, {4, 1.5, 1.6}));
    for (const bool inward : {false, true}) {
        if (inward)
            for (std::size_t t = 12; t < 24; ++t) flip(surface, t);
        folder_.write("body.stl", stl_text(surface, "body"));
        mesh(scene_of("body.stl"));
        EXPECT_THAT(notes_, Contains(HasSubstr("'body' meets itself in ")));
        EXPECT_NEAR(filled_, 8 + 2 * 0.6 * 0.8, 1e-6) << "what both have counts once";
    }
}

TEST_F(RepairedGeometries, SolidsThatOverlapAreSaidWithTheirPlace) {
    folder_.write("two.stl",
                  stl_text(box({0, 0, 0}, {2, 2, 2}), "body") + stl_text(box({0.5, 0.6, 1}, {1, 1.1, 3}), "post"));
    mesh(scene_of("two.stl") + "[[part]]\nname = \"post\"\nkind = \"rigid\"\n");
    EXPECT_THAT(notes_, Contains(testing::MatchesRegex(
                            "'post' and 'body' share 0.25 mm.3, around \\(.*, .*, 2\\) mm: rigid bodies take the room "
                            "first, then fluids in the scene's order")));
    EXPECT_THAT(notes_, Contains("body: 250 lattice points left to what has the room before it"));
    EXPECT_NEAR(filled_, 8 - 0.25, 1e-6);
    EXPECT_THAT(run_dmp(folder_.path(), {"inspect", "two.stl"}).output,
                HasSubstr("note: 'body' and 'post' share 0.25 units^3, around ("));
}

TEST_F(RepairedGeometries, BodiesThatTouchAlongARoundSurfaceDoNotOverlap) {
    folder_.write("pipe.geo",
                  "SetFactory(\"OpenCASCADE\");\nCylinder(1) = {0, 0, 0, 0, 0, 2, 0.5};\n"
                  "Cylinder(2) = {0, 0, 0, 0, 0, 2, 0.8};\nCylinder(3) = {0, 0, 0, 0, 0, 2, 0.5};\n"
                  "BooleanDifference(4) = { Volume{2}; Delete; }{ Volume{3}; Delete; };\n"
                  "Physical Volume(\"body\") = {1};\nPhysical Volume(\"tube\") = {4};\n");
    mesh(scene_of("pipe.geo", "0.2 mm") + "[[part]]\nname = \"tube\"\nkind = \"rigid\"\n");
    EXPECT_THAT(notes_, Not(Contains(HasSubstr(" share "))));
    EXPECT_THAT(notes_, Not(Contains(HasSubstr(" cross "))));
}

// Whatever took time with the square of their number would run into ctest's limit.
TEST_F(RepairedGeometries, AMillionTrianglesAreASolid) {
    folder_.write("ball.stl", stl_binary(ball(354)));
    const Outcome outcome = run_dmp(folder_.path(), {"inspect", "ball.stl", "--unit", "mm"});
    EXPECT_EQ(outcome.code, 0) << outcome.errors;
    EXPECT_THAT(outcome.output, HasSubstr("solid, watertight, 4.18"));
    EXPECT_THAT(outcome.output, HasSubstr("1 002 528 triangles"));
}

}  // namespace

}  // namespace dmp::tests::repaired_geometries_tests
