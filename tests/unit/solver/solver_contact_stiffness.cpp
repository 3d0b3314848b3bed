// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Contacts of spring bodies that are pressed together are stiffer than at touch, and their nodes may be light.
#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "models/contact/contact_stiffness.hpp"
#include "small_scenes.hpp"
#include "solver/elastic/spring_bodies.hpp"
#include "solver/neighbours/neighbours.hpp"
#include "solver/run/setup.hpp"
#include "tests/modules.hpp"

namespace dmp::tests::solver_contact_stiffness_tests {
namespace {

constexpr double strength = 2, range = 0.1;

TEST(ContactStiffness, is_the_slope_of_the_force) {
    const Repulsion repulsion{strength};
    const auto force = [&](double r) { return repulsion.law(Vector<double, 2>{{r, 0}}, range)[0]; };
    for (const double r : {0.06, 0.075, 0.09, 0.0999}) {
        const double by_differences = (force(r - 1e-7) - force(r + 1e-7)) / 2e-7;
        EXPECT_NEAR(contact_stiffness(repulsion, r * r, range) / by_differences, 1, 1e-4) << r;
    }
    EXPECT_EQ(contact_stiffness(repulsion, range * range, range), 0);
    EXPECT_EQ(contact_stiffness(repulsion, 1, range), 0);
    EXPECT_EQ(contact_step_limit(0), std::numeric_limits<double>::infinity());
    // One mass on one spring: 2 / omega.
    EXPECT_DOUBLE_EQ(contact_step_limit(contact_rate(8, 1 / 2.0, 0)), 1);
    // Two equal masses that are free: omega^2 = 2 k / m.
    EXPECT_DOUBLE_EQ(contact_rate(8, 1 / 2.0, 1 / 2.0), 2 * 8 / 2.0);
}

/// Rods among water, of unlike mass; one node is fixed.
SceneAndParticles rods_in_water() {
    SceneAndParticles made = endless_water();
    made.scene.contact.range = 1.0;
    add_flags(made);
    ParticleSet& set = made.particles;
    add_rod(made, Vec(0.31, 0.32, 0), 0);
    add_rod(made, Vec(0.375, 0.33, 0), 1);
    add_rod(made, Vec(0.03, 0.77, 0), 2);  // reaches across the border
    for (std::size_t k = 0; k < 6; ++k) set.mass[set.size() - 1 - k] = 1 + 0.5 * static_cast<double>(k);
    set.fixed[set.size() - 3] = 1;
    return made;
}

TEST(ContactStiffness, of_bodies_is_the_largest_sum_over_all_that_touches_a_node) {
    const SceneAndParticles made = rods_in_water();
    const ParticleSet& set = made.particles;
    const Ranks ranks = Ranks::alone();
    const PairSettings settings = pair_settings(made.scene, set, {1});
    ParticleStore particles(set, rest_densities(made.scene, set));
    const auto sweeps = make_pair_sweeps(settings, particles);
    fill_store(made.scene, set, particles);
    const Repulsion repulsion{settings.repulsion_strength};
    SpringBodies bodies(set, made.scene, ranks, {repulsion, range});
    Neighbours neighbours(ranks, particles.space(), settings.support, 1);
    neighbours.renew(particles);
    bodies.find_nodes(particles);

    double expected = 0;
    const auto inverse_mass = [&](std::size_t i) { return set.fixed[i] ? 0 : 1 / set.mass[i]; };
    for (std::size_t i = 0; i < set.size(); ++i) {
        if (set.body[i] < 0) continue;
        double sum = 0;
        for (std::size_t j = 0; j < set.size(); ++j) {
            if (set.body[i] == set.body[j]) continue;
            Vec apart = set.position[i] - set.position[j];
            for (int axis = 0; axis < 2; ++axis) apart[axis] -= 0.8 * std::round(apart[axis] / 0.8);
            sum += contact_rate(contact_stiffness(repulsion, apart.squaredNorm(), range), inverse_mass(i),
                                inverse_mass(j));
        }
        expected = std::max(expected, sum);
    }
    ASSERT_GT(expected, 0);
    const double found = bodies.largest_contact_rate(particles, neighbours.list(), 1);
    EXPECT_NEAR(found / expected, 1, 1e-9);
    EXPECT_EQ(bodies.largest_contact_rate(particles, neighbours.list(), 2), found);
}

TEST(ContactStiffness, of_a_body_with_itself) {
    SelfContact<2> contact({{strength}, range}, {{0, 1}});
    const SelfContact<2>::Vectors position{{{0, 0}}, {{0.02, 0}}, {{0, 0.08}}};
    const auto stiffness = [&](double square) { return contact_stiffness({strength}, square, range); };
    const double of_first = contact_rate(stiffness(0.0064), 1 / 3.0, 1 / 5.0),
                 of_last = contact_rate(stiffness(0.0064), 1 / 5.0, 1 / 3.0) +
                           contact_rate(stiffness(0.0064 + 0.0004), 1 / 5.0, 1 / 2.0);
    EXPECT_DOUBLE_EQ(contact.rate(position, {1 / 3.0, 1 / 2.0, 1 / 5.0}), std::max(of_first, of_last));
}

/// A light rod between two fixed ones, all but in the middle, at 0.68 of the range from each; nothing else is there.
SceneAndParticles squeezed_rod() {
    SceneAndParticles made = endless_water();
    made.scene.parts.clear();
    made.particles = {};
    ParticleSet& set = made.particles;
    set.spacing = range;
    set.box = {Vec::Zero(), Vec(0.8, 0.8, 0)};
    set.periodic = {true, true, false};
    add_flags(made);
    add_rod(made, Vec(0.3, 0.3, 0), 0);
    add_rod(made, Vec(0.3681, 0.3, 0), 1);
    add_rod(made, Vec(0.436, 0.3, 0), 2);
    set.fixed = {1, 1, 0, 0, 1, 1};
    std::ranges::fill(set.mass, 0.5);
    made.scene.contact.range = 1.0;
    made.scene.contact.strength = strength;
    made.scene.numerics.sound_speed = 10.0;
    made.scene.run.duration = made.scene.output.every = 0.5;
    return made;
}

// Walls have no mass, and what is held does not swing: neither makes the limit vanish or shorter.
TEST(ContactStiffness, of_walls_and_held_nodes_leaves_the_step_its_limit) {
    SceneAndParticles made = squeezed_rod();
    const auto limit = [&] {
        const PairSettings settings = pair_settings(made.scene, made.particles, Resources(1));
        return step_scales(made.scene, made.particles, settings, 1).contact_limit;
    };
    const double of_alike = limit();
    EXPECT_GT(of_alike, 0);
    for (const std::size_t held : {0, 1, 4, 5}) made.particles.mass[held] = 0;
    EXPECT_EQ(limit(), of_alike);
    made.particles.parts.push_back({"wall", PartKind::rigid});
    for (const std::size_t at_wall : {0, 1}) {
        made.particles.part[at_wall] = static_cast<int>(made.particles.parts.size()) - 1;
        made.particles.fixed[at_wall] = 0;
    }
    EXPECT_EQ(limit(), of_alike);
    std::ranges::fill(made.particles.fixed, 1);
    EXPECT_EQ(limit(), 0);  // nothing swings
}

TEST(ContactStiffness, shortens_the_step_for_light_nodes_that_are_pressed_together) {
    const SceneAndParticles made = squeezed_rod();
    KeptFrames kept;
    RunOptions options;
    options.sink = &kept;
    Simulation simulation(made.scene, made.particles, 1);
    const double planned = simulation.plan().dt;  // by the drawn particles at touch
    const RunSummary summary = simulation.run(options);
    const double omega = std::sqrt(2 * contact_stiffness({strength}, 0.068 * 0.068, range) / 0.5);
    EXPECT_GT(planned * omega, 2);  // it would not be stable
    EXPECT_GT(static_cast<double>(summary.steps), 0.9 * 0.5 * omega);
    const FrameGroup& rods = *group_of(kept.frames.back(), "solid");
    for (const std::size_t node : {2, 3}) EXPECT_NEAR(rods.position[3 * node], 0.368, 1.1e-4);
}

}  // namespace
}  // namespace dmp::tests::solver_contact_stiffness_tests
