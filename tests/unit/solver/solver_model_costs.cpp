// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include "small_scenes.hpp"
#include "solver/model_costs.hpp"
#include "tests/modules.hpp"

namespace dmp::tests::solver_model_costs_tests {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::Ge;
using ::testing::IsEmpty;
using ::testing::IsSupersetOf;
using ::testing::Le;

/// With a clock that stands still all models are timed, however slow the machine, and a step seems to take a
/// microsecond: this is the time for ten rounds of a few steps.
double standing() { return 0; }
constexpr double brief = 1e-4;

std::vector<std::string> names(const std::vector<MeasuredTime>& times) {
    std::vector<std::string> all;
    all.reserve(times.size());
    for (const MeasuredTime& time : times) all.push_back(time.of);
    return all;
}

TEST(ModelCosts, are_of_the_models_that_can_be_left_out) {
    auto made = endless_water("0.5");
    made.scene.numerics.sound_speed = 1000.0;  // steps so short that the water falls nowhere near that fast
    const ModelCosts costs = measure_costs(made.scene, made.particles, 1, brief, standing);
    EXPECT_THAT(names(costs.models), ElementsAre("density diffusion", "particle shifting"));
    EXPECT_THAT(names(costs.stages), IsSupersetOf({"forces", "density", "kick", "drift"}));
    EXPECT_EQ(costs.threads, 1);
    EXPECT_GE(costs.steps, 10);
    EXPECT_GT(costs.step.ns, 0);
    double sum = 0;
    for (const MeasuredTime& stage : costs.stages) sum += stage.ns;
    EXPECT_NEAR(sum, costs.step.ns, 1e-9 * sum);

    made.scene.numerics.shifting = 0.0;
    EXPECT_THAT(names(measure_costs(made.scene, made.particles, 1, brief, standing).models),
                ElementsAre("density diffusion"));
}

TEST(ModelCosts, of_a_valve_know_contact_springs_and_residence) {
    auto made = case_of("vein_valve", {"particles.spacing=0.5 mm", "output.fields=['velocity']"});
    ResidenceRegion all;
    all.from = Vec(-1, -1, 0);
    all.to = Vec(1, 1, 0);
    made.scene.regions = {all};
    made.scene.output.fields = {FluidField::residence_time};
    const ModelCosts costs = measure_costs(made.scene, made.particles, 1, brief, standing);
    EXPECT_THAT(names(costs.models), ElementsAre("density diffusion", "particle shifting", "extrapolated walls",
                                                 "short-range repulsion", "residence times"));
    EXPECT_THAT(names(costs.stages), IsSupersetOf({"elastic"}));
}

TEST(ModelCosts, know_correction_transport_velocity_implicit_viscosity_and_each_species) {
    auto made = endless_water("0.5");
    made.scene.numerics.sound_speed = 1000.0;
    made.scene.numerics.viscosity_stepping = ViscosityStepping::implicitly;
    made.scene.numerics.transport_velocity = true;
    made.scene.numerics.gradient_correction = true;
    for (const char* name : {"oxygen", "dye"}) {
        Species species;
        species.name = std::string(name);
        species.diffusivity.all = Value<double>(1e-9);
        made.scene.species.push_back(species);
    }
    const ModelCosts costs = measure_costs(made.scene, made.particles, 1, brief, standing);
    EXPECT_THAT(names(costs.models), ElementsAre("implicit viscosity", "gradient correction", "density diffusion",
                                                 "transport velocity", "diffusion of 'oxygen'", "diffusion of 'dye'"));
}

TEST(ModelCosts, take_no_more_time_than_they_are_given) {
    const auto made = endless_water("0.5");
    double now = 0;
    const auto ticking = [&] { return now++; };  // a second passes between any two looks at it
    const ModelCosts some = measure_costs(made.scene, made.particles, 1, 10, ticking);
    EXPECT_EQ(some.models.size(), 2U);
    EXPECT_EQ(now, 11);
    EXPECT_THAT(some.steps, AllOf(Ge(5), Le(6)));  // one in each of five rounds
    now = 0;
    const ModelCosts few = measure_costs(made.scene, made.particles, 1, 5, ticking);
    EXPECT_THAT(few.models, IsEmpty()) << "two fifths of the time were over";
    EXPECT_EQ(now, 6);
    EXPECT_THAT(few.steps, AllOf(Ge(1), Le(2)));
}

}  // namespace
}  // namespace dmp::tests::solver_model_costs_tests
