// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Dials of a scene, their ladders of values, and the search for a limit on them.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "study/limit_bisection.hpp"
#include "study/limit_dials.hpp"
#include "study/limit_study.hpp"
#include "study/points.hpp"
#include "study/read_study.hpp"
#include "study/written_study.hpp"
#include "tests/modules.hpp"
#include "tests/unit/scene/scene_text.hpp"

namespace dmp::tests::study_limits_tests {
namespace {

using study::Dial;
using study::DialSide;
using study::LimitFacts;
using study::LimitStudy;
using study::RungState;
using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsSupersetOf;
using testing::Not;

constexpr RungState unknown = RungState::unknown, clean = RungState::clean, bad = RungState::bad,
                    failed = RungState::failed;

TEST(Bracket, IsBetweenTheHighestCleanRungAndTheLowestBadOne) {
    const auto none = bracket_of({});
    EXPECT_EQ(none.clean, 0U);
    EXPECT_EQ(none.bad, 1U);
    EXPECT_TRUE(none.is_settled());
    const auto one = bracket_of({clean, unknown, clean, unknown, bad, unknown, bad});
    EXPECT_EQ(one.clean, 3U);
    EXPECT_EQ(one.bad, 5U);
    EXPECT_FALSE(one.is_settled());
    EXPECT_EQ(next_rung({clean, unknown, clean, unknown, bad}), 4U);
    const auto late = bracket_of({unknown, bad, clean});
    EXPECT_EQ(late.clean, 0U) << "what is clean beyond a bad rung does not count";
    EXPECT_EQ(late.bad, 2U);
}

/// The rungs that a search runs, in order, where those from `first_bad` on are bad.
std::vector<std::size_t> searched(std::size_t rungs, std::size_t first_bad) {
    std::vector<RungState> states(rungs, unknown);
    std::vector<std::size_t> order;
    while (const auto next = next_rung(states)) {
        EXPECT_EQ(states.at(*next - 1), unknown) << "no rung twice";
        order.push_back(*next);
        states[*next - 1] = *next >= first_bad ? bad : clean;
    }
    const auto bracket = bracket_of(states);
    EXPECT_EQ(bracket.bad, std::min(first_bad, rungs + 1));
    EXPECT_EQ(bracket.clean, bracket.bad - 1);
    return order;
}

TEST(Bisection, FindsEachLimitWithinTheRunsThatItAnnounces) {
    for (const std::size_t rungs : {0, 1, 2, 3, 7, 8, 17, 18})
        for (std::size_t first_bad = 1; first_bad <= rungs + 1; ++first_bad)
            EXPECT_LE(searched(rungs, first_bad).size(), most_runs_left(std::vector(rungs, unknown)))
                << first_bad << " of " << rungs;
    EXPECT_THAT(searched(18, 19), ElementsAre(9, 14, 16, 17, 18)) << "where none is bad, up to the last one";
    EXPECT_THAT(searched(18, 1), ElementsAre(9, 4, 2, 1));
    EXPECT_EQ(most_runs_left({}), 0U);
    EXPECT_EQ(most_runs_left({clean, bad, unknown}), 0U);
    EXPECT_EQ(most_runs_left({unknown, unknown, bad}), 2U);
}

TEST(Bisection, DoesNotGoOnWhereARungInBetweenFailed) {
    const std::vector<RungState> between{clean, unknown, failed, unknown, bad};
    EXPECT_EQ(failed_rung(between), 3U);
    EXPECT_FALSE(next_rung(between));
    EXPECT_EQ(bracket_of(between).bad, 5U) << "it is not bad";
    EXPECT_EQ(most_runs_left(between), 2U) << "it is run again";
    EXPECT_FALSE(failed_rung({failed, clean, unknown, bad, failed})) << "they do not matter";
    EXPECT_EQ(next_rung({failed, clean, unknown, bad, failed}), 3U);
}

/// Of good_scene: a step that sound rules, a little below that of the viscosity.
LimitFacts facts() {
    LimitFacts facts;
    facts.contact_strength = 1e-6;
    facts.dt = 1e-5;
    facts.step_limits = {{"sound", 1e-5}, {"viscosity", 4e-5}};
    return facts;
}

std::vector<Dial> dials_of(const std::string& scene, const LimitFacts& of = facts(),
                           const std::vector<std::string>& overrides = {}) {
    const Folder folder;
    Folder::write(scene);
    return limit_dials(read_scene("scene.toml", overrides), "scene.toml", overrides, of);
}

std::set<std::string> names_of(const std::vector<Dial>& dials) {
    std::set<std::string> names;
    for (const Dial& dial : dials) names.insert(dial.name);
    return names;
}

const Dial& dial(const std::vector<Dial>& dials, const std::string& name, DialSide side) {
    const auto found =
        std::ranges::find_if(dials, [&](const Dial& each) { return each.name == name && each.side == side; });
    if (found == dials.end()) throw std::logic_error("no dial " + name);
    return *found;
}

TEST(Dials, AreThoseOfTheModelsThatTheSceneUses) {
    EXPECT_THAT(names_of(dials_of(good_scene)),
                ElementsAre("contact.range", "contact.strength", "numerics.density_diffusion", "numerics.mach_number",
                            "numerics.shifting", "numerics.step_factor", "numerics.support", "part.blood.viscosity",
                            "part.leaflets.bending_stiffness", "part.leaflets.mass_per_length", "particles.spacing"));
    const auto subcycled = names_of(dials_of(good_scene, facts(), {"numerics.spring_stepping=subcycled"}));
    EXPECT_THAT(subcycled, Contains("numerics.spring_step_factor"));
    const auto given =
        names_of(dials_of(good_scene, facts(), {"numerics.sound_speed=\"3 m/s\"", "numerics.shifting=0"}));
    EXPECT_THAT(given, AllOf(Contains("numerics.sound_speed"), Not(Contains("numerics.mach_number")),
                             Not(Contains("numerics.shifting"))));
    const auto written = names_of(dials_of(good_scene, facts(), {"numerics.sound_speed=\"auto\""}));
    EXPECT_THAT(written, AllOf(Contains("numerics.mach_number"), Not(Contains("numerics.sound_speed"))));
    const std::string tracer = "\n[[species]]\nname = \"tracer\"\ndiffusivity = \"1e-9 m^2/s\"\n";
    LimitFacts at_rest = facts();
    at_rest.at_rest = true;
    const auto resting = names_of(dials_of(good_scene + tracer, at_rest));
    EXPECT_THAT(resting, AllOf(IsSupersetOf({"species.tracer.diffusivity", "numerics.support"}),
                               Not(Contains("numerics.step_factor")), Not(Contains("part.blood.viscosity"))));
}

TEST(Dials, OfAPartsStiffnessTurnAllThatItGives) {
    const auto dials = dials_of(good_scene);
    const Dial& up = dial(dials, "part.leaflets.bending_stiffness", DialSide::up);
    ASSERT_EQ(up.keys.size(), 2U);
    EXPECT_EQ(up.keys[1].key, "part.leaflets.axial_stiffness");
    EXPECT_THAT(up.rungs[3].toml, ElementsAre("\"6e-06 N*m^2\"", "\"200 N\""));
    EXPECT_TRUE(up.is_physical);
    EXPECT_EQ(dial(dials, "contact.strength", DialSide::up).keys[0].own_toml, "\"auto\"");
    EXPECT_THAT(dial(dials, "contact.strength", DialSide::down).rungs[3].toml, ElementsAre("\"5e-07 J\""));
}

TEST(Ladders, AreFineNearTheOwnValueAndReachFar) {
    const auto dials = dials_of(good_scene);
    const Dial& up = dial(dials, "particles.spacing", DialSide::up);
    ASSERT_EQ(up.rungs.size(), 18U);
    EXPECT_NEAR(up.rungs[0].factor, std::exp2(0.25), 1e-5);
    EXPECT_NEAR(up.rungs[8].factor / up.rungs[7].factor, std::sqrt(2), 1e-5);
    EXPECT_NEAR(up.rungs.back().factor, 1024, 1e-9);
    EXPECT_THAT(up.rungs[3].toml, ElementsAre("\"0.0002 m\""));
    EXPECT_EQ(up.end, "the end of the ladder");
    const Dial& down = dial(dials, "part.leaflets.mass_per_length", DialSide::down);
    EXPECT_NEAR(down.rungs[3].value, 0.21, 1e-12);
}

TEST(Ladders, EndAtTheBoundThatTheCheckHas) {
    const auto dials = dials_of(good_scene);
    const Dial& mach = dial(dials, "numerics.mach_number", DialSide::up);
    EXPECT_DOUBLE_EQ(mach.rungs.back().value, 0.3);
    EXPECT_THAT(mach.refused, HasSubstr("numerics.mach_number"));
    ASSERT_TRUE(mach.stated);
    EXPECT_DOUBLE_EQ(mach.stated->value, 0.3);
    EXPECT_EQ(mach.stated->formula, mach.refused);
    const Dial& support = dial(dials, "numerics.support", DialSide::down);
    EXPECT_NEAR(support.rungs.back().value, 2.8, 1e-5) << "of the corrected scheme";
    EXPECT_EQ(support.rungs.size(), 1U);
    const Dial& wide = dial(dials, "numerics.support", DialSide::up);
    EXPECT_TRUE(wide.rungs.empty());
    EXPECT_THAT(wide.refused, HasSubstr("wall"));
    ASSERT_TRUE(wide.stated);
    EXPECT_NEAR(wide.stated->value, 3, 1e-5) << "of a wall of three rows";
    const auto thick = dials_of(good_scene, facts(), {"part.wall.layers=6"});
    EXPECT_NEAR(dial(thick, "numerics.support", DialSide::up).rungs.back().value, 6, 1e-6);
}

TEST(Ladders, EndWhereAnotherLimitRulesTheStep) {
    LimitFacts near = facts();
    near.step_limits["viscosity"] = 1.3e-5;
    const auto dials = dials_of(good_scene, near);
    const Dial& step = dial(dials, "numerics.step_factor", DialSide::up);
    ASSERT_EQ(step.rungs.size(), 2U) << "1.19 is below 1.3, 1.41 is the first one beyond, and the next is no other";
    EXPECT_EQ(step.end, "beyond, the limit 'viscosity' rules the step");
    EXPECT_EQ(step.refused, "");
    ASSERT_TRUE(step.stated);
    EXPECT_EQ(step.stated->value, 0.6) << "c0 dt / R = 0.6 with elastic solids";
    EXPECT_NEAR(step.stated_margin(), 1.2, 1e-12);
    const auto subcycled = dials_of(good_scene, near, {"numerics.spring_stepping=subcycled"});
    EXPECT_EQ(dial(subcycled, "numerics.step_factor", DialSide::up).stated->value, 0.33);
    const auto plain = dials_of(good_scene, near, {"numerics.scheme=plain", "numerics.kernel=wendland_c2"});
    EXPECT_EQ(dial(plain, "numerics.step_factor", DialSide::up).stated->value, 0.878) << "by linear theory";
    const std::string liquid =
        good_scene.substr(0, good_scene.find("[[part]]\nname = \"leaflets\"")) +
        good_scene.substr(good_scene.find("[flow]"),
                          good_scene.find("\n[[measure]]\nname = \"tip") - good_scene.find("[flow]"));
    EXPECT_EQ(dial(dials_of(liquid, near), "numerics.step_factor", DialSide::up).stated->value, 0.7);
    EXPECT_THAT(dial(dials_of(good_scene), "numerics.step_factor", DialSide::up).refused, HasSubstr("step_factor"));
}

TEST(Dials, OfAModelsStepAreThoseOfTheLimitThatRules) {
    EXPECT_THAT(names_of(dials_of(good_scene)), Not(Contains("numerics.viscous_step_factor"))) << "sound rules";
    LimitFacts thick = facts();
    thick.dt = thick.step_limits["viscosity"] = 2.4e-6;
    const auto dials = dials_of(good_scene, thick);
    const Dial& viscous = dial(dials, "numerics.viscous_step_factor", DialSide::up);
    EXPECT_EQ(viscous.own(), 0.5);
    EXPECT_EQ(viscous.stated->value, 0.65) << "with solids";
    EXPECT_FALSE(viscous.is_physical);
    ASSERT_EQ(viscous.rungs.size(), 9U) << "4.2 times as long, sound rules: 2^(8/4) and 2^(8/4 + 1/2)";
    EXPECT_EQ(viscous.end, "beyond, the limit 'sound' rules the step");
    EXPECT_TRUE(dial(dials, "numerics.step_factor", DialSide::up).rungs.empty());
    EXPECT_THAT(names_of(dials), Not(Contains("numerics.contact_step_factor")));
}

TEST(Ladders, EndWhereStepsBecomeTwentyTimesShorter) {
    const auto dials = dials_of(good_scene);
    const Dial& viscosity = dial(dials, "part.blood.viscosity", DialSide::up);
    EXPECT_NEAR(viscosity.rungs.back().factor, 64, 1e-9) << "80 times: 4 times until viscosity rules, 20 times then";
    EXPECT_NEAR(viscosity.rungs.back().cost, 16, 1e-9);
    EXPECT_DOUBLE_EQ(viscosity.rungs.front().cost, 1);
    EXPECT_THAT(viscosity.end, HasSubstr("more than 20 times shorter, by 'viscosity'"));
    EXPECT_EQ(dial(dials, "part.blood.viscosity", DialSide::down).rungs.size(), 18U);
}

TEST(Ladders, DoNotEndByElasticSolidsThatAreSubcycledButTakeAsMuchLonger) {
    LimitFacts elastic = facts();
    elastic.subcycled = {"elastic (leaflets)"};
    const std::vector<std::string> subcycled{"numerics.spring_stepping=subcycled"};
    const auto dials = dials_of(good_scene, elastic, subcycled);
    const Dial& step = dial(dials, "numerics.step_factor", DialSide::up);
    const auto dials_without = dials_of(good_scene, facts(), subcycled);
    const Dial& without = dial(dials_without, "numerics.step_factor", DialSide::up);
    EXPECT_GT(step.rungs.size(), 1U);
    EXPECT_EQ(step.rungs.size(), without.rungs.size());
    EXPECT_EQ(step.end, without.end);
    EXPECT_DOUBLE_EQ(step.rungs[0].cost, 1) << "at most: the solids take as many steps in the same time";
    const Dial& stiff = dial(dials, "part.leaflets.bending_stiffness", DialSide::up);
    EXPECT_NEAR(stiff.rungs[7].factor, 4, 1e-5);
    EXPECT_NEAR(stiff.rungs[7].cost, 2, 1e-5);
    EXPECT_NEAR(stiff.rungs.back().factor, 256, 1e-3);
    EXPECT_EQ(stiff.end, "beyond, steps are more than 20 times shorter, by 'elastic (leaflets)'");
}

TEST(Ladders, OfDiffusivitiesByPartKeepTheirRatios) {
    const std::string tracer =
        "\n[[species]]\nname = \"tracer\"\ndiffusivity = { blood = \"1e-9 m^2/s\", leaflets = \"4e-9 m^2/s\" }\n";
    const auto dials = dials_of(good_scene + tracer);
    const Dial& up = dial(dials, "species.tracer.diffusivity", DialSide::up);
    EXPECT_DOUBLE_EQ(up.own(), 4e-9);
    EXPECT_THAT(up.rungs[3].toml, ElementsAre("{\"blood\" = \"2e-09 m^2/s\", \"leaflets\" = \"8e-09 m^2/s\"}"));
}

TEST(LimitStudies, HaveTheScenesOwnRunItsRepeatAndARunForEachRung) {
    const Folder folder;
    Folder::write(good_scene);
    const std::vector<std::string> overrides{"run.duration=\"0.5 s\"", "numerics.mach_number=0.12"};
    const Scene scene = read_scene("scene.toml", overrides);
    const LimitStudy limits(limit_dials(scene, "scene.toml", overrides, facts()), repeat_of(scene, facts()));
    std::filesystem::create_directories("out/limits");
    const Study read =
        study::parse_study(limits.text("scene.toml", "Test", overrides, "out/limits"), "out/limits/study.toml");
    const study::Points points(read);
    ASSERT_EQ(points.size(), limits.size());
    ASSERT_EQ(limits.costs().size(), limits.size());
    const auto values = [&](std::size_t run) { return study::overrides(read, points.at(run)); };
    const auto own = values(LimitStudy::own);
    EXPECT_THAT(own, IsSupersetOf({"numerics.mach_number=0.12", "particles.spacing=\"1e-04 m\"",
                                   "run.duration=\"0.5 s\"", "contact.strength=\"auto\""}));
    EXPECT_EQ(resolved_scene(read_scene("scene.toml", own)), resolved_scene(scene)) << "the scene's own";
    ASSERT_EQ(limits.repeat(), 1U);
    EXPECT_THAT(values(1), IsSupersetOf({"particles.spacing=\"0.0001005 m\"", "numerics.step_factor=0.485"}));
    for (std::size_t run = 2; run < limits.size(); ++run) {
        const auto place = limits.place_of(run);
        ASSERT_TRUE(place);
        EXPECT_EQ(limits.run_of(place->dial, place->rung), run);
        std::vector<std::string> turned = values(run);
        std::erase_if(turned, [&](const auto& each) { return std::ranges::find(own, each) != own.end(); });
        EXPECT_THAT(turned, testing::UnorderedElementsAreArray(limits.overrides(*place))) << run;
    }
    EXPECT_EQ(limits.run_of(3, 0), LimitStudy::own);
    EXPECT_FALSE(limits.place_of(LimitStudy::own) || limits.place_of(1));
}

TEST(ValuesSet, AreTheLastOnesOfTheirKeys) {
    const auto values = study::values_set({" a.b = 3 ", "run.threads=2", "c=text", "a.b=\"4 m\""});
    EXPECT_EQ(values, (std::map<std::string, std::string>{{"a.b", "\"4 m\""}, {"c", "\"text\""}}));
}

}  // namespace
}  // namespace dmp::tests::study_limits_tests
