// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Liquid that turns solid, on several ranks and through a restart: the same aggregate, particle for particle and bond
// for bond, and the bits of one rank.
#include <atomic>

#include <gtest/gtest.h>

#include "tests/modules.hpp"
#include "tests/unit/solver/clot_scenes.hpp"
#include "tests/unit/temporary_files.hpp"

namespace dmp::tests::solidify_ranks_tests {
namespace {

/// A clot that grows from the lower wall into the flow, another from a seed in its middle, both torn by it.
SceneAndParticles clotting() {
    SceneAndParticles made = blood_channel(24, "8");
    made.scene.regions = {middle_of(made), region_of("low", Vec(0, 0, 0), Vec(8 * clot_spacing, 5 * clot_spacing, 0))};
    Solidify clot = clot_of("blood");
    clot.seed_region = std::string("nidus");
    clot.probability = 0.4;
    clot.interval = 0.003;
    clot.reach = 1.3 * clot_spacing;
    clot.bond_stiffness = 0.5;
    Solidify deposit = clot;
    deposit.name = std::string("deposit");
    deposit.seed_region = std::string();
    deposit.seed_part = std::string("wall");
    deposit.region = std::string("low");
    deposit.rule = SolidifyRule::mutually_closest;
    deposit.bond_to = BondTo::neighbours;
    deposit.stress_above = 1e-6;
    deposit.from = 0.002;
    made.scene.solidify = {clot, deposit};
    Breaking tear, rip;
    tear.name = std::string("tear");
    tear.part = std::string("clot");
    tear.strain_above = 5e-4;
    rip.name = std::string("rip");
    rip.part = std::string("deposit");
    rip.force_above = 2e-6;
    rip.interval = 0.0013;
    made.scene.breaking = {tear, rip};
    made.scene.run.duration = 0.03;
    made.scene.output.every = 0.005;
    return made;
}

/// Stops the run when a frame is written.
class Stopper : public KeptFrames {
  public:
    explicit Stopper(std::size_t after) : after_(after) {}
    void write(const Frame& frame) override {
        KeptFrames::write(frame);
        if (frames.size() == after_) stop = true;
    }
    std::atomic<bool> stop = false;

  private:
    std::size_t after_;
};

struct Outcome {
    RunSummary summary;
    Frame last;
};

constexpr std::size_t never = 1000;

Outcome run_on(const SceneAndParticles& made, const Ranks& ranks, std::size_t frames = never,
               const std::filesystem::path& folder = {}, const std::filesystem::path& resumed = {}) {
    Resources resources(1);
    resources.ranks = ranks;
    Simulation simulation(made.scene, made.particles, resources);
    if (!resumed.empty()) simulation.resume(resumed);
    Stopper sink(frames);
    RunOptions options;
    options.sink = ranks.is_first() ? &sink : nullptr;
    options.stop = &sink.stop;
    options.checkpoints.folder = folder;
    options.checkpoints.every = 0;
    Outcome outcome;
    outcome.summary = simulation.run(options);
    if (ranks.is_first()) outcome.last = sink.frames.back();
    return outcome;
}

void expect_same(const Outcome& found, const Outcome& expected) {
    EXPECT_EQ(found.summary.steps, expected.summary.steps);
    ASSERT_EQ(found.summary.aggregates.size(), 2U);
    for (std::size_t k = 0; k < 2; ++k) {
        const Aggregate &a = found.summary.aggregates[k], &b = expected.summary.aggregates[k];
        EXPECT_EQ(a.particles, b.particles);
        EXPECT_EQ(a.mass, b.mass);
        EXPECT_EQ(a.pieces, b.pieces);
        EXPECT_EQ(a.largest, b.largest);
        EXPECT_EQ(a.bonds_made, b.bonds_made);
        EXPECT_EQ(a.bonds_broken, b.bonds_broken);
    }
    if (!Ranks::world().is_first()) return;
    EXPECT_EQ(found.summary.state_hash, expected.summary.state_hash);
    EXPECT_EQ(bonds_of(found.last), bonds_of(expected.last));
    const FrameGroup &a = *group_of(found.last, "solid"), &b = *group_of(expected.last, "solid");
    EXPECT_EQ(a.id, b.id);
    EXPECT_EQ(a.position, b.position);
    EXPECT_EQ(a.bond_ends, b.bond_ends);
    for (std::size_t k = 0; k < a.bond_fields.size(); ++k) EXPECT_EQ(a.bond_fields[k].values, b.bond_fields[k].values);
}

TEST(SolidifyOnRanks, makes_the_same_aggregate_bond_for_bond) {
    const SceneAndParticles made = clotting();
    const Outcome alone = run_on(made, Ranks::alone()), shared = run_on(made, Ranks::world());
    EXPECT_EQ(shared.summary.ranks, Ranks::world().size());
    expect_same(shared, alone);
    for (const Aggregate& aggregate : alone.summary.aggregates) {
        EXPECT_GT(aggregate.particles, 12) << aggregate.name;
        EXPECT_GT(aggregate.bonds_broken, 2) << aggregate.name;
    }
    EXPECT_GT(alone.summary.aggregates[0].pieces, 1);
    EXPECT_LT(alone.summary.momentum_residual, 1e-12);
    EXPECT_NEAR(alone.summary.end.mass, alone.summary.start.mass, 1e-13 * alone.summary.start.mass);
}

TEST(SolidifyOnRanks, makes_the_same_aggregate_with_implicit_viscosity_and_with_subcycled_springs) {
    SceneAndParticles made = clotting();
    made.scene.run.duration = 0.012;
    made.scene.numerics.viscosity_stepping = ViscosityStepping::implicitly;
    expect_same(run_on(made, Ranks::world()), run_on(made, Ranks::alone()));
    made.scene.numerics.viscosity_stepping = ViscosityStepping::explicitly;
    made.scene.numerics.spring_stepping = SpringStepping::subcycled;
    const Outcome alone = run_on(made, Ranks::alone());
    expect_same(run_on(made, Ranks::world()), alone);
    EXPECT_LT(alone.summary.momentum_residual, 1e-12);
}

/// Where the checkpoint is that the first rank's folder has.
std::filesystem::path checkpoint_in(std::filesystem::path folder, const Ranks& ranks) {
    std::string name = folder.string();
    ranks.broadcast(name);
    return CheckpointFolder(name).newest_good()->file;
}

TEST(SolidifyOnRanks, goes_on_after_a_restart_on_any_number_of_them) {
    const SceneAndParticles made = clotting();
    const Outcome whole = run_on(made, Ranks::alone());
    const TemporaryFolder on_each;
    std::string first = on_each.path().string();
    Ranks::world().broadcast(first);
    const std::filesystem::path folder = first;
    // From all ranks to one ...
    run_on(made, Ranks::world(), 4, folder / "shared");
    const auto by_all = checkpoint_in(folder / "shared", Ranks::world());
    expect_same(run_on(made, Ranks::alone(), never, {}, by_all), whole);
    // ... and from one to all.
    if (Ranks::world().is_first()) run_on(made, Ranks::alone(), 3, folder / "alone");
    const auto by_one = checkpoint_in(folder / "alone", Ranks::world());
    expect_same(run_on(made, Ranks::world(), never, {}, by_one), whole);
}

}  // namespace
}  // namespace dmp::tests::solidify_ranks_tests
