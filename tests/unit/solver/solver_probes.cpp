// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// What probes read beside walls.
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "small_scenes.hpp"
#include "solver/output/linear_fit.hpp"
#include "tests/modules.hpp"
#include "tests/unit/thrown.hpp"

namespace dmp::tests::solver_probes_tests {
namespace {

using testing::ElementsAre;

struct Fitted {
    double value = 0, shares = 0;
};

/// The fit of `field` at the origin from samples at `places`, nearer ones counting more.
template <class FieldOf>
Fitted fitted(const std::vector<Vec>& places, const FieldOf& field) {
    const auto weight = [](const Vec& x) { return std::exp(-x.squaredNorm()); };
    LinearFit fit;
    for (const Vec& x : places) fit.add(x, weight(x));
    fit.finish(Ranks::alone(), 1);
    Fitted found;
    for (const Vec& x : places) {
        found.value += fit.share(x, weight(x)) * field(x);
        found.shares += fit.share(x, weight(x));
    }
    return found;
}

double linear(const Vec& x) { return 7 + 2 * x[0] - 3 * x[1] + 5 * x[2]; }

TEST(LinearFit, is_exact_for_linear_functions_beside_a_wall) {
    std::vector<Vec> above;
    for (int i = -3; i <= 3; ++i)
        for (int j = 0; j < 3; ++j)
            for (int k = -3; k <= 3; ++k) above.emplace_back(i + 0.1 * j, 0.5 + j, k - 0.2 * j);
    const Fitted found = fitted(above, linear);
    EXPECT_NEAR(found.value, 7, 1e-12);
    EXPECT_NEAR(found.shares, 1, 1e-14);
}

TEST(LinearFit, takes_the_mean_along_directions_in_which_samples_do_not_spread) {
    std::vector<Vec> row;
    for (int i = -3; i <= 3; ++i) row.emplace_back(i + 0.3, 0.4, 0);
    const Fitted found = fitted(row, linear);
    EXPECT_NEAR(found.value, 7 - 3 * 0.4, 1e-12);
    EXPECT_NEAR(fitted({Vec(0.4, 0.1, 0)}, linear).value, linear(Vec(0.4, 0.1, 0)), 1e-14);
}

TEST(LinearFit, without_samples_says_so) {
    LinearFit fit;
    fit.finish(Ranks::alone(), 1);
    EXPECT_FALSE(fit.has_samples());
}

/// Probes at x = 0.2 mm and these y [m], of a channel 1 mm wide.
std::vector<Measure> probes_at(const std::vector<double>& places, FluidField field) {
    std::vector<Measure> probes;
    for (const double y : places) {
        Measure probe;
        probe.name = "at_" + std::to_string(probes.size());
        probe.kind = MeasureKind::probe;
        probe.point = Vec(0.2e-3, y, 0);
        probe.field = field;
        probes.push_back(probe);
    }
    return probes;
}

std::vector<double> last_row(SceneAndParticles made, std::vector<Measure> probes) {
    made.scene.measures = std::move(probes);
    return Simulation(made.scene, made.particles, 1).run({}).measures.rows.back();
}

const std::vector<double> beside_the_wall{0, 0.0125e-3, 0.025e-3, 0.05e-3, 0.1e-3, 0.15e-3, 0.2e-3};

TEST(ProbesBesideWalls, read_the_parabola) {
    // A mean over the fluid weighted by the kernel read 13 % of the largest speed on the wall, and 16 % for 9.75 at
    // 0.025 mm.
    const auto made = case_of("verification/poiseuille", {"particles.spacing=\"0.05 mm\""});
    const auto row = last_row(made, probes_at(beside_the_wall, FluidField::velocity));
    for (std::size_t k = 0; k < beside_the_wall.size(); ++k) {
        const double y = beside_the_wall[k] / 1e-3;
        EXPECT_NEAR(row[2 * k] / 1.25e-5, 4 * y * (1 - y), 0.01) << "y = " << y;
        EXPECT_NEAR(row[2 * k + 1] / 1.25e-5, 0, 0.001) << "y = " << y;
    }
}

TEST(ProbesBesideWalls, read_the_speed_of_a_lid_on_it) {
    for (const std::string scheme : {"corrected", "plain"}) {
        const auto made = case_of("verification/couette", {"numerics.scheme=" + scheme, "run.duration=\"2 s\""});
        const auto row = last_row(made, probes_at({1e-3, 0.975e-3, 0.9e-3, 0}, FluidField::velocity));
        const std::array<double, 4> expected{1, 0.975, 0.9, 0};
        for (std::size_t k = 0; k < expected.size(); ++k)
            EXPECT_NEAR(row[2 * k] / 1.25e-5, expected[k], 0.01) << scheme << ", probe " << k;
    }
}

TEST(Line, reads_what_probes_read_at_its_points) {
    auto made = case_of("verification/poiseuille", {"particles.spacing=\"0.1 mm\"", "run.duration=\"0.1 s\""});
    std::vector<Measure> measures = probes_at({-0.5e-3, 0, 0.5e-3, 1e-3}, FluidField::velocity);
    Measure line = measures[0];
    measures.erase(measures.begin());
    line.name = std::string("profile");
    line.kind = MeasureKind::line;
    line.from = Vec(0.2e-3, -0.5e-3, 0);
    line.to = Vec(0.2e-3, 1e-3, 0);
    line.points = 4;
    measures.push_back(line);
    made.scene.measures = measures;
    const MeasureSeries series = Simulation(made.scene, made.particles, 1).run({}).measures;
    ASSERT_EQ(series.names.size(), 14U);
    EXPECT_EQ(series.names[6], "profile_1_x");
    EXPECT_EQ(series.names[13], "profile_4_y");
    const auto& row = series.rows.back();
    EXPECT_TRUE(std::isnan(row[6])) << "it starts in the wall";
    for (std::size_t k = 0; k < 6; ++k) EXPECT_NEAR(row[8 + k], row[k], 1e-15) << k;
}

TEST(ProbesBesideWalls, read_the_pressure_at_bottom_and_top) {
    auto made = case_of("verification/hydrostatic", {"run.duration=\"1 s\""});
    std::vector<Measure> probes = probes_at({0, 0.005, 0.02, 0.5, 0.98, 1}, FluidField::pressure);
    for (Measure& probe : probes) probe.point.value[0] = 0.2;
    const auto row = last_row(made, probes);
    for (std::size_t k = 0; k < probes.size(); ++k) {
        const double height = probes[k].point.value[1];
        EXPECT_NEAR(row[k] / 9810, 1 - height, 0.01) << "y = " << height;
    }
}

/// -cos a sin b = (sin(a - b) - sin(a + b)) / 2: two waves, which decay with 2 nu k^2.
TEST(Mode, of_taylor_green_vortices_decays_as_it_must) {
    auto made = case_of("verification/taylor_green", {"particles.spacing=\"0.03125 m\"", "run.duration=\"0.5 s\""});
    Measure mode;
    mode.name = std::string("wave");
    mode.kind = MeasureKind::mode;
    mode.waves = std::array<int, 3>{1, 1, 0};
    Measure other = mode;
    other.name = std::string("none");
    other.waves = std::array<int, 3>{2, 0, 0};
    made.scene.measures = {mode, other};
    const MeasureSeries series = Simulation(made.scene, made.particles, 1).run({}).measures;
    EXPECT_THAT(series.names, ElementsAre("wave_x_cos", "wave_x_sin", "wave_y_cos", "wave_y_sin", "none_x_cos",
                                          "none_x_sin", "none_y_cos", "none_y_sin"));
    const double decay = std::exp(-8 * std::pow(std::numbers::pi, 2) * 0.01 * 0.5);
    const auto expect = [](const std::vector<double>& row, double amplitude, double error) {
        const std::array<double, 4> factors{0, -amplitude, 0, amplitude};
        for (std::size_t k = 0; k < row.size(); ++k)
            EXPECT_NEAR(row[k], k < factors.size() ? factors[k] : 0, error) << "column " << k;
    };
    expect(series.rows.front(), 0.5, 1e-9);
    expect(series.rows.back(), 0.5 * decay, 0.005);
}

TEST(Mode, of_waves_as_short_as_particles_is_refused) {
    auto made = case_of("verification/taylor_green", {"particles.spacing=\"0.03125 m\""});
    Measure mode;
    mode.name = std::string("wave");
    mode.kind = MeasureKind::mode;
    mode.waves = std::array<int, 3>{0, 9, 0};
    made.scene.measures = {mode};
    EXPECT_EQ(text_thrown<InputError>([&] { (void)Simulation(made.scene, made.particles, 1); }),
              "the waves of measure 'wave' are shorter than 4 spacings: particles cannot show them\n"
              "  give fewer waves, or a smaller particles.spacing");
}

}  // namespace
}  // namespace dmp::tests::solver_probes_tests
