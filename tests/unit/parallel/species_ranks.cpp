// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Species on several ranks: the bits of one.
#include <gtest/gtest.h>

#include "tests/modules.hpp"
#include "tests/unit/solver/dissolved.hpp"

namespace dmp::tests::species_ranks_tests {
namespace {

void expect_same_bits(SpeciesStepping stepping) {
    SceneAndParticles made = stirred_mixture();
    made.scene.numerics.species_stepping = stepping;
    made.scene.run.duration = 0.2;
    const Ranks ranks = Ranks::world();
    const RunSummary shared = run_of(made, nullptr, ranks), alone = run_of(made);
    EXPECT_GT(alone.steps, 10);
    ASSERT_EQ(shared.species.size(), 2U);
    for (std::size_t s = 0; s < 2; ++s) {
        EXPECT_EQ(shared.species[s].end, alone.species[s].end);
        EXPECT_EQ(shared.species[s].from_walls, alone.species[s].from_walls);
        EXPECT_LT(std::abs(shared.species[s].residual()), 1e-14);
    }
    EXPECT_EQ(shared.species_solves.iterations, alone.species_solves.iterations);
    ASSERT_EQ(shared.measures.rows.size(), alone.measures.rows.size());
    EXPECT_EQ(shared.measures.rows.back(), alone.measures.rows.back());
    if (!ranks.is_first()) return;
    EXPECT_EQ(shared.state_hash, alone.state_hash);
}

TEST(SpeciesOnRanks, are_the_same_bits) { expect_same_bits(SpeciesStepping::explicitly); }

TEST(SpeciesOnRanks, are_the_same_bits_implicitly) { expect_same_bits(SpeciesStepping::implicitly); }

}  // namespace
}  // namespace dmp::tests::species_ranks_tests
