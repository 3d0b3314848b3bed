// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Geometries that are broken in each way that files are broken: every kind ends with exit code 2, says what is wrong,
// where, and what to do. What can be used all the same is in mended_drawings.cpp.
#include <array>
#include <cmath>
#include <ostream>

#include <gmock/gmock.h>

#include "cli/commands.hpp"
#include "geometry/geometry_process.hpp"
#include "tests/end_to_end/program.hpp"
#include "tests/end_to_end/triangle_texts.hpp"
#include "tests/modules.hpp"
#include "tests/unit/geometry/surface_shapes.hpp"

namespace dmp::tests::broken_geometry_files_tests {

namespace {

struct Broken {
    std::string name;
    std::string file;
    std::string contents;
    std::string scene;              ///< empty: `dmp inspect` of the file
    std::vector<std::string> says;  ///< all of these stand in the message
};

std::ostream& operator<<(std::ostream& stream, const Broken& broken) { return stream << broken.name; }

/// With `found`, which must be there, replaced once.
std::string with(std::string text, const std::string& found, const std::string& replacement) {
    const auto at = text.find(found);
    EXPECT_NE(at, std::string::npos) << found;
    return text.replace(at, found.size(), replacement);
}

/// A cube of 1 in each format, its sides as quadrangles.
const std::array<const char*, 8> corners{"0 0 0", "1 0 0", "1 1 0", "0 1 0", "0 0 1", "1 0 1", "1 1 1", "0 1 1"};
const std::array<std::array<int, 4>, 6> sides{
    {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}};

std::string listed(const std::string& before_corner, const std::string& before_side, int first) {
    std::string text;
    for (const char* corner : corners) text += before_corner + corner + "\n";
    for (const auto& side : sides) {
        text += before_side;
        for (const int k : side) text += " " + std::to_string(k + first);
        text += "\n";
    }
    return text;
}
const std::string obj = listed("v ", "f", 1);
const std::string off = "OFF\n8 6 0\n" + listed("", "4", 0);
const std::string ply =
    "ply\nformat ascii 1.0\nelement vertex 8\nproperty float x\nproperty float y\nproperty float z\n"
    "element face 6\nproperty list uchar int vertex_indices\nend_header\n" +
    listed("", "4", 0);
const std::string stl = stl_text(cube(), "body");

/// A flat box, its upper and lower side divided along different diagonals: closed, and without volume.
TriangleSurface flat_box() {
    TriangleSurface flat = box({0, 0, 0}, {1, 1, 0});
    flat.triangles[0] = {0, 2, 3};
    flat.triangles[1] = {0, 3, 1};
    return flat;
}

TriangleSurface without_a_side() {
    TriangleSurface surface = cube();
    surface.triangles.resize(10);  // x = 1
    return surface;
}

/// Three triangles on one edge.
TriangleSurface open_book() {
    TriangleSurface surface;
    surface.corners = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {-1, 0, 0}, {0, 1, 0}};
    surface.triangles = {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}};
    return surface;
}

TriangleSurface at_infinity() {
    TriangleSurface surface = cube();
    surface.corners[7] = Vec(1, HUGE_VAL, 1);
    return surface;
}

const std::string cut_step =
    "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\nENDSEC;\nDATA;\n#1=CARTESIAN_POINT('',(0.,0.";
const std::string occ = "SetFactory(\"OpenCASCADE\");\n";

std::vector<Broken> broken_files() {
    const std::string mesh_of_stl = scene_of("body.stl");
    return {
        // STL
        {"StlEmpty", "body.stl", "", mesh_of_stl, {"body.stl' is empty", "export it again"}},
        {"StlBinaryCutOff",
         "body.stl",
         stl_binary(cube()).substr(0, 400),
         mesh_of_stl,
         {"cut off", "for its 12 triangles it needs 684 bytes, and it has 400"}},
        {"StlBinaryAndMore", "body.stl", stl_binary(cube()) + "and more", {}, {"needs 684 bytes, and it has 692"}},
        {"StlWithoutAUnit",
         "body.stl",
         stl,
         scene_of("body.stl", "0.1 mm", ""),
         {"scene.toml:4:8:", "1 x 1 x 1 m, 1 x 1 x 1 mm or 1 x 1 x 1 um", "geometry.unit"}},
        {"StlWithoutItsLastEndfacet",
         "body.stl",
         stl.substr(0, stl.rfind("endfacet")) + "endsolid body\n",
         mesh_of_stl,
         {"body.stl:85:1:", "the triangle before this line has no 'endfacet'"}},
        {"StlTextWithNan",
         "body.stl",
         with(stl, "vertex 1 0 0", "vertex nan 0 0"),
         {},
         {"body.stl:6:1:", "vertex nan"}},
        {"StlBinaryWithInfinity", "body.stl", stl_binary(at_infinity()), mesh_of_stl, {"triangle 3 ", "not finite"}},
        {"StlThatIsAPicture", "body.stl", "\x89PNG\r\n\x1a\n" + std::string(200, '\7'), {}, {"is no STL file"}},
        // OBJ, OFF, PLY
        {"ObjCornerBeyondTheLast", "body.obj", obj + "f 1 2 9\n", {}, {"body.obj:15:1:", "corner 9", "8 so far"}},
        {"ObjCornerZero", "body.obj", obj + "f 0 1 2\n", {}, {"body.obj:15:1:", "a face has corner 0"}},
        {"ObjCornerBeforeTheFirst", "body.obj", obj + "f -1 -2 -9\n", {}, {"body.obj:15:1:", "corner -9"}},
        {"ObjWithNan", "body.obj", with(obj, "v 1 1 0", "v 1 nan 0"), {}, {"body.obj:3:1:", "corner 3 is not finite"}},
        {"OffTooFewFaces", "body.off", with(off, "8 6 0", "8 5 0"), {}, {"body.off:16:1:", "after the 5 faces"}},
        {"OffCountsBeyondReason",
         "body.off",
         with(off, "8 6 0", "800000000000 6 0"),
         {},
         {"body.off:2:1:", "more than its"}},
        {"PlyTooManyVertices",
         "body.ply",
         with(ply, "vertex 8", "vertex 9"),
         {},
         {"body.ply:19:1:", "face 0 has 2 corners"}},
        {"PlyTooFewFaces", "body.ply", with(ply, "face 6", "face 5"), {}, {"after the last 'face'"}},
        {"PlyCountsBeyondReason", "body.ply", with(ply, "face 6", "face 60000000000"), {}, {"more than the file's"}},
        {"PlyWithNan", "body.ply", with(ply, "1 1 0", "1 nan 0"), {}, {"body.ply:12:1:", "vertex 2 is not finite"}},
        // bodies
        {"ANotClosedBody",
         "body.stl",
         stl_text(without_a_side(), "body"),
         scene_of("body.stl", "0.125 mm"),
         {"solid 'body' is not closed and cannot be repaired", "4 edges with one triangle", "_bad_triangles.vtp"}},
        {"AnEdgeOfThreeTriangles",
         "body.stl",
         stl_text(open_book(), "body"),
         scene_of("body.stl", "0.125 mm"),
         {"6 edges with one triangle, 1 with more than two", "triangles of sheets", "_bad_triangles.vtp"}},
        {"ABodyWithoutVolume",
         "body.stl",
         stl_text(flat_box(), "body"),
         mesh_of_stl,
         {"closed, but encloses no volume"}},
        {"ABodyBackToBack",
         "body.stl",
         stl_text(box({0, 0, 0}, {1, 1, 0}), "body"),
         mesh_of_stl,
         {"has no volume: its triangles lie back to back at ("}},
        {"ABodySmallerThanAParticle",
         "body.stl",
         stl,
         scene_of("body.stl", "2 mm"),
         {"'body' is smaller than a particle: it is 1 x 1 x 1 mm large, around (0.5, 0.5, 0.5) mm",
          "one unit of the geometry is 1 mm now"}},
        {"AUnitThatIsFarTooSmall",
         "body.stl",
         stl,
         scene_of("body.stl", "0.1 mm", "1 nm"),
         {"smaller than a particle"}},
        {"AUnitThatIsFarTooLarge",
         "body.stl",
         stl,
         scene_of("body.stl", "0.1 mm", "1 m"),
         {"1 x 1 x 1 m large and particles are 0.1 mm apart: that is a lattice of 1e+12 points",
          "one unit of the geometry is 1 m now"}},
        {"ABodyBeyondTheStars",
         "body.stl",
         with(stl, "vertex 1 0 0", "vertex 1e200 0 0"),
         mesh_of_stl,
         {"further out than any geometry can mean", "unit"}},
        // what gmsh reads
        {"StepCutOff",
         "body.step",
         cut_step,
         scene_of("body.step", "0.1 mm", ""),
         {"body.step: ", "Could not read file", "again"}},
        {"StepWithAUnitInTheScene", "body.step", cut_step, scene_of("body.step"), {"states its unit itself"}},
        {"IgesEmpty", "body.igs", "", {}, {"body.igs' is empty"}},
        {"IgesOfNoLines", "body.igs", "nothing of the kind\n", {}, {"body.igs: ", "no bodies", "whole"}},
        {"BrepOfNoShape", "body.brep", "DBRep_DrawableShape\n", {}, {"body.brep: ", "no bodies", "whole"}},
        {"MshOfAnUnknownVersion",
         "body.msh",
         "$MeshFormat\n9.7 0 8\n$EndMeshFormat\n",
         {},
         {"Unknown MSH file version 9.7", "again"}},
        {"GeoThatDoesNotParse", "body.geo", "Point(1) = {0, 0 0};\n", {}, {"body.geo:1: ", "syntax error near"}},
        {"GeoWithoutAVolume",
         "body.geo",
         occ + "Rectangle(1) = {0, 0, 1, 1, 1};\nPhysical Surface(\"body\") = {1};\n",
         scene_of("body.geo"),
         {"body.geo: ", "leaves the plane z = 0", "give it volumes"}},
        {"GeoOfSurfacesWithoutNames", "body.geo", occ + "Box(1) = {0, 0, 0, 1, 1, 1};\n", {}, {"none with a name"}},
        {"UnknownEnding", "body.dxf", "0\nSECTION\n", {}, {"unknown extension .dxf", "dmp reads .geo"}},
    };
}

class BrokenGeometryFile : public testing::TestWithParam<Broken> {};

TEST_P(BrokenGeometryFile, EndsWithTwoAndSaysWhatWhereAndWhatToDo) {
    const Broken& broken = GetParam();
    const CaseFolder folder;
    folder.write(broken.file, broken.contents);
    if (!broken.scene.empty()) folder.write("scene.toml", broken.scene);
    const Outcome outcome =
        broken.scene.empty() ? run_dmp(folder.path(), {"inspect", broken.file}) : run_dmp(folder.path(), {"mesh", "."});
    RecordProperty("message", outcome.errors);
    EXPECT_EQ(outcome.code, 2) << outcome.output;
    EXPECT_EQ(outcome.output, "");
    EXPECT_THAT(outcome.errors, testing::StartsWith("error: "));
    for (const std::string& words : broken.says) EXPECT_THAT(outcome.errors, testing::HasSubstr(words));
    EXPECT_THAT(outcome.errors, testing::ContainsRegex("\n  [^ ]")) << "there is no line that says what to do";
    EXPECT_LT(outcome.errors.size(), 2000U);
}

INSTANTIATE_TEST_SUITE_P(Input, BrokenGeometryFile, testing::ValuesIn(broken_files()),
                         [](const auto& broken) { return broken.param.name; });

TEST(BrokenGeometryFiles, OfWhichNothingIsThere) {
    const CaseFolder folder;
    std::filesystem::create_directory(folder.path() / "folder.stl");
    EXPECT_EQ(run_dmp(folder.path(), {"inspect", "folder.stl"}).errors,
              "error: the geometry 'folder.stl' is a folder\n  Name a file in it.\n");
    EXPECT_EQ(run_dmp(folder.path(), {"inspect", "none.stl"}).errors,
              "error: the geometry 'none.stl' does not exist\n  Check the path.\n");
    EXPECT_EQ(run_dmp(folder.path(), {"inspect", "none.stl"}).code, 2);
}

TEST(BrokenGeometryFiles, ThatNeverEndAreGivenUp) {
    const CaseFolder folder;
    folder.write("endless.geo", "n = 1000000; n = n * n;\nFor i In {1 : n}\n  a = i;\nEndFor\n");
    GeometryOptions options;
    options.file = (folder.path() / "endless.geo").string();
    // This one would take days: whoever waits for it runs into ctest's limit.
    try {
        (void)read_geometry_in_process(options,
                                       {.command = {DMP_PROGRAM, dmp::cli::read_geometry_command}, .seconds = 1});
        ADD_FAILURE() << "it ended";
    } catch (const InputError& error) {
        EXPECT_THAT(error.what(), testing::HasSubstr("endless.geo: the geometry cannot be read: gmsh was not done "
                                                     "after 1 s, when it was "));
    }
}

TEST(BrokenGeometryFiles, MakeNoFirstScene) {
    const CaseFolder folder;
    folder.write("body.stl", stl_text(without_a_side(), "body"));
    const Outcome outcome = run_dmp(folder.path(), {"new", "mine", "--from", "body.stl", "--unit", "mm"});
    EXPECT_EQ(outcome.code, 2);
    EXPECT_EQ(outcome.errors,
              "error: body.stl: the geometry has no closed body that could hold the fluid\n"
              "  'dmp inspect' says what is open; close it in the program that made the geometry.\n");
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "mine"));
    EXPECT_THAT(run_dmp(folder.path(), {"inspect", "body.stl"}).output,
                testing::HasSubstr("no solid: it is not closed: 4 edges of its surface have one side only, the first"));
}

TEST(BrokenGeometryFiles, LeaveTheTrianglesThatAreToBlame) {
    const CaseFolder folder;
    folder.write("body.stl", stl_text(without_a_side(), "body"));
    folder.write("scene.toml", scene_of("body.stl", "0.125 mm"));
    const Outcome outcome = run_dmp(folder.path(), {"mesh", "scene.toml"});
    EXPECT_EQ(outcome.code, 2);
    const std::string file = folder.path().filename().string() + "_bad_triangles.vtp";
    EXPECT_THAT(outcome.errors, testing::HasSubstr("(the triangles are in " + file + ")"));
    const std::string vtp = folder.read(file);
    EXPECT_THAT(vtp, testing::HasSubstr("<VTKFile type=\"PolyData\""));
    // Those with an edge at the missing side.
    EXPECT_THAT(vtp, testing::HasSubstr("NumberOfPolys=\"4\""));
    EXPECT_THAT(outcome.errors, testing::HasSubstr("the largest hole is 32 spacings around, at (1, 0.5, "
                                                   "0.5) mm"));
}

TEST(BrokenGeometryFiles, AreInspectedWithTheirTrianglesAtOpenEdgesInAFileThatIsNamed) {
    const CaseFolder folder;
    folder.write("body.stl", stl_text(without_a_side(), "body"));
    const auto inspect = [&](std::vector<std::string> more) {
        more.insert(more.begin(), {"inspect", "body.stl", "--unit", "mm"});
        return run_dmp(folder.path(), more);
    };
    const Outcome unasked = inspect({});
    EXPECT_EQ(unasked.code, 0);
    EXPECT_THAT(unasked.output, testing::HasSubstr("The triangles at open edges, for ParaView: "));
    EXPECT_THAT(unasked.output, testing::HasSubstr(" inspect body.stl --unit mm --bad-triangles open_edges.vtp\n"));
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1) << "nothing but body.stl";
    const Outcome asked = inspect({"--bad-triangles", "open.vtp"});
    EXPECT_EQ(asked.code, 0) << asked.errors;
    EXPECT_THAT(asked.output, testing::HasSubstr("4 triangles at open edges: open.vtp, lengths in m\n"));
    EXPECT_THAT(folder.read("open.vtp"), testing::HasSubstr("NumberOfPolys=\"4\""));
    EXPECT_EQ(inspect({"--json"}).output, inspect({"--json", "--bad-triangles", "open.vtp"}).output);
    EXPECT_EQ(inspect({"--bad-triangles", "/dev/null"}).code, 2);
}

TEST(BrokenGeometryFiles, AreRepairedAsFarAsTheSceneSays) {
    const CaseFolder folder;
    folder.write("body.stl", stl_text(without_a_side(), "body"));
    folder.write("scene.toml", scene_of("body.stl", "0.125 mm"));
    const auto meshed = [&](std::vector<std::string> settings) {
        std::vector<std::string> command{"mesh", "scene.toml"};
        for (std::string& each : settings) command.insert(command.end(), {"--set", std::move(each)});
        return run_dmp(folder.path(), command);
    };
    const Outcome filled = meshed({"geometry.largest_hole=32"});
    EXPECT_EQ(filled.code, 0);
    EXPECT_THAT(filled.output, testing::HasSubstr("32 spacings around, filled with 2 triangles"));
    const Outcome refused = meshed({"geometry.largest_hole=32", "geometry.repair=weld"});
    EXPECT_EQ(refused.code, 2);
    EXPECT_THAT(refused.errors, testing::HasSubstr("let geometry.repair go further"));
}

}  // namespace

}  // namespace dmp::tests::broken_geometry_files_tests
