// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// OBJ, PLY, OFF and STL as geometries.
#include <Eigen/Geometry>
#include <bit>
#include <cmath>
#include <cstdint>
#include <functional>
#include <sstream>

#include <gmock/gmock.h>

#include "geometry/split_polygon.hpp"
#include "geometry/triangle_file.hpp"
#include "geometry/triangle_geometry.hpp"
#include "temporary_geometry.hpp"
#include "tests/modules.hpp"

namespace dmp::tests::triangle_files_tests {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// A box of 3 x 2 x 1 by its six sides, numbers from 0.
const std::string box_corners[] = {"0 0 0", "3 0 0", "3 2 0", "0 2 0", "0 0 1", "3 0 1", "3 2 1", "0 2 1"};
const std::vector<std::array<int, 4>> box_sides{{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4},
                                                {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};

std::string numbers_of(const std::array<int, 4>& side, int first) {
    std::string text;
    for (const int k : side) text += " " + std::to_string(k + first);
    return text;
}

/// `before_side` stands before each side, by its number.
std::string obj_box(const std::function<std::string(int)>& before_side = [](int) { return ""; }) {
    std::string text = "# a box\nmtllib none.mtl\n";
    for (const std::string& corner : box_corners) text += "v " + corner + "\n";
    for (int k = 0; k < 6; ++k)
        text += before_side(k) + "f" + numbers_of(box_sides[static_cast<std::size_t>(k)], 1) + "\n";
    return text;
}

std::string off_box() {
    std::string text = "OFF # a box\n8 6 12\n";
    for (const std::string& corner : box_corners) text += corner + "\n";
    for (const auto& side : box_sides) text += "4" + numbers_of(side, 0) + " 255 0 0\n";
    return text;
}

std::string ply_header(const std::string& format) {
    return "ply\nformat " + format +
           " 1.0\ncomment a box\nelement vertex 8\nproperty float x\nproperty float y\nproperty uchar red\n"
           "property float z\nelement face 6\nproperty list uchar int vertex_indices\nend_header\n";
}

std::string ply_text() {
    std::string text = ply_header("ascii");
    for (const std::string& corner : box_corners) text += corner.substr(0, 3) + " 7" + corner.substr(3) + "\n";
    for (const auto& side : box_sides) text += "4" + numbers_of(side, 0) + "\n";
    return text;
}

std::string ply_binary(bool big_endian) {
    std::string text = ply_header(big_endian ? "binary_big_endian" : "binary_little_endian");
    const auto add = [&](std::uint32_t bits, unsigned bytes) {
        for (unsigned byte = 0; byte < bytes; ++byte)
            text += static_cast<char>(bits >> (8 * (big_endian ? bytes - 1 - byte : byte)) & 0xffU);
    };
    const auto number = [&](char digit) { add(std::bit_cast<std::uint32_t>(static_cast<float>(digit - '0')), 4); };
    for (const std::string& corner : box_corners) {
        number(corner[0]);
        number(corner[2]);
        add(7, 1);
        number(corner[4]);
    }
    for (const auto& side : box_sides) {
        add(4, 1);
        for (const int k : side) add(static_cast<std::uint32_t>(k), 4);
    }
    return text;
}

/// A PLY file with a long word for a type.
std::string with_word(std::size_t length) {
    return "ply\nformat ascii 1.0\nelement vertex 1\nproperty " + std::string(length, 'y') + " x\nend_header\n";
}

class TriangleGeometries : public GeometryFileTest {
  protected:
    [[nodiscard]] Geometry read_file(const std::string& name, const std::string& text,
                                     std::optional<double> unit = 1e-3) const {
        auto options = options_for(write(name, text));
        options.unit = unit;
        return read_geometry(options);
    }
    [[nodiscard]] std::string fault(const std::string& name, const std::string& text,
                                    std::optional<double> unit = 1e-3) const {
        try {
            (void)read_file(name, text, unit);
        } catch (const InputError& error) {
            return error.what();
        }
        return "no error";
    }
};

TEST_F(TriangleGeometries, ABoxInEachFormatIsOneSolidWithTheFilesName) {
    const std::vector<std::pair<std::string, std::string>> files{{"a box.obj", obj_box()},
                                                                 {"a box.off", off_box()},
                                                                 {"a box.ply", ply_text()},
                                                                 {"a box.PLY", ply_binary(false)},
                                                                 {"a box.ply", ply_binary(true)}};
    for (const auto& [name, text] : files) {
        SCOPED_TRACE(name);
        const Geometry geometry = read_file(name, text);
        EXPECT_EQ(geometry.dimension, 3);
        EXPECT_THAT(geometry.names(), ElementsAre("a_box"));
        ASSERT_NE(geometry.solid("a_box"), nullptr);
        EXPECT_EQ(geometry.solid("a_box")->surface.triangles.size(), 12U);
        EXPECT_EQ(geometry.solid("a_box")->surface.corners.size(), 8U);
        EXPECT_NEAR(geometry.solid("a_box")->volume(), 6e-9, 1e-20);
        EXPECT_EQ(geometry.box.high, Vec(3e-3, 2e-3, 1e-3));
        EXPECT_EQ(geometry.unit, 1e-3);
        EXPECT_EQ(geometry.unit_source, UnitSource::scene);
    }
}

TEST_F(TriangleGeometries, GroupsThatCloseTogetherAreASolidAndItsNamedSurfaces) {
    const Geometry geometry = read_file("duct.obj", obj_box([](int side) {
                                            return side == 5   ? std::string("g inlet\n")
                                                   : side == 3 ? std::string("g outlet\n")
                                                               : std::string("g wall\n");
                                        }));
    EXPECT_THAT(geometry.names(), ElementsAre("duct", "inlet", "outlet", "wall"));
    ASSERT_NE(geometry.solid("duct"), nullptr);
    EXPECT_NEAR(geometry.solid("duct")->volume(), 6e-9, 1e-20);
    EXPECT_NEAR(geometry.surface_set("inlet")->surface.area(), 2e-6, 1e-17);
    EXPECT_NEAR(geometry.surface_set("wall")->surface.area(), 18e-6, 1e-17);
    EXPECT_THAT(geometry.surface_set("inlet")->why_open, HasSubstr("4 edges of its surface have one side only"));
    EXPECT_EQ(geometry.surface_set("inlet")->surface.corners.size(), 4U);
}

TEST_F(TriangleGeometries, ClosedGroupsAreSolidsOfTheirOwnAndAHoleMakesASurface) {
    std::string two = obj_box([](int side) { return side == 0 ? std::string("o first body\n") : ""; });
    for (const std::string& corner : box_corners) two += "v 9" + corner.substr(1) + "\n";  // flat in x, and of no use
    const Geometry geometry = read_file("two.obj", two);
    EXPECT_THAT(geometry.names(), ElementsAre("first"));
    std::string open = obj_box();
    open = open.substr(0, open.rfind("f "));
    const Geometry holed = read_file("holed.obj", open);
    EXPECT_TRUE(holed.solids.empty());
    ASSERT_NE(holed.surface_set("holed"), nullptr);
    EXPECT_THAT(holed.surface_set("holed")->why_open,
                HasSubstr("it is not closed: 4 edges of its surface have one side only, the first from"));
}

TEST_F(TriangleGeometries, SolidsOfAnStlTextHaveTheirNames) {
    const auto facet = [](const char* a, const char* b, const char* c) {
        return std::string("facet normal 0 0 0\nouter loop\nvertex ") + a + "\nvertex " + b + "\nvertex " + c +
               "\nendloop\nendfacet\n";
    };
    const auto tetrahedron = [&](const std::string& name, const char* top) {
        return "solid " + name + "\n" + facet("0 0 0", "0 1 0", "1 0 0") + facet("0 0 0", "1 0 0", top) +
               facet("0 0 0", top, "0 1 0") + facet("1 0 0", "0 1 0", top) + "endsolid\n";
    };
    const Geometry geometry =
        read_file("a.stl", tetrahedron("upper (1)", "0 0 1") + tetrahedron("2nd", "0 0 -2") + "\n");
    EXPECT_THAT(geometry.names(), ElementsAre("part_2nd", "upper_1"));
    EXPECT_NEAR(geometry.solid("upper_1")->volume(), 1e-9 / 6, 1e-22);
    EXPECT_NEAR(geometry.solid("part_2nd")->volume(), 2e-9 / 6, 1e-22);
    EXPECT_THAT(geometry.warnings,
                ElementsAre("'upper (1)' is called 'upper_1' here", "'2nd' is called 'part_2nd' here",
                            "4 of the 4 triangles of 'part_2nd' faced inward and were turned"));
}

TEST_F(TriangleGeometries, NumbersOfCornersMayCountBackAndPolygonsMayBendInward) {
    // An L of six corners, extruded.
    std::string text;
    for (const char* z : {"0", "1"})
        for (const char* xy : {"0 0", "2 0", "2 1", "1 1", "1 2", "0 2"})
            text += std::string("v ") + xy + " " + z + "\n";
    text += "f 6 5 4 3 2 1\nf -6/1/1 -5//2 -4/3 -3 -2 -1\n";
    for (int k = 1; k <= 6; ++k) {
        const int next = k % 6 + 1;
        text += "f " + std::to_string(k) + " " + std::to_string(next) + " \\\n" + std::to_string(next + 6) + " " +
                std::to_string(k + 6) + "\n";
    }
    const Geometry geometry = read_file("l.obj", text, 1);
    ASSERT_NE(geometry.solid("l"), nullptr);
    EXPECT_NEAR(geometry.solid("l")->volume(), 3, 1e-12);
    EXPECT_NEAR(geometry.solid("l")->surface.area(), 2 * 3 + 8, 1e-12);  // triangles that overlap would have more
}

TEST(SplitPolygon, CoversEachPolygonOnce) {
    const auto area_of = [](const std::vector<Vec>& corners) {
        double sum = 0;
        for (const auto& [a, b, c] : split_polygon(corners)) {
            const Vec across = (corners[b] - corners[a]).cross(corners[c] - corners[a]);
            EXPECT_GE(across.z(), 0);
            sum += 0.5 * across.norm();
        }
        return sum;
    };
    EXPECT_NEAR(area_of({{0, 0, 0}, {2, 0, 0}, {0.5, 0.5, 0}, {0, 2, 0}}), 1, 1e-14);  // an arrow
    std::vector<Vec> star;
    for (int k = 0; k < 10; ++k) {
        const double radius = k % 2 == 0 ? 2 : 0.5, angle = 0.2 * 3.141592653589793 * k;
        star.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0);
    }
    EXPECT_NEAR(area_of(star), 5 * 2 * 0.5 * std::sin(0.2 * 3.141592653589793), 1e-12);
    EXPECT_EQ(split_polygon(std::vector<Vec>{{0, 0, 0}, {1, 0, 0}}).size(), 0U);
}

TEST(SplitPolygon, OfOneThatCoversItselfEnds) {
    // Twice around a circle: each corner is there twice, so that no triangle is an ear.
    std::vector<Vec> twice;
    const auto half = static_cast<int>(most_polygon_corners / 2);
    for (int k = 0; k < 2 * half; ++k) {
        const double angle = 2 * 3.141592653589793 * (k % half) / half;
        twice.emplace_back(std::cos(angle), std::sin(angle), 0);
    }
    // Within the time that CTest gives a test.
    EXPECT_EQ(split_polygon(twice).size(), most_polygon_corners - 2);
}

TEST_F(TriangleGeometries, AFileWithoutAUnitShowsWhatItsBoxMayBe) {
    EXPECT_EQ(
        fault("b.obj", obj_box(), std::nullopt),
        "scene.toml:6:8: the geometry '" + path("b.obj") +
            "' does not say its unit, and the scene gives none: is it 3 x 2 x 1 m, 3 x 2 x 1 mm or 3 x 2 x 1 um?\n"
            "  Give geometry.unit in the scene, \"1 m\", \"1 mm\" or \"1 um\"; on the command line --unit.");
    EXPECT_THAT(fault("b.stl", "solid a\nendsolid\n", std::nullopt), HasSubstr("has no triangle with an area"));
}

/// Each: file, contents, what the error says.
TEST_F(TriangleGeometries, WrongOnesAreRefusedWithTheirLine) {
    const auto with = [](std::string text, const std::string& found, const std::string& replacement) {
        const auto at = text.find(found);
        EXPECT_NE(at, std::string::npos) << found;
        return text.replace(at, found.size(), replacement);
    };
    const std::string cut = ply_binary(false).substr(0, ply_binary(false).size() - 3);
    struct Wrong {
        std::string name, text, says;
    };
    const std::vector<Wrong> all{
        {"a.obj", "", "' is empty"},
        {"a.stl", "", "' is empty"},
        {"a.obj", obj_box() + "f 1 2 9\n", "a.obj:17:1: a face has corner 9, and there are 8 so far"},
        {"a.obj", obj_box() + "f 1 2 0\n", "a.obj:17:1: a face has corner 0"},
        {"a.obj", obj_box() + "f 1 2 -9\n", "a face has corner -9"},
        {"a.obj", obj_box() + "f 1 2\n", "a.obj:17:1: a face has 2 corners"},
        {"a.obj", obj_box() + "f 1 b 3\n", "expected the number of a corner, found \"b\""},
        {"a.obj", with(obj_box(), "v 3 2 0", "v nan 2 0"), "a.obj:5:1: corner 3 is not finite"},
        {"a.obj", with(obj_box(), "v 3 2 0", "v 1e999 2 0"), "a.obj:5:1: corner 3 is not finite"},
        {"a.obj", with(obj_box(), "v 3 2 0", "v 3 2"), "a.obj:5:1: expected three numbers after 'v', found \"v 3 2\""},
        {"a.obj", obj_box() + "surf 0 1 0 1 1 2\n", "'surf' is not read"},
        {"a.obj", "v 0 0 0\n", "has no triangle with an area"},
        {"a.off", "hello\n", "is no OFF file"},
        {"a.off", "OFF\n8 six 12\n", "a.off:2:1: expected the numbers of corners, faces and edges"},
        {"a.off", with(off_box(), "8 6 12", "8 7 12"), "the file ends before face 7 of 7"},
        {"a.off", with(off_box(), "8 6 12", "9000000000 6 12"), "a.off:2:1: the file states 9000000000 corners and 6"},
        {"a.off", with(off_box(), "8 6 12", "-8 6 12"), "expected the numbers of corners"},
        {"a.off", with(off_box(), "8 6 12", "8 5 12"), "a.off:16:1: the file goes on after the 5 faces that it states"},
        {"a.off", with(off_box(), "4 0 3 2 1", "4 0 3 2 8"),
         "a.off:11:1: a face has corner \"8\", and corners count from 0 to 7"},
        {"a.off", with(off_box(), "4 0 3 2 1", "9 0 3 2 1"), "a.off:11:1: expected a face"},
        {"a.off", with(off_box(), "3 2 0\n", "3 inf 0\n"), "a.off:5:1: corner 2 is not finite"},
        {"a.ply", "solid\n", "is no PLY file, or one that was cut off"},
        {"a.ply", with(ply_text(), "ply\n", "PLY?\n"), "it does not begin with 'ply'"},
        {"a.ply", with(ply_text(), "end_header", "end_of_it"), "its header has no end"},
        {"a.ply", with(ply_text(), "ascii", "binary"), "a.ply:2:1: 'binary' is no format of PLY files"},
        {"a.ply", with(ply_text(), "float x", "half x"), "a.ply:5:1: cannot read \"property half x\""},
        {"a.ply", with(ply_text(), "float z", "float w"), "element 'vertex' has no x, y and z"},
        {"a.ply", with(ply_text(), "element face 6", "element side 6"), "has no element 'face'"},
        {"a.ply", with(ply_text(), "vertex 8", "vertex 9"), "face 0 has 1 corners"},
        {"a.ply", with(ply_text(), "face 6", "face 7"), "the file ends, or has no number, in 'face' 6 of 7"},
        {"a.ply", with(ply_text(), "vertex 8", "vertex 90000000000"),
         "the header states 90000000000 of element 'vertex', more than the file's"},
        {"a.ply", with(ply_binary(true), "face 6", "face 4000000000"),
         "the header states 4000000000 of element 'face'"},
        {"a.ply", with(ply_text(), "4 0 3 2 1", "4 0 3 2 8"), "face 0 has a corner that is not among the 8 before it"},
        {"a.ply", with(ply_text(), "4 0 3 2 1", "4 0 3 2 -1"), "face 0 has a corner that is not among the 8 before it"},
        {"a.ply", with(ply_text(), "3 2 7 0", "nan 2 7 0"), "vertex 2 is not finite"},
        {"a.ply", with(ply_text(), "face 6", "face 5"),
         "the file goes on after the last 'face' that its header states"},
        {"a.ply", with(ply_binary(true), "face 6", "face 5"), "the file goes on after the last 'face'"},
        {"a.ply", ply_binary(false) + "x", "the file goes on after the last 'face'"},
        {"a.ply", cut, "the file ends, or has no number, in 'face' 5 of 6"},
        {"a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nf 3 2 1\n", "solid 'a' is closed, but encloses no volume"},
    };
    for (const auto& [name, text, says] : all) EXPECT_THAT(fault(name, text), HasSubstr(says));
}

TEST_F(TriangleGeometries, ABinaryStlThatWasCutOffSaysWhatIsMissing) {
    std::string text(80, ' ');
    text += std::string("\x10\x27\0\0", 4) + std::string(50, '\0');  // says 10,000 triangles
    EXPECT_THAT(fault("a.stl", text), HasSubstr("for its 10000 triangles it needs 500084 bytes, and it has 134"));
    std::filesystem::create_directory(path("folder.stl"));
    EXPECT_THAT(fault("folder.stl", ""), HasSubstr("folder.stl' is a folder"));
}

TEST_F(TriangleGeometries, BlanksBehindTheLastFaceAreNothing) {
    EXPECT_EQ(read_file("a.ply", ply_text() + "\n \n").solids.size(), 1U);
    EXPECT_EQ(read_file("a.ply", ply_binary(true) + std::string("\n\0\0", 3)).solids.size(), 1U);
    EXPECT_EQ(read_file("a.off", off_box() + "\n # done\n").solids.size(), 1U);
}

TEST_F(TriangleGeometries, LinesGoOnInObjOnly) {
    EXPECT_EQ(read_file("a.ply", ply_header("ascii").insert(4, "comment of C:\\\n") +
                                     ply_text().substr(ply_header("ascii").size()))
                  .solids.size(),
              1U);
    EXPECT_EQ(read_file("a.obj", "v 0 0 \\\n0\nv 1 0 0\nv 0 1 0\nf 1 2 \\\n 3\n").surfaces.size(), 1U);
}

TEST_F(TriangleGeometries, MessagesShowTheBeginningOfWhatCannotBePrinted) {
    const std::string long_line = "v 1 2\t\x1b[31m\xff" + std::string(100000, 'x') + "\n";
    EXPECT_THAT(fault("a.obj", long_line),
                HasSubstr("expected three numbers after 'v', found \"v 1 2 ?[31m?" + std::string(48, 'x') + "...\""));
    EXPECT_LT(fault("a.ply", with_word(100000)).size(), 600U);
}

TEST_F(TriangleGeometries, EdgesWithoutClearSidesHaveAPlace) {
    const Geometry fin = read_file("fin.obj", obj_box() + "v 5 5 5\nf 1 2 9\n", 1);
    ASSERT_NE(fin.surface_set("fin"), nullptr);
    EXPECT_THAT(fin.surface_set("fin")->why_open, HasSubstr("2 edges of its surface have one side only"));
    // Two boxes of one edge: no edge is open, and one has four triangles.
    std::string two = obj_box();
    for (const std::string& corner : box_corners)
        two += "v " + std::to_string(corner[0] - '0' + 3) + " " + std::to_string(corner[2] - '0' + 2) +
               corner.substr(3) + "\n";
    for (const auto& side : box_sides) two += "f" + numbers_of(side, 9) + "\n";
    const Geometry edge = read_file("edge.obj", two, 1);
    ASSERT_NE(edge.surface_set("edge"), nullptr);
    EXPECT_THAT(edge.surface_set("edge")->why_open,
                HasSubstr("1 edges of its surface have more than two sides, or two that cannot both face outward, the "
                          "first near (3, 2, 0.5) m"));
}

TEST_F(TriangleGeometries, BodiesOfAGroupThatCrossAllFaceOutward) {
    for (const char* shift : {"1.5 0.9 0.4", "0.1 0.1 0.9", "-1 -1 -0.5"}) {
        std::string two = obj_box();
        double x = 0, y = 0, z = 0;
        std::istringstream(shift) >> x >> y >> z;
        for (const std::string& corner : box_corners) {
            double a = 0, b = 0, c = 0;
            std::istringstream(corner) >> a >> b >> c;
            two += "v " + std::to_string(a + x) + " " + std::to_string(b + y) + " " + std::to_string(c + z) + "\n";
        }
        for (const auto& side : box_sides) two += "f" + numbers_of(side, 9) + "\n";
        const Geometry geometry = read_file("two.obj", two, 1);
        ASSERT_NE(geometry.solid("two"), nullptr) << shift;
        EXPECT_NEAR(geometry.solid("two")->volume(), 12, 1e-5) << shift << ": the room that both have counts twice";
    }
}

TEST(PlainName, IsWhatScenesAllow) {
    EXPECT_EQ(plain_name("blood"), "blood");
    EXPECT_EQ(plain_name("a__b_"), "a__b_");
    EXPECT_EQ(plain_name("Body 1 (left)"), "Body_1_left");
    EXPECT_EQ(plain_name("3d-print.v2"), "part_3d_print_v2");
    const std::string hundred(100, 'a');
    EXPECT_EQ(plain_name(hundred), hundred);
    EXPECT_EQ(plain_name(hundred + "b").size(), 100U);
    EXPECT_NE(plain_name(hundred + "b"), plain_name(hundred + "c"));
    EXPECT_EQ(plain_name("_hidden"), "hidden");
    EXPECT_EQ(plain_name("gr\xc3\xb6\xc3\x9f"), "gr");
    EXPECT_EQ(plain_name("???"), "");
    EXPECT_EQ(plain_name("Created by Gmsh"), "");
    EXPECT_EQ(plain_name("Open CASCADE STEP translator 7.6 1"), "");
    EXPECT_EQ(plain_name("SOLID"), "");
    EXPECT_EQ(plain_name("solid"), "solid");
    EXPECT_EQ(name_of_file("/tmp/my artery.stl"), "my_artery");
    EXPECT_EQ(name_of_file("\xc3\xb6.stl"), "body");
}

}  // namespace
}  // namespace dmp::tests::triangle_files_tests
