// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "small_scenes.hpp"
#include "solver/forcing/drive_time.hpp"
#include "solver/time/step_limits.hpp"
#include "tests/modules.hpp"

namespace dmp::tests::solver_step_limits_tests {
namespace {

using testing::ElementsAre;

std::vector<std::string> models(const std::vector<StepLimit>& limits) {
    std::vector<std::string> names;
    names.reserve(limits.size());
    for (const StepLimit& limit : limits) names.push_back(limit.model);
    return names;
}

double limit_of(const std::string& model, const std::vector<StepLimit>& limits) {
    for (const StepLimit& limit : limits)
        if (limit.model == model) return limit.dt;
    return -1;
}

StepScales scales() {
    StepScales s;
    s.support = 3e-4;
    s.sound_speed = 2;
    s.kinematic_viscosity = 1e-6;
    s.viscous_limit = 0.07;
    s.step_factor = 0.3;
    s.shifting = 4;
    s.contact_limit = 2e-3;
    return s;
}

TEST(StepLimits, by_their_formulas) {
    const auto limits = fluid_step_limits(scales(), 0.5, 10);
    EXPECT_THAT(models(limits), ElementsAre("sound", "viscosity", "body force", "shifting", "contact"));
    EXPECT_NEAR(limit_of("sound", limits), 0.3 * 3e-4 / 2.5, 1e-18);
    EXPECT_NEAR(limit_of("viscosity", limits), 0.5 * 0.07 * 9e-8 / 1e-6, 1e-15);
    EXPECT_NEAR(limit_of("body force", limits), 0.25 * std::sqrt(1.5e-4 / 10), 1e-15);
    EXPECT_NEAR(limit_of("shifting", limits), 1.2 * 3e-4 / (4 * 2), 1e-15);
    EXPECT_EQ(limit_of("contact", limits), 1e-3);
    for (const StepLimit& limit : limits) EXPECT_FALSE(limit.formula.empty()) << limit.model;
}

TEST(StepLimits, are_parts_of_what_is_stable) {
    StepScales s = scales();
    s.diffusivity = 1e-7;
    s.diffusion_limit = 0.08;
    s.lightest_solid = 0.25;
    s.elastic_solids = true;
    s.density_diffusion = 1;
    const auto usual = fluid_step_limits(s, 0.5, 0);
    s.factors = {
        .viscous = 1, .species = 0.25, .contact = 0.75, .light_solid = 0.6, .density_diffusion = 0.15, .shifting = 2.4};
    const auto changed = fluid_step_limits(s, 0.5, 0);
    const auto ratio = [&](const std::string& model) { return limit_of(model, changed) / limit_of(model, usual); };
    EXPECT_NEAR(ratio("viscosity"), 2, 1e-12);
    EXPECT_NEAR(ratio("viscosity at elastic solids"), 2, 1e-12);
    EXPECT_NEAR(ratio("species"), 0.5, 1e-12);
    EXPECT_NEAR(ratio("contact"), 1.5, 1e-12);
    EXPECT_NEAR(ratio("light solids"), 1.5, 1e-12);
    EXPECT_NEAR(ratio("density diffusion"), 1.25, 1e-12);
    EXPECT_NEAR(ratio("shifting"), 2, 1e-12);
    EXPECT_EQ(ratio("sound"), 1);
    s.factors.density_diffusion = 0.4;
    EXPECT_EQ(limit_of("density diffusion", fluid_step_limits(s, 0.5, 0)), -1) << "sound rules";
}

TEST(StepLimits, between_liquids_of_unlike_density_sound_needs_shorter_steps) {
    StepScales two = scales();
    two.density_ratio = 7;
    EXPECT_NEAR(limit_of("sound", fluid_step_limits(two, 0.5, 10)), 0.3 * 3e-4 / 2.5 / 2, 1e-18);
}

TEST(StepLimits, strong_density_diffusion_needs_shorter_steps) {
    StepScales strong = scales();
    strong.density_diffusion = 1;
    EXPECT_NEAR(limit_of("density diffusion", fluid_step_limits(strong, 0.5, 10)), 0.12 * 3e-4 / 2.5, 1e-18);
    strong.density_diffusion = 0.1;
    EXPECT_EQ(limit_of("density diffusion", fluid_step_limits(strong, 0.5, 10)), -1) << "far from ruling";
}

/// Of water that is driven along x.
double time_of(const std::string& formula) {
    const auto made = endless_water(formula);
    return drive_time(made.scene, made.particles);
}

TEST(DriveTime, is_a_part_of_the_shortest_period) {
    EXPECT_NEAR(time_of("3 * sin(2 * 3.14159265 * t / 0.01)"), 0.45 * 0.01, 0.05 * 0.01);
    EXPECT_NEAR(time_of("2 + sin(2 * 3.14159265 * t / 0.00001) * (1 + x)"), 0.45e-5, 0.05e-5)
        << "shorter than a sample";
    EXPECT_NEAR(time_of("5 * t"), 1, 0.01) << "a ramp takes the run";
    const double pulses = time_of("max(0, sin(2 * 3.14159265 * t / 0.01))");
    EXPECT_NEAR(pulses, 0.225 * 0.01, 0.03 * 0.01);
    EXPECT_NEAR(time_of("t < 0.5 ? sqrt(-1) : sin(2 * 3.14159265 * t / 0.01)"), 0.45 * 0.01, 0.05 * 0.01);
}

TEST(DriveTime, is_infinite_for_what_is_constant_or_jumps) {
    EXPECT_TRUE(std::isinf(time_of("9.81")));
    EXPECT_TRUE(std::isinf(time_of("9.81 * x")));
    EXPECT_TRUE(std::isinf(time_of("t < 0.3 ? 1 : 2")));
}

TEST(StepLimits, a_fast_drive_is_followed) {
    StepScales fast = scales();
    fast.drive_time = 1e-5;
    EXPECT_NEAR(limit_of("drive", fluid_step_limits(fast, 0.5, 10)), 1e-6, 1e-18);
    fast.drive_time = 1;
    EXPECT_EQ(limit_of("drive", fluid_step_limits(fast, 0.5, 10)), -1) << "it does not rule";
}

TEST(Drives, with_a_period_of_one_step_push_no_fluid) {
    // Sampled once a period, in the middle of the steps, it would be a constant drive.
    auto made = endless_water("0");
    made.scene.run.duration = 0.1;
    const double step = Simulation(made.scene, made.particles, 1).plan().dt;
    const std::string formula = "10 * sin(2 * 3.14159265358979 * t / " + std::to_string(step) + ")";
    made.scene.flow.acceleration[0] = Expression(formula, formula);
    const RunSummary summary = Simulation(made.scene, made.particles, 1).run({});
    // Speed of the swing: 10 / omega about its mean of 10 / omega.
    const double swing = 10 * step / (2 * 3.14159265358979);
    EXPECT_LT(summary.largest_speed, 2.1 * swing);
}

TEST(StepLimits, what_is_not_there_sets_no_limit) {
    StepScales s = scales();
    s.kinematic_viscosity = 0;
    s.contact_limit = 0;
    s.shifting = 0;
    EXPECT_THAT(models(fluid_step_limits(s, 0.5, 0)), ElementsAre("sound"));
}

TEST(StepLimits, the_shortest_rules) {
    EXPECT_EQ(ruling_limit(fluid_step_limits(scales(), 0.5, 10)).model, "sound");
    StepScales thick = scales();
    thick.kinematic_viscosity = 1;
    EXPECT_EQ(ruling_limit(fluid_step_limits(thick, 0.5, 10)).model, "viscosity");
    EXPECT_EQ(ruling_limit(fluid_step_limits(scales(), 0.5, 1e9)).model, "body force");
}

}  // namespace
}  // namespace dmp::tests::solver_step_limits_tests
