// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Stated limits of the keys that set steps, and defaults that are lowered for a margin to them.
#include <algorithm>
#include <stdexcept>

#include <gmock/gmock.h>

#include "scene/step_margins.hpp"
#include "tests/modules.hpp"
#include "tests/unit/scene/scene_text.hpp"

namespace dmp::tests::scene_step_margins_tests {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

const std::string step_factor = "numerics.step_factor", subcycled = "numerics.spring_stepping=subcycled";

/// Of a key that sets steps in the scene.
StepMargin step_margin(const Scene& scene, const std::string& key) {
    const std::vector<StepMargin> margins = step_margins(scene);
    const auto found = std::ranges::find(margins, key, &StepMargin::key);
    if (found == margins.end()) throw std::out_of_range(key);
    return *found;
}

/// good_scene has leaflets.
StepMargin of_step_factor(const std::vector<std::string>& overrides) {
    return step_margin(read_text(good_scene, overrides), step_factor);
}

std::vector<std::string> keys_of(const Scene& scene) {
    std::vector<std::string> keys;
    for (const StepMargin& margin : step_margins(scene)) keys.push_back(margin.key);
    return keys;
}

TEST(StepMargins, AreToTheLimitsOfTheScheme) {
    EXPECT_EQ(of_step_factor({}).stated.value, 0.6);
    EXPECT_EQ(of_step_factor({subcycled}).stated.value, 0.33);
    EXPECT_EQ(of_step_factor({"part.leaflets.enabled=false"}).stated.value, 0.7);
    EXPECT_EQ(of_step_factor({"numerics.scheme=plain"}).stated.value, 0.878) << "of wendland_c2 in 2-D";
    EXPECT_EQ(of_step_factor({"numerics.scheme=plain", "quality=draft"}).stated.value, 1.001) << "of lucy";
    EXPECT_NEAR(of_step_factor({"numerics.step_factor=0.4"}).margin(), 1.5, 1e-12);
    EXPECT_FALSE(of_step_factor({}).is_small()) << "1.2, but for rounding";
    EXPECT_FALSE(of_step_factor({"numerics.step_factor=0.5"}).is_small());
    EXPECT_TRUE(of_step_factor({"numerics.step_factor=0.501"}).is_small());
    EXPECT_EQ(of_step_factor({"numerics.step_factor=0.9"}).too_large_text(),
              "numerics.step_factor = 0.9 is too large; its stated limit is 0.6");
    EXPECT_FALSE(of_step_factor({"numerics.step_factor=0.9"}).is_small(2)) << "another limit halves the steps";
}

TEST(StepMargins, AreOfTheKeysThatSetStepsInTheScene) {
    const std::vector<std::string> usual{step_factor, "numerics.viscous_step_factor", "numerics.contact_step_factor",
                                         "numerics.light_solid_step_factor", "numerics.density_diffusion_step_factor"};
    EXPECT_EQ(keys_of(read_text(good_scene)), usual);
    EXPECT_THAT(keys_of(read_text(good_scene, {subcycled})), Contains("numerics.spring_step_factor"));
    EXPECT_THAT(keys_of(read_text(good_scene, {"numerics.viscosity_stepping=implicit", "contact.range=0"})),
                ElementsAre(step_factor, "numerics.light_solid_step_factor", "numerics.density_diffusion_step_factor"));
    EXPECT_THAT(keys_of(read_text(good_scene, {"part.leaflets.enabled=false"})),
                Contains("numerics.contact_step_factor"))
        << "walls repel, too";
}

TEST(StepMargins, OfExplicitViscosityDependOnSolids) {
    const auto of = [](const Scene& scene) { return step_margin(scene, "numerics.viscous_step_factor").stated.value; };
    Scene scene = read_text(good_scene);
    EXPECT_EQ(of(scene), 0.65);
    std::erase_if(scene.parts, [](const Part& part) { return *part.kind != PartKind::fluid; });
    EXPECT_EQ(of(scene), 1);
}

TEST(StepMargins, OfALeastValueGrowWithIt) {
    const StepMargin steps{"numerics.steps_per_contact", "", 5.5, {5, ""}, true};
    EXPECT_NEAR(steps.margin(), 1.1, 1e-12);
    EXPECT_TRUE(steps.is_small());
    EXPECT_NEAR(steps.with_least_margin(), 6, 1e-12);
}

TEST(StepMargins, OfAllDefaultsAreLargeEnough) {
    for (const std::string quality : {"draft", "standard", "fine"})
        for (const std::string scheme : {"corrected", "plain"})
            for (const StepMargin& margin :
                 step_margins(read_text(good_scene, {"quality=" + quality, "numerics.scheme=" + scheme, subcycled})))
                EXPECT_FALSE(margin.is_small()) << margin.key << ' ' << quality << ' ' << scheme;
}

TEST(StepKeys, AreNotWrittenWhereTheyAreNotGiven) {
    const Scene usual = read_text(good_scene);
    EXPECT_EQ(*usual.numerics.viscous_step_factor, 0.5);
    EXPECT_FALSE(usual.numerics.viscous_step_factor.given());
    EXPECT_THAT(resolved_scene(usual), Not(HasSubstr("viscous_step_factor")));
    const Scene given = read_text(good_scene, {"numerics.viscous_step_factor=0.5"});
    EXPECT_THAT(resolved_scene(given), HasSubstr("\nviscous_step_factor = 0.5\n"));
    EXPECT_EQ(resolved_scene(read_text(resolved_scene(given))), resolved_scene(given));
    EXPECT_THAT(explain_key("numerics.light_solid_step_factor"), HasSubstr("default: 0.4"));
    EXPECT_THROW(read_text(good_scene, {"numerics.species_step_factor=0"}), InputError);
}

TEST(StepKeys, OfModelsThatTheSceneHasNotAreIdle) {
    const Scene scene = read_text(good_scene, {"numerics.viscosity_stepping=implicit",
                                               "numerics.viscous_step_factor=0.4", "numerics.contact_step_factor=0.4"});
    const auto idle = idle_step_keys(scene);
    ASSERT_EQ(idle.size(), 1U);
    EXPECT_EQ(idle[0].key, "numerics.viscous_step_factor");
    EXPECT_EQ(idle[0].location.text(), "--set numerics.viscous_step_factor=0.4");
    EXPECT_EQ(idle[0].reason, "no viscosity is stepped explicitly");
}

TEST(LoweredDefaults, KeepTheirMargin) {
    const Scene scene = read_text(good_scene, {subcycled});
    EXPECT_DOUBLE_EQ(*scene.numerics.step_factor, 0.275);
    EXPECT_FALSE(scene.numerics.step_factor.given());
    EXPECT_FALSE(step_margin(scene, step_factor).is_small());
    EXPECT_EQ(default_origin(scene, step_factor),
              "default, lowered from 0.5 to 1 / 1.2 of its stated limit, c0 dt / R = 0.33, measured, with sub-cycled "
              "elastic solids");
    EXPECT_EQ(default_origin(scene, "numerics.spring_step_factor"), "default");
    const std::string resolved = resolved_scene(scene);
    EXPECT_THAT(resolved, HasSubstr("\nstep_factor = 0.275\n"));
    EXPECT_EQ(resolved_scene(read_text(resolved)), resolved);
    EXPECT_FALSE(step_margin(read_text(resolved), step_factor).is_small()) << "as it is given there";
    EXPECT_THAT(explain_key(step_factor), HasSubstr("0.275")) << "as it says";
}

TEST(LoweredDefaults, AreTheOnlyOnesThatChange) {
    EXPECT_EQ(*read_text(good_scene).numerics.step_factor, 0.5);
    EXPECT_EQ(default_origin(read_text(good_scene), step_factor), "default");
    const Scene given = read_text(good_scene, {subcycled, "numerics.step_factor=0.5"});
    EXPECT_EQ(*given.numerics.step_factor, 0.5) << "what is given is kept";
    EXPECT_EQ(lowered_text(given, step_factor), "");
    for (const std::string quality : {"draft", "standard", "fine"})
        for (const std::string stepping : {"implicit", "subcycled"}) {
            const Scene plain = read_text(
                good_scene, {"numerics.scheme=plain", "quality=" + quality, "numerics.spring_stepping=" + stepping});
            EXPECT_EQ(lowered_text(plain, step_factor), "") << quality << ' ' << stepping;
        }
}

}  // namespace
}  // namespace dmp::tests::scene_step_margins_tests
