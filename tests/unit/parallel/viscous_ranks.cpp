// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Implicit viscosity, and the corrected scheme, on several ranks: the bits of one.
#include <gtest/gtest.h>

#include "tests/modules.hpp"
#include "tests/unit/solver/layered_channel.hpp"

namespace dmp::tests::viscous_ranks_tests {
namespace {

RunSummary run_on(const SceneAndParticles& made, const Ranks& ranks) {
    Resources resources(1);
    resources.ranks = ranks;
    Simulation simulation(made.scene, made.particles, resources);
    return simulation.run({});
}

/// Mucus between two layers of water, with a stretched rod from one into the other.
SceneAndParticles mucus_and_rod() {
    LayeredChannel channel;
    channel.layers = {{"water", 8, 1e-3}, {"mucus", 6, 20}, {"more_water", 8, 1e-3}};
    channel.columns = 12;
    channel.speed = 1e-4;
    channel.acceleration = "(y > 4e-4 && y < 7e-4) ? 0.01 : 0";
    channel.duration = 0.3;
    SceneAndParticles made = layered(channel);
    add_flags(made);
    add_rod(made, Vec(2e-4, 3.6e-4, 0), 0);
    ParticleSet& set = made.particles;
    set.position.back()[1] = 4.1e-4;
    for (std::size_t node = set.size() - 2; node < set.size(); ++node) {
        set.volume[node] = channel.spacing * channel.spacing;
        set.mass[node] = 1e-2 * LayeredChannel::density * set.volume[node];
    }
    set.bonds.back() = {set.bonds.back().a, set.bonds.back().b, 4.8e-5, 1};
    return made;
}

TEST(ImplicitViscosity, is_the_same_bits_on_any_number_of_ranks) {
    const SceneAndParticles made = mucus_and_rod();
    const RunSummary alone = run_on(made, Ranks::alone()), shared = run_on(made, Ranks::world());
    EXPECT_EQ(shared.ranks, Ranks::world().size());
    if (Ranks::world().is_first()) {
        EXPECT_EQ(shared.state_hash, alone.state_hash);
    }
    EXPECT_EQ(shared.steps, alone.steps);
    EXPECT_GT(shared.steps, 5);
    EXPECT_EQ(shared.viscous_solves.iterations, alone.viscous_solves.iterations);
    EXPECT_GT(shared.viscous_solves.mean_iterations(), 3);
    EXPECT_LT(shared.momentum_residual, 1e-12);
    EXPECT_EQ(shared.momentum_residual, alone.momentum_residual);
}

TEST(CorrectedScheme, is_the_same_bits_on_any_number_of_ranks) {
    SceneAndParticles made = mucus_and_rod();  // unlike fluids, so that all of the scheme's sums are there
    made.scene.numerics.scheme.value = FluidScheme::corrected;
    made.scene.numerics.viscous_law.value = ViscousLaw::of<NewtonianViscosity>();
    made.scene.contact.range.value = 0.7;
    made.scene.run.duration.value = 20 * Simulation(made.scene, made.particles, 1).plan().dt;
    const RunSummary alone = run_on(made, Ranks::alone()), shared = run_on(made, Ranks::world());
    if (Ranks::world().is_first()) {
        EXPECT_EQ(shared.state_hash, alone.state_hash);
    }
    EXPECT_EQ(shared.steps, alone.steps);
    EXPECT_LT(shared.momentum_residual, 1e-12);
    EXPECT_EQ(shared.momentum_residual, alone.momentum_residual);
}

}  // namespace
}  // namespace dmp::tests::viscous_ranks_tests
