// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <clocale>
#include <cmath>
#include <numbers>
#include <thread>

#include <omp.h>

#include "temporary_geometry.hpp"
#include "tests/modules.hpp"

namespace dmp::tests::read_geometry_tests {
namespace {

constexpr double pi = std::numbers::pi;

using ReadGeometry = GeometryFileTest;

const std::string named_square =
    unit_square + "Physical Surface(\"water\") = {1};\nPhysical Curve(\"wall\") = {1, 3};\n";

TEST_F(ReadGeometry, NamesScalesAndBoundsASquare) {
    auto options = options_for(write("domain.geo", named_square + "Physical Point(\"corner\") = {3};\n"));
    options.unit = 0.001;
    const Geometry geometry = read_geometry(options);
    EXPECT_EQ(geometry.file, options.file);
    EXPECT_EQ(geometry.dimension, 2);
    EXPECT_EQ(geometry.names(), (std::vector<std::string>{"corner", "wall", "water"}));
    EXPECT_NEAR(geometry.region("water")->area(), 1e-6, 1e-20);
    EXPECT_EQ(geometry.box.low, Vec(0, 0, 0));
    EXPECT_EQ(geometry.box.high, Vec(0.001, 0.001, 0));
    ASSERT_EQ(geometry.curve_set("wall")->pieces.size(), 2U);
    EXPECT_EQ(geometry.curve_set("wall")->pieces[0].points, (std::vector<Vec>{{0, 0, 0}, {0.001, 0, 0}}));
    EXPECT_EQ(geometry.points.at("corner"), (std::vector<Vec>{{0.001, 0.001, 0}}));
    EXPECT_TRUE(geometry.warnings.empty());
}

TEST_F(ReadGeometry, LoopsCloseBitForBitAndTurnLeft) {
    const Geometry geometry = read(
        "Point(1) = {0.1, 0.2, 0};\nPoint(2) = {0.4, 0.2, 0};\nPoint(3) = {0.1, 0.5, 0};\n"
        "Line(1) = {1, 2};\nCircle(2) = {2, 1, 3};\nLine(3) = {3, 1};\n"
        "Curve Loop(1) = {-3, -2, -1};\nPlane Surface(1) = {1};\nPhysical Surface(\"quarter\") = {1};\n"
        "Physical Curve(\"arc\") = {2};\nPhysical Point(\"ends\") = {2, 3};\n");
    const auto& loops = geometry.region("quarter")->loops;
    ASSERT_EQ(loops.size(), 1U);
    const auto& arc = geometry.curve_set("arc")->pieces.at(0).points;
    EXPECT_EQ(arc.front(), geometry.points.at("ends")[0]);
    EXPECT_EQ(arc.back(), geometry.points.at("ends")[1]);
    for (const auto& point : arc) EXPECT_EQ(std::ranges::count(loops[0].points, point), 1);
    EXPECT_EQ(loops[0].points.size(), arc.size() + 1);
    double twice = 0;
    for (std::size_t i = 0; i < loops[0].points.size(); ++i) {
        twice += loops[0].points[i].cross(loops[0].points[(i + 1) % loops[0].points.size()]).z();
    }
    EXPECT_NEAR(twice / 2, pi * 0.09 / 4, 1e-6);
}

TEST_F(ReadGeometry, AnArcStaysWithinTheChordErrorAndIsNotFinerThanNeeded) {
    auto options = options_for(write("domain.geo",
                                     "Point(1) = {0, 0, 0};\nPoint(2) = {7, 0, 0};\nPoint(3) = {0, 7, 0};\n"
                                     "Circle(1) = {2, 1, 3};\nPhysical Curve(\"arc\") = {1};\n"));
    options.unit = 1e-3;
    for (const double chord_error : {1e-4, 1e-5, 1e-6, 1e-8}) {
        options.chord_error = chord_error;
        const Geometry geometry = read_geometry(options);
        const auto& points = geometry.curve_set("arc")->pieces.at(0).points;
        for (std::size_t i = 0; i + 1 < points.size(); ++i) {
            EXPECT_NEAR(points[i].norm(), 7e-3, 1e-17);
            // The sagitta of a chord, without the difference of two large numbers.
            const double half = (points[i + 1] - points[i]).norm() / 2;
            const double sagitta = half * half / (7e-3 + std::sqrt(49e-6 - half * half));
            EXPECT_LE(sagitta, chord_error);
        }
        const double fewest = pi / 4 / std::acos(1 - chord_error / 7e-3);
        EXPECT_LT(static_cast<double>(points.size()), std::max(9.0, 2.1 * fewest + 1));
    }
}

TEST_F(ReadGeometry, ASplineKeepsItsEndsAndPassesItsPoints) {
    const Geometry geometry = read(
        "Point(1) = {0, 0, 0};\nPoint(2) = {1, 1, 0};\nPoint(3) = {2, -1, 0};\nPoint(4) = {3, 0, 0};\n"
        "Spline(1) = {1, 2, 3, 4};\nPhysical Curve(\"s\") = {1};\n");
    const auto& set = *geometry.curve_set("s");
    EXPECT_EQ(set.pieces.at(0).points.front(), Vec(0, 0, 0));
    EXPECT_EQ(set.pieces.at(0).points.back(), Vec(3, 0, 0));
    EXPECT_LE(set.nearest({1, 1, 0}).distance, 1e-6);
    EXPECT_LE(set.nearest({2, -1, 0}).distance, 1e-6);
}

TEST_F(ReadGeometry, CurvesJoinIntoChainsAcrossTheGroupsNumbers) {
    const Geometry geometry = read(unit_square + "Physical Curve(\"u\") = {4, 1, 2};\n");
    const auto& pieces = geometry.curve_set("u")->pieces;
    ASSERT_EQ(pieces.size(), 1U);
    EXPECT_EQ(pieces[0].points, (std::vector<Vec>{{0, 1, 0}, {0, 0, 0}, {1, 0, 0}, {1, 1, 0}}));
    EXPECT_EQ(geometry.curve_set("u")->length(), 3);
}

TEST_F(ReadGeometry, TheEdgeBetweenTwoSurfacesOfARegionIsInside) {
    const Geometry geometry = read(unit_square +
                                   "Point(5) = {2, 0, 0};\nPoint(6) = {2, 1, 0};\n"
                                   "Line(5) = {2, 5};\nLine(6) = {5, 6};\nLine(7) = {6, 3};\n"
                                   "Curve Loop(2) = {5, 6, 7, -2};\nPlane Surface(2) = {2};\n"
                                   "Physical Surface(\"both\") = {1, 2};\nPhysical Surface(\"right\") = {2};\n");
    EXPECT_EQ(geometry.region("both")->loops.size(), 1U);
    EXPECT_EQ(geometry.region("both")->area(), 2);
    EXPECT_EQ(geometry.region("both")->side_of({1, 0.5, 0}), Side::inside);
    EXPECT_EQ(geometry.region("right")->side_of({1, 0.5, 0}), Side::on_edge);
    EXPECT_EQ(geometry.region("right")->area(), 1);
}

TEST_F(ReadGeometry, HolesOfTheOpenCascadeKernel) {
    const Geometry geometry = read(
        "SetFactory(\"OpenCASCADE\");\nRectangle(1) = {0, 0, 0, 4, 4};\nDisk(2) = {2, 2, 0, 1};\n"
        "BooleanDifference(3) = { Surface{1}; Delete; }{ Surface{2}; Delete; };\nPhysical Surface(\"plate\") = {3};\n");
    const Region& plate = *geometry.region("plate");
    EXPECT_EQ(plate.loops.size(), 2U);
    EXPECT_NEAR(plate.area(), 16 - pi, 2 * pi * 1e-6);
    EXPECT_EQ(plate.side_of({2, 2, 0}), Side::outside);
    EXPECT_EQ(plate.side_of({0.5, 2, 0}), Side::inside);
}

TEST_F(ReadGeometry, ParametersReplaceConstants) {
    const std::string text =
        "DefineConstant[ width = {2, Name \"width\"}, height = {3, Min 1, Max 5, Name \"Size/height\"} ];\n"
        "Point(1) = {0, 0, 0};\nPoint(2) = {width, height, 0};\nLine(1) = {1, 2};\nPhysical Curve(\"line\") = {1};\n";
    auto options = options_for(write("domain.geo", text));
    EXPECT_EQ(read_geometry(options).box.high, Vec(2, 3, 0));
    options.parameters = {{"width", 0.1}, {"Size/height", 0.7}};
    EXPECT_EQ(read_geometry(options).box.high, Vec(0.1, 0.7, 0));
    options.parameters = {};
    EXPECT_EQ(read_geometry(options).box.high, Vec(2, 3, 0));  // nothing is left of the last reading
}

TEST_F(ReadGeometry, AParameterMayBringOthersToLight) {
    auto options = options_for(write("domain.geo",
                                     "DefineConstant[ round = {0, Name \"round\"} ];\nr = 1;\n"
                                     "If (round)\n  DefineConstant[ radius = {2, Name \"radius\"} ];\n  r = radius;\n"
                                     "EndIf\nPoint(1) = {r, 0, 0};\nPoint(2) = {0, 0, 0};\nLine(1) = {1, 2};\n"
                                     "Physical Curve(\"line\") = {1};\n"));
    options.parameters = {{"radius", 5}, {"round", 1}};
    EXPECT_EQ(read_geometry(options).box.high, Vec(5, 0, 0));
    options.parameters = {{"radius", 5}};
    EXPECT_THROW(read_geometry(options), InputError);
}

TEST_F(ReadGeometry, ReadsUnrolledScriptsAndOddFileNames) {
    EXPECT_NEAR(read_geometry(options_for(write("a domain.geo_unrolled", named_square))).region("water")->area(), 1, 0);
    EXPECT_NEAR(read_geometry(options_for(write("DRAWING.GEO", named_square))).region("water")->area(), 1, 0);
}

/// A square of two triangles (order 1) with the lower side named, in MSH 4.1.
const std::string square_mesh =
    "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n"
    "$PhysicalNames\n3\n0 3 \"corner\"\n1 1 \"wall\"\n2 2 \"water\"\n$EndPhysicalNames\n"
    "$Entities\n1 1 1 0\n1 0 0 0 1 3\n1 0 0 0 2 0 0 1 1 0\n1 0 0 0 2 2 0 1 2 0\n$EndEntities\n"
    "$Nodes\n3 5 1 5\n0 1 0 1\n1\n0 0 0\n1 1 0 2\n2\n3\n1 0 0\n2 0 0\n2 1 0 2\n4\n5\n2 2 0\n0 2 0\n$EndNodes\n"
    "$Elements\n3 6 1 6\n0 1 15 1\n1 1\n1 1 1 2\n2 1 2\n3 2 3\n2 1 2 3\n4 1 2 5\n5 2 4 5\n6 2 3 4\n$EndElements\n";

TEST_F(ReadGeometry, AMeshGivesItsEdges) {
    auto options = options_for(write("square.msh", square_mesh));
    options.unit = 0.5;
    const Geometry geometry = read_geometry(options);
    EXPECT_EQ(geometry.names(), (std::vector<std::string>{"corner", "wall", "water"}));
    EXPECT_EQ(geometry.region("water")->loops.size(), 1U);
    EXPECT_EQ(geometry.region("water")->loops[0].points.size(), 5U);
    EXPECT_EQ(geometry.region("water")->area(), 1);
    EXPECT_EQ(geometry.region("water")->side_of({0.4, 0.6, 0}), Side::inside);  // on an edge between two triangles
    ASSERT_EQ(geometry.curve_set("wall")->pieces.size(), 1U);
    EXPECT_EQ(geometry.curve_set("wall")->pieces[0].points, (std::vector<Vec>{{0, 0, 0}, {0.5, 0, 0}, {1, 0, 0}}));
    EXPECT_EQ(geometry.points.at("corner"), (std::vector<Vec>{{0, 0, 0}}));
}

TEST_F(ReadGeometry, LeavesThreadsAndLocaleAsTheyWere) {
    omp_set_num_threads(3);
    ASSERT_NE(std::setlocale(LC_ALL, "C.UTF-8"), nullptr);
    (void)read(named_square);
    EXPECT_THROW((void)read("Point(1) = {\n"), InputError);
    EXPECT_EQ(omp_get_max_threads(), 3);
    EXPECT_STREQ(std::setlocale(LC_ALL, nullptr), "C.UTF-8");
}

TEST_F(ReadGeometry, SaysNothingOnTheTerminal) {
    ::testing::internal::CaptureStdout();
    ::testing::internal::CaptureStderr();
    (void)read(named_square + "Printf(\"hello\");\n");
    EXPECT_THROW((void)read("Point(1) = {\n"), InputError);
    EXPECT_EQ(::testing::internal::GetCapturedStdout(), "");
    EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
}

TEST_F(ReadGeometry, ReadsAgainAfterAnError) {
    EXPECT_THROW((void)read("a = 7;\nPoint(1) = {0, 0\n"), InputError);
    EXPECT_EQ(read(named_square).region("water")->area(), 1);
    EXPECT_THROW((void)read("Point(1) = {a, 0, 0};\n"), InputError);  // the constant of the first script is gone
}

TEST_F(ReadGeometry, SeveralThreadsMayRead) {
    const auto options = options_for(write("domain.geo", named_square));
    std::array<double, 4> areas{};
    std::vector<std::thread> threads;
    threads.reserve(areas.size());
    for (auto& area : areas) threads.emplace_back([&] { area = read_geometry(options).region("water")->area(); });
    for (auto& thread : threads) thread.join();
    for (const double area : areas) EXPECT_EQ(area, 1);
}

}  // namespace
}  // namespace dmp::tests::read_geometry_tests
