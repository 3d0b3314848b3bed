// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Time steps of spheres that are set by hand, and what a run says of its energy.
#include <algorithm>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "models/dem/contact_steps.hpp"
#include "solver/spheres/sphere_energy.hpp"
#include "solver/spheres/sphere_run.hpp"
#include "tests/modules.hpp"
#include "tests/unit/solver/sphere_scenes.hpp"

namespace dmp::tests::solver_sphere_steps_tests {
namespace {

using testing::AllOf;
using testing::HasSubstr;

/// A ball on its way to a floor.
SphereScene falling_ball(double restitution = 1) {
    SphereScene made;
    const int ball = made.part("ball", PartKind::spheres), floor = made.part("floor", PartKind::plane, 0);
    made.contact(restitution, 0.3);
    made.plane(floor, Vec::Zero(), Vec::UnitZ());
    made.sphere(ball, Vec(0, 0, 1.01e-3), 1e-3, Vec(0.5, 0, -1));
    made.scene.run.duration = given(4e-4);
    return made;
}

Plan plan_of(const SphereScene& made) { return SphereRun(made.scene, made.set, Resources(1)).plan(); }

/// Of the limit that numerics.steps_per_contact rules [s].
double limit_of_contact(const SphereScene& made) {
    for (const StepLimit& limit : plan_of(made).limits)
        if (limit.model == "contact of 'ball' and 'floor'") return limit.dt;
    return 0;
}

TEST(SphereSteps, of_a_ball_alone_know_no_contact_with_itself) {
    SphereScene made = falling_ball();
    const auto models = [&] {
        std::string all;
        const Plan plan = plan_of(made);
        for (const StepLimit& limit : plan.limits) all += limit.model + "\n";
        for (const ModelUse& use : plan.models) all += use.model + "\n";
        return all;
    };
    EXPECT_THAT(models(), testing::Not(HasSubstr("'ball' and 'ball'")));
    made.sphere(0, Vec(0, 0, 1), 1e-3);
    EXPECT_THAT(models(), HasSubstr("'ball' and 'ball'"));
}

TEST(SphereSteps, set_by_hand_are_listed_beside_the_limits) {
    SphereScene made = falling_ball();
    const Plan automatic = plan_of(made);
    made.scene.numerics.contact_step = given(0.9 * limit_of_contact(made));
    const Plan by_hand = plan_of(made);
    EXPECT_EQ(by_hand.ruling_limit, "contact_step");
    EXPECT_EQ(by_hand.dt, *made.scene.numerics.contact_step);
    EXPECT_TRUE(by_hand.warnings.empty());
    ASSERT_EQ(by_hand.limits.size(), automatic.limits.size() + 1);
    for (std::size_t k = 0; k < automatic.limits.size(); ++k) {
        EXPECT_EQ(by_hand.limits[k].model, automatic.limits[k].model);
        EXPECT_EQ(by_hand.limits[k].dt, automatic.limits[k].dt);
        EXPECT_THAT(by_hand.limits[k].formula, HasSubstr("not binding"));
    }
}

TEST(SphereSteps, set_by_hand_rule_even_where_others_are_shorter_and_say_what_that_costs) {
    SphereScene made = falling_ball();
    made.scene.numerics.contact_step = given(2 * limit_of_contact(made));
    const Plan plan = plan_of(made);
    EXPECT_EQ(plan.ruling_limit, "contact_step");
    EXPECT_EQ(plan.dt, *made.scene.numerics.contact_step);
    ASSERT_EQ(plan.warnings.size(), 1U);
    EXPECT_THAT(plan.warnings[0].text(),
                AllOf(HasSubstr("numerics.contact_step"), HasSubstr("with 15 steps in an impact"),
                      HasSubstr("about 2.2 %"), HasSubstr("give at most")));
}

TEST(SphereSteps, with_which_contacts_gain_energy_are_refused) {
    SphereScene made = falling_ball();
    const double limit = limit_of_contact(made) * StepsPerContact::standard / StepsPerContact::least;
    made.scene.numerics.contact_step = given(0.999 * limit);
    EXPECT_NO_THROW(plan_of(made));
    made.scene.numerics.contact_step = given(1.001 * limit);
    try {
        static_cast<void>(plan_of(made));
        FAIL() << "it was taken";
    } catch (const InputError& error) {
        EXPECT_THAT(std::string(error.what()),
                    AllOf(HasSubstr("scene.toml:1"), HasSubstr("numerics.contact_step is too long"),
                          HasSubstr("'ball' and 'floor'"), HasSubstr("give at most \"")));
    }
}

TEST(SphereSteps, that_spheres_have_outgrown_on_the_way_are_warned_of) {
    SphereScene made = falling_ball();
    made.scene.numerics.contact_step = given(6 * limit_of_contact(made) * 0.99);
    made.set.velocity[0] = Vec(0, 0, -0.2);
    made.scene.flow.acceleration[2] = Expression("-1e5", "-1e5");
    SphereRun engine(made.scene, made.set, Resources(1));
    EXPECT_NO_THROW(static_cast<void>(engine.plan()));
    int warned = 0;
    RunOptions options;
    options.warn = [&](double, const Warning& warning) {
        ++warned;
        EXPECT_THAT(warning.text(), HasSubstr("impacts gain more than 4 % of energy"));
    };
    const RunSummary summary = engine.run(options);
    EXPECT_EQ(warned, 1);
    ASSERT_EQ(summary.warnings.size(), 1U);
    EXPECT_EQ(summary.warnings[0].key, "numerics.contact_step");
}

// In the middle of an elastic impact without friction contacts hold most of the energy.
TEST(SphereEnergies, of_an_elastic_impact_stay_the_same_all_along) {
    for (const bool on_a_wall : {true, false}) {
        SphereScene made = falling_ball();
        made.set.velocity[0] = Vec(0, 0, -1);
        made.scene.contact_pairs[0].friction = given(0);
        if (!on_a_wall) {
            made.set.wall_planes.clear();
            made.sphere(0, Vec(0, 0, -1.01e-3), 1e-3, Vec(0, 0, 1));
        }
        made.scene.numerics.steps_per_contact = 200;
        double most = 0;
        for (const double time : {1e-6, 3e-5, 5e-5, 7e-5, 4e-4}) {
            made.scene.run.duration = given(time);
            const SphereSummary seen = *SphereRun(made.scene, made.set, Resources(1)).run({}).spheres;
            EXPECT_EQ(seen.start.contacts, 0);
            EXPECT_NEAR(seen.end.total() / seen.start.total(), 1, 1e-4) << time;
            most = std::max(most, seen.end.contacts / seen.start.total());
        }
        EXPECT_GT(most, 0.3);
        EXPECT_LT(most, 1.0001);
    }
}

TEST(SphereEnergies, count_springs_and_adhesion) {
    constexpr ContactModel model = model_of<HertzContact, RescaledHistory, RollingSpring, DmtAdhesion>;
    ContactConstants<double> pair;
    pair.normal_stiffness = 2;
    pair.tangential_stiffness = 3;
    pair.rolling_friction = 0.5;
    pair.adhesion_energy = 0.1;
    const std::vector<double> history{0.1, 0, 0.2, 0, 0.3, 0};
    const double radius = 4, overlap = 0.25, touch = 1;  // sqrt(R* d)
    EXPECT_NEAR(contact_energy(model, pair, overlap, radius, history),
                HertzContact::energy(overlap, radius, pair) + DmtAdhesion::energy(overlap, radius, pair) +
                    0.5 * 3 * (0.01 + 0.04) + 0.5 * 2.25 * 2 * touch * 4 * 0.09,
                1e-12);
    EXPECT_EQ(contact_energy(model, pair, -1e-3, radius, std::vector<double>(6)), 0);
}

TEST(SphereEnergies, that_grow_where_nothing_drives_are_warned_of) {
    // Nothing is known of speeds at the start: two balls in each other that are let go.
    SphereScene made = falling_ball();
    made.set.velocity[0] = Vec::Zero();
    made.set.position[0][2] = 0.99e-3;
    made.scene.numerics.contact_step = given(8e-5);
    const RunSummary grown = SphereRun(made.scene, made.set, Resources(1)).run({});
    ASSERT_FALSE(grown.warnings.empty());
    EXPECT_GT(grown.spheres->end.total(), 1.01 * grown.spheres->start.total());
    EXPECT_THAT(grown.warnings.back().text(),
                AllOf(HasSubstr("numerics.contact_step"), HasSubstr("energy"), HasSubstr("nothing drives them")));
    made.scene.numerics.contact_step = 0.0;
    EXPECT_TRUE(SphereRun(made.scene, made.set, Resources(1)).run({}).warnings.empty());
    made.scene.numerics.contact_step = given(8e-5);
    made.scene.flow.acceleration[2] = Expression("1e-3", "1e-3");
    for (const Warning& warning : SphereRun(made.scene, made.set, Resources(1)).run({}).warnings)
        EXPECT_THAT(warning.text(), testing::Not(HasSubstr("nothing drives")));
}

TEST(SphereEnergies, that_grow_by_a_law_are_not_blamed_on_the_steps) {
    SphereScene made = falling_ball();
    made.scene.parts[0].poisson_ratio = given(0.1);
    made.scene.contact_pairs[0].friction = given(1e9);
    made.set.velocity[0] = Vec(1, 0, -1);
    EXPECT_TRUE(SphereRun(made.scene, made.set, Resources(1)).run({}).warnings.empty());
    made.scene.contact_pairs[0].tangential = TangentialLaw::of<PlainHistory>();
    const RunSummary grown = SphereRun(made.scene, made.set, Resources(1)).run({});
    ASSERT_EQ(grown.warnings.size(), 1U);
    EXPECT_THAT(grown.warnings[0].text(),
                AllOf(HasSubstr("contact_pair.tangential is \"mindlin_unscaled\", which adds energy"),
                      HasSubstr("write \"mindlin\"")));
}

TEST(SphereSteps, follow_what_drives_the_spheres) {
    SphereScene made = falling_ball();
    EXPECT_NE(plan_of(made).ruling_limit, "drive");
    const std::string shaken = "10 * sin(2 * 3.14159265358979 * t / 0.000001)";
    made.scene.flow.acceleration[0] = Expression(shaken, shaken);
    const Plan plan = plan_of(made);
    EXPECT_EQ(plan.ruling_limit, "drive");
    EXPECT_NEAR(plan.dt, 1e-6 / 22, 0.1e-6 / 22);
}

}  // namespace
}  // namespace dmp::tests::solver_sphere_steps_tests
