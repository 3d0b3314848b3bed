// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "solver/spheres/smooth_edges.hpp"
#include "solver/spheres/sphere_group.hpp"
#include "solver/spheres/sphere_run.hpp"
#include "tests/modules.hpp"
#include "tests/unit/solver/sphere_scenes.hpp"

namespace dmp::tests::solver_smooth_edges_tests {
namespace {

constexpr double ball_radius = 1e-3, speed = 0.2, degree = std::numbers::pi / 180;

/// A surface of triangles that share corners.
struct Facets {
    std::vector<Vec> corners;
    std::vector<std::array<int, 3>> triangles;

    int corner(const Vec& place) {
        corners.push_back(place);
        return static_cast<int>(corners.size()) - 1;
    }
    void quad(int a, int b, int c, int d) {
        triangles.push_back({a, b, c});
        triangles.push_back({a, c, d});
    }
};

/// Two plates along y that rise to both sides of the z axis, bent by so many degrees.
Facets fold(double bend) {
    Facets made;
    const double rise = std::tan(bend / 2 * degree);
    std::array<std::array<int, 2>, 3> ends{};
    for (int k = -1; k <= 1; ++k)
        for (int end = 0; end < 2; ++end)
            ends.at(static_cast<std::size_t>(k + 1)).at(static_cast<std::size_t>(end)) =
                made.corner(Vec(0.01 * k, end == 0 ? -0.01 : 0.013, 0.01 * std::abs(k) * rise));
    for (std::size_t k = 0; k < 2; ++k) made.quad(ends[k][0], ends[k + 1][0], ends[k + 1][1], ends[k][1]);
    return made;
}

/// A tube along y around the y axis, or a cone whose radius is `slope` times y.
Facets tube(int sides, double radius, double low, double high, double slope = 0) {
    Facets made;
    for (int k = 0; k < sides; ++k) {
        const double angle = 2 * std::numbers::pi * k / sides;
        const Vec out(std::sin(angle), 0, -std::cos(angle));
        made.corner((radius + slope * low) * out + low * Vec::UnitY());
        made.corner((radius + slope * high) * out + high * Vec::UnitY());
    }
    for (int k = 0; k < sides; ++k) {
        const int next = (k + 1) % sides;
        made.quad(2 * k, 2 * next, 2 * next + 1, 2 * k + 1);
    }
    return made;
}

SphereScene ball_before(const Facets& facets, const Vec& position, const Vec& velocity) {
    SphereScene made;
    const int ball = made.part("ball", PartKind::spheres, 1e7);
    made.part("wall", PartKind::surface, 0);
    made.contact(0.7, 0.3);
    made.sphere(ball, position, ball_radius, velocity);
    made.set.wall_corners = facets.corners;
    for (const auto& [a, b, c] : facets.triangles) made.set.wall_triangles.push_back({1, a, b, c});
    made.scene.numerics.steps_per_contact = 100;
    made.scene.output.every = made.scene.run.duration = given(1e-3);
    return made;
}

RunSummary run(const SphereScene& made) {
    SphereRun engine(made.scene, made.set, Resources(1));
    return engine.run({});
}

struct Rebound {
    double restitution, duration;
};
/// Of a ball that hits a place of the wall, 2 micrometres away; the facets there are inclined by an angle of this
/// cosine.
Rebound rebound(const Facets& facets, const Vec& wall, const Vec& normal, double cosine = 1) {
    SphereScene made = ball_before(facets, wall + (ball_radius + 2e-6) / cosine * normal, -speed * normal);
    Measure velocity;
    velocity.name = std::string("v");
    velocity.kind = MeasureKind::velocity;
    velocity.part = Value<std::string>("ball", SourceLocation{"scene.toml", 3, 1});
    made.scene.measures = {velocity};
    made.scene.output.measure_every = 5e-7;
    made.scene.run.duration = given(5e-4);
    const auto rows = run(made).measures.rows;
    double touched = 0;
    for (std::size_t k = 1; k < rows.size(); ++k)
        if (std::abs(rows[k][2] - rows[k - 1][2]) + std::abs(rows[k][0] - rows[k - 1][0]) > 1e-9 * speed)
            touched += made.scene.output.measure_every.value;
    return {Vec(rows.back()[0], rows.back()[1], rows.back()[2]).norm() / speed, touched};
}

const Rebound& from_plane() {
    static const Rebound found = rebound(fold(0), Vec(0.003, 0.0021, 0), Vec::UnitZ());
    return found;
}

void expect_as_from_a_plane(const Rebound& found, const std::string& what) {
    EXPECT_NEAR(found.restitution, 0.7, 0.002) << what;
    EXPECT_NEAR(found.duration / from_plane().duration, 1, 0.01) << what;
}

// Two touches in place of one have a restitution of 0.7^sqrt(2) = 0.604 in 2^(-2/5) = 0.758 of the time.
TEST(SmoothEdges, a_ball_rebounds_from_a_fold_as_from_a_plane) {
    ASSERT_NEAR(from_plane().restitution, 0.7, 0.002);
    for (const double bend : {0.0, 0.001, 0.01, 0.1, 1.0})
        expect_as_from_a_plane(rebound(fold(bend), Vec(0, 0.0021, 0), Vec::UnitZ()), std::to_string(bend) + " degrees");
}

TEST(SmoothEdges, a_ball_rebounds_in_a_tube_however_fine_its_facets_are) {
    for (const double share : {0.1, 0.5, 0.9})
        for (const int sides : {36, 90, 720}) {
            const double radius = ball_radius / share;
            const Facets walls = tube(sides, radius, -0.005, 0.006);
            const double half = std::numbers::pi / sides;
            for (const double place : {0.0, 0.4, 1.0}) {  // from the middle of a facet to an edge
                const double angle = half * (1 + place);
                const double away = radius * std::cos(half) / std::cos(half * place);
                const Vec out(std::sin(angle), 0, -std::cos(angle));
                expect_as_from_a_plane(rebound(walls, away * out, -out, std::cos(half * place)),
                                       std::to_string(share) + " of a tube of " + std::to_string(sides) + ", place " +
                                           std::to_string(place));
            }
        }
}

/// The force on a ball at rest.
Vec force_on(SphereScene made) {
    const SphereSetup setup = sphere_setup(made.scene, made.set);
    ParticleGroup group = sphere_group(made.set, PositionQuantum(made.set), Ranks::alone());
    SphereStep step(made.scene, made.set, made.set, group, setup, Resources(1));
    step.start(true, 0);
    const double* force = step.rows().loads()[0].force.c;
    return {force[0], force[1], force[2]};
}

TEST(SmoothEdges, below_32_degrees_are_smooth_and_above_are_corners) {
    const auto pressed = [](double bend) {
        const double up = 1 / std::cos(bend / 2 * degree);  // as deep in both plates as in one
        return force_on(ball_before(fold(bend), Vec(0, 0.0021, (ball_radius - 1e-6) * up), Vec::Zero()));
    };
    const double once = pressed(0)[2];
    for (const double smooth : {30.0, 31.9}) {
        EXPECT_NEAR(pressed(smooth).norm() / once, 1, 1e-7);
        EXPECT_NEAR(pressed(smooth)[2] / once, std::cos(smooth / 2 * degree), 1e-7);
    }
    EXPECT_NEAR(pressed(33)[2] / once, 2 * std::cos(16.5 * degree), 1e-7);
    EXPECT_NEAR(pressed(33)[0] / once, 0, 1e-7);
}

/// A floor that falls and rises by 5 degrees between places along y.
Facets valley(const std::vector<double>& places, const std::vector<double>& heights) {
    Facets made;
    for (std::size_t k = 0; k < places.size(); ++k)
        for (const double x : {-0.01, 0.01}) made.corner(Vec(x, places[k], heights[k]));
    for (int k = 0; k + 1 < static_cast<int>(places.size()); ++k) made.quad(2 * k, 2 * k + 1, 2 * k + 3, 2 * k + 2);
    return made;
}

TEST(SmoothEdges, go_on_across_a_periodic_side) {
    const double low = -0.004, high = 0.004, rise = high * std::tan(5 * degree);
    const auto floor_of = [&](double middle, double side) {
        return ball_before(valley({low, 0, high}, {side, middle, side}), Vec(0, 0, 0), Vec::Zero());
    };
    const double up = (ball_radius - 1e-6) / std::cos(5 * degree);
    SphereScene inside = floor_of(0, rise), across = floor_of(rise, 0);
    inside.set.position.front() = Vec(0, 0, up);
    across.set.position.front() = Vec(0, low, up);
    for (SphereScene* made : {&inside, &across}) {
        made->set.periodic = {false, true, false};
        made->set.box = {Vec(-0.01, low, -0.01), Vec(0.01, high, 0.01)};
    }
    EXPECT_NEAR(force_on(across).norm() / force_on(inside).norm(), 1, 1e-6);
    const SmoothEdges edges(across.set);
    EXPECT_TRUE(edges.join(0, 1));  // the halves of a quad
    EXPECT_TRUE(edges.join(0, 3));  // the first half is at the low side, the last one at the high side
    EXPECT_TRUE(edges.join(3, 0));
    across.set.periodic = {};
    EXPECT_FALSE(SmoothEdges(across.set).join(0, 3));
}

// Touches on opposite sides of one smooth surface hold the ball from both.
TEST(SmoothEdges, a_ball_that_is_wedged_in_a_cone_comes_to_rest) {
    const double slope = 0.5;  // touched all around, 2.2 radii above the tip
    SphereScene made = ball_before(tube(60, 0, 1e-4, 0.008, slope), Vec(2e-5, ball_radius * 2.25, 1e-5), Vec::Zero());
    made.scene.flow.acceleration[1] = Expression("-9.81", "-9.81");
    made.scene.run.duration = given(0.05);
    const RunSummary summary = run(made);
    for (const double momentum : summary.end.momentum) EXPECT_NEAR(momentum / summary.end.mass, 0, 1e-3);
}

}  // namespace
}  // namespace dmp::tests::solver_smooth_edges_tests
