// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// The cases in 3-D: their geometries against closed forms.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "geometry/geometry.hpp"
#include "tests/modules.hpp"

namespace dmp::tests::case_geometries_3d_tests {
namespace {

constexpr double pi = std::numbers::pi, chord_error = 5e-6;

using Parameters = std::map<std::string, double>;

Geometry read_case(const std::string& cad_geometry, const Parameters& parameters = {}) {
    GeometryOptions options;
    options.file = DMP_SOURCE_DIR "/cases/" + cad_geometry;
    options.parameters = parameters;
    options.chord_error = chord_error;
    return read_geometry(options);
}

std::string error_of(const std::string& cad_geometry, const Parameters& parameters) {
    try {
        (void)read_case(cad_geometry, parameters);
    } catch (const InputError& error) {
        return error.problem();
    }
    return "no error";
}

/// Area between the x axis and a circle of radius r around the origin, for |x| <= c.
double circle_slice(double r, double c) { return c * std::sqrt(r * r - c * c) + r * r * std::asin(c / r); }

/// Rings and, between each two of them, two bars.
double stent_volume(double inner, double outer, double width, int rings, double pitch) {
    const double bar = circle_slice(outer, width / 2) - circle_slice(inner, width / 2);
    return rings * pi * (outer * outer - inner * inner) * width + 2 * (rings - 1) * (pitch - width) * bar;
}

void expect_the_stent(const Geometry& artery, double share, double length) {
    const double lumen = pi * 1.5e-3 * 1.5e-3 * length / share;
    const double stent = stent_volume(1.2e-3, 1.65e-3, 0.3e-3, 4, 1.2e-3);
    EXPECT_NEAR(artery.solid("blood")->volume() / lumen, 1, 1e-2);
    EXPECT_NEAR(artery.solid("stent")->volume() / stent, 1, 1e-2);
}

TEST(Stent, WholeHalfAndQuarterOfTheArtery) {
    for (const double share : {1.0, 2.0, 4.0}) {
        const Geometry artery = read_case("stent/stent.geo", {{"share", share}});
        EXPECT_EQ(artery.names(), (std::vector<std::string>{"blood", "stent", "wall"}));
        expect_the_stent(artery, share, 24e-3);
        const TriangleSurface& wall = artery.surface_set("wall")->surface;
        EXPECT_NEAR(wall.area() / (2 * pi * 1.5e-3 * 24e-3 / share), 1, 5e-3);
        for (const Vec& corner : wall.corners) {
            EXPECT_NEAR(std::hypot(corner.y(), corner.z()), 1.5e-3, 1e-12);
            if (share > 1) {
                EXPECT_GT(corner.z(), -1e-12);
            }
            if (share > 2) {
                EXPECT_GT(corner.y(), -1e-12);
            }
        }
    }
}

TEST(Stent, FollowsItsParameters) {
    const Geometry artery = read_case("stent/stent.geo", {{"radius", 2e-3},
                                                          {"length", 9e-3},
                                                          {"struts", 3},
                                                          {"strut", 4e-4},
                                                          {"width", 5e-4},
                                                          {"embedded", 2e-4},
                                                          {"pitch", 2e-3},
                                                          {"first", 1e-3}});
    EXPECT_NEAR(artery.solid("blood")->volume() / (pi * 4e-6 * 9e-3), 1, 1e-2);
    EXPECT_NEAR(artery.solid("stent")->volume() / stent_volume(1.6e-3, 2.2e-3, 5e-4, 3, 2e-3), 1, 1e-2);
    double low = 1, high = 0;
    for (const Vec& corner : artery.solid("stent")->surface.corners) {
        low = std::min(low, corner.x());
        high = std::max(high, corner.x());
    }
    EXPECT_NEAR(low, 1e-3, 1e-9);
    EXPECT_NEAR(high, 5.5e-3, 1e-9);
    const Geometry ring = read_case("stent/stent.geo", {{"struts", 1}});
    EXPECT_NEAR(ring.solid("stent")->volume() / stent_volume(1.2e-3, 1.65e-3, 0.3e-3, 1, 0), 1, 1e-2);
}

TEST(Stent, IsTheSameAsStepFile) {
    const Geometry artery = read_case("stent/stent.step");
    EXPECT_EQ(artery.names(), (std::vector<std::string>{"blood", "stent"}));
    EXPECT_EQ(artery.unit_source, UnitSource::file);
    expect_the_stent(artery, 1, 24e-3);
    const Geometry drawn = read_case("stent/stent.geo");
    EXPECT_NEAR((artery.box.low - drawn.box.low).norm(), 0, 1e-9);
    EXPECT_NEAR((artery.box.high - drawn.box.high).norm(), 0, 1e-9);
}

TEST(Stent, RefusesWhatCannotBeDrawn) {
    const std::string cad_geometry = "stent/stent.geo", problem = "gmsh cannot read the geometry: ";
    EXPECT_EQ(error_of(cad_geometry, {{"strut", 2e-3}}), problem + "strut must be less than radius");
    EXPECT_EQ(error_of(cad_geometry, {{"struts", 2.5}}), problem + "struts must be a whole number of 1 or more");
    EXPECT_EQ(error_of(cad_geometry, {{"pitch", 1e-4}}), problem + "pitch must exceed width");
    EXPECT_EQ(error_of(cad_geometry, {{"length", 10e-3}}), problem + "the stent does not fit between 0 and length");
    EXPECT_EQ(error_of(cad_geometry, {{"share", 3}}), problem + "share must be 1, 2 or 4");
}

/// Of one of three leaflets: the part of a third of a circle that is half a gap from its straight sides, inclined.
double leaflet_area(double radius, double height, double gap) {
    const double half_angle = pi / 3 - std::asin(gap / (2 * radius));
    const double corner = gap / std::sqrt(3.0);  // of two slits, from the axis
    const double seen_along_x = radius * radius * half_angle - corner * radius * std::sin(half_angle);
    return seen_along_x * std::hypot(1, height / radius);
}

TEST(TricuspidValve, ThreeLeafletsInTheBloodOfATube) {
    for (const auto& [height, gap] : {std::pair{6e-3, 1e-3}, {4e-3, 0.6e-3}}) {
        const Geometry valve = read_case("tricuspid_valve/tricuspid_valve.geo", {{"height", height}, {"gap", gap}});
        EXPECT_EQ(valve.names(), (std::vector<std::string>{"blood", "leaflets", "wall"}));
        EXPECT_NEAR(valve.solid("blood")->volume() / (pi * 25e-6 * 30e-3), 1, 2e-3);
        // No leaflet is part of the blood's surface.
        EXPECT_NEAR(valve.solid("blood")->surface.area() / (2 * pi * 5e-3 * (30e-3 + 5e-3)), 1, 2e-3);
        EXPECT_NEAR(valve.surface_set("wall")->surface.area() / (2 * pi * 5e-3 * 30e-3), 1, 1e-3);
        const TriangleSurface& leaflets = valve.surface_set("leaflets")->surface;
        EXPECT_NEAR(leaflets.area() / (3 * leaflet_area(5e-3, height, gap)), 1, 2e-3);
        std::array<int, 3> at_wall{};
        for (const Vec& corner : leaflets.corners) {
            // By its third, turned to the one about y.
            const double angle = std::atan2(corner.z(), corner.y());
            const double third = std::round(angle / (2 * pi / 3));
            const double r = std::hypot(corner.y(), corner.z()), turned = angle - third * 2 * pi / 3;
            EXPECT_NEAR(corner.x(), height * (1 - r * std::cos(turned) / 5e-3), 1e-9);
            // At least half a gap from the planes between the thirds.
            EXPECT_GT(r * std::sin(pi / 3 - std::abs(turned)), gap / 2 - 1e-9);
            EXPECT_LT(r, 5e-3 + 1e-9);
            if (r > 5e-3 - 1e-9) ++at_wall.at(static_cast<std::size_t>(third + 1));
        }
        for (const int count : at_wall) EXPECT_GT(count, 10);
    }
}

TEST(TricuspidValve, RefusesWhatCannotBeDrawn) {
    const std::string cad_geometry = "tricuspid_valve/tricuspid_valve.geo", problem = "gmsh cannot read the geometry: ";
    EXPECT_EQ(error_of(cad_geometry, {{"gap", 6e-3}}), problem + "gap must be less than radius");
    EXPECT_EQ(error_of(cad_geometry, {{"height", 30e-3}}), problem + "downstream must exceed height");
}

}  // namespace
}  // namespace dmp::tests::case_geometries_3d_tests
