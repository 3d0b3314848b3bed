// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// `dmp inspect` and `dmp new`, and geometries that another process reads.
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "tests/end_to_end/program.hpp"

namespace dmp::tests::geometries_tests {

namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

/// A tube of 4 x 1 x 1 along x with eight sides, closed, as OBJ.
std::string tube(double scale = 1) {
    std::string text;
    const double c = 0.5, s = 0.353553390593;
    const double ring[8][2] = {{c, 0}, {s, s}, {0, c}, {-s, s}, {-c, 0}, {-s, -s}, {0, -c}, {s, -s}};
    for (const double x : {0.0, 4.0})
        for (const auto& [y, z] : ring)
            text += "v " + std::to_string(scale * x) + " " + std::to_string(scale * y) + " " +
                    std::to_string(scale * z) + "\n";
    text += "f 8 7 6 5 4 3 2 1\nf 9 10 11 12 13 14 15 16\n";
    for (int k = 1; k <= 8; ++k) {
        const int next = k % 8 + 1;
        text += "f " + std::to_string(k) + " " + std::to_string(next) + " " + std::to_string(next + 8) + " " +
                std::to_string(k + 8) + "\n";
    }
    return text;
}

class Geometries : public testing::Test {
  protected:
    [[nodiscard]] Outcome dmp(const std::vector<std::string>& words, const Surroundings& with = {}) const {
        return run_dmp(folder_.path(), words, with);
    }
    /// A STEP file of a round pipe, 3 mm long and 1 mm wide, made by gmsh in its own process.
    void write_step() const {
        folder_.write("export.geo",
                      "SetFactory(\"OpenCASCADE\");\nCylinder(1) = {0, 0, 0, 3, 0, 0, 0.5};\n"
                      "Physical Volume(\"pipe\") = {1};\nSave \"pipe.step\";\n");
        EXPECT_EQ(dmp({"inspect", "export.geo", "--trust-geometry"}).code, 0);
    }
    CaseFolder folder_;
};

TEST_F(Geometries, InspectTellsPartsSizesAndThatTheUnitIsUnknown) {
    folder_.write("tube.obj", tube());
    Outcome shown = dmp({"inspect", "tube.obj"});
    EXPECT_EQ(shown.code, 0) << shown.errors;
    EXPECT_THAT(shown.output, AllOf(HasSubstr("unknown: the file does not say it"),
                                    HasSubstr("4 x 1 x 1 m, 4 x 1 x 1 mm or 4 x 1 x 1 um"),
                                    HasSubstr("tube  solid, watertight, 2.8284 units^3"), HasSubstr("28 triangles")));
    shown = dmp({"inspect", "tube.obj", "--unit", "mm"});
    EXPECT_THAT(shown.output, AllOf(HasSubstr("1 mm, as given"), HasSubstr("2.8284 mm^3")));
    shown = dmp({"inspect", "tube.obj", "--unit", "0.5 mm", "--json"});
    const auto json = nlohmann::json::parse(shown.output);
    EXPECT_EQ(json["unit"]["metres"], 5e-4);
    EXPECT_EQ(json["parts"][0]["name"], "tube");
    EXPECT_EQ(json["parts"][0]["watertight"], true);
    EXPECT_NEAR(json["parts"][0]["volume"].get<double>(), 2.8284e-9 / 8, 1e-13);
    EXPECT_TRUE(nlohmann::json::parse(dmp({"inspect", "tube.obj", "--json"}).output)["unit"].is_null());
}

TEST_F(Geometries, WhatIsWrongIsSaidInOneMessage) {
    folder_.write("broken.step", "ISO-10303-21;\nHEADER;\nENDSEC;\nDATA;\n#1=CARTESIAN_POINT('',(0.,0.");
    folder_.write("nan.obj", "v nan 0 0\n");
    for (const auto& [words, says] : std::vector<std::pair<std::vector<std::string>, std::string>>{
             {{"inspect", "none.step"}, "the geometry 'none.step' does not exist"},
             {{"inspect", "."}, "the geometry '.' is a folder"},
             {{"inspect", "broken.step"}, "broken.step"},
             {{"inspect", "nan.obj"}, "nan.obj:1:1: corner 1 is not finite"},
             {{"inspect", "nan.obj", "--unit", "s"}, "--unit"},
             {{"inspect", "nan.obj", "--unit", "-1 mm"}, "'-1 mm' is no length of a unit"}}) {
        const Outcome outcome = dmp(words);
        EXPECT_EQ(outcome.code, 2) << outcome.output;
        EXPECT_THAT(outcome.errors, HasSubstr(says));
        EXPECT_EQ(outcome.output, "");
    }
}

TEST_F(Geometries, ANewSceneOfAStepFileRunsAsItIs) {
    write_step();
    const Outcome made = dmp({"new", "my_pipe", "--from", "pipe.step"});
    ASSERT_EQ(made.code, 0) << made.errors;
    EXPECT_THAT(made.output, AllOf(HasSubstr("'pipe' is the fluid: the only body"), HasSubstr("it is water"),
                                   HasSubstr("what leaves along x comes in again"),
                                   HasSubstr("it starts from the parabolic profile"), HasSubstr("Next: "),
                                   HasSubstr("dmp mesh my_pipe\n")));
    EXPECT_THAT(folder_.read("my_pipe/scene.toml"), HasSubstr("except = [\"inlet\", \"outlet\"]"));
    const Outcome run = dmp({"run", "my_pipe", "--until", "0.5 ms", "--set", "particles.spacing=\"0.1 mm\"", "--set",
                             "output.pictures=false", "--threads", "1"});
    EXPECT_EQ(run.code, 0) << run.errors;
    EXPECT_THAT(run.output, AllOf(HasSubstr("Done"), HasSubstr("smallest to largest\n    largest_speed  ")));
    const Outcome again = dmp({"new", "my_pipe", "--from", "pipe.step"});
    EXPECT_EQ(again.code, 2);
    EXPECT_THAT(again.errors, HasSubstr("there is something of this name already"));
}

TEST_F(Geometries, ANewSceneOfAnArteryWithAStentKnowsBloodAndWhatStandsInIt) {
    const std::string cad_geometry = DMP_SOURCE_DIR "/cases/stent/stent.step";
    const Outcome made = dmp({"new", "my_stent", "--from", cad_geometry});
    ASSERT_EQ(made.code, 0) << made.errors;
    EXPECT_THAT(made.output,
                AllOf(HasSubstr("'blood' is the fluid, by its name"),
                      HasSubstr("it is blood, Newtonian: 1060 kg/m^3, 3.5 mPa s"), HasSubstr("'stent', 'wall'"),
                      HasSubstr("the parabolic profile of a round pipe, as if nothing stood in it")));
    EXPECT_THAT(folder_.read("my_stent/scene.toml"),
                AllOf(HasSubstr("spacing = \"0.15 mm\""), HasSubstr("(1 - (y^2 + z^2) / (1.5 mm)^2)"),
                      HasSubstr("viscosity = \"3.5 mPa*s\"")));
    const Outcome run = dmp({"run", "my_stent", "--until", "1 ms", "--set", "particles.spacing=\"0.3 mm\"", "--set",
                             "output.pictures=false", "--threads", "1"});
    EXPECT_EQ(run.code, 0) << run.errors;
}

TEST_F(Geometries, ANewSceneOfTrianglesNeedsTheirUnit) {
    folder_.write("tube.obj", tube());
    const Outcome refused = dmp({"new", "my_tube", "--from", "tube.obj"});
    EXPECT_EQ(refused.code, 2);
    EXPECT_THAT(refused.errors, HasSubstr("4 x 1 x 1 mm"));
    EXPECT_FALSE(std::filesystem::exists(folder_.path() / "my_tube"));
    ASSERT_EQ(dmp({"new", "my_tube", "--from", "tube.obj", "--unit", "mm"}).code, 0);
    folder_.replace("my_tube/scene.toml", "[[measure]]\nname = \"largest_speed\"\nkind = \"largest_speed\"\n", "");
    const Outcome run = dmp({"run", "my_tube", "--until", "0.5 ms", "--set", "particles.spacing=\"0.1 mm\"", "--set",
                             "output.pictures=false", "--threads", "1"});
    EXPECT_EQ(run.code, 0) << run.errors;
    EXPECT_THAT(run.output, Not(HasSubstr("smallest to largest"))) << "nothing was measured";
}

TEST_F(Geometries, ANewSceneOfAGmshGeometryNeedsItsUnit) {
    folder_.write(
        "pipe.geo",
        "SetFactory(\"OpenCASCADE\");\nCylinder(1) = {0, 0, 0, 30, 0, 0, 5};\nPhysical Volume(\"b\") = {1};\n");
    const Outcome refused = dmp({"new", "pipe", "--from", "pipe.geo"});
    EXPECT_EQ(refused.code, 2);
    EXPECT_THAT(refused.errors, AllOf(HasSubstr("is it 30 x "), HasSubstr("--unit")));
    EXPECT_EQ(dmp({"new", "pipe", "--from", "pipe.geo", "--unit", "mm"}).code, 0);
    EXPECT_THAT(folder_.read("pipe/scene.toml"), HasSubstr("unit = \"1 mm\""));
}

TEST_F(Geometries, ASeamThatARunWeldsMakesAFirstSceneToo) {
    // The first end has corners of its own, off those of the tube by what rounding leaves.
    std::string text = tube();
    const std::size_t faces = text.find("f 8 7 6 5 4 3 2 1");
    std::istringstream corners(text.substr(0, faces));
    std::string doubled, line;
    for (int k = 0; k < 8 && std::getline(corners, line); ++k) {
        const std::size_t x = line.find(' ') + 1;
        doubled += line.substr(0, x) + "1e-15" + line.substr(line.find(' ', x)) + "\n";
    }
    text.insert(faces, doubled);
    text.replace(text.find("f 8 7 6 5 4 3 2 1"), 17, "f 24 23 22 21 20 19 18 17");
    folder_.write("tube.obj", text);
    const Outcome made = dmp({"new", "my_tube", "--from", "tube.obj", "--unit", "mm"});
    ASSERT_EQ(made.code, 0) << made.errors;
    const Outcome run = dmp({"run", "my_tube", "--until", "0.5 ms", "--set", "particles.spacing=\"0.1 mm\"", "--set",
                             "output.pictures=false", "--threads", "1"});
    EXPECT_EQ(run.code, 0) << run.errors;
}

TEST_F(Geometries, AFaceThatBoundsNoBodyIsListedAndIsASheetInTheFluid) {
    folder_.write("export.geo",
                  "SetFactory(\"OpenCASCADE\");\nCylinder(1) = {0, 0, 0, 30, 0, 0, 5};\n"
                  "Rectangle(50) = {10, -3, 0, 8, 6};\nSave \"artery.step\";\nSave \"artery.brep\";\n"
                  "Physical Volume(\"artery\") = {1};\n");
    ASSERT_EQ(dmp({"inspect", "export.geo", "--trust-geometry"}).code, 0);
    const Outcome shown = dmp({"inspect", "artery.step"});
    EXPECT_THAT(shown.output, AllOf(HasSubstr("face_1  surface, 48 mm^2, box 8 x 6 x 0 mm"),
                                    HasSubstr("; no solid: it bounds no body of the file"),
                                    HasSubstr("Flat ends, which are walls unless a scene selects them for a period")));
    EXPECT_THAT(dmp({"inspect", "artery.brep", "--unit", "mm"}).output, HasSubstr("face_1  surface, 48 mm^2"));
    const Outcome made = dmp({"new", "artery", "--from", "artery.step"});
    ASSERT_EQ(made.code, 0) << made.errors;
    EXPECT_THAT(made.output, HasSubstr("'face_1' lies in the fluid: flexible, free; E = "));
    const Outcome run = dmp({"run", "artery", "--dry-run", "--set", "particles.spacing=\"1 mm\"", "--threads", "1"});
    EXPECT_EQ(run.code, 0) << run.errors;
    EXPECT_THAT(run.output, HasSubstr(" elastic"));
}

TEST_F(Geometries, AnEndOfABranchThatNothingClosesIsNamedAndSaidToBeAWall) {
    folder_.write("tee.geo",
                  "SetFactory(\"OpenCASCADE\");\nCylinder(1) = {-20, 0, 0, 40, 0, 0, 5};\n"
                  "Cylinder(2) = {0, 0, 0, 0, 20, 0, 4};\n"
                  "BooleanUnion(3) = { Volume{1}; Delete; }{ Volume{2}; Delete; };\nPhysical Volume(\"tee\") = {3};\n");
    const Outcome shown = dmp({"inspect", "tee.geo", "--unit", "mm"});
    EXPECT_THAT(shown.output,
                AllOf(HasSubstr("Flat ends, which are walls"), HasSubstr(" around (-20, "), HasSubstr(", 20, ")));
    EXPECT_EQ(
        nlohmann::json::parse(dmp({"inspect", "tee.geo", "--unit", "mm", "--json"}).output)["parts"][0]["flat_ends"]
            .size(),
        3U);
    const Outcome made = dmp({"new", "tee", "--from", "tee.geo", "--unit", "mm"});
    ASSERT_EQ(made.code, 0) << made.errors;
    EXPECT_THAT(made.output, AllOf(HasSubstr("the flat end of 50"),
                                   HasSubstr(" is a wall, 'closed_end_1': nothing flows through it"),
                                   HasSubstr("sticks to: 'closed_end_1', 'wall'")));
    EXPECT_THAT(folder_.read("tee/scene.toml"), AllOf(HasSubstr("name = \"closed_end_1\"\nof = \"tee\"\ny = \"20 mm\""),
                                                      HasSubstr("except = [\"inlet\", \"outlet\", \"closed_end_1\"]")));
    const Outcome run = dmp({"run", "tee", "--dry-run", "--set", "particles.spacing=\"1 mm\"", "--threads", "1"});
    EXPECT_EQ(run.code, 0) << run.errors;
}

TEST_F(Geometries, AClosedBodyBecomesABasinAtRest) {
    folder_.write("ball.geo",
                  "SetFactory(\"OpenCASCADE\");\nSphere(1) = {0, 0, 0, 0.001};\nPhysical Volume(\"b\") = {1};\n");
    const Outcome made = dmp({"new", "ball", "--from", "ball.geo", "--unit", "m"});
    ASSERT_EQ(made.code, 0) << made.errors;
    EXPECT_THAT(made.output, HasSubstr("it is enclosed, at rest and not driven"));
    const Outcome run = dmp({"run", "ball", "--until", "0.5 ms", "--set", "particles.spacing=\"0.2 mm\"", "--set",
                             "output.pictures=false", "--threads", "1"});
    EXPECT_EQ(run.code, 0) << run.errors;
}

TEST_F(Geometries, ASheetInTheFluidIsAShellHeldByTheWall) {
    folder_.write("duct.geo",
                  "SetFactory(\"OpenCASCADE\");\nBox(1) = {0, 0, 0, 0.004, 0.002, 0.002};\n"
                  "Point(101) = {0.002, 0, 0.0005};\nPoint(102) = {0.002, 0.0015, 0.0005};\n"
                  "Point(103) = {0.002, 0.0015, 0.0015};\nPoint(104) = {0.002, 0, 0.0015};\n"
                  "Line(101) = {101, 102};\nLine(102) = {102, 103};\nLine(103) = {103, 104};\nLine(104) = {104, 101};\n"
                  "Curve Loop(101) = {101, 102, 103, 104};\nPlane Surface(101) = {101};\n"
                  "Physical Volume(\"water\") = {1};\nPhysical Surface(\"flap\") = {101};\n");
    const Outcome made = dmp({"new", "duct", "--from", "duct.geo", "--unit", "m"});
    ASSERT_EQ(made.code, 0) << made.errors;
    EXPECT_THAT(made.output, AllOf(HasSubstr("'flap' lies in the fluid: flexible, clamped at 'wall'"),
                                   HasSubstr("sticks to: 'wall'")));
    const Outcome run = dmp({"run", "duct", "--until", "0.2 ms", "--set", "particles.spacing=\"0.125 mm\"", "--set",
                             "output.pictures=false", "--threads", "1"});
    EXPECT_EQ(run.code, 0) << run.errors;
}

/// A case's geometry as a newcomer takes it: a scene is made of it, and runs with nothing changed but fewer steps.
class PlanarGeometries : public Geometries, public testing::WithParamInterface<const char*> {};

TEST_P(PlanarGeometries, MakeAFirstSceneThatRunsAsItIs) {
    const std::string name = GetParam();
    const std::string cad_geometry = DMP_SOURCE_DIR "/cases/" + name + "/" + name + ".geo";
    const Outcome made = dmp({"new", "mine", "--from", cad_geometry, "--unit", "m"});
    ASSERT_EQ(made.code, 0) << made.errors;
    const Outcome run = dmp({"run", "mine", "--until", "0.2 ms", "--set", "output.pictures=false", "--threads", "1"});
    EXPECT_EQ(run.code, 0) << run.errors;
    EXPECT_THAT(run.output, HasSubstr("Done"));
}

INSTANTIATE_TEST_SUITE_P(OfCases, PlanarGeometries,
                         testing::Values("vein_valve", "bent_channel", "heart_valve", "double_vein_valve", "clotting"),
                         [](const auto& one) { return std::string(one.param); });

TEST_F(Geometries, AVeinValveHasWallsLeafletsAndAPeriod) {
    const Outcome made =
        dmp({"new", "valve", "--from", DMP_SOURCE_DIR "/cases/vein_valve/vein_valve.geo", "--unit", "m"});
    ASSERT_EQ(made.code, 0) << made.errors;
    EXPECT_THAT(made.output,
                AllOf(HasSubstr("'blood' is the fluid: the only area"), HasSubstr("it is blood, Newtonian"),
                      HasSubstr("walls that do not move and that the fluid sticks to: 'wall'"),
                      HasSubstr("'leaflets' lies in the fluid: flexible, clamped at 'leaflet_roots'"),
                      HasSubstr("what leaves along x comes in again"), HasSubstr("6 at the narrowest tip")));
    EXPECT_THAT(folder_.read("valve/scene.toml"),
                AllOf(HasSubstr("dimension = 2"), HasSubstr("kind = \"elastic\""), HasSubstr("periodic = [\"x\"]")));
}

TEST_F(Geometries, EdgesWithoutANameAreSelected) {
    // A closed basin with a flap on its floor, of which only the area and the flap have a name.
    folder_.write(
        "basin.geo",
        "Point(1) = {0, 0, 0};\nPoint(2) = {0.03, 0, 0};\nPoint(3) = {0.03, 0.01, 0};\nPoint(4) = {0, 0.008, 0};\n"
        "Line(1) = {1, 2};\nLine(2) = {2, 3};\nLine(3) = {3, 4};\nLine(4) = {4, 1};\n"
        "Curve Loop(1) = {1, 2, 3, 4};\nPlane Surface(1) = {1};\n"
        "Point(5) = {0.01, 0, 0};\nPoint(6) = {0.01, 0.005, 0};\nLine(5) = {5, 6};\n"
        "Physical Surface(\"water\") = {1};\nPhysical Curve(\"flap\") = {5};\n");
    const Outcome made = dmp({"new", "basin", "--from", "basin.geo", "--unit", "m"});
    ASSERT_EQ(made.code, 0) << made.errors;
    EXPECT_THAT(made.output, AllOf(HasSubstr("sticks to: 'wall'"),
                                   HasSubstr("'flap' lies in the fluid: flexible, clamped at 'wall'"),
                                   HasSubstr("it is enclosed, at rest and not driven")));
    const Outcome run = dmp({"run", "basin", "--until", "0.2 ms", "--set", "output.pictures=false", "--threads", "1"});
    EXPECT_EQ(run.code, 0) << run.errors;
}

TEST_F(Geometries, AFaceOfAStepFileIsADrawingInThePlane) {
    folder_.write("export.geo",
                  "SetFactory(\"OpenCASCADE\");\nRectangle(1) = {0, 0, 0, 12, 3};\nDisk(2) = {4, 1.5, 0, 0.5};\n"
                  "BooleanDifference(3) = { Surface{1}; Delete; }{ Surface{2}; Delete; };\n"
                  "Physical Surface(\"water\") = {3};\nSave \"channel.step\";\n");
    ASSERT_EQ(dmp({"inspect", "export.geo", "--trust-geometry"}).code, 0);
    const Outcome shown = dmp({"inspect", "channel.step"});
    EXPECT_THAT(shown.output, AllOf(HasSubstr("in 2-D"), HasSubstr("12 x 3 x 0 mm"), HasSubstr("35.2")));
    const Outcome made = dmp({"new", "channel", "--from", "channel.step"});
    ASSERT_EQ(made.code, 0) << made.errors;
    EXPECT_THAT(made.output, AllOf(HasSubstr("what leaves along x comes in again"), HasSubstr("sticks to: 'wall'")));
    const Outcome run =
        dmp({"run", "channel", "--until", "0.5 ms", "--set", "output.pictures=false", "--threads", "1"});
    EXPECT_EQ(run.code, 0) << run.errors;
}

TEST_F(Geometries, ANewSceneKnowsSurfacesAndPointsThatTheDrawingNames) {
    folder_.write("duct.geo",
                  "SetFactory(\"OpenCASCADE\");\nBox(1) = {0, 0, 0, 0.004, 0.001, 0.001};\n"
                  "Physical Volume(\"water\") = {1};\nPhysical Surface(\"floor\") = {3};\n"
                  "Physical Point(\"corner\") = {1};\n");
    const Outcome made = dmp({"new", "duct", "--from", "duct.geo", "--unit", "m"});
    ASSERT_EQ(made.code, 0) << made.errors;
    EXPECT_THAT(made.output, HasSubstr("'floor', 'wall'"));
    const Outcome run = dmp({"run", "duct", "--until", "0.2 ms", "--set", "particles.spacing=\"0.1 mm\"", "--set",
                             "output.pictures=false", "--threads", "1"});
    EXPECT_EQ(run.code, 0) << run.errors;
}

}  // namespace

}  // namespace dmp::tests::geometries_tests
