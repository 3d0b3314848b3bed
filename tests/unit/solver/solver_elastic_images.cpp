// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// What fluid particles see in those of elastic solids, on single pairs.
#include <gtest/gtest.h>

#include "models/sph/walls.hpp"
#include "tests/modules.hpp"
#include "tests/unit/solver/one_pair.hpp"

namespace dmp::tests::solver_elastic_images_tests {
namespace {

using namespace one_pair;

TEST(ElasticSolidsAsWalls, shows_a_particle_that_is_its_own_surface_as_it_moves) {
    const ExtrapolatedSolid<2> law{{{0, -9.81}}, 0.05};
    const Solid body{{{0, 0}}, {{0.3, -0.2}}, 0.8, 1, 2, {{0, 0}}, 0};
    const auto ghost = law.springs(particle_i, body, particle_i.position - body.position);
    expect_near(ghost.velocity, body.velocity, 0);
    EXPECT_EQ(ghost.pressure, particle_i.pressure);
    EXPECT_EQ(ghost.volume, 0.8);
    EXPECT_EQ(ghost.viscosity, particle_i.viscosity);
}

/// A particle of an elastic body at the origin, 0.15 behind its surface, which faces y, and 0.25 from the other side.
Solid elastic_particle() {
    Solid body{{{0, 0}}, {{0.3, -0.2}}, 0.8, 1, 2, {{0, 1}}, 0.15};
    body.opposite = 0.25;
    body.held = 1;
    return body;
}

TEST(ElasticSolidsAsWalls, extrapolates_the_velocity_through_the_surface_of_a_body_on_either_side) {
    const ExtrapolatedSolid<2> law{{{0, 0}}, 0.05};
    const Solid body = elastic_particle();
    Point fluid = particle_i;
    fluid.velocity = {{1, 0}};
    // 0.25 above the surface: v_b - 0.15 / 0.25 (v_i - v_b)
    fluid.position = {{0.1, 0.4}};
    expect_near(law.springs(fluid, body, fluid.position - body.position).velocity,
                Vector<double, 2>{{0.3 - 0.6 * 0.7, -0.2 - 0.6 * 0.2}}, 1e-14);
    // 0.5 below the other side
    fluid.position = {{0.1, -0.75}};
    expect_near(law.springs(fluid, body, fluid.position - body.position).velocity,
                Vector<double, 2>{{0.3 - 0.5 * 0.7, -0.2 - 0.5 * 0.2}}, 1e-14);
    // Beside an edge: as a particle half a spacing behind the surface, half a spacing away.
    fluid.position = {{0.3, 0.1}};
    expect_near(law.springs(fluid, body, fluid.position - body.position).velocity,
                Vector<double, 2>{{0.3 - 0.7, -0.2 - 0.2}}, 1e-14);
}

TEST(ElasticSolidsAsWalls, has_no_slip_where_a_sheet_is_though_its_particles_stand_in_front) {
    const ExtrapolatedSolid<2> law{{{0, 0}}, 0.05};
    Solid body = elastic_particle();
    body.depth = -0.04;
    Point fluid = particle_i;
    fluid.position = {{0, 0.16}};  // 0.2 from the surface
    fluid.velocity = {{1, 0}};
    // The linear velocity from the surface to the fluid particle, at the particle of the body.
    EXPECT_NEAR(law.springs(fluid, body, fluid.position).velocity[0], 0.3 + 0.2 * 0.7, 1e-14);
}

TEST(ElasticSolidsAsWalls, takes_particles_without_a_normal_as_round) {
    const ExtrapolatedSolid<2> law{{{0, 0}}, 0.05};
    Solid body = elastic_particle();
    body.normal = {{0, 0}};
    body.depth = body.opposite = 0.1;
    Point fluid = particle_i;
    fluid.position = {{0.3, 0.4}};
    fluid.velocity = {{1, 0}};
    EXPECT_NEAR(law.springs(fluid, body, fluid.position).velocity[0], 0.3 - 0.1 / 0.4 * 0.7, 1e-14);
}

TEST(ElasticSolidsAsWalls, shows_no_shear_to_fluid_that_turns_with_a_body) {
    const ExtrapolatedSolid<2> law{{{0, 0}}, 0.05};
    const double spin = 3;
    Solid body = elastic_particle();
    body.position = {{0.2, 0.5}};
    const auto turning = [&](const Vector<double, 2>& x) { return Vector<double, 2>{{-spin * x[1], spin * x[0]}}; };
    body.velocity = turning(body.position);
    body.surface_gradient = {{{{0, -spin}}, {{spin, 0}}}};
    for (const Vector<double, 2>& place : {Vector<double, 2>{{0.3, 0.9}}, {{0.2, 0.2}}, {{0.5, 0.5}}}) {
        Point fluid = particle_i;
        fluid.position = place;
        fluid.velocity = turning(place);
        const auto ghost = law.springs(fluid, body, fluid.position - body.position);
        expect_near(ghost.velocity + ghost.velocity_by_gradient, body.velocity, 1e-14);
    }
}

TEST(ElasticSolidsAsWalls, continues_the_pressure_into_what_is_behind_a_bodys_surface) {
    const ExtrapolatedSolid<2> law{{{0, -10}}, 0.05};
    Solid body = elastic_particle();
    Point fluid = particle_i;
    fluid.position = {{0, 0.4}};
    fluid.density = 1000;
    EXPECT_NEAR(law.springs(fluid, body, fluid.position).pressure, fluid.pressure + 1000 * 10 * 0.4, 1e-9);
    body.depth = 0.025;  // half as far behind as the first row of a thick body
    EXPECT_NEAR(law.springs(fluid, body, fluid.position).pressure, fluid.pressure + 0.5 * 1000 * 10 * 0.4, 1e-9);
    body.depth = -0.02;
    EXPECT_EQ(law.springs(fluid, body, fluid.position).pressure, fluid.pressure);
    body.depth = 0.15;
    body.held = 0;  // free to fall with the liquid
    EXPECT_EQ(law.springs(fluid, body, fluid.position).pressure, fluid.pressure);
}

}  // namespace
}  // namespace dmp::tests::solver_elastic_images_tests
