// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// How coarse the particles are for a flow.
#include <string>

#include <gmock/gmock.h>

#include "small_scenes.hpp"
#include "tests/modules.hpp"

namespace dmp::tests::solver_velocity_change_tests {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::Not;
using testing::Property;

RunSummary channel(const std::string& spacing, const std::vector<std::string>& more = {}) {
    std::vector<std::string> overrides{"particles.spacing=\"" + spacing + "\"", "geometry.parameters.length=\"4 mm\""};
    overrides.insert(overrides.end(), more.begin(), more.end());
    const auto [scene, particles] = case_of("verification/poiseuille", overrides);
    return Simulation(scene, particles, 1).run({});
}

const auto says_coarse = Contains(Property(&Warning::text, HasSubstr("particles.spacing is coarse for this flow")));

TEST(VelocityChange, of_poiseuille_flow_is_that_of_the_parabola) {
    // <gamma^2> = 16 U^2 / (3 H^2), <u^2> = 8 U^2 / 15: (10)^(1/2) / n; flow that starts has thinner layers.
    const RunSummary ten = channel("0.1 mm");
    ASSERT_TRUE(ten.velocity_change);
    EXPECT_NEAR(*ten.velocity_change, 0.316, 0.02);
    EXPECT_THAT(ten.warnings, Not(says_coarse));
    const RunSummary five = channel("0.2 mm");
    EXPECT_NEAR(*five.velocity_change, 0.6, 0.06);
    EXPECT_THAT(five.warnings, says_coarse) << "its flux is 3.9 % too large";
}

TEST(VelocityChange, is_not_known_of_the_plain_scheme_or_fluid_at_rest) {
    EXPECT_FALSE(channel("0.1 mm", {"numerics.scheme=plain", "run.duration=\"0.1 s\""}).velocity_change);
    auto made = endless_water("0");
    made.scene.run.duration = 1.0;
    EXPECT_FALSE(Simulation(made.scene, made.particles, 1).run({}).velocity_change);
}

TEST(VelocityChange, of_uniform_flow_is_none) {
    auto made = endless_water("0.5");
    made.scene.run.duration = 2.0;
    const RunSummary summary = Simulation(made.scene, made.particles, 1).run({});
    EXPECT_NEAR(summary.velocity_change.value_or(0), 0, 1e-9);
    EXPECT_THAT(summary.warnings, Not(says_coarse));
}

}  // namespace
}  // namespace dmp::tests::solver_velocity_change_tests
