// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Species on several ranks: the bits of one.
#include <cmath>
#include <filesystem>
#include <string>

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
    ASSERT_EQ(shared.species.size(), 3U);
    for (std::size_t s = 0; s < 3; ++s) {
        EXPECT_EQ(shared.species[s].end, alone.species[s].end);
        EXPECT_EQ(shared.species[s].from_walls, alone.species[s].from_walls);
        EXPECT_EQ(shared.species[s].taken_up, alone.species[s].taken_up);
        EXPECT_LT(std::abs(shared.species[s].residual()), 1e-14);
    }
    EXPECT_GT(alone.species[0].taken_up, 1e-4);
    EXPECT_NE(alone.species[2].from_walls, 0);
    EXPECT_EQ(shared.species_solves.iterations, alone.species_solves.iterations);
    ASSERT_EQ(shared.measures.rows.size(), alone.measures.rows.size());
    EXPECT_EQ(shared.measures.rows.back(), alone.measures.rows.back());
    if (!ranks.is_first()) return;
    EXPECT_EQ(shared.state_hash, alone.state_hash);
}

TEST(SpeciesOnRanks, are_the_same_bits) { expect_same_bits(SpeciesStepping::explicitly); }

TEST(SpeciesOnRanks, go_on_from_a_checkpoint_to_the_same_bits) {
    SceneAndParticles made = stirred_mixture();
    made.scene.run.duration = 0.2;
    made.scene.output.every = 0.1;
    const Ranks ranks = Ranks::world();
    const auto folder = std::filesystem::temp_directory_path() / ("dmp_species_ranks_" + std::to_string(ranks.size()));
    if (ranks.is_first()) std::filesystem::remove_all(folder);
    const RunSummary shared = run_in_two_parts(made, folder, ranks), alone = run_of(made);
    for (std::size_t s = 0; s < 3; ++s) {
        EXPECT_EQ(shared.species[s].end, alone.species[s].end);
        EXPECT_EQ(shared.species[s].from_walls, alone.species[s].from_walls);
        EXPECT_EQ(shared.species[s].taken_up, alone.species[s].taken_up);
    }
    if (!ranks.is_first()) return;
    std::filesystem::remove_all(folder);
    EXPECT_EQ(shared.state_hash, alone.state_hash);
}

TEST(SpeciesOnRanks, are_the_same_bits_implicitly) { expect_same_bits(SpeciesStepping::implicitly); }

}  // namespace
}  // namespace dmp::tests::species_ranks_tests
