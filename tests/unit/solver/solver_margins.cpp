// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Margins of what sets the steps of a run, and warnings of small ones.
#include <gmock/gmock.h>

#include "solver/simulation.hpp"
#include "solver/time/margins.hpp"
#include "tests/modules.hpp"
#include "tests/unit/solver/small_scenes.hpp"

namespace dmp::tests::solver_margins_tests {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

Scene with_step_factor(double step_factor) {
    Scene scene;
    Part water;
    water.kind = PartKind::fluid;
    scene.parts = {water};
    scene.numerics.step_factor = {step_factor, {"scene.toml", 7, 9}};
    return scene;
}

Plan plan_of(const Scene& scene, std::vector<StepLimit> limits) {
    Plan plan;
    plan.limits = std::move(limits);
    add_margins(plan, scene);
    return plan;
}

TEST(Margins, ThatAreSmallAreWarnedOf) {
    const Plan plan = plan_of(with_step_factor(0.65), {{"sound", 1e-5, ""}});
    ASSERT_THAT(plan.margins, SizeIs(1));
    EXPECT_EQ(plan.margins[0].key, "numerics.step_factor");
    EXPECT_EQ(plan.margins[0].own, 0.65);
    EXPECT_EQ(plan.margins[0].stated, 0.7);
    EXPECT_NEAR(plan.margins[0].times, 0.7 / 0.65, 1e-12);
    ASSERT_THAT(plan.warnings, SizeIs(1));
    EXPECT_EQ(plan.warnings[0].text(),
              "scene.toml:7:9: numerics.step_factor is 0.65, within a factor of 1.2 of its stated limit, 0.7 (c0 dt / "
              "R = 0.7, measured): the run may diverge; give 0.583 or less, or leave it out");
    EXPECT_THAT(plan_of(with_step_factor(0.8), {{"sound", 1e-5, ""}}).warnings[0].problem,
                AllOf(HasSubstr("beyond its stated limit"), HasSubstr("expect the run to diverge")));
}

TEST(Margins, OfOrdinaryValuesAreNotWarnedOf) {
    EXPECT_THAT(plan_of(with_step_factor(0.583), {{"sound", 1e-5, ""}}).warnings, IsEmpty());
    Scene by_default = with_step_factor(0.65);
    by_default.numerics.step_factor = 0.65;  // without a place
    EXPECT_THAT(plan_of(by_default, {{"sound", 1e-5, ""}}).warnings, IsEmpty());
}

TEST(Margins, AreLargerWhereAnotherLimitAlwaysKeepsTheStepsShorter) {
    const Scene scene = with_step_factor(0.65);
    const Plan held = plan_of(scene, {{"sound", 1e-5, ""}, {"viscosity", 5e-6, ""}});
    EXPECT_NEAR(held.margins[0].times, 2 * 0.7 / 0.65, 1e-12);
    EXPECT_TRUE(held.margins[0].is_by_other);
    EXPECT_THAT(held.warnings, IsEmpty());
    const Plan at_times = plan_of(scene, {{"sound", 1e-5, ""}, {"body force", 5e-6, ""}, {"driving", 5e-6, ""}});
    EXPECT_FALSE(at_times.margins[0].is_by_other) << "the force may be less at another time";
    EXPECT_THAT(at_times.warnings, SizeIs(1));
    const Plan at_rest = plan_of(scene, {{"species", 1e-5, ""}});
    EXPECT_THAT(at_rest.margins, IsEmpty()) << "nothing moves: sound sets no step";
    ASSERT_THAT(at_rest.warnings, SizeIs(1));
    EXPECT_THAT(at_rest.warnings[0].text(), HasSubstr("numerics.step_factor has no effect: "));
}

TEST(Margins, OfAnExplicitModelAreToItsOwnLimit) {
    Scene scene = with_step_factor(0.5);
    scene.numerics.viscous_step_factor = {0.9, {"scene.toml", 8, 9}};
    const Plan ruled = plan_of(scene, {{"sound", 1e-5, ""}, {"viscosity", 5e-6, ""}});
    ASSERT_THAT(ruled.margins, SizeIs(2));
    EXPECT_EQ(ruled.margins[1].key, "numerics.viscous_step_factor");
    EXPECT_NEAR(ruled.margins[1].times, 1 / 0.9, 1e-12);
    ASSERT_THAT(ruled.warnings, SizeIs(1));
    EXPECT_EQ(ruled.warnings[0].key, "numerics.viscous_step_factor");
    EXPECT_THAT(plan_of(scene, {{"sound", 1e-6, ""}, {"viscosity", 5e-6, ""}}).warnings, IsEmpty());
}

TEST(Margins, AreInThePlanOfARun) {
    SceneAndParticles made = endless_water();
    made.scene.numerics.step_factor = {0.65, {"scene.toml", 7, 9}};
    const Plan plan = Simulation(made.scene, made.particles).plan();
    ASSERT_FALSE(plan.margins.empty());
    EXPECT_NEAR(plan.margins[0].times, 0.7 / 0.65, 1e-12);
    std::vector<std::string> keys;
    for (const Warning& warning : plan.warnings) keys.push_back(warning.key);
    EXPECT_THAT(keys, Contains("numerics.step_factor"));
}

}  // namespace
}  // namespace dmp::tests::solver_margins_tests
