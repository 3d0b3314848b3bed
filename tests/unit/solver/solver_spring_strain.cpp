// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// What a run says of the strains of its solids, and damping by mass.
#include <cmath>
#include <string>

#include <gmock/gmock.h>

#include "small_scenes.hpp"
#include "tests/modules.hpp"

namespace dmp::tests::solver_spring_strain_tests {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::Not;
using testing::Property;

/// A rod of two nodes of 10 kg in empty space, 0.1 m long, with a stiffness of 2 kN/m, pushed along itself.
SceneAndParticles rod(const std::string& acceleration) {
    SceneAndParticles made = endless_water();
    made.scene.parts.clear();
    ParticleSet empty;
    empty.spacing = made.particles.spacing;
    empty.box = made.particles.box;
    empty.periodic = made.particles.periodic;
    made.particles = empty;
    add_flags(made);
    add_rod(made, Vec(0.4, 0.4, 0), 0);
    made.scene.parts[0].bond_damping = 1.0;
    made.scene.flow.acceleration[1] = Expression(acceleration, acceleration);
    made.scene.run.duration = 4.0;
    made.scene.output.every = 1.0;
    return made;
}

SceneAndParticles hanging_rod(const std::string& acceleration) {
    SceneAndParticles made = rod(acceleration);
    made.particles.fixed[1] = 1;
    made.scene.parts[0].mass_damping = 30.0;  // more than critical: it does not swing
    return made;
}

const auto says_strained = Contains(Property(&Warning::text, HasSubstr("part.flags was strained by")));

TEST(SpringStrain, of_a_hanging_rod_is_its_load_over_its_stiffness) {
    const auto [scene, particles] = hanging_rod("-2");
    int warned = 0;
    RunOptions options;
    options.warn = [&](double, const Warning&) { ++warned; };
    const RunSummary summary = Simulation(scene, particles, 1).run(options);
    ASSERT_EQ(summary.strains.size(), 1U);
    EXPECT_EQ(summary.strains[0].name, "flags");
    EXPECT_NEAR(summary.strains[0].stretched, 10 * 2 / 2e3 / 0.1, 1e-4);
    EXPECT_NEAR(summary.strains[0].compressed, 0, 1e-12);
    EXPECT_EQ(warned, 0);
    EXPECT_THAT(summary.warnings, Not(says_strained));
}

TEST(SpringStrain, beyond_a_fifth_is_warned_of_once_and_at_the_end) {
    for (const std::string acceleration : {"-5", "5"}) {
        const auto [scene, particles] = hanging_rod(acceleration);
        int warned = 0;
        RunOptions options;
        options.warn = [&](double, const Warning& warning) {
            ++warned;
            EXPECT_THAT(warning.text(), HasSubstr("part.flags was strained by"));
        };
        const RunSummary summary = Simulation(scene, particles, 1).run(options);
        EXPECT_EQ(warned, 1) << acceleration;
        EXPECT_THAT(summary.warnings, says_strained) << acceleration;
    }
}

TEST(SpringStrain, of_solids_that_break_is_theirs_to_limit) {
    auto made = hanging_rod("-5");
    Breaking rule;
    rule.name = std::string("tears");
    rule.part = std::string("flags");
    rule.strain_above = 0.4;
    made.scene.breaking = {rule};
    const RunSummary summary = Simulation(made.scene, made.particles, 1).run({});
    EXPECT_GT(summary.strains.at(0).stretched, 0.2);
    EXPECT_THAT(summary.warnings, Not(says_strained));
}

TEST(MassDamping, lets_a_body_fall_at_the_speed_that_its_weight_gives_whatever_its_mass) {
    for (const double mass : {10.0, 0.1}) {
        auto made = rod("-1");
        made.scene.parts[0].mass_damping = 10.0;
        for (double& of_node : made.particles.mass) of_node = mass;
        made.scene.run.duration = 0.2;
        made.scene.numerics.step_factor = 0.01;  // weight and damping take turns within a step
        const RunSummary summary = Simulation(made.scene, made.particles, 1).run({});
        const double speed = summary.end.momentum[1] / summary.end.mass;
        EXPECT_NEAR(speed, -0.1 * (1 - std::exp(-10 * 0.2)), 2e-4) << mass;
        EXPECT_LT(summary.momentum_residual, 1e-12);
    }
}

}  // namespace
}  // namespace dmp::tests::solver_spring_strain_tests
