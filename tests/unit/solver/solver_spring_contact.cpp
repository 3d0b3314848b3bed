// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "solver/neighbours/neighbours.hpp"
#include "solver/run/setup.hpp"
#include "solver/sweeps/pair_sweeps.hpp"
#include "tests/modules.hpp"
#include "tests/unit/solver/ladder_body.hpp"

namespace dmp::tests::solver_spring_contact_tests {
namespace {

constexpr double strength = 1e-2;
SpringContact contact_within(double range) { return {{strength}, range}; }

std::vector<Vec> in_space(const Vectors& forces) {
    std::vector<Vec> values;
    for (const V2& force : forces) values.emplace_back(force[0], force[1], 0);
    return values;
}

TEST(SelfContact, a_body_at_rest_feels_nothing_even_where_neighbours_are_within_its_range) {
    const ParticleSet set = ladder({12, 0.5, false});
    PlaneBody body(set, part_with(0), 0, contact_within(1.3));
    body.advance(std::vector<Vec>(set.size(), Vec::Zero()), 0.5, 1);
    for (const V2& velocity : body.velocities()) EXPECT_LT(std::sqrt(dot(velocity, velocity)), 1e-14);
}

TEST(SelfContact, repels_what_was_drawn_apart_as_the_law_says_and_nothing_else) {
    // Nodes of a chain along x, the last brought near the first; its neighbour too, but that one was drawn near it.
    const Vectors drawn{{{0, 0}}, {{1, 0}}, {{2, 0}}, {{3, 0}}};
    const auto held_apart = pairs_within(in_space(drawn), 2, neighbourhood_of_contact(1, 1));
    SelfContact<2> contact(contact_within(1), held_apart);
    const Vectors now{{{0, 0}}, {{0.5, 0}}, {{2, 0}}, {{0.3, 0.6}}};
    Vectors force(4, V2::zero());
    contact.add_forces(now, force);
    const V2 by_first = Repulsion{strength}.law(now[3] - now[0], 1.0),
             by_second = Repulsion{strength}.law(now[3] - now[1], 1.0);
    for (int axis = 0; axis < 2; ++axis) {
        EXPECT_DOUBLE_EQ(force[3][axis], by_first[axis] + by_second[axis]);
        EXPECT_DOUBLE_EQ(force[0][axis], -by_first[axis]);
        EXPECT_DOUBLE_EQ(force[1][axis], -by_second[axis]);
        EXPECT_EQ(force[2][axis], 0);
    }
    EXPECT_GT(by_first[1], 0);
    // Approaching by small steps, with pairs listed before: the same bits as looked for anew.
    for (int small = 0; small < 139; ++small) {
        const double x = 2.2 - 0.013 * small;
        const Vectors position{{{0, 0}}, {{1, 0}}, {{2, 0}}, {{x, 0.2}}};
        Vectors listed(4, V2::zero()), anew(4, V2::zero());
        contact.add_forces(position, listed);
        SelfContact<2>(contact_within(1), held_apart).add_forces(position, anew);
        for (std::size_t n = 0; n < 4; ++n)
            for (int axis = 0; axis < 2; ++axis) EXPECT_EQ(listed[n][axis], anew[n][axis]);
    }
}

/// Columns of a leaflet that is held in its middle while its arms are lifted and pressed together: how far the left arm
/// reaches over the middle to the right.
double overlap_of_folded_leaflet(const SpringContact& contact) {
    constexpr int cells = 48;
    ParticleSet set = ladder({cells, 0.2, false});
    for (int node = cells - 2; node <= cells + 3; ++node) set.fixed[node] = 1;
    PlaneBody body(set, part_with(0.05, 0.01), 0, contact);
    Vectors load(set.size());
    for (std::size_t n = 0; n < set.size(); ++n) load[n] = {{(set.position[n][0] < 0.5 * cells ? 1 : -1) * 1e-3, 4e-4}};
    for (int step = 0; step < 4000; ++step) body.advance(in_space(load), 0.5, 0);
    double overlap = -std::numeric_limits<double>::infinity();
    for (int column = 0; column < 12; ++column)
        overlap = std::max(overlap, body.positions()[2 * static_cast<std::size_t>(column)][0] - 0.5 * cells);
    return overlap;
}

TEST(SelfContact, a_leaflet_that_folds_does_not_pass_through_itself) {
    EXPECT_GT(overlap_of_folded_leaflet({}), 2);  // it does without
    const double overlap = overlap_of_folded_leaflet(contact_within(1));
    EXPECT_LT(overlap, 0);
    EXPECT_GT(overlap, -6);  // and the arms do meet
}

/// Two cantilevers from opposite sides, one above the other, pressed together by forces on their nodes: the smallest
/// height of the upper one's nodes over the lower one's where they overlap.
double gap_of_pressed_leaflets(double repulsion) {
    constexpr int cells = 16;
    const ParticleSet one = ladder({cells, 0.2, true});
    ParticleSet set = one;
    const int count = static_cast<int>(one.size());
    for (const Vec& at : one.position) {
        set.position.emplace_back(4 + cells - at[0], 4.3 + at[1], 0);
        set.body.push_back(1);
    }
    for (auto* values : {&set.volume, &set.mass, &set.wall_distance}) values->resize(2 * one.size(), values->back());
    set.part.resize(2 * one.size(), 0);
    set.seated.resize(2 * one.size(), 0);
    set.wall_normal.resize(2 * one.size(), Vec::Zero());
    set.fixed.insert(set.fixed.end(), one.fixed.begin(), one.fixed.end());
    for (const Bond& bond : one.bonds)
        set.bonds.push_back({bond.a + count, bond.b + count, bond.rest_length, bond.stiffness});
    for (const Hinge& hinge : one.hinges)  // mirrored
        set.hinges.push_back(
            {hinge.a + count, hinge.centre + count, hinge.b + count, -hinge.rest_angle, hinge.stiffness});
    set.box = {Vec(-10, -30, 0), Vec(40, 30, 0)};

    const Ranks ranks = Ranks::alone();
    PairSettings settings;
    settings.spacing = 1;
    settings.support = 3;
    settings.sound_speed = 1;
    settings.density.largest = 1;
    settings.repulsion_strength = repulsion;
    ParticleStore particles(set, {1});
    const auto sweeps = make_pair_sweeps(settings, particles);
    ParticleGroup& nodes = particles.of(PartKind::elastic);
    for (std::size_t i = 0; i < nodes.owned() && repulsion > 0; ++i)
        nodes.data(Field::contact_range)[i] = nodes.data(Field::wall_contact_range)[i] = 1;
    Neighbours neighbours(ranks, particles.space(), settings.support, 1);
    SpringBodies bodies(set, scene_with(part_with(0.05, 0.01), SpringStepping::implicit), ranks, {{repulsion}, 1});
    constexpr double dt = 0.5;
    for (int step = 0; step < 2500; ++step) {
        neighbours.renew(particles);
        bodies.find_nodes(particles);
        sweeps->forces(particles, neighbours.list(), {});
        for (std::size_t i = 0; i < nodes.owned(); ++i)
            nodes.data(Field::force, 1)[i] += nodes.tags()[i].body == 0 ? 1e-3 : -1e-3;
        bodies.advance(particles, dt, 1);
        bodies.show_positions(particles);
    }
    double gap = std::numeric_limits<double>::infinity();
    const SpringBody &low = *bodies.bodies()[0], &high = *bodies.bodies()[1];
    for (std::size_t a = 0; a < low.nodes(); ++a)
        for (std::size_t b = 0; b < high.nodes(); ++b)
            if (const Vec apart = high.position(b) - low.position(a); std::abs(apart[0]) < 0.5)
                gap = std::min(gap, apart[1]);
    return gap;
}

TEST(Contact, two_leaflets_do_not_pass_through_each_other) {
    EXPECT_LT(gap_of_pressed_leaflets(0), -2);  // they do without
    const double gap = gap_of_pressed_leaflets(strength);
    EXPECT_GT(gap, 0.3);
    EXPECT_LT(gap, 1.5);  // and they do meet
}

}  // namespace
}  // namespace dmp::tests::solver_spring_contact_tests
