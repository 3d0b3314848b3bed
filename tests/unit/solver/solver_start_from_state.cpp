// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Runs that start from the state of another run with other values.
#include <gmock/gmock.h>

#include "base/errors.hpp"
#include "clot_scenes.hpp"
#include "small_scenes.hpp"
#include "solver/state/checkpoints.hpp"
#include "sphere_scenes.hpp"
#include "tests/modules.hpp"
#include "tests/unit/temporary_files.hpp"
#include "tests/unit/thrown.hpp"

namespace dmp::tests::solver_start_from_state_tests {
namespace {

using testing::HasSubstr;

/// Runs to `until` and leaves a checkpoint in the folder.
std::filesystem::path checkpoint_of(const Scene& scene, const ParticleSet& set, double until,
                                    const std::filesystem::path& folder) {
    RunOptions options;
    options.until = until;
    options.checkpoints.folder = folder;
    options.checkpoints.every = 0;
    options.checkpoints.label.scene = "a scene";
    Simulation(scene, set, 1).run(options);
    return checkpoint_to_start_from(folder, {}, 2 * until).file;
}

/// From the file to the scene's end; with its frames.
RunSummary started(const Scene& scene, const ParticleSet& set, const std::filesystem::path& file, KeptFrames& kept,
                   int threads = 1) {
    Simulation simulation(scene, set, threads);
    simulation.start_from(file);
    RunOptions options;
    options.sink = &kept;
    return simulation.run(options);
}

SceneAndParticles sheared_water() {
    SceneAndParticles made = endless_water();
    made.scene.flow.initial_velocity.value[0] = Expression("0.1*sin(7.85*y)", "0.1*sin(7.85*y)");
    made.scene.output.fields = {FluidField::shear_stress};
    return made;
}

std::vector<float> shear_of(const Frame& frame) {
    for (const FrameGroup& group : frame.groups)
        for (const FrameField& field : group.fields)
            if (field.name == "shear_stress") return field.values;
    return {};
}

TEST(StartFromState, TheFluidHasItsNewViscosityFromTheFirstFrameOn) {
    SceneAndParticles made = sheared_water();
    const TemporaryFolder folder;
    const auto file = checkpoint_of(made.scene, made.particles, 0.1, folder.path());
    KeptFrames before, after;
    static_cast<void>(started(made.scene, made.particles, file, before));
    made.scene.parts[0].viscosity = 2.0;
    const RunSummary summary = started(made.scene, made.particles, file, after);
    const std::vector<float> thin = shear_of(before.frames.front()), thick = shear_of(after.frames.front());
    ASSERT_EQ(thin.size(), 64U);
    float largest = 0;
    for (std::size_t k = 0; k < thin.size(); ++k) {
        EXPECT_FLOAT_EQ(thick[k], 2 * thin[k]);
        largest = std::max(largest, thin[k]);
    }
    EXPECT_GT(largest, 0.01F);
    EXPECT_EQ(summary.simulated_s, 1.0);
    EXPECT_GT(after.frames.front().time, 0.05);
    EXPECT_LE(after.frames.front().time, 0.1);
    EXPECT_EQ(after.times().size(), 5U) << "that of the start, 0.25, 0.5, 0.75 and 1 s";
}

TEST(StartFromState, CountsFromItsOwnStart) {
    SceneAndParticles made = sheared_water();
    made.scene.flow.acceleration[0] = Expression("1", "1");
    const TemporaryFolder folder;
    const auto file = checkpoint_of(made.scene, made.particles, 0.5, folder.path());
    KeptFrames kept;
    const RunSummary summary = started(made.scene, made.particles, file, kept);
    const double lasted = 1 - kept.frames.front().time, mass = summary.start.mass;
    EXPECT_NEAR(summary.impulse_of_body_forces[0], mass * lasted, 1e-9 * mass);
    EXPECT_NEAR(summary.end.momentum[0] - summary.start.momentum[0], mass * lasted, 1e-9 * mass);
    EXPECT_LT(summary.momentum_residual, 1e-9);
    EXPECT_EQ(summary.measures.time.size(), summary.measures.rows.size());
}

TEST(StartFromState, NotUnderAnotherSpeedOfSound) {
    SceneAndParticles made = sheared_water();
    const TemporaryFolder folder;
    const auto file = checkpoint_of(made.scene, made.particles, 0.1, folder.path());
    made.scene.numerics.sound_speed = 99.0;
    Simulation simulation(made.scene, made.particles, 1);
    EXPECT_THAT(text_thrown<InputError>([&] { simulation.start_from(file); }),
                HasSubstr("99 would be chosen for it; under another one the state would mean something else"));
}

/// A sphere that nothing pushed until then.
TEST(StartFromState, SpheresMayBeDrivenInAnotherWay) {
    SphereScene made;
    const int part = made.part("ball", PartKind::spheres);
    made.sphere(part, Vec(0, 0, 0), 0.01, Vec(0.1, 0, 0));
    made.scene.output.every = 0.25;
    const TemporaryFolder folder;
    const auto file = checkpoint_of(made.scene, made.set, 0.5, folder.path());
    made.scene.flow.acceleration[2] = Expression("-2", "-2");
    made.force("ball", {"0", "0.5", "0"}, ForceAmount::per_particle);
    KeptFrames kept;
    const RunSummary summary = started(made.scene, made.set, file, kept, 2);
    const double from = kept.frames.front().time, lasted = 1 - from, mass = made.set.mass[0];
    EXPECT_GT(from, 0.2);
    EXPECT_NEAR(summary.start.momentum[0], 0.1 * mass, 1e-12 * mass);
    EXPECT_NEAR(summary.end.momentum[0], 0.1 * mass, 1e-12 * mass);
    EXPECT_NEAR(summary.end.momentum[1], 0.5 * lasted, 1e-9);
    EXPECT_NEAR(summary.end.momentum[2], -2 * mass * lasted, 1e-9 * mass);
    EXPECT_LT(summary.momentum_residual, 1e-9);
}

/// A clot that grows from the middle of a channel at rest, every 10 ms, by the nearest of a square lattice.
SceneAndParticles channel_with_a_clot(double duration) {
    SceneAndParticles made = blood_channel();
    made.scene.regions = {middle_of(made)};
    Solidify clot = clot_of("blood");
    clot.seed_region = std::string("nidus");
    made.scene.solidify = {clot};
    made.scene.run.duration = duration;
    return made;
}

TEST(StartFromState, LiquidMayTurnSolidInAnotherWay) {
    SceneAndParticles made = channel_with_a_clot(0.045);
    const TemporaryFolder folder;
    const auto file = checkpoint_of(made.scene, made.particles, 0.025, folder.path());  // after three events
    const auto size_after = [&](double probability) {
        made.scene.solidify[0].probability = probability;
        KeptFrames kept;
        return started(made.scene, made.particles, file, kept).particles.at("elastic");
    };
    EXPECT_EQ(size_after(1), 61U) << "as in a run that is not divided";
    EXPECT_EQ(size_after(0), 25U) << "what there was";
}

TEST(StartFromState, LiquidMayTurnSolidAgainAfterTheLastTimeOfTheState) {
    SceneAndParticles made = channel_with_a_clot(0.055);
    made.scene.solidify[0].until = 0.015;  // two events, at 0 and 0.01 s
    const TemporaryFolder folder;
    const auto file = checkpoint_of(made.scene, made.particles, 0.035, folder.path());
    KeptFrames kept;
    EXPECT_EQ(started(made.scene, made.particles, file, kept).particles.at("elastic"), 13U);
    made.scene.solidify[0].until = {};
    EXPECT_EQ(started(made.scene, made.particles, file, kept).particles.at("elastic"), 41U)
        << "with two more, at 0.04 and 0.05 s";
}

}  // namespace
}  // namespace dmp::tests::solver_start_from_state_tests
