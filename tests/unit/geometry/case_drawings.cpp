// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "geometry/inside_test.hpp"

namespace dmp {
namespace {

constexpr double pi = std::numbers::pi;

Geometry read_case(const std::string& drawing, const std::map<std::string, double>& parameters = {}) {
    DrawingOptions options;
    options.file = DMP_SOURCE_DIR "/cases/" + drawing;
    options.parameters = parameters;
    return read_drawing(options);
}

Geometry vein_valve(const std::map<std::string, double>& parameters = {}) {
    return read_case("vein_valve/vein_valve.geo", parameters);
}

/// Area between y = 0 and an ellipse with semi-axes a, b around the origin, for |x| <= c.
double ellipse_slice(double a, double b, double c) {
    return b * (c * std::sqrt(1 - c * c / (a * a)) + a * std::asin(c / a));
}

double vein_valve_area(double half_width, double domain, double chamber, double height) {
    const double corner = chamber / 2;
    const double a = corner / std::sqrt(1 - std::pow(half_width / height, 2));
    return 2 * half_width * (domain - chamber) + 2 * ellipse_slice(a, height, corner);
}

std::string error_of(const std::string& drawing, const std::map<std::string, double>& parameters) {
    try {
        (void)read_case(drawing, parameters);
    } catch (const InputError& error) {
        return error.problem();
    }
    return "no error";
}

TEST(VeinValve, NamesAndBox) {
    const Geometry valve = vein_valve();
    EXPECT_EQ(valve.names(), (std::vector<std::string>{"blood", "leaflet_roots", "leaflets", "wall"}));
    EXPECT_NEAR((valve.box.low - Vec(-0.046, -0.007, 0)).norm(), 0, 1e-15);
    EXPECT_NEAR((valve.box.high - Vec(0.046, 0.007, 0)).norm(), 0, 1e-15);
    EXPECT_TRUE(valve.warnings.empty());
}

TEST(VeinValve, AreaAgainstTheEllipsesClosedForm) {
    // The chords lie inside the ellipses by at most the chord error.
    const double expected = vein_valve_area(0.004, 0.092, 0.040, 0.007);
    EXPECT_NEAR(expected, 904e-6, 1e-6);
    const double area = vein_valve().region("blood")->area();
    EXPECT_LE(area, expected);
    EXPECT_GT(area, expected - 2 * 0.044 * 1e-6);
    const std::map<std::string, double> other{
        {"half_width", 0.005}, {"domain_length", 0.120}, {"chamber_length", 0.030}, {"chamber_height", 0.009}};
    EXPECT_NEAR(vein_valve(other).region("blood")->area(), vein_valve_area(0.005, 0.120, 0.030, 0.009), 1e-7);
}

TEST(VeinValve, WallLiesOnTheEllipse) {
    const Geometry valve = vein_valve();
    const CurveSet& wall = *valve.curve_set("wall");
    ASSERT_EQ(wall.pieces.size(), 2U);
    const double a = 0.020 / std::sqrt(1 - 16.0 / 49.0);
    for (const auto& piece : wall.pieces) {
        EXPECT_FALSE(piece.closed);
        EXPECT_EQ(piece.points.front().x(), -0.046);  // in the direction of x
        EXPECT_EQ(piece.points.back().x(), 0.046);
        for (const auto& point : piece.points) {
            if (std::abs(point.x()) > 0.020) {
                EXPECT_EQ(std::abs(point.y()), 0.004);
            } else {
                EXPECT_NEAR(std::abs(point.y()), 0.007 * std::sqrt(1 - point.x() * point.x() / (a * a)), 1e-15);
            }
        }
    }
    // Chord error: the ellipse is nowhere further from the polyline than asked for.
    for (int i = -1000; i <= 1000; ++i) {
        const double x = 0.020 * i / 1000;
        EXPECT_LE(wall.nearest({x, 0.007 * std::sqrt(1 - x * x / (a * a)), 0}).distance, 1e-6);
    }
}

TEST(VeinValve, LeafletsLeanFromTheirRootsToTheGap) {
    for (const auto& [length, gap] : {std::pair{0.0175, 0.002}, std::pair{0.0256, 0.001}}) {
        const Geometry valve = vein_valve({{"leaflet_length", length}, {"tip_gap", gap}});
        const auto& leaflets = valve.curve_set("leaflets")->pieces;
        const auto& roots = valve.points.at("leaflet_roots");
        ASSERT_EQ(leaflets.size(), 2U);
        ASSERT_EQ(roots.size(), 2U);
        const double lean = std::asin((0.004 - gap / 2) / length);
        for (std::size_t i = 0; i < 2; ++i) {
            const double up = i == 0 ? 1 : -1;
            ASSERT_EQ(leaflets[i].points.size(), 2U);
            EXPECT_NEAR(leaflets[i].length(), length, 1e-16);
            EXPECT_EQ(leaflets[i].points[0], roots[i]);
            EXPECT_EQ(roots[i], Vec(-0.020, up * 0.004, 0));
            EXPECT_NEAR(leaflets[i].points[1].x(), -0.020 + length * std::cos(lean), 1e-16);
            EXPECT_EQ(leaflets[i].points[1].y(), up * gap / 2);
            EXPECT_EQ(valve.curve_set("wall")->nearest(roots[i]).distance, 0);
        }
    }
}

TEST(VeinValve, TheFluidDoesNotEndAtTheLeaflets) {
    const Geometry valve = vein_valve();
    const Region& blood = *valve.region("blood");
    const auto [middle, tangent] = valve.curve_set("leaflets")->pieces[0].at(0.00875);
    EXPECT_EQ(blood.side_of(middle), Side::inside);
    EXPECT_EQ(blood.side_of(valve.points.at("leaflet_roots")[0]), Side::on_edge);
    EXPECT_EQ(blood.side_of({0.046, 0.001, 0}), Side::on_edge);
}

TEST(VeinValve, BothInsideTestsAgreeOnRandomAndLatticePoints) {
    const Geometry valve = vein_valve();
    const Region& blood = *valve.region("blood");
    const InsideTest test(blood);
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> x(-0.05, 0.05);
    std::uniform_real_distribution<double> y(-0.008, 0.008);
    std::vector<Vec> points;
    points.reserve(5000);
    for (int i = 0; i < 5000; ++i) points.emplace_back(x(random), y(random), 0);
    for (int i = -250; i <= 250; ++i) {
        for (int j = -40; j <= 40; ++j) points.emplace_back(2e-4 * i, 2e-4 * j, 0);
    }
    for (const auto& vertex : blood.loops[0].points) {
        points.push_back(vertex);
        points.emplace_back(-0.03, vertex.y(), 0);  // its ray passes through the vertex
        points.emplace_back(vertex.x(), 0.0, 0);
    }
    std::array<int, 3> count{};
    for (const auto& point : points) {
        const Side side = test.side_of(point);
        ASSERT_EQ(side, blood.side_of(point)) << point.transpose();
        ++count[static_cast<std::size_t>(side)];
    }
    for (const int sides : count) EXPECT_GT(sides, 400);
}

TEST(VeinValve, RefusesParametersThatMakeNoValve) {
    const auto error = [](const std::map<std::string, double>& parameters) {
        return error_of("vein_valve/vein_valve.geo", parameters);
    };
    EXPECT_EQ(error({{"leaflet_length", 0.002}}),
              "gmsh cannot read the drawing: leaflet_length is too short to reach tip_gap: it must exceed half_width - "
              "tip_gap/2");
    EXPECT_EQ(error({{"tip_gap", 0.009}}), "gmsh cannot read the drawing: tip_gap is wider than the vein");
    EXPECT_EQ(error({{"tip_gap", 0}}), "gmsh cannot read the drawing: half_width and tip_gap must be positive");
    EXPECT_EQ(error({{"chamber_height", 0.004}}),
              "gmsh cannot read the drawing: chamber_height must exceed half_width");
    EXPECT_EQ(error({{"domain_length", 0.04}}),
              "gmsh cannot read the drawing: chamber_length must be positive, and domain_length must exceed it");
}

TEST(BentChannel, AreaIsTheCentreLineTimesTheWidth) {
    const auto expected = [](double half_width, double domain, double radius, double angle, double leg) {
        const double level = domain - 2 * (2 * radius * std::sin(angle) + leg * std::cos(angle));
        return 2 * half_width * (level + 4 * radius * angle + 2 * leg);
    };
    // Chord errors on inner and outer arcs nearly cancel: what is lost outside is won inside.
    EXPECT_NEAR(read_case("bent_channel/bent_channel.geo").region("blood")->area(),
                expected(0.003, 0.060, 0.012, pi / 3, 0.004), 2 * 0.05 * 1e-6);
    const auto steep = read_case("bent_channel/bent_channel.geo", {{"bend_angle", pi / 2}, {"leg_length", 0.006}});
    EXPECT_NEAR(steep.region("blood")->area(), expected(0.003, 0.060, 0.012, pi / 2, 0.006), 2 * 0.05 * 1e-6);
}

TEST(BentChannel, BothEndsMatchAndTheWallsAreParallel) {
    const Geometry channel = read_case("bent_channel/bent_channel.geo");
    EXPECT_EQ(channel.names(), (std::vector<std::string>{"blood", "flap", "flap_root", "wall"}));
    const auto& wall = channel.curve_set("wall")->pieces;
    ASSERT_EQ(wall.size(), 2U);
    for (std::size_t i = 0; i < 2; ++i) {
        const double side = i == 0 ? -0.003 : 0.003;
        EXPECT_EQ(wall[i].points.front(), Vec(-0.030, side, 0));
        EXPECT_EQ(wall[i].points.back(), Vec(0.030, side, 0));
        EXPECT_EQ(wall[i].at(0.001).second, Vec(1, 0, 0));
        EXPECT_EQ(wall[i].at(wall[i].length()).second, Vec(1, 0, 0));
        // A smooth wall: no kink beyond what chords of the tightest bend (9 mm) need for 1 um.
        for (std::size_t k = 1; k + 1 < wall[i].points.size(); ++k) {
            const Vec before = (wall[i].points[k] - wall[i].points[k - 1]).normalized();
            const Vec after = (wall[i].points[k + 1] - wall[i].points[k]).normalized();
            EXPECT_LT(std::asin(before.cross(after).norm()), 2 * std::acos(1 - 1e-6 / 0.009));
        }
    }
    const CurveSet lower{.name = "lower", .pieces = {wall[0]}};
    for (const auto& point : wall[1].points) EXPECT_NEAR(lower.nearest(point).distance, 0.006, 1.1e-6);
}

TEST(BentChannel, TheFlapStandsOnTheWallAndCrossesTwoThirds) {
    const Geometry channel = read_case("bent_channel/bent_channel.geo", {{"flap_length", 0.004}});
    const auto& flap = channel.curve_set("flap")->pieces;
    ASSERT_EQ(flap.size(), 1U);
    EXPECT_NEAR(flap[0].length(), 0.004, 1e-16);
    EXPECT_EQ(flap[0].points.front(), channel.points.at("flap_root").at(0));
    EXPECT_EQ(channel.curve_set("wall")->nearest(flap[0].points.front()).distance, 0);
    EXPECT_EQ(channel.region("blood")->side_of(flap[0].points.back()), Side::inside);
    EXPECT_NEAR(channel.curve_set("wall")->nearest(flap[0].points.back()).distance / 0.006, 1.0 / 3, 0.04);
}

TEST(BentChannel, RefusesParametersThatMakeNoChannel) {
    const std::string drawing = "bent_channel/bent_channel.geo";
    EXPECT_EQ(error_of(drawing, {{"bend_radius", 0.003}}),
              "gmsh cannot read the drawing: bend_radius must exceed half_width");
    EXPECT_EQ(error_of(drawing, {{"domain_length", 0.04}}),
              "gmsh cannot read the drawing: domain_length is too short for the bends and legs");
    EXPECT_EQ(error_of(drawing, {{"flap_length", 0.007}}),
              "gmsh cannot read the drawing: the flap does not fit into the channel");
}

TEST(PoiseuilleChannel, IsARectangle) {
    const Geometry channel = read_case("verification/poiseuille/channel.geo", {{"width", 0.002}});
    EXPECT_EQ(channel.names(), (std::vector<std::string>{"wall", "water"}));
    EXPECT_NEAR(channel.region("water")->area(), 8e-7, 1e-21);
    const auto& wall = channel.curve_set("wall")->pieces;
    ASSERT_EQ(wall.size(), 2U);
    EXPECT_EQ(wall[0].points, (std::vector<Vec>{{0, 0, 0}, {4e-4, 0, 0}}));
    EXPECT_EQ(wall[1].points, (std::vector<Vec>{{0, 0.002, 0}, {4e-4, 0.002, 0}}));
    EXPECT_EQ(error_of("verification/poiseuille/channel.geo", {{"width", -1}}),
              "gmsh cannot read the drawing: width and length must be positive");
}

}  // namespace
}  // namespace dmp
