// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Runs of the corrected scheme: what the answer must not depend on, and its accounts.
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "small_scenes.hpp"
#include "tests/modules.hpp"

namespace dmp::tests::solver_corrected_scheme_tests {
namespace {

std::vector<std::string> corrected(std::vector<std::string> more) {
    more.emplace_back("numerics.scheme=corrected");
    return more;
}

RunSummary run_on(const SceneAndParticles& made, const Resources& resources, double until) {
    Simulation simulation(made.scene, made.particles, resources);
    RunOptions options;
    options.until = until;
    return simulation.run(options);
}

RunSummary vortices(const std::vector<std::string>& more, double until = 0.5) {
    std::vector<std::string> all{"particles.spacing=0.04 m", "particles.disorder=0.2"};
    all.insert(all.end(), more.begin(), more.end());
    return run_on(case_of("verification/taylor_green", corrected(all)), 2, until);
}

/// Relative error of the kinetic energy of vortices of speed 1 and viscosity 0.01.
double energy_error(const RunSummary& run) {
    const auto name = std::ranges::find(run.measures.names, "energy");
    const auto column = static_cast<std::size_t>(name - run.measures.names.begin());
    const double t = run.measures.time.back(), pi = std::numbers::pi;
    return run.measures.rows.back().at(column) / (0.25 * std::exp(-16 * pi * pi * 0.01 * t)) - 1;
}

TEST(CorrectedScheme, does_not_depend_on_the_speed_of_sound) {
    const double slow = energy_error(vortices({"numerics.sound_speed=10 m/s"}));
    const double fast = energy_error(vortices({"numerics.sound_speed=40 m/s"}));
    EXPECT_LT(std::abs(slow), 0.02);  // 25 x 25 particles
    EXPECT_LT(std::abs(fast - slow), 0.005);
}

TEST(CorrectedScheme, does_not_feel_the_level_of_the_pressure) {
    const double without = energy_error(vortices({"numerics.sound_speed=10 m/s"}));
    for (const std::string level : {"1", "100"}) {
        const double with =
            energy_error(vortices({"numerics.sound_speed=10 m/s", "numerics.background_pressure=" + level + " Pa"}));
        EXPECT_NEAR(with, without, 1e-6) << level << " Pa";
    }
}

TEST(CorrectedScheme, keeps_momentum_where_it_interpolates_velocities) {
    const RunSummary run = vortices({"numerics.sound_speed=10 m/s"}, 0.1);
    EXPECT_EQ(run.end.mass, run.start.mass);
    for (std::size_t axis = 0; axis < 3; ++axis) EXPECT_NEAR(run.end.momentum[axis], run.start.momentum[axis], 1e-13);
}

/// The box is closed, so the volume that its fluid fills is constant.
TEST(CorrectedScheme, keeps_the_volume_of_the_fluid) {
    const auto made = case_of("verification/taylor_green",
                              corrected({"particles.spacing=0.04 m", "particles.disorder=0.2",
                                         "part.water.viscosity=0.0005 Pa*s", "output.fields=[\"density\"]"}));
    KeptFrames frames;
    RunOptions options;
    options.until = 1;
    options.sink = &frames;
    const RunSummary run = Simulation(made.scene, made.particles, 2).run(options);
    const auto volume = [](const Frame& frame) {
        const std::vector<float>& density = frame.groups.front().fields.front().values;
        double sum = 0;
        for (const float value : density) sum += 1.0 / value;
        return sum / static_cast<double>(density.size());
    };
    EXPECT_NEAR(volume(frames.frames.back()), volume(frames.frames.front()), 5e-6);
    EXPECT_GT(std::abs(run.density_drift), 1e-4);  // there was something to correct
}

/// About `steps` steps on every vector unit and on 1, 2 and 3 threads.
void expect_same_bits(const SceneAndParticles& made, long steps) {
    const double until = static_cast<double>(steps) * Simulation(made.scene, made.particles, 1).plan().dt;
    const RunSummary first = run_on(made, 1, until);
    EXPECT_LT(first.momentum_residual, 1e-12);
    EXPECT_EQ(first.lost, 0U);
    std::vector<Resources> all{2, 3};
    for (const VectorUnit unit : available_vector_units()) all.emplace_back(1).vector_unit = unit;
    for (const Resources& resources : all) EXPECT_EQ(run_on(made, resources, until).state_hash, first.state_hash);
}

TEST(CorrectedScheme, has_the_same_bits_on_threads_and_vector_units) {
    expect_same_bits(case_of("verification/poiseuille", corrected({})), 100);
    expect_same_bits(case_of("vein_valve", corrected({"particles.spacing=0.5 mm"})), 200);
}

TEST(CorrectedScheme, is_stable_with_solids_far_lighter_than_the_fluid) {
    // A disc in shear flow that fills its volume, and a node of which has a twentieth of the liquid's mass.
    for (const auto& [speed, limit] :
         {std::pair{"20 m/s", "light solids"}, std::pair{"1 m/s", "viscosity at elastic solids"}}) {
        const auto made = case_of("verification/body_in_shear",
                                  corrected({"part.body.density=50 kg/m^3", "part.liquid.viscosity=10 mPa*s",
                                             std::string("numerics.sound_speed=") + speed}));
        const Plan plan = Simulation(made.scene, made.particles, 1).plan();
        EXPECT_EQ(plan.ruling_limit, limit);
        const RunSummary run = run_on(made, 2, 300 * plan.dt);
        EXPECT_NEAR(run.density_low, 1000, 10) << speed;
        EXPECT_NEAR(run.density_high, 1000, 10) << speed;
    }
}

/// The pressure of the heavier liquid accelerates particles of the lighter; steps for one liquid stirred both at 20 m/s
/// here.
TEST(CorrectedScheme, is_stable_between_liquids_of_unlike_density) {
    const auto made =
        case_of("verification/two_liquids", corrected({"particles.spacing=0.04 m", "numerics.sound_speed=400 m/s"}));
    EXPECT_EQ(Simulation(made.scene, made.particles, 1).plan().ruling_limit, "sound");
    EXPECT_LT(run_on(made, 2, 0.2).largest_speed, 0.1);
}

TEST(CorrectedScheme, does_not_shorten_steps_for_leaflets_thinner_than_their_two_layers_of_nodes) {
    for (const char* mass : {"0.1 kg/m", "0.42 kg/m"}) {
        const auto made =
            case_of("vein_valve",
                    corrected({"particles.spacing=0.8 mm", std::string("part.leaflets.mass_per_length=") + mass}));
        EXPECT_EQ(Simulation(made.scene, made.particles, 1).plan().ruling_limit, "sound") << mass;
    }
}

/// Fluid rows alone between a leaflet and the wall: they resonate and grow where the density rate is not the partner of
/// the pressure force at solids.
TEST(CorrectedScheme, is_stable_in_gaps_one_particle_wide) {
    const RunSummary run = run_on(case_of("vein_valve", corrected({"particles.spacing=0.8 mm"})), 2, 1.4);
    EXPECT_NEAR(run.density_low, 1056, 16);
    EXPECT_NEAR(run.density_high, 1056, 16);
}

TEST(CorrectedScheme, accounts_for_the_momentum_of_a_column_under_gravity) {
    const auto made = case_of("verification/hydrostatic", corrected({}));
    const Plan plan = Simulation(made.scene, made.particles, 1).plan();
    const RunSummary run = run_on(made, 2, 200 * plan.dt);
    EXPECT_EQ(run.lost, 0U);
    EXPECT_LT(run.momentum_residual, 1e-12);
}

}  // namespace
}  // namespace dmp::tests::solver_corrected_scheme_tests
