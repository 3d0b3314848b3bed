// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Spheres in contact: the same bits on any number of ranks, and through a checkpoint to another number of them.
#include <atomic>

#include <gtest/gtest.h>

#include "solver/spheres/sphere_run.hpp"
#include "tests/modules.hpp"
#include "tests/unit/solver/sphere_scenes.hpp"
#include "tests/unit/temporary_files.hpp"

namespace dmp::tests::spheres_on_ranks_tests {
namespace {

Resources on(const Ranks& ranks) {
    Resources resources(1);
    resources.ranks = ranks;
    return resources;
}

RunSummary run_of(const SphereScene& made, const Ranks& ranks) {
    SphereRun run(made.scene, made.set, on(ranks));
    return run.run({});
}

/// Asks to stop at its second frame.
class StopAtSecondFrame : public FrameSink {
  public:
    void write(const Frame&) override {
        if (++frames_ == 2) stop = true;
    }
    std::atomic<bool> stop = false;

  private:
    int frames_ = 0;
};

std::string resumed(const SphereScene& made, const Ranks& before, const Ranks& after, const std::string& folder) {
    RunOptions options;
    StopAtSecondFrame sink;
    if (before.is_first()) options.sink = &sink;
    options.stop = &sink.stop;
    options.checkpoints.folder = folder;
    options.checkpoints.every = 0;
    options.checkpoints.label.scene = "scene";
    SphereRun first(made.scene, made.set, on(before));
    EXPECT_TRUE(first.run(options).interrupted);
    std::vector<std::string> file;
    if (before.is_first()) file = files_in(std::filesystem::path(folder) / "checkpoints");
    std::string name = file.empty() ? "" : file.back();
    Ranks::world().broadcast(name);
    SphereRun second(made.scene, made.set, on(after));
    second.resume(Hdf5Reader(std::filesystem::path(folder) / "checkpoints" / name));
    return second.run({}).state_hash;
}

/// One that flies freely between contacts, and one that is driven.
SphereScene free_crowd() {
    SphereScene made = crowd(150, 4);
    made.scene.contact_pairs[0].rolling_friction = given(0.05);
    return made;
}
SphereScene driven_crowd() {
    SphereScene made = free_crowd();
    made.force("small", {"1e-4 * cos(300 * x)", "0", "1e-4 * sin(8000 * t)"}, ForceAmount::per_particle).until =
        given(5e-4);
    made.circle("large", {"0.002 + t", "0.01", "0"}, 1.7e-3);
    return made;
}

/// A floor that stands at first, then sinks faster than any sphere and so rules the step.
SphereScene crowd_on_a_fast_floor() {
    SphereScene made = free_crowd();
    made.scene.parts[2].velocity =
        std::array{Expression(), Expression(), SphereScene::expression("-12 * sin(3000 * t)")};
    return made;
}

void expect_the_same_bits(const SphereScene& made) {
    const Ranks ranks = Ranks::world();
    const RunSummary shared = run_of(made, ranks), alone = run_of(made, Ranks::alone());
    if (!ranks.is_first()) return;
    EXPECT_EQ(shared.state_hash, alone.state_hash);
    EXPECT_EQ(shared.impulse_of_fixed, alone.impulse_of_fixed);
    EXPECT_EQ(shared.impulse_of_body_forces, alone.impulse_of_body_forces);
    EXPECT_EQ(alone.impulse_of_body_forces[0] != 0, !made.scene.forces.empty());
    EXPECT_EQ(shared.spheres->contacts, alone.spheres->contacts);
    EXPECT_EQ(shared.spheres->end.rotation, alone.spheres->end.rotation);
    EXPECT_EQ(shared.spheres->end.contacts, alone.spheres->end.contacts);
    EXPECT_GT(shared.steps, 100);
}

TEST(SpheresOnRanks, same_bits) { expect_the_same_bits(driven_crowd()); }
TEST(SpheresOnRanks, same_bits_in_free_flight) { expect_the_same_bits(free_crowd()); }

void expect_checkpoints_of_any_number_of_ranks(const SphereScene& made) {
    const Ranks ranks = Ranks::world();
    const std::string expected = run_of(made, Ranks::alone()).state_hash;
    const TemporaryFolder own;
    std::string shared_folder = own.path().string();
    ranks.broadcast(shared_folder);
    // Of all ranks, taken up by each alone.
    EXPECT_EQ(resumed(made, ranks, Ranks::alone(), shared_folder), expected);
    // Of the first rank alone, taken up by all.
    RunOptions options;
    StopAtSecondFrame sink;
    options.sink = &sink;
    options.stop = &sink.stop;
    options.checkpoints.folder = shared_folder + "/alone";
    options.checkpoints.every = 0;
    options.checkpoints.label.scene = "scene";
    std::string name;
    if (ranks.is_first()) {
        SphereRun first(made.scene, made.set, on(Ranks::alone()));
        EXPECT_TRUE(first.run(options).interrupted);
        name = files_in(std::filesystem::path(shared_folder) / "alone/checkpoints").back();
    }
    ranks.broadcast(name);
    SphereRun second(made.scene, made.set, on(ranks));
    second.resume(Hdf5Reader(std::filesystem::path(shared_folder) / "alone/checkpoints" / name));
    const std::string found = second.run({}).state_hash;
    if (ranks.is_first()) {
        EXPECT_EQ(found, expected);
    }
    EXPECT_FALSE(ranks.any(false));  // nobody takes the folder away before all have read
}

TEST(SpheresOnRanks, checkpoints_are_of_any_number_of_ranks) {
    expect_checkpoints_of_any_number_of_ranks(driven_crowd());
}
TEST(SpheresOnRanks, checkpoints_in_free_flight_are_of_any_number_of_ranks) {
    expect_checkpoints_of_any_number_of_ranks(free_crowd());
}
TEST(SpheresOnRanks, checkpoints_beside_fast_walls_are_of_any_number_of_ranks) {
    expect_checkpoints_of_any_number_of_ranks(crowd_on_a_fast_floor());
}

}  // namespace
}  // namespace dmp::tests::spheres_on_ranks_tests
