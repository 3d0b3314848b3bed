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
#include "tests/unit/solver/sphere_scenes.hpp"
#include "tests/unit/solver/walled_water.hpp"
#include "tests/unit/temporary_files.hpp"
#include "tests/unit/thrown.hpp"

namespace dmp::tests::solver_forged_checkpoints_tests {
namespace {

using ::testing::HasSubstr;

/// A checkpoint of some scene.
class Forged : public ::testing::Test {
  protected:
    /// Runs it until its second frame.
    void save(const Scene& scene, const ParticleSet& set) {
        scene_ = scene;
        set_ = set;
        Simulation simulation(scene, set, Resources(1));
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
        replace(name, at, value, [&] { return Hdf5Reader(file_).array<T>(name); });
    }
    /// The same in place of a number.
    template <class T>
    void forge_number(const std::string& name, T value) const {
        replace(name, 0, value, [&] { return std::vector{Hdf5Reader(file_).number<T>(name)}; });
    }

    /// What resuming from it says.
    [[nodiscard]] std::string refusal() const {
        return text_thrown<InputError>([&] {
            Simulation simulation(scene_, set_, Resources(1));
            simulation.resume(file_);
        });
    }

    TemporaryFolder folder_;
    std::filesystem::path file_;
    Scene scene_;
    ParticleSet set_;

  private:
    template <class T>
    static std::string bytes_of_array(const std::vector<T>& values) {
        const auto bytes = std::as_bytes(std::span(values));
        return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
    }
    template <class T, class Read>
    void replace(const std::string& name, std::size_t at, T value, const Read& read) const {
        std::vector<T> values = read();
        const std::string before = bytes_of_array(values), whole = bytes_of(file_);
        values.at(at) = value;
        const std::string forged = bytes_of_array(values);
        // Other datasets may hold the same.
        for (std::size_t found = whole.find(before); found != std::string::npos;
             found = whole.find(before, found + 1)) {
            put_bytes(file_, std::string(whole).replace(found, before.size(), forged));
            seal(file_, checkpoint_kind, file_);
            if (bytes_of_array(read()) == forged) return;
        }
        FAIL() << name << " was not found in the file";
    }
};

/// A clot that grows in a channel, stopped with a checkpoint.
class ForgedCheckpoint : public Forged {
  protected:
    ForgedCheckpoint() {
        SceneAndParticles made = blood_channel();
        made.scene.regions = {middle_of(made)};
        Solidify clot = clot_of("blood");
        clot.seed_region = std::string("nidus");
        made.scene.solidify = {clot};
        made.scene.run.duration = 0.03;
        made.scene.output.every = 0.015;
        save(made.scene, made.particles);
    }
};

/// Spheres that touch each other and a floor.
class ForgedSpheres : public Forged {
  protected:
    ForgedSpheres() {
        SphereScene made = crowd(150, 4);
        made.scene.flow.acceleration[2] = Expression("-4000", "-4000");
        made.scene.output.every = 4e-4;
        save(made.scene, made.set);
    }
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

/// The numbers of a body: how many nodes, for each its id, whether it is held, of a wall, on planes of symmetry (3),
/// its origin, ...
TEST_F(ForgedCheckpoint, WithABodyOfNoSolid) {
    forge<double>("springs/bodies", 8, 77);
    EXPECT_THAT(refusal(), HasSubstr("a body of no solid of the scene"));
}

TEST_F(ForgedCheckpoint, WithSpringsBetweenNodesThatAreNotThere) {
    constexpr std::size_t numbers_of_node = 6 + 3 + 4 * 3 + 5;
    const auto nodes = static_cast<std::size_t>(Hdf5Reader(file_).array<double>("springs/bodies").at(1));
    forge<double>("springs/bodies", 2 + nodes * numbers_of_node + 1, 1e6);
    EXPECT_THAT(refusal(), HasSubstr("springs between nodes that are not there"));
}

TEST_F(ForgedCheckpoint, WithATimeThatNoRunHas) {
    for (const double time : {-1.0, 1e300, std::numeric_limits<double>::quiet_NaN()}) {
        forge_number<double>("time", time);
        EXPECT_THAT(refusal(), HasSubstr("a time before 0 or beyond any schedule")) << time;
    }
}

TEST_F(ForgedCheckpoint, WithFramesThatAreNotDue) {
    forge_number<std::int64_t>("frames_due", -5);
    EXPECT_THAT(refusal(), HasSubstr("frames or measures that are not due next"));
}

TEST_F(ForgedCheckpoint, WithFewerThanNoSteps) {
    forge_number<std::int64_t>("step", -7);
    EXPECT_THAT(refusal(), HasSubstr("fewer than no steps or frames"));
}

TEST_F(ForgedCheckpoint, WithASeedThatIsNoParticle) {
    forge<double>("solidify/clot/seeds", 0, 0.5);
    EXPECT_THAT(refusal(), HasSubstr("0.5 as a seed"));
    forge<double>("solidify/clot/seeds", 0, 1e300);
    EXPECT_THAT(refusal(), HasSubstr("1e+300 as a seed"));
}

TEST_F(ForgedSpheres, AreTakenUpUnforged) {
    ASSERT_GT(Hdf5Reader(file_).length("spheres/contacts"), 0U);
    ASSERT_GT(Hdf5Reader(file_).length("spheres/wall_contacts"), 0U);
    EXPECT_EQ(refusal(), "nothing was thrown");
}

TEST_F(ForgedSpheres, OfOtherSizes) {
    forge<double>("spheres/radius", 3, -1e-3);
    EXPECT_THAT(refusal(), HasSubstr("a radius of -0.001 m"));
    forge<double>("spheres/radius", 3, 1e3);
    EXPECT_THAT(refusal(), HasSubstr("spheres of other sizes than the run has"));
}

TEST_F(ForgedSpheres, BeyondAllNumbers) {
    forge<double>("spheres/velocity_1", 2, 1e300);
    EXPECT_THAT(refusal(), HasSubstr("a velocity of 1e+300 m/s"));
}

/// They are places in an array.
TEST_F(ForgedSpheres, WithContactsOfNoSphere) {
    for (const double id : {-1.0, 151.0, 1e15, 1e300, 0.5, std::numeric_limits<double>::infinity()}) {
        forge<double>("spheres/contacts", 0, id);
        EXPECT_THAT(refusal(), HasSubstr("the checkpoint holds what no run of dmp writes: ")) << id;
    }
}

TEST_F(ForgedSpheres, WithContactsOfNoWall) {
    forge<double>("spheres/wall_contacts", 1, 1);
    EXPECT_THAT(refusal(), HasSubstr("1 as a surface of a wall"));
    forge<double>("spheres/wall_contacts", 1, 0);
    forge<double>("spheres/wall_contacts", 2, -2);
    EXPECT_THAT(refusal(), HasSubstr("-2 as a part that is a wall"));
}

}  // namespace
}  // namespace dmp::tests::solver_forged_checkpoints_tests
