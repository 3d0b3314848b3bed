// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "base/errors.hpp"
#include "tests/modules.hpp"
#include "tests/unit/solver/ladder_body.hpp"

namespace dmp::tests::solver_spring_bodies_tests {
namespace {

const Ranks alone = Ranks::alone();

TEST(SpringBodies, substeps_keep_below_the_asked_fraction_of_the_limit) {
    const ParticleSet set = ladder({16, 0.5, true});
    Scene scene = scene_with(part_with(0), SpringStepping::subcycled);
    scene.numerics.spring_step_factor = 0.5;
    const SpringBodies bodies(set, scene, alone);
    ASSERT_EQ(bodies.step_limits().size(), 1U);
    EXPECT_EQ(bodies.step_limits()[0].part, "beam");
    const double limit = bodies.step_limits()[0].dt;
    EXPECT_EQ(limit, bodies.bodies()[0]->step_limit());
    EXPECT_EQ(bodies.substeps(0.1 * limit), 1);
    EXPECT_EQ(bodies.substeps(0.499 * limit), 1);
    EXPECT_EQ(bodies.substeps(0.501 * limit), 2);
    EXPECT_EQ(bodies.substeps(5.01 * limit), 11);
}

TEST(SpringBodies, implicit_bodies_take_one_step) {
    const ParticleSet set = ladder({16, 0.5, true});
    const SpringBodies bodies(set, scene_with(part_with(0), SpringStepping::implicit), alone);
    EXPECT_TRUE(bodies.implicit());
    EXPECT_EQ(bodies.substeps(100), 1);
}

TEST(SpringBodies, part_the_scene_does_not_know_is_an_error) {
    const ParticleSet set = ladder({4, 0.5, true});
    Scene scene = scene_with(part_with(0), SpringStepping::implicit);
    scene.parts[0].name = std::string("leaf");
    try {
        const SpringBodies bodies(set, scene, alone);
        FAIL() << "no error";
    } catch (const InputError& error) {
        EXPECT_EQ(std::string(error.problem()), "the particles have an elastic solid 'beam' that is not in the scene");
        EXPECT_EQ(error.what_to_do(), "mesh the scene again");
    }
}

TEST(SpringBodies, load_that_is_no_number_is_a_divergence_that_can_be_caught) {
    const ParticleSet set = ladder({4, 0.5, true});
    for (const int threads : {1, 2}) {
        SpringBodies bodies(set, scene_with(part_with(0), SpringStepping::implicit), alone);
        ParticleStore particles(set, {1000});
        bodies.find_nodes(particles);
        particles.of(PartKind::elastic).data(Field::force, 1)[set.size() - 1] =
            std::numeric_limits<double>::quiet_NaN();
        EXPECT_THROW(bodies.advance(particles, 0.1, threads), DivergenceError);
    }
}

/// Two ladders, one above the other, as bodies 0 and 1.
ParticleSet two_ladders() {
    const ParticleSet one = ladder({6, 0.5, true});
    ParticleSet set = one;
    const int count = static_cast<int>(one.size());
    for (const Vec& position : one.position) {
        set.position.emplace_back(position + Vec(0, 3, 0));
        set.body.push_back(1);
    }
    for (auto* values : {&set.volume, &set.mass, &set.wall_distance}) values->resize(2 * one.size(), values->back());
    set.part.resize(2 * one.size(), 0);
    set.seated.resize(2 * one.size(), 0);
    set.wall_normal.resize(2 * one.size(), Vec::Zero());
    set.fixed.insert(set.fixed.end(), one.fixed.begin(), one.fixed.end());
    for (Bond bond : one.bonds) set.bonds.push_back({bond.a + count, bond.b + count, bond.rest_length, bond.stiffness});
    for (Hinge hinge : one.hinges)
        set.hinges.push_back(
            {hinge.a + count, hinge.centre + count, hinge.b + count, hinge.rest_angle, hinge.stiffness});
    set.box.high[1] += 3;
    return set;
}

TEST(SpringBodies, take_forces_from_and_show_motion_to_particles_in_any_order_and_their_copies) {
    const ParticleSet set = two_ladders();
    const double dt = 0.2;
    const auto force_on = [](std::int64_t id) { return V2{{1e-5 * static_cast<double>(id), 1e-4}}; };
    for (const bool reversed : {false, true}) {
        SpringBodies bodies(set, scene_with(part_with(0.01), SpringStepping::implicit), alone);
        ParticleStore particles(set, {1000});
        ParticleGroup& group = particles.of(PartKind::elastic);
        std::vector<std::int32_t> order(group.owned());
        std::iota(order.begin(), order.end(), 0);
        if (reversed) std::reverse(order.begin(), order.end());
        group.reorder(order);
        group.resize(group.owned(), 1);  // a copy of the first, a period away, as a border would make
        group.tags().back() = group.tags().front();
        for (int axis = 0; axis < 2; ++axis)
            group.data(Field::position, axis)[group.owned()] = group.data(Field::position, axis)[0] + 40;
        bodies.find_nodes(particles);
        for (std::size_t i = 0; i < group.owned(); ++i)
            for (int axis = 0; axis < 2; ++axis) group.data(Field::force, axis)[i] = force_on(group.tags()[i].id)[axis];

        const auto given = bodies.advance(particles, dt, 2);
        const double farthest = bodies.show_positions(particles);

        double expected_farthest = 0;
        V2 of_anchors{};
        for (int body = 0; body < 2; ++body) {
            PlaneBody expected(set, part_with(0.01), body);
            Vectors force;
            for (const int id : expected.ids()) force.push_back(force_on(id));
            of_anchors += expected.kick_from_outside(force, dt);
            of_anchors += expected.advance_implicit(dt).of_anchors;
            for (std::size_t i = 0; i < group.total(); ++i) {
                const auto node = std::find(expected.ids().begin(), expected.ids().end(), group.tags()[i].id);
                if (node == expected.ids().end()) continue;
                const auto n = static_cast<std::size_t>(node - expected.ids().begin());
                const V2 way = expected.positions()[n] - expected.positions_before()[n];
                expected_farthest = std::max(expected_farthest, std::sqrt(dot(way, way)));
                for (int axis = 0; axis < 2; ++axis) {
                    const double away = i < group.owned() ? 0 : 40;
                    EXPECT_EQ(group.data(Field::velocity, axis)[i], expected.mean_velocity(n, dt)[axis]);
                    EXPECT_NEAR(group.data(Field::position, axis)[i], expected.positions()[n][axis] + away, 1e-13);
                }
            }
        }
        EXPECT_GT(farthest, 0);
        EXPECT_DOUBLE_EQ(farthest, expected_farthest);
        EXPECT_NE(given.of_anchors[1], 0);
        for (int axis = 0; axis < 2; ++axis) EXPECT_NEAR(given.of_anchors[axis], of_anchors[axis], 1e-18);
    }
}

TEST(SpringBodies, node_goes_to_a_multiple_of_the_quantum_wherever_it_was_wrapped) {
    const ParticleSet set = ladder({6, 0.5, true});
    SpringBodies bodies(set, scene_with(part_with(0.01), SpringStepping::implicit), alone);
    ParticleStore particles(set, {1000});
    ParticleGroup& group = particles.of(PartKind::elastic);
    const double period = 16;
    for (std::size_t i = 0; i < group.owned(); i += 2) group.data(Field::position)[i] -= period;
    bodies.find_nodes(particles);
    for (std::size_t i = 0; i < group.owned(); ++i) group.data(Field::force, 0)[i] = 1e-4;
    for (int step = 0; step < 20; ++step) {
        bodies.advance(particles, 0.2, 1);
        bodies.show_positions(particles);
    }
    for (std::size_t i = 0; i < group.owned(); ++i) {
        const double x = group.data(Field::position)[i] + (i % 2 == 0 ? period : 0);
        EXPECT_EQ(x, particles.quantum().round(bodies.bodies()[0]->position(i)[0]));
    }
}

}  // namespace
}  // namespace dmp::tests::solver_spring_bodies_tests
