// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Writes what fuzzing starts from: make_seeds FOLDER. A folder for each program, in it a few small inputs that are in
// order.
#include <array>
#include <bit>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <string>

#include "geometry/geometry_bytes.hpp"
#include "geometry/triangle_file.hpp"
#include "geometry/triangle_geometry.hpp"
#include "tests/modules.hpp"

namespace {

const std::array<const char*, 8> corners{"0 0 0", "2 0 0", "2 1 0", "0 1 0", "0 0 3", "2 0 3", "2 1 3", "0 1 3"};
const std::array<std::array<int, 4>, 6> sides{
    {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}}};

std::string box(const std::string& before_corner, const std::string& before_side, int first) {
    std::string text;
    for (const char* corner : corners) text += before_corner + corner + "\n";
    for (const auto& side : sides) {
        text += before_side;
        for (const int k : side) text += " " + std::to_string(k + first);
        text += "\n";
    }
    return text;
}

void add_number(std::string& text, std::uint32_t bits, bool big_endian) {
    for (unsigned byte = 0; byte < 4; ++byte)
        text += static_cast<char>(bits >> (8 * (big_endian ? 3 - byte : byte)) & 0xffU);
}

/// The box as the ladder of repairs gets it: highest rung, corners, triangles; some more corners and triangles after
/// it.
std::string surface(char rung, const std::string& more_corners, const std::string& more_triangles,
                    std::size_t left_out) {
    std::string text{rung, static_cast<char>(corners.size() + more_corners.size() / 3)};
    for (const char* corner : corners)
        for (const std::size_t digit : {0, 2, 4}) text += static_cast<char>(4 * (corner[digit] - '0'));
    text += more_corners;
    std::string triangles;
    for (const auto& [a, b, c, d] : sides)
        for (const int k : {a, b, c, a, c, d}) triangles += static_cast<char>(k);
    return text + triangles.substr(3 * left_out) + more_triangles;
}

std::string ply_header(const std::string& format) {
    return "ply\nformat " + format +
           " 1.0\nelement vertex 8\nproperty float x\nproperty float y\nproperty float z\nelement face 6\n"
           "property list uchar int vertex_indices\nend_header\n";
}

std::string ply_binary(const dmp::geometry::TriangleSoup& soup, bool big_endian) {
    std::string text = ply_header(big_endian ? "binary_big_endian" : "binary_little_endian");
    for (const dmp::Vec& corner : soup.surface.corners)
        for (const double x : corner) add_number(text, std::bit_cast<std::uint32_t>(static_cast<float>(x)), big_endian);
    for (const auto& side : sides) {
        text += '\4';
        for (const int k : side) add_number(text, static_cast<std::uint32_t>(k), big_endian);
    }
    return text;
}

std::string stl_text(const dmp::geometry::TriangleSoup& soup) {
    std::string text = "solid box\n";
    for (const auto& triangle : soup.surface.triangles) {
        text += "facet normal 0 0 0\nouter loop\n";
        for (const int corner : triangle)
            text += std::string("vertex ") + corners.at(static_cast<std::size_t>(corner)) + "\n";
        text += "endloop\nendfacet\n";
    }
    return text + "endsolid box\n";
}

std::string stl_binary(const dmp::geometry::TriangleSoup& soup) {
    std::string text(80, ' ');
    add_number(text, static_cast<std::uint32_t>(soup.surface.triangles.size()), false);
    for (const auto& triangle : soup.surface.triangles) {
        text += std::string(12, '\0');
        for (const int corner : triangle)
            for (const double x : soup.surface.corners[static_cast<std::size_t>(corner)])
                add_number(text, std::bit_cast<std::uint32_t>(static_cast<float>(x)), false);
        text += std::string(2, '\0');
    }
    return text;
}

}  // namespace

int main(int count, char** words) {
    if (count != 2) {
        std::cerr << "fuzz_seeds FOLDER\n";
        return 2;
    }
    const std::filesystem::path folder = words[1];
    const auto write = [&](const std::string& name, const std::string& contents) {
        std::filesystem::create_directories((folder / name).parent_path());
        std::ofstream(folder / name, std::ios::binary) << contents;
    };
    const std::string obj = "g box\n" + box("v ", "f", 1);
    const dmp::geometry::TriangleSoup soup = dmp::geometry::read_obj_text(obj, "box.obj");
    write("obj/box", obj);
    write("obj/backwards", box("v ", "f", -8) + "g lid\nf -4/1/1 -3//2 -2/3 -1\n");
    write("obj/crossing", box("v ", "f", 1) + box("v 0.5", "f", 9));  // a slab in it, from x = 0.50 to 0.52
    write("off/box", "OFF\n8 6 12\n" + box("", "4", 0));
    write("off/with_normals", "NOFF # of one triangle\n3 1 0\n0 0 0 0 0 1\n1 0 0 0 0 1\n0 1 0 0 0 1\n3 0 1 2\n");
    write("ply/text", ply_header("ascii") + box("", "4", 0));
    write("ply/little_endian", ply_binary(soup, false));
    write("ply/big_endian", ply_binary(soup, true));
    write("stl/text", stl_text(soup));
    write("stl/two_solids", "solid a\nendsolid a\n" + stl_text(soup));
    write("stl/binary", stl_binary(soup));

    dmp::geometry::GeometryOptions options;
    options.file = "box.obj";
    options.unit = 1e-3;
    dmp::geometry::Geometry geometry = dmp::geometry::triangle_geometry(soup, options);
    write("answer/in_space", "G" + dmp::geometry::bytes_of(geometry));
    geometry = {};
    geometry.regions.push_back({"water", {{{dmp::Vec(0, 0, 0), dmp::Vec(1, 0, 0), dmp::Vec(0, 1, 0)}, true}}});
    geometry.curves.push_back({"wall", {{{dmp::Vec(0, 0, 0), dmp::Vec(1, 0, 0)}, false}}});
    geometry.points["root"] = {dmp::Vec(0, 0, 0)};
    geometry.warnings = {"a warning"};
    write("answer/in_the_plane", "G" + dmp::geometry::bytes_of(geometry));
    write("answer/error",
          "I" + dmp::geometry::bytes_of(dmp::geometry::ErrorText{{"a.geo", 3, 4}, "it is wrong", "correct it"}));
    options.parameters["width"] = 2;
    options.parameter_locations["width"] = {"scene.toml", 5, 6};
    write("answer/request", "Q" + dmp::geometry::bytes_of(options));
    write("repair/box", surface(0, "", "", 0));
    write("repair/hole", surface(2, "", "", 1));
    write("repair/wide_hole", surface(8, "", "", 2));
    write("repair/sheet", surface(16, {0, 8, 8}, {0, 1, 8}, 0));
    write("repair/tetrahedron_beside", surface(1, {0, 0, 15}, {4, 5, 8, 5, 7, 8, 7, 4, 8, 4, 7, 5}, 0));
    write("script/loop",
          "width = 2; // If\nFor i In {1:3}\n  Point(i) = {i, 0, 0};\nEndFor\n/* a\n */ Printf(\"If\");\n");
    write("script/cut", "If (1)\n  DefineConstant[ width = {1, Name \"width\"} ];\nEndIf\na = 1; b = 2;");
    write("script/harm",
          "Field[1] = Box; Mesh.Algorithm = 6;\nPrintf(\"%g\", (1)) > \"a\"; SystemCall StrCat(\"a\", 'b');\n");
    return 0;
}
