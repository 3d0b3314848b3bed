// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "small_scenes.hpp"
#include "tests/modules.hpp"

namespace dmp::tests::solver_poiseuille_tests {
namespace {

constexpr double width = 1e-3, viscosity = 1e-6, acceleration = 1e-4, density = 1000;

/// Start-up from rest between plates at y = 0 and y = width (series of Morris, Fox & Zhu 1997).
double speed_by_series(double y, double t) {
    constexpr double pi = std::numbers::pi;
    double u = acceleration / (2 * viscosity) * y * (width - y);
    for (int n = 0; n < 60; ++n) {
        const double k = (2 * n + 1) * pi;
        u -= 4 * acceleration * width * width / (viscosity * k * k * k) * std::sin(k * y / width) *
             std::exp(-k * k * viscosity * t / (width * width));
    }
    return u;
}

TEST(PoiseuilleSeries, agrees_with_the_tabulated_values) {
    constexpr double final = acceleration * width * width / (8 * viscosity);
    const std::map<double, std::pair<double, double>> tabulated{
        {0.0225, {0.17862, 0.16192}}, {0.1, {0.61535, 0.47801}}, {0.5, {0.99258, 0.74475}}};
    for (const auto& [time, u] : tabulated) {
        EXPECT_NEAR(speed_by_series(width / 2, time) / final, u.first, 1e-5);
        EXPECT_NEAR(speed_by_series(width / 4, time) / final, u.second, 1e-5);
    }
}

struct Flow {
    std::map<double, double> error;  ///< L2 error of the velocity by time [relative]
    RunSummary summary;
    KeptFrames kept;
};

Flow flow_of(const std::string& spacing, std::vector<std::string> more = {}) {
    std::vector<std::string> overrides{"particles.spacing=\"" + spacing + "\""};
    overrides.insert(overrides.end(), more.begin(), more.end());
    auto [scene, particles] = case_of("verification/poiseuille", overrides);
    Flow flow;
    RunOptions options;
    options.sink = &flow.kept;
    Simulation simulation(scene, std::move(particles), 1);
    flow.summary = simulation.run(options);
    for (const Frame& frame : flow.kept.frames) {
        const FrameGroup& fluid = *group_of(frame, "fluid");
        const FrameField& velocity = *field_of(fluid, "velocity");
        double square = 0, reference = 0;
        for (std::size_t k = 0; k < fluid.size(); ++k) {
            const double expected = speed_by_series(fluid.position[3 * k + 1], frame.time);
            square += std::pow(velocity.values[3 * k] - expected, 2) + std::pow(velocity.values[3 * k + 1], 2);
            reference += expected * expected;
        }
        if (frame.time > 0) flow.error[std::round(frame.time * 1e6) / 1e6] = std::sqrt(square / reference);
    }
    return flow;
}

TEST(Poiseuille, follows_the_series_at_20_particles_across) {
    const Flow flow = flow_of("0.05 mm");
    EXPECT_LE(flow.error.at(0.1), 0.01);
    EXPECT_LE(flow.error.at(1.0), 0.01);
    // The wall holds what the drive gives: no mass or momentum comes from nowhere.
    EXPECT_EQ(flow.summary.start.mass, flow.summary.end.mass);
    EXPECT_LT(flow.summary.momentum_residual, 1e-12);
    EXPECT_EQ(flow.summary.lost, 0U);
    EXPECT_NEAR(flow.summary.impulse_of_body_forces[0], flow.summary.end.mass * acceleration * 1.0, 1e-12);
    EXPECT_LT(flow.summary.impulse_of_fixed[0], 0);
    EXPECT_GT(flow.summary.density_low, 0.99 * density);
    EXPECT_LT(flow.summary.density_high, 1.01 * density);
}

TEST(Poiseuille, follows_the_series_at_40_particles_across) {
    const Flow flow = flow_of("0.025 mm", {"output.every=\"0.1 s\""});
    EXPECT_LE(flow.error.at(0.1), 0.005);
    EXPECT_LE(flow.error.at(1.0), 0.005);
}

TEST(Poiseuille, plain_walls_slip) {
    const Flow flow = flow_of("0.05 mm", {"numerics.scheme=plain", "numerics.walls=plain"});
    EXPECT_GE(flow.error.at(1.0), 0.05);
    EXPECT_LE(flow.error.at(1.0), 0.30);
    EXPECT_LT(flow.summary.momentum_residual, 1e-12);
}

TEST(Poiseuille, runs_with_lucys_kernel) {
    const Flow flow = flow_of("0.05 mm", {"numerics.scheme=plain", "numerics.kernel=lucy"});
    EXPECT_LE(flow.error.at(1.0), 0.02);
}

TEST(Poiseuille, shear_stress_is_that_of_the_parabola_up_to_the_walls) {
    const Flow flow = flow_of("0.05 mm");
    const FrameGroup& fluid = *group_of(flow.kept.frames.back(), "fluid");
    const FrameField& stress = *field_of(fluid, "shear_stress");
    const double at_wall = density * acceleration * width / 2;
    EXPECT_GT(fluid.size(), 150U);
    for (std::size_t k = 0; k < fluid.size(); ++k) {
        const double y = fluid.position[3 * k + 1];
        EXPECT_NEAR(stress.values[k], density * acceleration * std::abs(width / 2 - y), 0.03 * at_wall) << "y = " << y;
    }
}

TEST(Poiseuille, probe_follows_the_speed_in_the_middle) {
    const Flow flow = flow_of("0.05 mm");
    const MeasureSeries& series = flow.summary.measures;
    ASSERT_EQ(series.names, (std::vector<std::string>{"centre_velocity_x", "centre_velocity_y"}));
    EXPECT_EQ(series.units, (std::vector<std::string>{"m/s", "m/s"}));
    const double final = speed_by_series(width / 2, 10);
    for (std::size_t row = 0; row < series.time.size(); ++row) {
        EXPECT_NEAR(series.rows[row][0], speed_by_series(width / 2, series.time[row]), 0.02 * final);
        EXPECT_NEAR(series.rows[row][1], 0, 0.001 * final);
    }
}

}  // namespace
}  // namespace dmp::tests::solver_poiseuille_tests
