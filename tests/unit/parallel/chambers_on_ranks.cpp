// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Closed chambers of the fluid: found on any number of ranks, and each keeps its volume to the same bits.
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "solver/neighbours/chambers.hpp"
#include "solver/time/fluid_reference.hpp"
#include "tests/modules.hpp"
#include "tests/unit/solver/small_scenes.hpp"
#include "tests/unit/solver/two_chambers.hpp"
#include "tests/unit/temporary_files.hpp"

namespace dmp::tests::chambers_on_ranks_tests {
namespace {

constexpr double support = 3 * spacing;
const std::vector<double> densities{1000, 1000, 1000, 1000};

/// Particles with their lists, on these ranks.
struct Listed {
    Ranks ranks;
    ParticleStore particles;
    Neighbours neighbours;

    Listed(const ParticleSet& set, const Ranks& on)
        : ranks(on), particles(set, densities, ranks), neighbours(ranks, particles.space(), support, 1) {
        particles.fluid().declare({Field::density, Field::chamber});
        for (std::size_t i = 0; i < particles.fluid().owned(); ++i) particles.fluid().data(Field::density)[i] = 1000;
        neighbours.renew(particles);
    }
    FoundChambers find() { return find_chambers(particles, neighbours, spacing, {}); }
    /// Moves the water between two places by that much along x.
    void move(double from, double to, double by) {
        ParticleGroup& water = particles.fluid();
        for (std::size_t i = 0; i < water.owned(); ++i) {
            double& x = water.data(Field::position)[i];
            if (x > from && x < to) x += by;
        }
        neighbours.renew(particles);
    }
    void take_out_of_gap() { move(7 * spacing, 9 * spacing, 100); }
    void put_into_gap() { move(50, 150, -100); }
};

TEST(ChambersOnRanks, finds_what_a_wall_of_two_rows_separates) {
    for (const Ranks& ranks : {Ranks::world(), Ranks::alone()}) {
        const FoundChambers found = Listed(two_chambers().particles, ranks).find();
        ASSERT_EQ(found.count(), 2U);
        EXPECT_NEAR(found.places[0][0], 0.5 * spacing, 1e-9);
        EXPECT_NEAR(found.places[1][0], 9.5 * spacing, 1e-9);
        EXPECT_EQ(found.shared, (std::vector<FoundChambers::Shared>{{0, 0, 56}, {0, 1, 56}}));
        EXPECT_FALSE(found.same_as_before());
        EXPECT_EQ(Listed(two_chambers(1).particles, ranks).find().count(), 1U) << "the wall has a gap";
    }
}

TEST(ChambersOnRanks, finds_one_where_the_box_is_periodic) {
    EXPECT_EQ(Listed(two_chambers(0, true).particles, Ranks::world()).find().count(), 1U);
}

TEST(ChambersOnRanks, counts_few_particles_as_of_the_chamber_they_were_in) {
    Listed water(two_chambers(1).particles, Ranks::world());
    EXPECT_EQ(water.find().count(), 1U);
    EXPECT_TRUE(water.find().same_as_before());
    water.take_out_of_gap();
    const FoundChambers found = water.find();
    EXPECT_EQ(found.count(), 2U);
    EXPECT_EQ(found.shared, (std::vector<FoundChambers::Shared>{{0, 0, 58}, {0, 1, 56}}));
}

TEST(ChambersOnRanks, share_their_targets_when_they_part_and_join) {
    const Ranks ranks = Ranks::world();
    Listed water(two_chambers(1).particles, ranks);
    FluidReference reference({true, true, 0.01, true}, densities, water.particles, ranks);
    const auto take = [&] { reference.take_chambers(water.find(), water.particles, ranks); };
    const auto update = [&](double volume, std::vector<double> of_each) {
        VolumeSums sums;
        sums.volume.add(volume);
        std::vector<ExactSum> volumes(of_each.size());
        for (std::size_t c = 0; c < of_each.size(); ++c) volumes[c].add(of_each[c]);
        reference.update(sums, 1e-3, volumes);
    };
    const double cell = spacing * spacing, all = 114 * cell;
    VolumeSums at_start;
    at_start.volume.add(all);
    reference.start(at_start);
    take();
    EXPECT_TRUE(reference.chamber_excess().empty());

    water.take_out_of_gap();
    take();
    ASSERT_EQ(reference.chamber_excess().size(), 2U);
    // One expands by what the other loses: nothing of it is in the whole.
    update(all, {57 * cell, 57 * cell});
    EXPECT_NEAR(reference.density_excess(), 0, 1e-14);
    EXPECT_NEAR(reference.chamber_excess()[0], 58.0 / 57 - 1, 1e-12);
    EXPECT_NEAR(reference.chamber_excess()[1], 56.0 / 57 - 1, 1e-12);
    EXPECT_NEAR(reference.chamber_drifts()[1].drift, 56.0 / 57 - 1, 1e-12);
    EXPECT_NEAR(reference.chamber_drifts()[1].mass, 1000 * 56 * cell, 1e-9);

    water.put_into_gap();
    take();
    EXPECT_TRUE(reference.chamber_excess().empty());
    update(1.1 * all, {});
    EXPECT_NEAR(reference.density_excess(), 1 / 1.1 - 1, 1e-12) << "the sum of the targets stays";
}

TEST(ChambersOnRanks, keep_their_pressures_to_the_same_bits) {
    const Ranks ranks = Ranks::world();
    const WalledWater made = two_chambers();
    KeptFrames kept;
    const RunSummary shared = run_of(made, nullptr, ranks), alone = run_of(made, &kept);
    ASSERT_EQ(alone.chambers.size(), 2U);
    EXPECT_GT(alone.steps, 100);
    const auto difference = [](const Frame& frame) { return mean_pressure(frame, true) - mean_pressure(frame, false); };
    EXPECT_NEAR(difference(kept.frames.back()), difference(kept.frames.front()), 0.01 * 500);
    if (!ranks.is_first()) return;
    EXPECT_EQ(shared.state_hash, alone.state_hash);
    EXPECT_EQ(shared.chambers[0].drift, alone.chambers[0].drift);
    EXPECT_LT(alone.momentum_residual, 1e-9);
}

TEST(ChambersOnRanks, go_on_from_a_checkpoint) {
    const TemporaryFolder folder;
    WalledWater made = two_chambers();
    made.scene.run.duration = 0.2;
    made.scene.output.every = 0.1;
    const RunSummary whole = run_of(made), parts = run_in_two_parts(made, folder.path());
    EXPECT_EQ(parts.state_hash, whole.state_hash);
    ASSERT_EQ(parts.chambers.size(), 2U);
    EXPECT_EQ(parts.chambers[0].drift, whole.chambers[0].drift);
}

}  // namespace
}  // namespace dmp::tests::chambers_on_ranks_tests
