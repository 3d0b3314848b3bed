// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Checkpoints that are sealed but hold what no run writes: refused as they are loaded, not met with in the middle of
// it.
#include <atomic>
#include <limits>
#include <span>

#include <gmock/gmock.h>

#include "base/errors.hpp"
#include "base/hdf5_file.hpp"
#include "base/seal.hpp"
#include "solver/state/checkpoint_file.hpp"
#include "solver/state/checkpoint_folder.hpp"
#include "tests/modules.hpp"
#include "tests/unit/damage.hpp"
#include "tests/unit/solver/clot_scenes.hpp"
#include "tests/unit/solver/walled_water.hpp"
#include "tests/unit/temporary_files.hpp"
#include "tests/unit/thrown.hpp"

namespace dmp::tests::solver_forged_checkpoints_tests {
namespace {

using ::testing::HasSubstr;

/// A clot that grows in a channel, stopped with a checkpoint.
class ForgedCheckpoint : public ::testing::Test {
  protected:
    ForgedCheckpoint() {
        made_.scene.regions = {middle_of(made_)};
        Solidify clot = clot_of("blood");
        clot.seed_region = std::string("nidus");
        made_.scene.solidify = {clot};
        made_.scene.run.duration = 0.03;
        made_.scene.output.every = 0.015;
        Simulation simulation(made_.scene, made_.particles, Resources(1));
        std::atomic<bool> stop{false};
        StoppingSink sink(stop);
        RunOptions options;
        options.sink = &sink;
        options.stop = &stop;
        options.checkpoints.folder = folder_.path();
        options.checkpoints.every = 0;
        simulation.run(options);
        file_ = CheckpointFolder(folder_.path()).newest_good().value().file;
    }

    /// Puts another value into an array of the checkpoint, and a seal that fits.
    template <class T>
    void forge(const std::string& name, std::size_t at, T value) const {
        std::vector<T> values = Hdf5Reader(file_).array<T>(name);
        const auto bytes_of_array = [&] {
            const auto bytes = std::as_bytes(std::span(values));
            return std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size());
        };
        const std::string before = bytes_of_array(), whole = bytes_of(file_);
        values.at(at) = value;
        // Other arrays may hold the same.
        for (std::size_t found = whole.find(before); found != std::string::npos;
             found = whole.find(before, found + 1)) {
            put_bytes(file_, std::string(whole).replace(found, before.size(), bytes_of_array()));
            seal(file_, checkpoint_kind, file_);
            if (Hdf5Reader(file_).array<T>(name).at(at) == value) return;
        }
        FAIL() << name << " was not found in the file";
    }

    /// What resuming from it says.
    [[nodiscard]] std::string refusal() const {
        return text_thrown<InputError>([&] {
            Simulation simulation(made_.scene, made_.particles, Resources(1));
            simulation.resume(file_);
        });
    }

    TemporaryFolder folder_;
    SceneAndParticles made_ = blood_channel();
    std::filesystem::path file_;
};

TEST_F(ForgedCheckpoint, IsTakenUpUnforged) {
    ASSERT_GT(Hdf5Reader(file_).length("elastic/id"), 1U);
    EXPECT_EQ(refusal(), "nothing was thrown");
}

TEST_F(ForgedCheckpoint, WithParticlesThatTheRunDoesNotHave) {
    forge<std::int64_t>("fluid/id", 3, 1'000'000);
    EXPECT_THAT(
        refusal(),
        HasSubstr("the checkpoint holds what no run of dmp writes: particle 1000000, which the run does not have\n  "));
    forge<std::int64_t>("fluid/id", 3, -1);
    EXPECT_THAT(refusal(), HasSubstr("particle -1, which"));
}

TEST_F(ForgedCheckpoint, WithPartsThatTheSceneDoesNotHave) {
    forge<std::uint16_t>("rigid/part", 0, 400);
    EXPECT_THAT(refusal(), HasSubstr("a particle of part 400, which the scene does not have"));
}

TEST_F(ForgedCheckpoint, WithAnElasticParticleThatIsNoNode) {
    forge<double>("springs/bodies", 2, 0);  // the id of the first node
    EXPECT_THAT(refusal(), HasSubstr("an elastic particle that is a node of no body"));
}

TEST_F(ForgedCheckpoint, WithNumbersThatAreNone) {
    forge<double>("fluid/velocity_0", 5, std::numeric_limits<double>::infinity());
    EXPECT_THAT(refusal(), HasSubstr("a velocity that is not finite"));
}

TEST_F(ForgedCheckpoint, WithMoreBodiesThanItHolds) {
    for (const double count : {1e9, -1.0, 1e300}) {
        forge<double>("springs/bodies", 0, count);
        EXPECT_THAT(refusal(), HasSubstr("the checkpoint's elastic bodies are damaged")) << count;
    }
}

/// The numbers of a body: how many nodes, for each its id, whether it is held, of a wall, its origin, ...
TEST_F(ForgedCheckpoint, WithABodyOfNoSolid) {
    forge<double>("springs/bodies", 5, 77);
    EXPECT_THAT(refusal(), HasSubstr("a body of no solid of the scene"));
}

TEST_F(ForgedCheckpoint, WithSpringsBetweenNodesThatAreNotThere) {
    constexpr std::size_t numbers_of_node = 6 + 4 * 3;
    const auto nodes = static_cast<std::size_t>(Hdf5Reader(file_).array<double>("springs/bodies").at(1));
    forge<double>("springs/bodies", 2 + nodes * numbers_of_node + 1, 1e6);
    EXPECT_THAT(refusal(), HasSubstr("springs between nodes that are not there"));
}

}  // namespace
}  // namespace dmp::tests::solver_forged_checkpoints_tests
