// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <string>
#include <vector>

#include <gmock/gmock.h>

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
    s.contact_limit = 1e-3;
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

TEST(StepLimits, strong_density_diffusion_needs_shorter_steps) {
    StepScales strong = scales();
    strong.density_diffusion = 1;
    EXPECT_NEAR(limit_of("density diffusion", fluid_step_limits(strong, 0.5, 10)), 0.12 * 3e-4 / 2.5, 1e-18);
    strong.density_diffusion = 0.1;
    EXPECT_EQ(limit_of("density diffusion", fluid_step_limits(strong, 0.5, 10)), -1) << "far from ruling";
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
