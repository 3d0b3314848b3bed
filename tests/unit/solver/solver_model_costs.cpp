// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <chrono>

#include <gmock/gmock.h>

#include "small_scenes.hpp"
#include "solver/model_costs.hpp"
#include "tests/modules.hpp"

namespace dmp::tests::solver_model_costs_tests {
namespace {

using ::testing::ElementsAre;
using ::testing::IsSupersetOf;

std::vector<std::string> names(const std::vector<MeasuredTime>& times) {
    std::vector<std::string> all;
    all.reserve(times.size());
    for (const MeasuredTime& time : times) all.push_back(time.of);
    return all;
}

TEST(ModelCosts, are_of_the_models_that_can_be_left_out) {
    auto made = endless_water("0.5");
    made.scene.numerics.sound_speed = 1000.0;  // steps so short that the water falls nowhere near that fast
    const ModelCosts costs = measure_costs(made.scene, made.particles, 1, 1.0);
    EXPECT_THAT(names(costs.models), ElementsAre("density diffusion", "particle shifting"));
    EXPECT_THAT(names(costs.stages), IsSupersetOf({"forces", "density", "kick", "drift"}));
    EXPECT_EQ(costs.threads, 1);
    EXPECT_GE(costs.steps, 10);
    EXPECT_GT(costs.step.ns, 0);
    double sum = 0;
    for (const MeasuredTime& stage : costs.stages) sum += stage.ns;
    EXPECT_NEAR(sum, costs.step.ns, 1e-9 * sum);

    made.scene.numerics.shifting = 0.0;
    EXPECT_THAT(names(measure_costs(made.scene, made.particles, 1, 0.5).models), ElementsAre("density diffusion"));
}

TEST(ModelCosts, of_a_valve_know_contact_springs_and_residence) {
    auto made = case_of("vein_valve", {"particles.spacing=0.5 mm", "output.fields=['velocity']"});
    ResidenceRegion all;
    all.from = Vec(-1, -1, 0);
    all.to = Vec(1, 1, 0);
    made.scene.regions = {all};
    made.scene.output.fields = {FluidField::residence_time};
    const ModelCosts costs = measure_costs(made.scene, made.particles, 1, 3.0);
    EXPECT_THAT(names(costs.models), ElementsAre("density diffusion", "particle shifting", "extrapolated no-slip walls",
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
    const ModelCosts costs = measure_costs(made.scene, made.particles, 1, 2.0);
    EXPECT_THAT(names(costs.models), ElementsAre("implicit viscosity", "gradient correction", "density diffusion",
                                                 "transport velocity", "diffusion of 'oxygen'", "diffusion of 'dye'"));
}

TEST(ModelCosts, take_about_the_time_they_are_given) {
    const auto made = endless_water("0.5");
    const auto start = std::chrono::steady_clock::now();
    (void)measure_costs(made.scene, made.particles, 1, 0.3);
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
    EXPECT_LT(took.count(), 3) << "ten times over, for a busy machine";
}

}  // namespace
}  // namespace dmp::tests::solver_model_costs_tests
