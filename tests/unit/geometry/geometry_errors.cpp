// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <limits>

#include <gmock/gmock.h>
#include <sys/stat.h>
#include <unistd.h>

#include "temporary_geometry.hpp"
#include "tests/modules.hpp"

namespace dmp::tests::geometry_errors_tests {
namespace {

using ::testing::HasSubstr;

class GeometryFileErrors : public GeometryFileTest {
  protected:
    /// The whole message of the error that reading ends in, with the test's folder cut out of it.
    [[nodiscard]] std::string error_of(const GeometryOptions& options) const {
        try {
            (void)read_geometry(options);
        } catch (const InputError& error) {
            std::string message = error.what();
            const std::string folder = path("");
            for (std::size_t at = 0; (at = message.find(folder)) != std::string::npos;)
                message.erase(at, folder.size());
            return message;
        }
        return "no error";
    }
    [[nodiscard]] std::string error_of_file(const std::string& name) const { return error_of(options_for(path(name))); }
    [[nodiscard]] std::string error_of_text(const std::string& text) const {
        return error_of(options_for(write("d.geo", text)));
    }
};

const std::string named = "Physical Surface(\"water\") = {1};\n";

TEST_F(GeometryFileErrors, Files) {
    EXPECT_EQ(error_of_file("none.geo"), "scene.toml:6:8: the geometry 'none.geo' does not exist\n  Check the path.");
    EXPECT_EQ(error_of(options_for("")), "scene.toml:6:8: the geometry '' does not exist\n  Check the path.");
    std::filesystem::create_directories(path("folder.geo"));
    EXPECT_EQ(error_of_file("folder.geo"),
              "scene.toml:6:8: the geometry 'folder.geo' is a folder\n  Name a file in it.");
}

TEST_F(GeometryFileErrors, UnreadableFile) {
    // Root may read everything: for a moment this is nobody's process.
    constexpr uid_t nobody = 65534;
    const bool is_root = geteuid() == 0;
    for (const char* name : {"locked.geo", "locked.stl"}) {
        std::filesystem::permissions(write(name, unit_square + named), std::filesystem::perms::none);
        ASSERT_EQ(is_root ? seteuid(nobody) : 0, 0);
        const std::string error = error_of_file(name);
        ASSERT_EQ(is_root ? seteuid(0) : 0, 0);
        EXPECT_EQ(error,
                  "scene.toml:6:8: the geometry '" + std::string(name) + "' cannot be read\n  Check its permissions.");
    }
}

TEST_F(GeometryFileErrors, APipeIsNoDrawing) {
    ASSERT_EQ(mkfifo(path("pipe.geo").c_str(), 0600), 0);
    EXPECT_THAT(error_of_file("pipe.geo"), HasSubstr("scene.toml:6:8: the geometry 'pipe.geo' cannot be read"));
}

TEST_F(GeometryFileErrors, Formats) {
    (void)write("part.txt", "");
    (void)write("part", "");
    EXPECT_EQ(error_of_file("part.txt"),
              "scene.toml:6:8: the geometry 'part.txt': unknown extension .txt\n"
              "  dmp reads .geo, .geo_unrolled, .msh, .step, .stp, .iges, .igs, .brep, .stl, .obj, .ply and .off "
              "geometries.");
    EXPECT_EQ(error_of_file("part"),
              "scene.toml:6:8: the geometry 'part' has no extension\n  dmp reads .geo, .geo_unrolled, .msh, .step, "
              ".stp, .iges, .igs, .brep, .stl, .obj, .ply and .off geometries.");
}

TEST_F(GeometryFileErrors, Options) {
    auto options = options_for(write("d.geo", unit_square + named));
    options.unit = 0;
    EXPECT_THAT(error_of(options), HasSubstr("scene.toml:6:8: the geometry's unit must be a positive length"));
    options.unit = std::numeric_limits<double>::infinity();
    EXPECT_THAT(error_of(options), HasSubstr("the geometry's unit must be a positive length"));
    options.unit = 1;
    options.chord_error = -1;
    EXPECT_THAT(error_of(options), HasSubstr("the chord error must be a positive length"));
}

TEST_F(GeometryFileErrors, SyntaxErrorsHaveTheirLine) {
    EXPECT_EQ(error_of_text("Point(1) = {0, 0, 0};\nPoint(2) = {1, 0, 0}\nLine(1) = {1, 2};\n"),
              "d.geo:3: gmsh cannot read the geometry: syntax error near 'Line'\n"
              "  Look for a missing ';' or bracket on this line or the one before.");
    EXPECT_THAT(error_of_text(unit_square + named + "Point(9) = {0, 0, 0}"), HasSubstr("syntax error at the end"));
    // What comes before the mistake is a whole geometry: it must not pass for it.
    EXPECT_THAT(error_of_text(unit_square + named + "Pysical Curve(\"wall\") = {1};\n"),
                HasSubstr("d.geo:12: gmsh cannot read the geometry: syntax error near"));
}

TEST_F(GeometryFileErrors, OtherErrorsOfGmshAllAppear) {
    EXPECT_EQ(error_of_text("Point(1) = {0, 0, 0};\nPoint(2) = {a, 0, 0};\nLine(1) = {1, 7};\n"),
              "d.geo:2: gmsh cannot read the geometry: Unknown variable 'a'; Unknown control point 7 in GEO curve 1; "
              "line 3: Could not add line\n  Correct the geometry; 'gmsh d.geo' shows it.");
    EXPECT_EQ(error_of_text("Error(\"too long\");\n" + unit_square + named),
              "d.geo: gmsh cannot read the geometry: too long\n  Correct the geometry; 'gmsh d.geo' shows it.");
    EXPECT_THAT(error_of_text("Include \"none.geo\";\n" + unit_square + named), HasSubstr("none.geo"));
}

TEST_F(GeometryFileErrors, WhatGmshPassesOver) {
    EXPECT_EQ(error_of_text(unit_square + named + "// For\nFor i In {1:3}\n  a = i;\n"),
              "d.geo:13: 'For' without its 'EndFor'\n  Add 'EndFor'; gmsh itself does not notice.");
    EXPECT_EQ(error_of_text("/* If\n */ If (1)\n  If (1)\n  EndIf\n" + unit_square + named),
              "d.geo:2: 'If' without its 'EndIf'\n  Add 'EndIf'; gmsh itself does not notice.");
    EXPECT_EQ(error_of_text("If (1)\nEndFor\nEndIf\n"),
              "d.geo:2: 'EndFor' without its 'For'\n  Add 'For'; gmsh itself does not notice.");
    EXPECT_EQ(error_of_text(unit_square + "a = 1; b = 2;"),
              "d.geo:11: several statements on a last line without line break\n"
              "  End the file with a line break; gmsh drops all but the first of them.");
    EXPECT_EQ(error_of_text(unit_square + "text = \"If For\"; // EndIf\n" + named), "no error");
}

TEST_F(GeometryFileErrors, UnknownParameter) {
    auto options = options_for(write("d.geo",
                                     "DefineConstant[ leaflet_length = {1, Name \"leaflet_length\"},\n"
                                     "  tip_gap = {2, Name \"tip_gap\"}, plain = 3 ];\nfixed = 4;\n" +
                                         unit_square + named));
    options.parameters = {{"leaflet_lenght", 2}};
    options.parameter_locations["leaflet_lenght"] = {.file = "scene.toml", .line = 7, .column = 16};
    EXPECT_EQ(error_of(options),
              "scene.toml:7:16: the geometry 'd.geo' offers no constant 'leaflet_lenght' for setting\n"
              "  Did you mean 'leaflet_length'? It offers 'leaflet_length' and 'tip_gap'.");
    options.parameters = {{"radius", 2}};
    EXPECT_EQ(error_of(options),
              "scene.toml:6:8: the geometry 'd.geo' offers no constant 'radius' for setting\n"
              "  It offers 'leaflet_length' and 'tip_gap'.");
    options.parameters = {{"plain", 2}};
    EXPECT_EQ(error_of(options),
              "scene.toml:6:8: the geometry 'd.geo' offers no constant 'plain' for setting\n"
              "  Line 2 of the geometry sets it, but not in the one form that can be set from outside: "
              "DefineConstant[ plain = {value, Name \"plain\"} ];");
    options.parameters = {{"fixed", 2}};
    EXPECT_THAT(error_of(options), HasSubstr("Line 3 of the geometry sets it"));
    options.parameters = {{"Gmsh/Model dimension", 2}};
    EXPECT_THAT(error_of(options), HasSubstr("offers no constant 'Gmsh/Model dimension'"));
}

TEST_F(GeometryFileErrors, ParameterOfADrawingThatOffersNone) {
    auto options = options_for(write("d.geo", unit_square + named));
    options.parameters = {{"a", 1}};
    EXPECT_EQ(error_of(options),
              "scene.toml:6:8: the geometry 'd.geo' offers no constant 'a' for setting\n"
              "  It offers nothing. A constant is offered by DefineConstant[ a = {value, Name \"a\"} ];");
    options.file = write("d.msh", "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n");
    EXPECT_EQ(error_of(options),
              "scene.toml:6:8: the geometry 'd.msh' offers no constant 'a' for setting\n"
              "  A mesh has no parameters; give its .geo script.");
}

TEST_F(GeometryFileErrors, ParameterThatTheDrawingFixes) {
    const std::string advice =
        "\n  Remove ReadOnly or SetNumber for it from the geometry, or the parameter from the scene.";
    auto options = options_for(write(
        "d.geo", "DefineConstant[ a = {1, ReadOnly 1, Name \"a\"} ];\nSetNumber(\"b\", 3);\n" + unit_square + named));
    options.parameters = {{"a", 2}};
    EXPECT_EQ(error_of(options), "scene.toml:6:8: the geometry 'd.geo' sets 'a' itself" + advice);
    options.parameters = {{"b", 2}};
    EXPECT_EQ(error_of(options), "scene.toml:6:8: the geometry 'd.geo' sets 'b' itself" + advice);
    options.parameters = {{"a", 1}};
    EXPECT_EQ(error_of(options), "no error");
}

TEST_F(GeometryFileErrors, Groups) {
    const std::string no_names =
        "d.geo: the geometry has no named groups\n"
        "  Name its parts, as in Physical Surface(\"blood\") = {1}; or Physical Curve(\"wall\") = {2, 3};";
    EXPECT_EQ(error_of_text(unit_square), no_names);
    EXPECT_EQ(error_of_text("\n"), no_names);
    EXPECT_EQ(error_of_text(unit_square + named + "Physical Curve(7) = {1};\n"),
              "d.geo: Physical Curve 7 has no name\n  Name it, as in Physical Curve(\"wall\") = {...};, or remove it.");
}

TEST_F(GeometryFileErrors, ThreeDimensions) {
    EXPECT_EQ(error_of_text("SetFactory(\"OpenCASCADE\");\nBox(1) = {0, 0, 0, 1, 1, 1};\n"),
              "d.geo: the geometry has volumes, but none with a name\n"
              "  Name its parts, as in Physical Volume(\"blood\") = {1}; and Physical Surface(\"wall\") = {2};.");
    EXPECT_EQ(error_of_text("Point(1) = {0, 0, 0};\nPoint(2) = {1, 0, -0.5};\nLine(1) = {1, 2};\n"
                            "Physical Curve(\"line\") = {1};\n"),
              "d.geo: the geometry leaves the plane z = 0: it reaches z = -500 mm\n"
              "  Draw it in the x-y plane, or give it volumes.");
}

TEST_F(GeometryFileErrors, RegionsThatAreNone) {
    EXPECT_EQ(error_of_text("Point(1) = {0, 0, 0};\nPoint(2) = {2, 0, 0};\nPoint(3) = {1, 0, 0};\n"
                            "Line(1) = {1, 2};\nLine(2) = {2, 3};\nLine(3) = {3, 1};\n"
                            "Curve Loop(1) = {1, 2, 3};\nPlane Surface(1) = {1};\n" +
                            named),
              "d.geo: region 'water' has no area, or is thinner than 1e-12 of its length\n  Check the geometry, or the "
              "parameters and the unit that it was given.");
    EXPECT_EQ(
        error_of_text("Point(1) = {0, 0, 0};\nPoint(2) = {2, 2, 0};\nPoint(3) = {2, 0, 0};\nPoint(4) = {0, 2, 0};\n"
                      "Line(1) = {1, 2};\nLine(2) = {2, 3};\nLine(3) = {3, 4};\nLine(4) = {4, 1};\n"
                      "Curve Loop(1) = {1, 2, 3, 4};\nPlane Surface(1) = {1};\n" +
                      named),
        "d.geo: region 'water' crosses itself near (1, 1) m\n"
        "  Check the geometry, or the parameters it was given.");
    EXPECT_THAT(
        error_of_text("Point(1) = {0, 0, 0};\nPoint(2) = {1, 0, 0};\nPoint(3) = {1, 1, 0};\n"
                      "Line(1) = {1, 2};\nLine(2) = {2, 3};\nCurve Loop(1) = {1, 2};\nPlane Surface(1) = {1};\n" +
                      named),
        HasSubstr("d.geo"));
}

TEST_F(GeometryFileErrors, CurveWithoutLength) {
    EXPECT_EQ(error_of_text("Point(1) = {1, 1, 0};\nPoint(2) = {1, 1, 0};\nLine(3) = {1, 2};\n"
                            "Physical Curve(\"line\") = {3};\n"),
              "d.geo: curve 3 has no length\n  Remove it, or move one of its ends.");
}

TEST_F(GeometryFileErrors, DrawingsThatAreNotFinite) {
    EXPECT_NE(error_of_text("Point(1) = {0, 0, 0};\nPoint(2) = {1 / 0, 0, 0};\nLine(1) = {1, 2};\n"
                            "Physical Curve(\"line\") = {1};\n"),
              "no error");
}

TEST_F(GeometryFileErrors, BrokenMeshes) {
    (void)write("d.msh", "nothing of the kind\n");
    EXPECT_THAT(error_of_file("d.msh"), HasSubstr("d.msh"));
    (void)write("d.msh", "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Nodes\n");
    EXPECT_THAT(error_of_file("d.msh"), HasSubstr("d.msh: gmsh cannot read the geometry: Could not read nodes"));
}

TEST_F(GeometryFileErrors, EmptyFiles) {
    for (const char* name : {"d.geo", "d.msh", "d.step", "d.igs", "d.brep", "d.stl", "d.obj", "d.ply", "d.off"}) {
        (void)write(name, "");
        EXPECT_EQ(error_of_file(name),
                  "scene.toml:6:8: the geometry '" + std::string(name) + "' is empty\n  Save or export it again.");
    }
}

TEST_F(GeometryFileErrors, PointsThatAreNoPlaces) {
    const std::string box =
        "SetFactory(\"OpenCASCADE\");\nBox(1) = {0, 0, 0, 1, 1, 1};\n"
        "Physical Volume(\"water\") = {1};\n";
    auto options = options_for(write("d.geo", box));
    options.unit = 1e13;
    EXPECT_THAT(error_of(options),
                HasSubstr("further out than any geometry can mean\n  Check the geometry and its unit"));
    options = options_for(write("d.obj", "v 0 0 0\nv 1e300 0 0\nv 0 1 0\nf 1 2 3\n"));
    options.unit = 1e-3;
    EXPECT_THAT(error_of(options), HasSubstr("the geometry has a point at (1e+297, 0, 0) m, further out than any"));
    options.unit = 1e20;
    EXPECT_THAT(error_of(options), HasSubstr("the geometry has a point without finite coordinates"));
}

}  // namespace
}  // namespace dmp::tests::geometry_errors_tests
