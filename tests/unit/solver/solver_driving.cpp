// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Whole runs that are driven by forces on parts and moving shapes, against closed forms.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>
#include <unistd.h>

#include "tests/modules.hpp"
#include "tests/unit/solver/driven_scenes.hpp"
#include "tests/unit/solver/small_scenes.hpp"
#include "tests/unit/solver/walled_water.hpp"

namespace dmp::tests::solver_driving_tests {
namespace {

RunSummary run(const SceneAndParticles& made, int threads = 1) {
    Resources resources(threads);
    return Simulation(made.scene, made.particles, resources).run({});
}

TEST(ForceOnPart, moves_a_fluid_as_newton_says_in_total_and_per_particle) {
    SceneAndParticles made = endless_water();  // 64 particles of 10 kg
    made.scene.forces = {force_on("water", "64", "-32", ForceAmount::total)};
    const RunSummary total = run(made);
    EXPECT_NEAR(total.end.momentum[0], 64, 64e-12);
    EXPECT_NEAR(total.end.momentum[1], -32, 64e-12);
    EXPECT_NEAR(total.impulse_of_body_forces[0], 64, 64e-12);
    EXPECT_LT(total.momentum_residual, 1e-12);
    made.scene.forces = {force_on("water", "1", "-0.5", ForceAmount::per_particle)};
    EXPECT_EQ(run(made).state_hash, total.state_hash) << "64 N on 64 particles are 1 N on each";
    EXPECT_EQ(run(made, 3).state_hash, total.state_hash) << "on any number of threads";
    made.scene.forces = {force_on("water", "1 * cos(0 * x)", "-0.5", ForceAmount::per_particle)};
    const RunSummary by_position = run(made);
    EXPECT_NEAR(by_position.end.momentum[0], 64, 64e-12);
    EXPECT_LT(by_position.momentum_residual, 1e-12);
}

TEST(ForceOnPart, of_time_gives_its_integral) {
    SceneAndParticles made = endless_water();
    made.scene.forces = {force_on("water", "64 * t", "0", ForceAmount::total)};
    EXPECT_NEAR(run(made).end.momentum[0], 32, 32e-12) << "the middle of each step is exact for a ramp";
}

TEST(ForceOnPart, acts_while_its_schedule_lasts) {
    SceneAndParticles made = endless_water();
    ForceOnPart first = force_on("water", "64", "0", ForceAmount::total),
                then = force_on("water", "0", "64", ForceAmount::total);
    first.from = 0.1;
    first.until = 0.23;
    first.period = 0.4;  // on from 0.1, 0.5 and 0.9 on: 0.13 + 0.13 + 0.1 s
    then.from = 0.23;
    then.until = 0.57;
    made.scene.forces = {first, then};
    const RunSummary summary = run(made);
    EXPECT_NEAR(summary.end.momentum[0], 64 * 0.36, 64e-12);
    EXPECT_NEAR(summary.end.momentum[1], 64 * 0.34, 64e-12);
    EXPECT_LT(summary.momentum_residual, 1e-12);
}

/// Two rods of two nodes of 10 kg, and nothing else.
SceneAndParticles two_rods() {
    SceneAndParticles made = endless_water();
    made.particles = ParticleSet{};
    made.particles.spacing = 0.1;
    made.particles.box = {Vec::Zero(), Vec(0.8, 0.8, 0)};
    made.scene.parts.clear();
    made.scene.flow.periodic = {};
    add_flags(made);
    add_rod(made, Vec(0.4, 0.4, 0), 0);
    add_rod(made, Vec(0.6, 0.4, 0), 1);
    return made;
}

TEST(ForceOnPart, accelerates_free_leaflets) {
    SceneAndParticles made = two_rods();
    made.scene.forces = {force_on("flags", "8", "-4", ForceAmount::total)};  // on 4 nodes of 10 kg
    const RunSummary summary = run(made);
    EXPECT_NEAR(summary.end.momentum[0], 8, 8e-12);
    EXPECT_NEAR(summary.end.momentum[1], -4, 8e-12);
    EXPECT_LT(summary.momentum_residual, 1e-12);
    // A clamped node hands its share to what holds it.
    made.particles.fixed[0] = 1;
    const RunSummary held = run(made);
    EXPECT_NEAR(held.impulse_of_body_forces[0], 8, 8e-12);
    EXPECT_LT(held.momentum_residual, 1e-12);
    EXPECT_LT(held.impulse_of_fixed[0], -1.9);
}

TEST(ForceOnPart, limits_the_step_by_its_acceleration) {
    SceneAndParticles made = endless_water();
    made.scene.forces = {force_on("water", "1e6", "0", ForceAmount::per_particle)};
    const Plan plan = Simulation(made.scene, made.particles).plan();
    EXPECT_EQ(plan.ruling_limit, "driving");
    EXPECT_NEAR(plan.dt, 0.25 * std::sqrt(0.5 * 0.3 / 1e5), 1e-12);
    const auto is_named = [](const ModelUse& use) { return use.model == "force on 'water'"; };
    EXPECT_TRUE(std::ranges::any_of(plan.models, is_named));
}

TEST(MovingShape, gives_its_impulse_to_the_account_of_a_run) {
    SceneAndParticles made = two_rods();
    MovingShape shape = bead_in_a_parabola().scene.moving_shapes[0];
    shape.parts = std::vector<std::string>{"flags"};
    shape.kind = ShapeKind::circle;
    shape.position = std::array{formula_of("0.2 + 0.1 * t"), formula_of("0.45"), Expression()};
    shape.radius = 0.15;
    shape.strength = 5.0;
    shape.side = PushedSide::outside;
    made.scene.moving_shapes = {shape};
    const RunSummary summary = run(made);
    EXPECT_GT(summary.impulse_of_body_forces[0], 0.1);
    EXPECT_LT(summary.momentum_residual, 1e-12);
    EXPECT_NEAR(summary.end.momentum[0], summary.impulse_of_body_forces[0], 1e-11);
}

TEST(Driving, goes_on_from_a_checkpoint_with_the_same_bits) {
    WalledWater made(8, 6, {"box"}, [](int, int) { return 1; });
    ForceOnPart force = force_on("water", "100 * sin(8 * t) * y", "0", ForceAmount::total);
    force.from = 0.15;
    force.until = 0.35;
    made.scene.forces = {force, force_on("water", "0", "20", ForceAmount::total)};
    made.scene.run.duration = 0.4;
    made.scene.output.every = 0.2;
    const auto folder = std::filesystem::temp_directory_path() / ("dmp_driving_" + std::to_string(::getpid()));
    KeptFrames kept;
    EXPECT_EQ(run_in_two_parts(made, folder).state_hash, run_of(made, &kept).state_hash);
    std::filesystem::remove_all(folder);
}

TEST(Driving, is_nothing_where_nobody_asks_for_it) {
    const SceneAndParticles made = endless_water();
    const Driving driving(made.scene, made.particles, made.particles);
    EXPECT_TRUE(driving.empty());
    EXPECT_EQ(driving.next_change(0), std::numeric_limits<double>::infinity());
    for (const StepLimit& limit : Simulation(made.scene, made.particles).plan().limits)
        EXPECT_NE(limit.model, "driving");
}

}  // namespace
}  // namespace dmp::tests::solver_driving_tests
