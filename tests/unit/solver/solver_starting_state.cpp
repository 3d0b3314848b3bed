// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <gmock/gmock.h>

#include "base/errors.hpp"
#include "small_scenes.hpp"
#include "solver/run/setup.hpp"
#include "solver/run/starting_state.hpp"
#include "tests/modules.hpp"

namespace dmp::tests::solver_starting_state_tests {
namespace {

using testing::HasSubstr;

Expression formula(const std::string& text) { return {text, text}; }

SceneAndParticles water_with(const std::string& velocity_x, const std::string& velocity_y,
                             const std::string& pressure) {
    SceneAndParticles made = endless_water();
    made.scene.flow.initial_velocity.value = {formula(velocity_x), formula(velocity_y), Expression()};
    made.scene.flow.initial_velocity.location = {"scene.toml", 20, 3};
    made.scene.flow.initial_pressure = {formula(pressure), {"scene.toml", 21, 3}};
    return made;
}

Frame first_frame(const SceneAndParticles& made) {
    KeptFrames kept;
    RunOptions options;
    options.sink = &kept;
    options.until = 1e-6;
    Simulation(made.scene, made.particles, 1).run(options);
    return kept.frames.front();
}

std::string fault_of(const SceneAndParticles& made) {
    try {
        const Simulation simulation(made.scene, made.particles, 1);
    } catch (const InputError& error) {
        return error.what();
    }
    return "no error";
}

TEST(StartingState, HoldsAtEachParticle) {
    const SceneAndParticles made = water_with("0.5 * x", "0.25 - y", "1000 * x + 10 * y");
    const Frame frame = first_frame(made);
    const FrameGroup& fluid = *group_of(frame, "fluid");
    const LiquidState state = equations_of_state(made.scene, made.particles).front();
    for (std::size_t k = 0; k < fluid.size(); ++k) {
        const double x = fluid.position[3 * k], y = fluid.position[3 * k + 1], pressure = 1000 * x + 10 * y;
        EXPECT_NEAR(field_of(fluid, "velocity")->values[3 * k], 0.5 * x, 1e-6);
        EXPECT_NEAR(field_of(fluid, "velocity")->values[3 * k + 1], 0.25 - y, 1e-6);
        EXPECT_NEAR(field_of(fluid, "pressure")->values[k], pressure, 0.01) << "32 bit of the frame";
        EXPECT_NEAR(state.pressure(state.density(pressure)), pressure, 1e-6);
        EXPECT_NEAR(field_of(fluid, "density")->values[k], 1000 + pressure / 100, 0.3) << "c0 = 10 m/s";
    }
}

TEST(StartingState, KeepsVolumesAndMakesMassesFitTheDensity) {
    const SceneAndParticles made = water_with("0", "0", "5000 * x");
    const auto states = equations_of_state(made.scene, made.particles);
    const ParticleStore particles = starting_particles(made.scene, made.particles, states, Ranks::alone());
    const ParticleGroup& fluid = particles.fluid();
    for (std::size_t i = 0; i < fluid.owned(); ++i) {
        EXPECT_EQ(fluid.data(Field::volume)[i], 0.01);
        EXPECT_DOUBLE_EQ(fluid.data(Field::mass)[i],
                         0.01 * states.front().density(5000 * made.particles.position[i][0]));
    }
}

TEST(StartingState, OfRestIsTheOldStart) {
    const SceneAndParticles made = endless_water();
    EXPECT_FALSE(has_starting_state(made.scene));
    const ParticleStore particles =
        starting_particles(made.scene, made.particles, equations_of_state(made.scene, made.particles), Ranks::alone());
    for (std::size_t i = 0; i < particles.fluid().owned(); ++i) {
        EXPECT_EQ(particles.fluid().data(Field::mass)[i], 10);
        EXPECT_EQ(particles.fluid().data(Field::velocity, 0)[i], 0);
    }
}

TEST(StartingState, RefusesWhatIsNoState) {
    EXPECT_THAT(fault_of(water_with("sqrt(x - 1)", "0", "0")),
                HasSubstr("scene.toml:20:3: the speed of flow.initial_velocity is"));
    EXPECT_THAT(
        fault_of(water_with("0", "40 * y", "0")),
        HasSubstr("scene.toml:20:3: the speed of flow.initial_velocity is 10 m/s at x = 0.05, y = 0.25, z = 0 m; "
                  "the fluid's sound travels at 10 m/s\n  correct the formula, or choose a higher "
                  "numerics.sound_speed"));
    EXPECT_THAT(fault_of(water_with("0", "0", "-40000 * y")),
                HasSubstr("scene.toml:21:3: flow.initial_pressure is -18000 Pa at x = 0.05, y = 0.45, z = 0 m; the "
                          "equation of state knows pressures above -14285.7 Pa"));
    EXPECT_THAT(fault_of(water_with("0", "0", "log(x - 1)")), HasSubstr("flow.initial_pressure is "));
    EXPECT_EQ(fault_of(water_with("9 * x", "0", "10")), "no error");
}

TEST(StartingState, IsPartOfThePlan) {
    const SceneAndParticles made = water_with("0.5", "0", "0");
    const Plan plan = Simulation(made.scene, made.particles, 1).plan();
    const auto found = std::find_if(plan.models.begin(), plan.models.end(),
                                    [](const ModelUse& use) { return use.model == "starting state"; });
    ASSERT_NE(found, plan.models.end());
    EXPECT_EQ(found->reason, "flow.initial_velocity at scene.toml:20:3");
}

/// Uniform motion is carried on unchanged, and fast fluid is found by the neighbour search from the first step on.
TEST(StartingState, UniformMotionGoesOn) {
    SceneAndParticles made = water_with("0.8", "-0.3", "0");
    made.scene.output.every = 0.5;
    KeptFrames kept;
    RunOptions options;
    options.sink = &kept;
    const RunSummary summary = Simulation(made.scene, made.particles, 1).run(options);
    for (const Frame& frame : kept.frames) {
        const FrameGroup& fluid = *group_of(frame, "fluid");
        for (std::size_t k = 0; k < fluid.size(); ++k) {
            EXPECT_FLOAT_EQ(field_of(fluid, "velocity")->values[3 * k], 0.8F);
            EXPECT_FLOAT_EQ(field_of(fluid, "velocity")->values[3 * k + 1], -0.3F);
        }
    }
    EXPECT_NEAR(summary.start.momentum[0], 640 * 0.8, 1e-9);
    EXPECT_NEAR(summary.end.momentum[0], 640 * 0.8, 1e-9);
}

TEST(TaylorGreen, StartsWithItsEnergyAndLosesItAtFirstAsTheory) {
    const auto [scene, particles] =
        case_of("verification/taylor_green", {"particles.spacing=0.04 m", "output.measure_every=0.02 s"});
    RunOptions options;
    options.until = 0.02;
    const RunSummary summary = Simulation(scene, particles, 1).run(options);
    const auto& rows = summary.measures.rows;
    ASSERT_EQ(rows.size(), 2U);
    EXPECT_NEAR(rows[0][0], 0.25, 0.001);  // masses follow the pressure, some 0.5 %
    EXPECT_NEAR(rows[1][0] / rows[0][0], std::exp(-16 * 9.8696 / 100 * 0.02), 0.002);
    EXPECT_NEAR(summary.end.momentum[0], 0, 1e-12);
    EXPECT_NEAR(summary.end.momentum[1], 0, 1e-12);
}

}  // namespace
}  // namespace dmp::tests::solver_starting_state_tests
