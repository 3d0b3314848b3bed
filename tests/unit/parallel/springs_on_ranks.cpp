// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// A solid and a shell with dihedrals in moving water, in 3-D, on several ranks: the bits of one, and what they say
// will run.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/modules.hpp"
#include "tests/unit/solver/bodies_in_space.hpp"
#include "tests/unit/solver/small_scenes.hpp"

namespace dmp::tests::springs_on_ranks_tests {
namespace {

using namespace lattice_solids;
using ::testing::ElementsAre;

constexpr double spacing = 0.1;
constexpr int side = 14;

Part spring_part(const std::string& name) {
    Part part = part_with(0.01);
    part.name = name;
    return part;
}

/// Bulged, and as heavy as the water in whose place it is.
ParticleSet stirred(ParticleSet body, const std::vector<double>& volume) {
    for (Bond& bond : body.bonds) bond.rest_length *= 1 + 0.02 * std::sin(bond.a);
    body.volume = volume;
    for (std::size_t n = 0; n < body.size(); ++n) body.mass[n] = 1000 * volume[n];
    return body;
}

ParticleSet bulged_solid() {
    const ParticleSet solid = set_of(cell_lattice(block(3, 3, 8, spacing), cell_constants(1e5, 0.1, spacing)));
    EXPECT_GT(solid.hinges.size(), 0U);
    return stirred(solid, std::vector<double>(solid.size(), std::pow(spacing, 3)));
}

ParticleSet bulged_shell() {
    const ParticleSet shell = hexagonal_shell(4, shell_constants(1e4, 50, spacing, spacing));
    EXPECT_GT(shell.dihedrals.size(), 0U);
    std::vector<double> volume;
    for (const double area : shell.mass) volume.push_back(2 * spacing * area);  // nodes' shares, two layers
    return stirred(shell, volume);
}

/// Water on a lattice, but where nodes are.
ParticleSet water_around(const ParticleSet& nodes) {
    ParticleSet water;
    for (int k = 0; k < side; ++k)
        for (int j = 0; j < side; ++j)
            for (int i = 0; i < side; ++i) {
                const Vec position = spacing * Vec(i + 0.5, j + 0.5, k + 0.5);
                const auto near = [&](const Vec& node) { return (position - node).norm() < 0.9 * spacing; };
                if (std::none_of(nodes.position.begin(), nodes.position.end(), near))
                    water.position.push_back(position);
            }
    water.mass.assign(water.size(), 1);
    water.volume.assign(water.size(), std::pow(spacing, 3));
    return water;
}

/// A cube of water, periodic along all axes, sheared, with a solid with hinges and a shell with dihedrals that reach
/// through the planes halfway across it: however ranks divide the cube, they share a body.
SceneAndParticles solid_and_shell_in_water() {
    SceneAndParticles made = endless_water();
    Scene& scene = made.scene;
    scene.dimension = 3;
    scene.flow.acceleration[0] = Expression("sin(4 * z)", "sin(4 * z)");
    scene.flow.periodic = {true, true, true};
    scene.parts.push_back(spring_part("solid"));
    scene.parts.push_back(spring_part("shell"));
    scene.contact.strength = 1e-2;
    scene.run.duration = 0.05;
    scene.numerics.step_factor = 0.3;
    scene.output.every = 0.05;

    // The solid's nodes are places of the water's lattice.
    const auto add_bodies = [solid = bulged_solid(), shell = bulged_shell()](ParticleSet& set) {
        append(set, solid, Vec(0.25, 0.55, 0.35), 1, 0);
        append(set, shell, Vec(0.9, 0.7, 0.75), 2, 1);
    };
    ParticleSet bodies;
    add_bodies(bodies);

    ParticleSet& set = made.particles;
    set = {};
    set.dimension = 3;
    set.spacing = spacing;
    set.box = {Vec::Zero(), Vec::Constant(spacing * side)};
    set.periodic = {true, true, true};
    set.parts = {{"water", PartKind::fluid}, {"solid", PartKind::elastic}, {"shell", PartKind::elastic}};
    append(set, water_around(bodies), Vec::Zero(), 0, -1);
    add_bodies(set);
    return made;
}

RunSummary run_on(const SceneAndParticles& made, const Ranks& ranks) {
    Resources resources(1);
    resources.ranks = ranks;
    return Simulation(made.scene, made.particles, resources).run({});
}

TEST(SpringsInSpace, are_the_same_bits_on_any_number_of_ranks) {
    SceneAndParticles made = solid_and_shell_in_water();
    const Ranks ranks = Ranks::world();
    for (const SpringStepping stepping : {SpringStepping::implicit, SpringStepping::subcycled}) {
        made.scene.numerics.spring_stepping = stepping;
        const RunSummary alone = run_on(made, Ranks::alone()), shared = run_on(made, ranks);
        EXPECT_GT(alone.steps, 5);
        EXPECT_EQ(shared.steps, alone.steps);
        EXPECT_EQ(shared.lost, 0U);
        EXPECT_EQ(shared.momentum_residual, alone.momentum_residual);
        EXPECT_LT(shared.momentum_residual, 1e-9);
        if (ranks.is_first()) {
            EXPECT_EQ(shared.state_hash, alone.state_hash);
        }
    }
}

TEST(SpringsInSpace, that_start_moving_are_the_same_bits_on_any_number_of_ranks) {
    SceneAndParticles made = solid_and_shell_in_water();
    made.scene.flow.acceleration[0] = Expression();
    made.scene.parts[1].initial_velocity =
        std::array{Expression("0.1", "0.1"), Expression("0.2 * z", "0.2 * z"), Expression()};
    const Ranks ranks = Ranks::world();
    const RunSummary alone = run_on(made, Ranks::alone()), shared = run_on(made, ranks);
    EXPECT_GT(alone.start.momentum[0], 0);
    EXPECT_EQ(shared.start.momentum, alone.start.momentum);
    // Liquid that was left out around the shell lets it border on nothing: something holds the level of the pressure.
    EXPECT_NEAR(alone.end.momentum[0] - alone.impulse_of_fixed[0], alone.start.momentum[0],
                1e-12 * alone.start.momentum[0]);
    if (ranks.is_first()) {
        EXPECT_EQ(shared.state_hash, alone.state_hash);
    }
}

TEST(DrivenInSpace, liquid_and_solids_are_the_same_bits_on_any_number_of_ranks) {
    SceneAndParticles made = solid_and_shell_in_water();
    made.scene.flow.acceleration[1] = Expression("-2", "-2");
    made.scene.flow.pressure_gradient.value[2] = Expression("-900 * cos(9 * t)", "-900 * cos(9 * t)");
    made.particles.fixed.back() = 1;
    const Ranks ranks = Ranks::world();
    const RunSummary alone = run_on(made, Ranks::alone()), shared = run_on(made, ranks);
    EXPECT_EQ(shared.momentum_residual, alone.momentum_residual);
    EXPECT_EQ(shared.impulse_of_body_forces, alone.impulse_of_body_forces);
    EXPECT_LT(shared.momentum_residual, 1e-13);
    EXPECT_GT(alone.impulse_of_body_forces[2], 0);
    EXPECT_LT(alone.impulse_of_body_forces[1], 0);
    if (ranks.is_first()) {
        EXPECT_EQ(shared.state_hash, alone.state_hash);
    }
}

/// A bond from each node of the solid to each of the shell within some spacings: one body.
SceneAndParticles joined() {
    SceneAndParticles made = solid_and_shell_in_water();
    Join join;
    join.name = std::string("seam");
    join.parts = std::array<std::string, 2>{"solid", "shell"};
    made.scene.joins = {join};
    ParticleSet& set = made.particles;
    for (std::size_t i = 0; i < set.size(); ++i)
        for (std::size_t j = 0; j < set.size(); ++j) {
            const double apart = (set.position[i] - set.position[j]).norm();
            if (set.part[i] == 1 && set.part[j] == 2 && apart < 2 * spacing)
                set.bonds.push_back({static_cast<int>(i), static_cast<int>(j), apart, 1e4, 0});
        }
    for (int& body : set.body) body = std::min(body, 0);
    return made;
}

TEST(JoinedInSpace, are_the_same_bits_on_any_number_of_ranks) {
    const SceneAndParticles made = joined();
    ASSERT_GE(made.particles.bonds.back().join, 0);
    const Ranks ranks = Ranks::world();
    const RunSummary alone = run_on(made, Ranks::alone()), shared = run_on(made, ranks),
                     apart = run_on(solid_and_shell_in_water(), Ranks::alone());
    EXPECT_LT(shared.momentum_residual, 1e-9);
    EXPECT_EQ(shared.momentum_residual, alone.momentum_residual);
    if (ranks.is_first()) {
        EXPECT_EQ(shared.state_hash, alone.state_hash);
        EXPECT_NE(shared.state_hash, apart.state_hash);
    }
}

TEST(PlanInSpace, names_hinges_and_dihedrals_of_the_bodies_that_have_them) {
    SceneAndParticles made = solid_and_shell_in_water();
    const Ranks ranks = Ranks::world();
    const auto asked_for_by = [&](const std::string& model) {
        Resources resources(1);
        resources.ranks = ranks;
        std::vector<std::string> reasons;
        for (const ModelUse& use : Simulation(made.scene, made.particles, resources).plan().models)
            if (use.model == model) reasons.push_back(use.reason.substr(0, use.reason.find(" at ")));
        return reasons;
    };
    EXPECT_THAT(asked_for_by("bonds with dashpots"), ElementsAre("part 'solid'", "part 'shell'"));
    EXPECT_THAT(asked_for_by("hinges"), ElementsAre("part 'solid'"));
    EXPECT_THAT(asked_for_by("dihedrals"), ElementsAre("part 'shell'"));
    EXPECT_EQ(asked_for_by("implicit springs").size(), 1U);
    made.scene.numerics.spring_stepping = SpringStepping::subcycled;
    EXPECT_EQ(asked_for_by("sub-cycled springs").size(), 1U);
    EXPECT_EQ(asked_for_by("implicit springs").size(), 0U);
}

}  // namespace
}  // namespace dmp::tests::springs_on_ranks_tests
