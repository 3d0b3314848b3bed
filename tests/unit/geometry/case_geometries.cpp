// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "geometry/inside_test.hpp"
#include "tests/modules.hpp"

namespace dmp::tests::case_geometries_tests {
namespace {

constexpr double pi = std::numbers::pi;

Geometry read_case(const std::string& cad_geometry, const std::map<std::string, double>& parameters = {}) {
    GeometryOptions options;
    options.file = DMP_SOURCE_DIR "/cases/" + cad_geometry;
    options.parameters = parameters;
    return read_geometry(options);
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

std::string error_of(const std::string& cad_geometry, const std::map<std::string, double>& parameters) {
    try {
        (void)read_case(cad_geometry, parameters);
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
    EXPECT_EQ(
        error({{"leaflet_length", 0.002}}),
        "gmsh cannot read the geometry: leaflet_length is too short to reach tip_gap: it must exceed half_width - "
        "tip_gap/2");
    EXPECT_EQ(error({{"tip_gap", 0.009}}), "gmsh cannot read the geometry: tip_gap is wider than the vein");
    EXPECT_EQ(error({{"tip_gap", 0}}), "gmsh cannot read the geometry: half_width and tip_gap must be positive");
    EXPECT_EQ(error({{"chamber_height", 0.004}}),
              "gmsh cannot read the geometry: chamber_height must exceed half_width");
    EXPECT_EQ(error({{"domain_length", 0.04}}),
              "gmsh cannot read the geometry: chamber_length must be positive, and domain_length must exceed it");
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
    const std::string cad_geometry = "bent_channel/bent_channel.geo";
    EXPECT_EQ(error_of(cad_geometry, {{"bend_radius", 0.003}}),
              "gmsh cannot read the geometry: bend_radius must exceed half_width");
    EXPECT_EQ(error_of(cad_geometry, {{"domain_length", 0.04}}),
              "gmsh cannot read the geometry: domain_length is too short for the bends and legs");
    EXPECT_EQ(error_of(cad_geometry, {{"flap_length", 0.007}}),
              "gmsh cannot read the geometry: the flap does not fit into the channel");
}

TEST(HeartValve, AreaAndWallAgainstTheCircle) {
    const Geometry valve = read_case("heart_valve/heart_valve.geo");
    EXPECT_EQ(valve.names(), (std::vector<std::string>{"blood", "leaflet_roots", "leaflets", "wall"}));
    const double radius = 0.0215, width = 0.0125, corner = std::sqrt(radius * radius - width * width);
    const double expected = 2 * width * (0.105 - 2 * corner) + 2 * ellipse_slice(radius, radius, corner);
    const double area = valve.region("blood")->area();
    EXPECT_LE(area, expected);
    EXPECT_GT(area, expected - 2 * 0.042 * 1e-6);  // chords lie inside the circle
    for (const auto& piece : valve.curve_set("wall")->pieces)
        for (const auto& point : piece.points) {
            if (std::abs(point.x()) > corner) {
                EXPECT_EQ(std::abs(point.y()), width);
            } else {
                EXPECT_NEAR(point.norm(), radius, 1e-15);
            }
        }
    const auto& leaflets = valve.curve_set("leaflets")->pieces;
    ASSERT_EQ(leaflets.size(), 2U);
    for (const auto& leaflet : leaflets) {
        EXPECT_NEAR(leaflet.length(), 0.016, 1e-16);
        EXPECT_NEAR(std::abs(leaflet.points[1].y()), 0.002, 1e-18);
        EXPECT_EQ(valve.curve_set("wall")->nearest(leaflet.points[0]).distance, 0);
    }
}

TEST(HeartValve, RefusesParametersThatMakeNoValve) {
    const std::string cad_geometry = "heart_valve/heart_valve.geo", problem = "gmsh cannot read the geometry: ";
    EXPECT_EQ(error_of(cad_geometry, {{"leaflet_length", 0.01}}),
              problem + "leaflet_length is too short to reach tip_gap: it must exceed half_width - tip_gap/2");
    EXPECT_EQ(error_of(cad_geometry, {{"chamber_radius", 0.0125}}), problem + "chamber_radius must exceed half_width");
    EXPECT_EQ(error_of(cad_geometry, {{"tip_gap", 0.026}}), problem + "tip_gap is wider than the vessel");
    EXPECT_EQ(error_of(cad_geometry, {{"domain_length", 0.03}}),
              problem + "domain_length must exceed the length of the chamber, 2 sqrt(chamber_radius^2 - half_width^2)");
}

TEST(DoubleVeinValve, AreasAgainstClosedForms) {
    const std::string cad_geometry = "double_vein_valve/double_vein_valve.geo";
    for (const double channel_1 : {0.048, 0.030}) {
        const Geometry valves = read_case(cad_geometry, {{"channel_1", channel_1}});
        const double length = 0.080 + 0.048 + channel_1;
        EXPECT_NEAR((valves.box.low - Vec(-0.040 - channel_1, -0.0115, 0)).norm(), 0, 1e-15);
        EXPECT_NEAR((valves.box.high - Vec(0.088, 0.0115, 0)).norm(), 0, 1e-15);
        const double axis = 0.020 / std::sqrt(1 - 16.0 / 49.0);
        const double vein = 4 * ellipse_slice(axis, 0.007, 0.020) + 0.008 * (0.048 + channel_1);
        const double embolus = pi * 0.0026 * 0.0026;
        EXPECT_NEAR(valves.region("embolus")->area(), embolus, 2 * pi * 0.0026 * 1e-6);
        EXPECT_NEAR(valves.region("blood")->area(), vein - embolus, 0.2 * 1e-6);
        const double shell_axis = 0.022 / std::sqrt(1 - std::pow(5.5 / 8.5, 2));
        const double inside = 4 * ellipse_slice(shell_axis, 0.0085, 0.022) + 0.008 * (0.040 + channel_1);
        EXPECT_NEAR(valves.region("tissue")->area(), 0.023 * length - inside, 0.2 * 1e-6);
    }
}

TEST(DoubleVeinValve, LeafletsChannelsAndEmbolusAreWhereTheyShouldBe) {
    const Geometry valves = read_case("double_vein_valve/double_vein_valve.geo",
                                      {{"embolus_length", 0.019}, {"embolus_height", 0.0026}, {"embolus_tilt", 0.1}});
    EXPECT_EQ(valves.names(),
              (std::vector<std::string>{"blood", "casing", "chambers", "channel_1", "channel_2", "channel_ends",
                                        "embolus", "leaflet_roots", "leaflets_1", "leaflets_2", "tissue"}));
    EXPECT_NEAR(valves.region("embolus")->area(), 0.0026 * 0.0164 + pi * 0.0013 * 0.0013, 2 * pi * 0.0013 * 1e-6);
    EXPECT_EQ(valves.region("embolus")->side_of({-0.034 + 0.0094 * std::cos(0.1), 0.0094 * std::sin(0.1), 0}),
              Side::inside);
    for (const auto& [name, root] : {std::pair{"leaflets_1", -0.020}, std::pair{"leaflets_2", 0.068}}) {
        const auto& pieces = valves.curve_set(name)->pieces;
        ASSERT_EQ(pieces.size(), 2U);
        for (const auto& leaflet : pieces) {
            EXPECT_NEAR(leaflet.length(), 0.010, 1e-16);
            EXPECT_NEAR(leaflet.points[0].x(), root, 1e-16);
            EXPECT_GT(leaflet.points[1].x(), root);  // both let liquid pass to the right
            EXPECT_EQ(valves.curve_set("chambers")->nearest(leaflet.points[0]).distance, 0);
        }
    }
    for (const auto& [name, from] : {std::pair{"channel_1", -0.066}, std::pair{"channel_2", 0.022}}) {
        for (const auto& wall : valves.curve_set(name)->pieces) {
            EXPECT_NEAR(wall.length(), 0.044, 1e-16);
            EXPECT_NEAR(wall.points[0].x(), from, 1e-16);
        }
    }
}

TEST(DoubleVeinValve, MayHaveNoEmbolusAndNarrowRoots) {
    const std::string cad_geometry = "double_vein_valve/double_vein_valve.geo";
    const Geometry with = read_case(cad_geometry), without = read_case(cad_geometry, {{"embolus", 0}});
    EXPECT_EQ(without.region("embolus"), nullptr);
    EXPECT_NEAR(without.region("blood")->area(), with.region("blood")->area() + with.region("embolus")->area(), 1e-9);
    const Geometry narrow = read_case(cad_geometry, {{"root_inset", 0.0005}});
    EXPECT_LT(narrow.region("blood")->area(), with.region("blood")->area());
}

TEST(DoubleVeinValve, RefusesParametersThatMakeNoValves) {
    const std::string cad_geometry = "double_vein_valve/double_vein_valve.geo",
                      problem = "gmsh cannot read the geometry: ";
    EXPECT_EQ(error_of(cad_geometry, {{"leaflet_length", 0.02}}),
              problem + "leaflet_length must exceed half_width - root_inset - tip_gap/2 and be below chamber_length/2");
    EXPECT_EQ(error_of(cad_geometry, {{"root_inset", -0.001}}),
              problem + "half_width, tip_gap and rim must be positive, and root_inset not negative");
    EXPECT_EQ(error_of(cad_geometry, {{"channel_1", 0.004}}), problem + "channel_1 and channel_2 must exceed 2 rim");
    EXPECT_EQ(error_of(cad_geometry, {{"casing", 0.008}}),
              problem + "shell must be positive, and casing must exceed chamber_height + shell");
    EXPECT_EQ(error_of(cad_geometry, {{"embolus_length", 0.003}}),
              problem + "embolus_height must be positive, and embolus_length at least as large");
}

TEST(Cilia, StandHalfAPitchFromTheEnds) {
    const Geometry carpet = read_case("cilia/cilia.geo", {{"cilia", 9}});
    EXPECT_EQ(carpet.names(), (std::vector<std::string>{"cilia", "membrane", "mucus", "pcl", "roots"}));
    EXPECT_NEAR(carpet.region("pcl")->area(), 20e-6 * 5e-6, 1e-23);
    EXPECT_NEAR(carpet.region("mucus")->area(), 20e-6 * 2e-6, 1e-23);
    const auto& cilia = carpet.curve_set("cilia")->pieces;
    ASSERT_EQ(cilia.size(), 9U);
    EXPECT_EQ(carpet.points.at("roots").size(), 9U);
    for (std::size_t k = 0; k < cilia.size(); ++k) {
        const double x = (static_cast<double>(k) + 0.5) * 20e-6 / 9;
        EXPECT_NEAR((cilia[k].points.front() - Vec(x, 0, 0)).norm(), 0, 1e-18);
        EXPECT_NEAR((cilia[k].points.back() - Vec(x, 5e-6, 0)).norm(), 0, 1e-18);
    }
    const std::string problem = "gmsh cannot read the geometry: ";
    EXPECT_EQ(error_of("cilia/cilia.geo", {{"cilia", 2.5}}), problem + "cilia must be a whole number, at least 1");
    EXPECT_EQ(error_of("cilia/cilia.geo", {{"cilium_length", 8e-6}}),
              problem + "cilium_length must be below pcl + mucus");
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
              "gmsh cannot read the geometry: width and length must be positive");
}

}  // namespace
}  // namespace dmp::tests::case_geometries_tests
