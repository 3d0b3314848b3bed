// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/triangle_surface.hpp"

#include <bit>
#include <cstdint>
#include <fstream>

#include <gmock/gmock.h>

#include "tests/modules.hpp"
#include "tests/unit/temporary_files.hpp"
#include "tests/unit/thrown.hpp"

namespace dmp::tests::triangle_surface_tests {
namespace {

using ::testing::HasSubstr;

using Triangle = std::array<std::array<float, 3>, 3>;

/// A tetrahedron: four corners, of which each triangle has three.
const std::vector<Triangle> tetrahedron{{{{0, 0, 0}, {0, 1, 0}, {1, 0, 0}}},
                                        {{{0, 0, 0}, {1, 0, 0}, {0, 0, 2}}},
                                        {{{0, 0, 0}, {0, 0, 2}, {0, 1, 0}}},
                                        {{{1, 0, 0}, {0, 1, 0}, {-0.0F, 0, 2}}}};

std::string as_text(const std::vector<Triangle>& triangles) {
    std::string text = "solid tetrahedron of mine\n";
    for (const Triangle& triangle : triangles) {
        text += "  facet normal 0 0 0\n    outer loop\n";
        for (const auto& corner : triangle)
            text += "      vertex " + std::to_string(corner[0]) + " " + std::to_string(corner[1]) + " " +
                    std::to_string(corner[2]) + "\n";
        text += "    endloop\n  endfacet\n";
    }
    return text + "endsolid tetrahedron of mine\n";
}

std::string as_binary(const std::vector<Triangle>& triangles) {
    std::string text = "solid that is binary all the same";
    text.resize(80);
    const auto add = [&](std::uint32_t bits) {
        for (int byte = 0; byte < 4; ++byte)
            text += static_cast<char>(bits >> (8U * static_cast<unsigned>(byte)) & 0xffU);
    };
    add(static_cast<std::uint32_t>(triangles.size()));
    for (const Triangle& triangle : triangles) {
        for (int k = 0; k < 3; ++k) add(0);
        for (const auto& corner : triangle)
            for (const float x : corner) add(std::bit_cast<std::uint32_t>(x));
        text += std::string(2, '\0');
    }
    return text;
}

TriangleSurface read(const std::string& contents, double unit = 1e-3) {
    const TemporaryFolder folder;
    const std::string file = (folder.path() / "a.stl").string();
    std::ofstream(file, std::ios::binary) << contents;
    return read_stl(file, unit, {"scene.toml", 3, 4});
}

std::string fault(const std::string& contents) {
    return text_thrown<InputError>([&] { read(contents); });
}

TEST(Stl, text_and_binary_say_the_same) {
    for (const std::string& contents : {as_text(tetrahedron), as_binary(tetrahedron)}) {
        const TriangleSurface surface = read(contents);
        ASSERT_EQ(surface.corners.size(), 4U) << "corners are shared, -0 is 0";
        ASSERT_EQ(surface.triangles.size(), 4U);
        EXPECT_EQ(surface.corners[1], Vec(0, 1e-3, 0));
        EXPECT_EQ(surface.triangles[3], (std::array<int, 3>{2, 1, 3}));
        EXPECT_EQ(surface.left_out, 0U);
        EXPECT_NEAR(surface.area(), 1e-6 * (0.5 + 1 + 1 + 1.5), 1e-18);
    }
}

TEST(Stl, counts_what_has_no_area) {
    std::vector<Triangle> triangles = tetrahedron;
    triangles.push_back({{{0, 0, 0}, {1, 0, 0}, {1, 0, 0}}});
    triangles.push_back({{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}});
    const TriangleSurface surface = read(as_binary(triangles));
    EXPECT_EQ(surface.triangles.size(), 4U);
    EXPECT_EQ(surface.left_out, 2U);
}

TEST(WrongStl, is_refused_with_its_line) {
    const std::string text = as_text(tetrahedron);
    const auto with = [&](const std::string& found, const std::string& replacement) {
        std::string changed = text;
        return fault(changed.replace(changed.find(found), found.size(), replacement));
    };
    EXPECT_THAT(with("vertex 0.000000 1.000000 0.000000", "vertex 0 one 0"),
                HasSubstr("a.stl:5:1: expected three numbers after 'vertex', found \"      vertex 0 one 0\""));
    EXPECT_THAT(with("vertex 0.000000 1.000000 0.000000", "vertex 0 1"),
                HasSubstr("a.stl:5:1: expected three numbers"));
    EXPECT_THAT(with("vertex 0.000000 1.000000 0.000000", ""), HasSubstr("a.stl:8:1: a triangle has 2 corners"));
    EXPECT_THAT(with("endloop", "wobble"), HasSubstr("a.stl:7:1: 'wobble' is no word of an STL file"));
    EXPECT_THAT(with("endsolid", "solid"), HasSubstr("the file ends before 'endsolid'"));
    EXPECT_THAT(with("  endfacet\n", ""), HasSubstr("a.stl:8:1: the triangle before this line has no 'endfacet'"));
    EXPECT_THAT(fault(text.substr(0, text.rfind("  endfacet")) + "endsolid\n"),
                HasSubstr("a.stl:29:1: the triangle before this line has no 'endfacet'"));
    EXPECT_THAT(fault(text.substr(0, text.rfind("  endfacet")) + text),
                HasSubstr("a.stl:29:1: the triangle before this line has no 'endfacet'"));
    EXPECT_THAT(fault(text + "vertex 0 0 0\n"), HasSubstr("a.stl:31:1: the file ends before 'endsolid'"));
    EXPECT_THAT(with("  facet normal 0 0 0\n    outer loop\n", "vertex 0 0 0\n"), HasSubstr("or no 'endfacet'"));
    EXPECT_THAT(fault("solid nothing\nendsolid\n"), HasSubstr("scene.toml:3:4: "));
    EXPECT_THAT(fault("solid nothing\nendsolid\n"), HasSubstr("has no triangle with an area"));
    EXPECT_THAT(fault(""), HasSubstr("is no STL file, or a binary one that was cut off"));
    const std::string binary = as_binary(tetrahedron).replace(0, 5, "hello");
    EXPECT_THAT(fault(binary.substr(0, binary.size() - 1)),
                HasSubstr("is no STL file, or a binary one that was cut off: for its 4 triangles it needs 284 bytes, "
                          "and it has 283"));
    EXPECT_THAT(fault(binary + "xyz"),
                HasSubstr("is no STL file, or a binary one and more: for its 4 triangles it needs "
                          "284 bytes, and it has 287"));
    std::vector<Triangle> infinite = tetrahedron;
    infinite[2][1][1] = std::numeric_limits<float>::infinity();
    EXPECT_THAT(fault(as_binary(infinite)), HasSubstr("triangle 2 has a corner that is not finite"));
    EXPECT_THAT(text_thrown<InputError>([] {
                    read_stl("/nowhere.stl", 1, {"scene.toml", 3, 4});
                }),
                HasSubstr("scene.toml:3:4: '/nowhere.stl' cannot be read"));
}

}  // namespace
}  // namespace dmp::tests::triangle_surface_tests
