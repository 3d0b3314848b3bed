// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// One body in every format gives the same particles and the same names.
#include <bit>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <numbers>
#include <regex>

#include <gmock/gmock.h>

#include "geometry/triangle_surface.hpp"
#include "meshed_text.hpp"
#include "scene/quantity.hpp"
#include "tests/modules.hpp"
#include "tests/unit/thrown.hpp"

namespace dmp::tests::cad_meshes_tests {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// A block of 2 x 1 x 1 with a ball of radius 0.3 missing in its middle.
const std::string block =
    "SetFactory(\"OpenCASCADE\");\nBox(1) = {0, 0, 0, 2, 1, 1};\nSphere(2) = {1, 0.5, 0.5, 0.3};\n"
    "BooleanDifference(3) = { Volume{1}; Delete; }{ Volume{2}; Delete; };\nPhysical Volume(\"block\") = {3};\n";

const std::string scene = R"(schema = 1
dimension = 3
[geometry]
file = "block.geo"
unit = "1 mm"
[[select]]
name = "wall"
of = "block"
from = ["-1 mm", "-1 mm", "-1 mm"]
to = ["9 mm", "9 mm", "9 mm"]
[particles]
spacing = "0.05 mm"
[[part]]
name = "block"
kind = "fluid"
density = "1000 kg/m^3"
viscosity = "1 mPa*s"
[[part]]
name = "wall"
kind = "rigid"
[flow]
largest_speed = "1 m/s"
[run]
duration = "1 s"
[output]
every = "1 s"
)";

std::string text_of(const std::string& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

void write_binary_stl(const TriangleSurface& surface) {
    std::string text(80, ' ');
    const auto add = [&](std::uint32_t bits) {
        for (unsigned byte = 0; byte < 4; ++byte) text += static_cast<char>(bits >> (8 * byte) & 0xffU);
    };
    add(static_cast<std::uint32_t>(surface.triangles.size()));
    for (const auto& triangle : surface.triangles) {
        for (int k = 0; k < 3; ++k) add(0);
        for (const int corner : triangle)
            for (const double x : surface.corners[static_cast<std::size_t>(corner)])
                add(std::bit_cast<std::uint32_t>(static_cast<float>(x)));
        text += std::string(2, '\0');
    }
    std::ofstream("block_binary.stl", std::ios::binary) << text;
}

/// OBJ, PLY and OFF: gmsh writes none of them as they are known elsewhere.
void write_other_triangles(const TriangleSurface& surface) {
    std::string corners, obj = "o block\n", faces;
    const auto line = [](const Vec& at) {
        return exact_text(at[0]) + " " + exact_text(at[1]) + " " + exact_text(at[2]) + "\n";
    };
    for (const Vec& corner : surface.corners) {
        corners += line(corner);
        obj += "v " + line(corner);
    }
    for (const auto& [a, b, c] : surface.triangles) {
        faces += "3 " + std::to_string(a) + " " + std::to_string(b) + " " + std::to_string(c) + "\n";
        obj += "f " + std::to_string(a + 1) + " " + std::to_string(b + 1) + " " + std::to_string(c + 1) + "\n";
    }
    const std::string counts[] = {std::to_string(surface.corners.size()), std::to_string(surface.triangles.size())};
    Folder::write(obj, "block.obj");
    Folder::write("OFF\n" + counts[0] + " " + counts[1] + " 0\n" + corners + faces, "block.off");
    Folder::write("ply\nformat ascii 1.0\nelement vertex " + counts[0] +
                      "\nproperty double x\nproperty double y\nproperty double z\nelement face " + counts[1] +
                      "\nproperty list uchar int vertex_index\nend_header\n" + corners + faces,
                  "block.ply");
}

/// Writes the block in all formats; `size` is that of a millimetre in the geometry's units.
void write_all_formats() {
    Folder::write(block, "block.geo");
    Folder::write(block +
                      "Mesh.MeshSizeFromCurvature = 100;\nMesh.SaveAll = 1;\n"
                      "Save \"block.step\";\nSave \"block.brep\";\nMesh 2;\nSave \"block.msh\";\n"
                      "Save \"block.stl\";\n",
                  "export.geo");
    GeometryOptions options;
    options.file = "export.geo";
    options.trust = Trust::full;  // it writes files
    (void)read_geometry(options);
    const std::string step = std::regex_replace(text_of("block.step"), std::regex("PRODUCT\\('[^']*',\\s*'[^']*'"),
                                                "PRODUCT('block','block'");
    Folder::write(step, "block_mm.step");
    // The same numbers as metres: a thousand times the size.
    Folder::write(std::regex_replace(step, std::regex("SI_UNIT\\(\\.MILLI\\.,\\.METRE\\.\\)"), "SI_UNIT($$,.METRE.)"),
                  "block_m.STP");
    std::string stl = text_of("block.stl");
    stl.replace(0, stl.find('\n'), "solid block");
    Folder::write(stl, "block_text.stl");
    const TriangleSurface surface = read_stl("block.stl", 1, {});
    write_binary_stl(surface);
    write_other_triangles(surface);
}

TEST(CadMeshes, OneBodyInEachFormatGivesTheSameParticles) {
    const Folder folder;
    Folder::write(scene);
    write_all_formats();
    const Meshed reference = mesh_file("scene.toml");
    const auto particles = static_cast<double>(reference.report.parts[0].particles);
    EXPECT_NEAR(particles * std::pow(0.05, 3), 2 - 4.0 / 3 * std::numbers::pi * 0.027, 0.005);
    struct Format {
        std::string file, name, unit;  ///< unit: "": stated by the file
    };
    const std::vector<Format> formats{{"block.msh", "block", "1 mm"},  {"block_mm.step", "block", ""},
                                      {"block.brep", "block", "1 mm"}, {"block_text.stl", "block", "1 mm"},
                                      {"block.obj", "block", "1 mm"},  {"block.ply", "block", "1 mm"},
                                      {"block.off", "block", "1 mm"},  {"block_binary.stl", "block_binary", "1 mm"}};
    for (const auto& [file, name, unit] : formats) {
        SCOPED_TRACE(file);
        std::string changed = scene;
        const auto put = [&](const std::string& found, const std::string& replacement) {
            for (auto at = changed.find(found); at != std::string::npos;
                 at = changed.find(found, at + replacement.size()))
                changed.replace(at, found.size(), replacement);
        };
        put("\"block\"", "\"" + name + "\"");
        put("block.geo", file);
        if (unit.empty()) put("unit = \"1 mm\"\n", "");
        Folder::write(changed);
        const Meshed meshed = mesh_file("scene.toml");
        EXPECT_THAT(meshed.geometry.names(), ElementsAre(name, "wall"));
        EXPECT_NEAR(static_cast<double>(meshed.report.parts[0].particles) / particles, 1, 0.005);
        EXPECT_NEAR(static_cast<double>(meshed.particles.position.size()) /
                        static_cast<double>(reference.particles.position.size()),
                    1, 0.005);
        EXPECT_LT((meshed.geometry.box.high - Vec(2e-3, 1e-3, 1e-3)).norm(), 1e-9);
        EXPECT_EQ(meshed.geometry.unit_source, unit.empty() ? UnitSource::file : UnitSource::scene);
    }
}

TEST(CadMeshes, AMetreInAStepFileIsAMetre) {
    const Folder folder;
    write_all_formats();
    GeometryOptions options;
    options.file = "block_m.STP";
    options.chord_error = 1e-3;
    const Geometry large = read_geometry(options);
    EXPECT_LT((large.box.high - Vec(2, 1, 1)).norm(), 1e-6);
    std::string scaled = scene;
    for (std::size_t at = 0; (at = scaled.find(" mm", at)) != std::string::npos;) scaled.replace(at, 3, " m");
    scaled.replace(scaled.find("unit = \"1 m\"\n"), 13, "");
    scaled.replace(scaled.find("block.geo"), 9, "block_m.STP");
    Folder::write(scaled);
    const auto in_metres = mesh_file("scene.toml").report.parts[0].particles;
    Folder::write(scene);
    const auto in_millimetres = mesh_file("scene.toml").report.parts[0].particles;
    EXPECT_NEAR(static_cast<double>(in_metres) / static_cast<double>(in_millimetres), 1, 0.005);
}

TEST(CadMeshes, BodiesWithoutNamesAreNumberedAndUnitsAreChecked) {
    const Folder folder;
    Folder::write(
        "SetFactory(\"OpenCASCADE\");\nBox(1) = {0, 0, 0, 1, 1, 1};\nBox(2) = {3, 0, 0, 1, 1, 2};\n"
        "Physical Volume(\"both\") = {1, 2};\nSave \"two.step\";\nSave \"two.brep\";\n",
        "export.geo");
    GeometryOptions options;
    options.file = "export.geo";
    options.trust = Trust::full;  // it writes files
    (void)read_geometry(options);
    options.file = "two.step";
    const Geometry two = read_geometry(options);
    EXPECT_THAT(two.names(), ElementsAre("solid_1", "solid_2"));
    ASSERT_NE(two.solid("solid_2"), nullptr);
    EXPECT_NEAR(two.solid("solid_2")->volume(), 2e-9, 1e-16);
    options.unit = 1e-3;
    options.location = {"scene.toml", 2, 3};
    const auto fault = [&] { return text_thrown<InputError>([&] { (void)read_geometry(options); }); };
    EXPECT_EQ(fault(),
              "scene.toml:2:3: the geometry 'two.step' states its unit itself, and the scene gives another\n"
              "  Leave geometry.unit out, or correct the unit in the program that made the geometry.");
    options.file = "two.brep";
    EXPECT_THAT(read_geometry(options).names(), ElementsAre("solid_1", "solid_2"));
    options.unit.reset();
    EXPECT_THAT(fault(), HasSubstr("is it 4 x 1 x 2 m, 4 x 1 x 2 mm or 4 x 1 x 2 um?"));
    options.file = "cut.step";
    const std::string step = text_of("two.step");
    Folder::write(step.substr(0, step.size() / 2), "cut.step");
    EXPECT_THAT(fault(), HasSubstr("cut.step"));
    Folder::write("hello", "cut.step");
    EXPECT_THAT(fault(), HasSubstr("cut.step"));
    options.unit = 1;
    options.file = "cut.brep";
    Folder::write("DBRep_DrawableShape\n", "cut.brep");
    EXPECT_THAT(fault(), HasSubstr("cut.brep"));
}

TEST(CadMeshes, LooseFacesOfAnIgesFileAreSewnToABody) {
    GeometryOptions options;
    options.file = DMP_SOURCE_DIR "/tests/data/cad/box.igs";
    const Geometry geometry = read_geometry(options);
    EXPECT_THAT(geometry.names(), ElementsAre("box"));
    ASSERT_NE(geometry.solid("box"), nullptr);
    EXPECT_NEAR(geometry.solid("box")->volume(), 2e-9, 1e-15);
    EXPECT_LT((geometry.box.high - Vec(2e-3, 1e-3, 1e-3)).norm(), 1e-9);
    EXPECT_EQ(geometry.unit_source, UnitSource::file);
}

TEST(CadMeshes, AnOpenSurfaceIsNoFluidAndSaysWhy) {
    const Folder folder;
    Folder::write("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\n", "block.obj");
    std::string changed = scene;
    changed.replace(changed.find("block.geo"), 9, "block.obj");
    Folder::write(changed);
    EXPECT_THAT(
        text_thrown<InputError>([] { (void)mesh_file("scene.toml"); }),
        HasSubstr("'block' is a surface in the geometry, but a volume for a fluid is needed here; it is not closed: "
                  "3 edges of its surface have one side only"));
}

}  // namespace
}  // namespace dmp::tests::cad_meshes_tests
