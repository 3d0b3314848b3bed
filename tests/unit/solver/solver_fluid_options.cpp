// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
//
// Whole runs with the fluid's terms that are off by default: plane Poiseuille flow from rest, 20 particles across.
#include <cmath>
#include <numbers>
#include <ostream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "models/sph/kernels.hpp"
#include "models/sph/lattice_viscosity.hpp"
#include "small_scenes.hpp"
#include "tests/modules.hpp"

namespace dmp::tests::solver_fluid_options_tests {
namespace {

using testing::HasSubstr;

constexpr double width = 1e-3, acceleration = 1e-4;  // [m], [m/s^2]

/// Start-up from rest between plates at y = 0 and y = width (series of Morris, Fox & Zhu 1997).
double speed_by_series(double y, double t, double viscosity) {
    constexpr double pi = std::numbers::pi;
    double u = acceleration / (2 * viscosity) * y * (width - y);
    for (int n = 0; n < 60; ++n) {
        const double k = (2 * n + 1) * pi;
        u -= 4 * acceleration * width * width / (viscosity * k * k * k) * std::sin(k * y / width) *
             std::exp(-k * k * viscosity * t / (width * width));
    }
    return u;
}

struct Flow {
    Plan plan;
    RunSummary summary;
    KeptFrames kept;
};

Flow flow_of(const std::vector<std::string>& options, int threads = 1) {
    std::vector<std::string> overrides{"numerics.scheme=plain", "run.duration=0.1 s",
                                       "output.fields=['velocity', 'pressure', 'density']"};
    overrides.insert(overrides.end(), options.begin(), options.end());
    const auto [scene, particles] = case_of("verification/poiseuille", overrides);
    Flow flow;
    RunOptions run;
    run.sink = &flow.kept;
    Simulation simulation(scene, particles, threads);
    flow.plan = simulation.plan();
    flow.summary = simulation.run(run);
    return flow;
}

/// Relative L2 error of the velocity at the end, for a fluid of this kinematic viscosity.
double error_of(const Flow& flow, double viscosity = 1e-6) {
    const Frame& frame = flow.kept.frames.back();
    const FrameGroup& fluid = *group_of(frame, "fluid");
    const FrameField& velocity = *field_of(fluid, "velocity");
    double square = 0, reference = 0;
    for (std::size_t k = 0; k < fluid.size(); ++k) {
        const double expected = speed_by_series(fluid.position[3 * k + 1], frame.time, viscosity);
        square += std::pow(velocity.values[3 * k] - expected, 2) + std::pow(velocity.values[3 * k + 1], 2);
        reference += expected * expected;
    }
    return std::sqrt(square / reference);
}

struct Option {
    std::string name;
    std::vector<std::string> settings;
    std::string model;  ///< that the plan names
    friend void PrintTo(const Option& option, std::ostream* out) { *out << option.name; }
};

class FluidOption : public testing::TestWithParam<Option> {};

TEST_P(FluidOption, follows_the_series_and_keeps_momentum) {
    const Flow flow = flow_of(GetParam().settings);
    EXPECT_LE(error_of(flow), 0.01);
    EXPECT_LT(flow.summary.momentum_residual, 1e-12);
    EXPECT_EQ(flow.summary.lost, 0U);
    std::string models;
    for (const ModelUse& use : flow.plan.models) models += use.model + " (" + use.reason + ")\n";
    EXPECT_THAT(models, HasSubstr(GetParam().model));
}

TEST_P(FluidOption, gives_the_same_bits_on_any_number_of_threads) {
    std::vector<std::string> settings = GetParam().settings;
    settings.emplace_back("run.duration=0.005 s");
    const std::string one = flow_of(settings).summary.state_hash;
    EXPECT_EQ(flow_of(settings, 3).summary.state_hash, one);
    if (GetParam().name == "linear") return;  // the density does not change here
    EXPECT_NE(flow_of({"run.duration=0.005 s"}).summary.state_hash, one) << "the option changes nothing";
}

INSTANTIATE_TEST_SUITE_P(
    All, FluidOption,
    testing::Values(Option{"linear", {"numerics.equation_of_state=linear"}, "equation of state (numerics.equ"},
                    Option{"background", {"numerics.background_pressure=\"1e-6 Pa\""}, "background pressure (numerics"},
                    Option{"summation", {"numerics.density=summation"}, "summation density (numerics.density at"},
                    Option{"correction", {"numerics.gradient_correction=true"}, "gradient correction (numerics."},
                    Option{"transport", {"numerics.transport_velocity=true"}, "transport velocity (numerics.tra"},
                    Option{"transport_and_summation",
                           {"numerics.transport_velocity=true", "numerics.density=summation"},
                           "transport velocity (numerics.tra"},
                    Option{"quintic_spline", {"numerics.kernel=quintic_spline"}, "continuity"},
                    Option{"cubic_spline", {"numerics.kernel=cubic_spline"}, "continuity"}),
    [](const auto& option) { return option.param.name; });

/// Particles hardly move here: the flow is that of the viscosity which the lattice makes of the law. Where only
/// approaching pairs count, they also push, with a pressure like the shear stress: the liquid must be stiff against it.
TEST(MonaghanViscosity, follows_the_series_of_its_viscosity_on_the_lattice) {
    const WendlandC2<2> kernel(3);
    const LatticeViscosity lattice = lattice_viscosity_of_monaghan(2, 1, 3, [&](double r) { return kernel.slope(r); });
    for (const char* law : {"monaghan", "monaghan_approaching"}) {
        const Flow flow = flow_of({std::string("numerics.viscous_law=") + law, "numerics.sound_speed=50 mm/s"});
        EXPECT_LE(error_of(flow, 1e-6 * lattice.shear), 0.01) << law;
        EXPECT_GE(error_of(flow), 0.05) << law;
        EXPECT_LT(flow.summary.momentum_residual, 1e-12);
        std::string source;
        for (const ModelUse& use : flow.plan.models)
            if (use.model == "viscous force") source = use.source;
        EXPECT_THAT(source, HasSubstr("on the lattice 0.87"));
        EXPECT_THAT(source, HasSubstr("alpha = "));
    }
}

/// Two layers of equal depth between plates, the upper one five times as viscous, driven by a body force: speed at y
/// once it is steady. Shear stress is one line across both.
double speed_of_layers(double y, double lower, double upper) {
    const double force = 1000 * acceleration, half = width / 2;
    const double at_wall = force * half * (1 / lower + 3 / upper) / (2 * (1 / lower + 1 / upper));
    if (y < half) return (at_wall * y - force * y * y / 2) / lower;
    return -(at_wall * (width - y) - force * (width * width - y * y) / 2) / upper;
}

TEST(ViscosityMean, harmonic_keeps_shear_stress_continuous_between_two_fluids) {
    const auto error_with = [](const std::string& mean) {
        auto made = case_of("verification/poiseuille",
                            {"numerics.viscosity_mean=" + mean, "output.every=1 s", "output.fields=['velocity']"});
        Part oil = made.scene.parts.front();
        oil.name = std::string("oil");
        oil.viscosity = 5e-3;
        made.scene.parts.push_back(oil);
        made.particles.parts.push_back({"oil", PartKind::fluid});
        for (std::size_t i = 0; i < made.particles.size(); ++i)
            if (made.particles.kind(i) == PartKind::fluid && made.particles.position[i][1] > width / 2)
                made.particles.part[i] = static_cast<int>(made.particles.parts.size()) - 1;
        KeptFrames kept;
        RunOptions run;
        run.sink = &kept;
        Simulation simulation(made.scene, made.particles, 1);
        std::string source;
        for (const ModelUse& use : simulation.plan().models)
            if (use.model == "viscous force") source = use.source;
        EXPECT_EQ(source.find("harmonic mean") != std::string::npos, mean == "harmonic") << source;
        EXPECT_LT(simulation.run(run).momentum_residual, 1e-12);
        const FrameGroup& fluid = *group_of(kept.frames.back(), "fluid");
        const FrameField& velocity = *field_of(fluid, "velocity");
        double square = 0, reference = 0;
        for (std::size_t k = 0; k < fluid.size(); ++k) {
            const double expected = speed_of_layers(fluid.position[3 * k + 1], 1e-3, 5e-3);
            square += std::pow(velocity.values[3 * k] - expected, 2);
            reference += expected * expected;
        }
        return std::sqrt(square / reference);
    };
    EXPECT_LE(error_with("harmonic"), 0.01);
    EXPECT_GE(error_with("arithmetic"), 0.02);
}

}  // namespace
}  // namespace dmp::tests::solver_fluid_options_tests
