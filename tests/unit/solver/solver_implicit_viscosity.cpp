// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <atomic>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "layered_channel.hpp"
#include "solver/state/checkpoints.hpp"
#include "tests/modules.hpp"
#include "tests/unit/temporary_files.hpp"

namespace dmp::tests::solver_implicit_viscosity_tests {
namespace {

constexpr double width = 1e-3, speed = 1e-5;

std::string text_of(double number) {
    std::ostringstream text;
    text.precision(17);
    text << number;
    return text.str();
}

/// Plane Poiseuille flow that reaches `speed` in the middle, for `times` of the time width^2 / nu.
SceneAndParticles poiseuille(double reynolds, double times, int across = 20) {
    const double nu = speed * width / reynolds;
    LayeredChannel channel;
    channel.spacing = width / across;
    channel.layers = {{"water", across, LayeredChannel::density * nu}};
    channel.speed = speed;
    channel.acceleration = text_of(8 * nu * speed / (width * width));
    channel.duration = times * width * width / nu;
    SceneAndParticles made = layered(channel);
    made.scene.numerics.step_factor = 0.3;
    return made;
}
double parabola(double y) { return 4 * speed * y * (width - y) / (width * width); }

struct Outcome {
    RunSummary summary;
    KeptFrames kept;
    [[nodiscard]] const Frame& last() const { return kept.frames.back(); }
};

Outcome run(const SceneAndParticles& made, const Resources& resources = 1) {
    Outcome outcome;
    RunOptions options;
    options.sink = &outcome.kept;
    outcome.summary = Simulation(made.scene, made.particles, resources).run(options);
    return outcome;
}

double limit(const Plan& plan, const std::string& model) {
    for (const StepLimit& one : plan.limits)
        if (one.model == model) return one.dt;
    throw std::invalid_argument("no limit " + model);
}

/// The step factor that makes steps as long as `factor` times the explicit viscous limit.
double step_factor_for(const SceneAndParticles& made, double factor) {
    const Plan plan = Simulation(made.scene, made.particles, 1).plan();
    return made.scene.numerics.step_factor * factor * limit(plan, "viscosity") / limit(plan, "sound");
}

struct Ratio {
    double reynolds;
    double step_over_limit;  ///< dt over the explicit limit, about
};

class AnyStep : public ::testing::TestWithParam<Ratio> {};

TEST_P(AnyStep, poiseuille_flow_becomes_the_parabola) {
    const SceneAndParticles made = poiseuille(GetParam().reynolds, 1.5);
    const Plan plan = Simulation(made.scene, made.particles, 1).plan();
    EXPECT_NEAR(std::log10(plan.dt / limit(plan, "viscosity")), std::log10(GetParam().step_over_limit), 0.1);
    const Outcome flow = run(made);
    EXPECT_LT(profile_error(flow.last(), parabola), 0.01);
    EXPECT_LT(flow.summary.momentum_residual, 1e-12);
    EXPECT_GT(flow.summary.viscous_solves.mean_iterations(), 1);
    EXPECT_EQ(flow.summary.viscous_solves.solves, flow.summary.steps);
}

INSTANTIATE_TEST_SUITE_P(Steps, AnyStep,
                         ::testing::Values(Ratio{5.1, 1}, Ratio{0.51, 10}, Ratio{0.051, 100}, Ratio{9.1e-4, 1e3},
                                           Ratio{9.1e-6, 1e4}, Ratio{9.1e-8, 1e5}));

TEST(ImplicitViscosity, is_explicit_viscosity_to_first_order_in_the_step) {
    SceneAndParticles made = poiseuille(0.0125, 0.1);
    const auto velocities = [&](ViscosityStepping stepping, double factor) {
        SceneAndParticles one = made;
        one.scene.numerics.viscosity_stepping = stepping;
        one.scene.numerics.viscosity_tolerance = 1e-10;
        one.scene.numerics.step_factor = step_factor_for(made, factor);
        return field_of(*group_of(run(one).last(), "fluid"), "velocity")->values;
    };
    const auto exact = velocities(ViscosityStepping::explicitly, 1.0 / 64);
    const auto error = [&](double factor) {
        const auto found = velocities(ViscosityStepping::implicitly, factor);
        double square = 0, reference = 0;
        for (std::size_t k = 0; k < exact.size(); ++k) {
            square += std::pow(found[k] - exact[k], 2);
            reference += exact[k] * exact[k];
        }
        return std::sqrt(square / reference);
    };
    const double whole = error(1), half = error(0.5), quarter = error(0.25);
    EXPECT_NEAR(std::log2(whole / half), 1, 0.1) << whole << " " << half;
    EXPECT_NEAR(std::log2(half / quarter), 1, 0.1) << half << " " << quarter;
    EXPECT_LT(quarter, 2e-3);
    RecordProperty("errors", std::to_string(whole) + " " + std::to_string(half) + " " + std::to_string(quarter));
}

/// A belt of mucus between two layers of water, pulled along: the water is sheared, as below mucus that cilia move.
SceneAndParticles mucus_over_water(int across, double relaxation_times) {
    constexpr double viscosity = 1e-3, ratio = 20000, reynolds = 0.2;
    const double height = viscosity / LayeredChannel::density * reynolds / speed, dx = height / across;
    const int rows = across / 2;
    const double belt = rows * dx, stress = viscosity * speed / height;
    LayeredChannel channel;
    channel.spacing = dx;
    channel.layers = {
        {"water", across, viscosity}, {"mucus", rows, ratio * viscosity}, {"more_water", across, viscosity}};
    channel.speed = speed;
    channel.acceleration = "(y > " + text_of(height) + " && y < " + text_of(height + belt) + ") ? " +
                           text_of(2 * stress / (LayeredChannel::density * belt)) + " : 0";
    // The belt slows down with its own mass and a third of the water's.
    channel.duration = relaxation_times * LayeredChannel::density * (belt / 2 + height / 3) * height / viscosity;
    return layered(channel);
}
/// Its steady velocity: a line to `speed` in the water; what the belt adds is less than 1e-5 of it.
double sheared(const SceneAndParticles& made, double y) {
    const double top = made.particles.box.high[1] - 3 * made.particles.spacing, height = top / 2.5;
    return speed * std::min({1.0, y / height, (top - y) / height});
}

TEST(ImplicitViscosity, shears_water_under_mucus) {
    const SceneAndParticles made = mucus_over_water(20, 8);
    const Plan plan = Simulation(made.scene, made.particles, 1).plan();
    EXPECT_GT(plan.dt / limit(plan, "viscosity"), 1e5);
    const Outcome flow = run(made);
    EXPECT_LT(profile_error(flow.last(), [&](double y) { return sheared(made, y); }), 0.01);
    EXPECT_LT(flow.summary.momentum_residual, 1e-12);
}

TEST(ImplicitViscosity, is_the_same_bits_on_any_threads_and_vector_unit) {
    const SceneAndParticles made = mucus_over_water(20, 0.4);
    const Outcome first = run(made);
    std::vector<Resources> all{2, 3};
    for (const VectorUnit unit : available_vector_units()) {
        all.emplace_back(1);
        all.back().vector_unit = unit;
    }
    for (const Resources& resources : all) {
        const Outcome other = run(made, resources);
        EXPECT_EQ(other.summary.state_hash, first.summary.state_hash);
        EXPECT_EQ(other.summary.viscous_solves.iterations, first.summary.viscous_solves.iterations);
    }
}

/// Stops a run when the second frame is written.
class StopsAtSecondFrame : public FrameSink {
  public:
    void write(const Frame& /*frame*/) override { stop = ++frames == 2; }
    std::atomic<bool> stop = false;

  private:
    int frames = 0;
};

/// When it goes on, its neighbours are listed in another order.
void expect_that_it_goes_on_as_if_it_had_not_stopped(SceneAndParticles made) {
    made.scene.output.every = made.scene.run.duration / 3;
    const Outcome whole = run(made);
    const TemporaryFolder folder;
    StopsAtSecondFrame sink;
    RunOptions options;
    options.sink = &sink;
    options.stop = &sink.stop;
    options.checkpoints.folder = folder.path();
    options.checkpoints.every = 0;
    options.checkpoints.label.scene = "a scene";
    EXPECT_TRUE(Simulation(made.scene, made.particles, 1).run(options).interrupted);
    Simulation resumed(made.scene, made.particles, 2);
    resumed.resume(checkpoint_to_resume(folder.path(), "a scene", made.scene.run.duration).file);
    const RunSummary summary = resumed.run({});
    EXPECT_GT(summary.first_step, 0);
    EXPECT_EQ(summary.state_hash, whole.summary.state_hash);
    EXPECT_EQ(summary.viscous_solves.solves, whole.summary.viscous_solves.solves);
    EXPECT_EQ(summary.viscous_solves.iterations, whole.summary.viscous_solves.iterations);
}

TEST(ImplicitViscosity, goes_on_from_a_checkpoint_as_if_it_had_not_stopped) {
    expect_that_it_goes_on_as_if_it_had_not_stopped(mucus_over_water(20, 0.4));
}

/// Densities differ by percents over 1 mm here, so that the sums of the density's diffusion are many times as large as
/// the term that their rounding expects.
TEST(ImplicitViscosity, goes_on_from_a_checkpoint_where_densities_differ_much) {
    SceneAndParticles made = mucus_over_water(20, 0.4);
    made.scene.numerics.sound_speed = 0.02;
    expect_that_it_goes_on_as_if_it_had_not_stopped(made);
}

TEST(ImplicitViscosity, says_when_it_finds_no_solution) {
    SceneAndParticles made = poiseuille(9.1e-6, 1.5);
    made.scene.numerics.viscosity_tolerance = 1e-17;
    try {
        run(made);
        FAIL() << "a residual below rounding";
    } catch (const DivergenceError& error) {
        EXPECT_THAT(error.problem(), ::testing::HasSubstr("implicit viscosity: the velocities' error is still "));
        EXPECT_THAT(error.what_to_do(), ::testing::HasSubstr("lower the viscosity or numerics.step_factor"));
    }
}

TEST(ImplicitViscosity, takes_its_limit_out_of_the_step_and_says_so) {
    SceneAndParticles made = poiseuille(9.1e-4, 1);
    const Plan implicit_plan = Simulation(made.scene, made.particles, 1).plan();
    made.scene.numerics.viscosity_stepping = ViscosityStepping::explicitly;
    const Plan explicit_plan = Simulation(made.scene, made.particles, 1).plan();
    EXPECT_EQ(explicit_plan.ruling_limit, "viscosity");
    EXPECT_EQ(implicit_plan.ruling_limit, "body force");
    EXPECT_EQ(limit(implicit_plan, "viscosity"), explicit_plan.dt);
    EXPECT_THAT(implicit_plan.limits.back().formula,
                ::testing::HasSubstr(
                    "; not binding, stepped implicitly: what changes within 10 steps, such as shear layers of "));
    EXPECT_LT(explicit_plan.bytes_per_particle, implicit_plan.bytes_per_particle);
    for (const std::string& field : explicit_plan.fields) EXPECT_EQ(field.find("viscous"), std::string::npos) << field;
}

}  // namespace
}  // namespace dmp::tests::solver_implicit_viscosity_tests
