// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numbers>
#include <stdexcept>

#include <gtest/gtest.h>

#include "geometry/geometry.hpp"
#include "tests/modules.hpp"

namespace dmp::tests::polyline_tests {
namespace {

const Polyline corner{.points = {{0, 0, 0}, {3, 0, 0}, {3, 4, 0}}};
const Polyline triangle{.points = {{0, 0, 0}, {3, 0, 0}, {3, 4, 0}}, .closed = true};

TEST(Polyline, LengthCountsTheClosingSegmentOfAClosedLineOnly) {
    EXPECT_DOUBLE_EQ(corner.length(), 7);
    EXPECT_DOUBLE_EQ(triangle.length(), 12);
    EXPECT_EQ(Polyline{}.length(), 0);
    EXPECT_EQ((Polyline{.points = {{1, 2, 3}}, .closed = true}).length(), 0);
}

TEST(Polyline, LengthOfARegularPolygon) {
    constexpr int n = 360;
    Polyline circle{.points = {}, .closed = true};
    for (int i = 0; i < n; ++i) {
        const double angle = 2 * std::numbers::pi * i / n;
        circle.points.emplace_back(std::cos(angle), std::sin(angle), 0);
    }
    EXPECT_NEAR(circle.length(), 2 * n * std::sin(std::numbers::pi / n), 1e-12);
}

TEST(Polyline, AtWalksAlongTheLine) {
    const auto [point, tangent] = corner.at(5);
    EXPECT_EQ(point, Vec(3, 2, 0));
    EXPECT_EQ(tangent, Vec(0, 1, 0));
    EXPECT_EQ(corner.at(0).first, Vec(0, 0, 0));
    EXPECT_EQ(corner.at(1.5).first, Vec(1.5, 0, 0));
    EXPECT_EQ(corner.at(7).first, Vec(3, 4, 0));
}

TEST(Polyline, AtACornerTheTangentIsThatOfTheSegmentBefore) {
    const auto [point, tangent] = corner.at(3);
    EXPECT_EQ(point, Vec(3, 0, 0));
    EXPECT_EQ(tangent, Vec(1, 0, 0));
}

TEST(Polyline, AtReachesTheClosingSegment) {
    const auto [point, tangent] = triangle.at(9.5);
    EXPECT_NEAR((point - Vec(1.5, 2, 0)).norm(), 0, 1e-15);
    EXPECT_NEAR((tangent - Vec(-0.6, -0.8, 0)).norm(), 0, 1e-15);
    EXPECT_EQ(triangle.at(12).first, Vec(0, 0, 0));
}

TEST(Polyline, AtSkipsRepeatedPoints) {
    const Polyline line{.points = {{0, 0, 0}, {0, 0, 0}, {1, 0, 0}, {1, 0, 0}}};
    EXPECT_EQ(line.at(0).second, Vec(1, 0, 0));
    EXPECT_EQ(line.at(1).first, Vec(1, 0, 0));
}

TEST(Polyline, AtRefusesWhatIsNotOnTheLine) {
    EXPECT_THROW((void)corner.at(-0.1), std::out_of_range);
    EXPECT_THROW((void)corner.at(7.1), std::out_of_range);
    EXPECT_THROW((void)corner.at(std::nan("")), std::out_of_range);
    EXPECT_THROW((void)Polyline{}.at(0), std::out_of_range);
}

TEST(Geometry, FindsItsPartsByNameAndListsEachNameOnce) {
    Geometry geometry;
    geometry.regions.push_back({.name = "water", .loops = {triangle}});
    geometry.curves.push_back({.name = "wall", .pieces = {corner}});
    geometry.curves.push_back({.name = "water", .pieces = {corner, triangle}});
    geometry.points["probe"] = {{1, 1, 0}};
    EXPECT_EQ(geometry.names(), (std::vector<std::string>{"probe", "wall", "water"}));
    EXPECT_EQ(geometry.region("water"), &geometry.regions.front());
    EXPECT_EQ(geometry.region("wall"), nullptr);
    EXPECT_EQ(geometry.curve_set("water"), &geometry.curves[1]);
    EXPECT_DOUBLE_EQ(geometry.curve_set("water")->length(), 19);
    EXPECT_EQ(geometry.curve_set("probe"), nullptr);
}

}  // namespace
}  // namespace dmp::tests::polyline_tests
