// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cstddef>

#include <gtest/gtest.h>

#include "tests/modules.hpp"
#include "tests/verification/record.hpp"
#include "tests/verification/run_case.hpp"

namespace dmp::tests::vein_valve_cycles_tests {
namespace {

constexpr double period = 4;            // of the drive [s]
constexpr double channel_width = 8e-3;  // [m]
constexpr double spacing = 0.2e-3;      // [m]

struct Strokes {
    double forward = 0, net = 0;  // volumes through the inlet in one cycle [m^3]
};

Strokes second_cycle(const MeasureSeries& series) {
    const auto flux = between(series, "inlet_flux", period, 2 * period);
    const double dt = series.time[1] - series.time[0];
    Strokes strokes;
    for (std::size_t k = 0; k + 1 < flux.size(); ++k) {
        const double mean = 0.5 * (flux[k] + flux[k + 1]);
        strokes.net += dt * mean;
        strokes.forward += dt * std::max(0.0, mean);
    }
    return strokes;
}

TEST(VeinValve, OpensClosesAndPumps) {
    const RunSummary run = run_case("vein_valve", {}, 2 * period);
    const MeasureSeries& series = run.measures;

    Record record("vein_valve", "second of two cycles", run);
    const double peak = largest(between(series, "inlet_velocity_x", period, 2 * period));
    record.percent("largest velocity on the inlet's centre line, off 0.07 m/s", peak / 0.07 - 1, 0.1);

    const auto gaps = between(series, "tip_gap", period, 2 * period);
    record.at_least("widest gap of the tips, of the channel", 100 * largest(gaps) / channel_width, 40, "%");
    record.at_most("narrowest, in spacings", smallest(gaps) / spacing, 3);

    const Strokes strokes = second_cycle(series);
    record.at_least("net over forward volume", 100 * strokes.net / strokes.forward, 30, "%");

    double open = 0, closing = 0;
    const auto gap = column(series, "tip_gap");
    const auto low = column(series, "density_low"), high = column(series, "density_high");
    for (std::size_t k = 0; k < gap.size(); ++k) {
        double& off = gap[k] > 0.4 * channel_width ? open : closing;
        off = std::max({off, 1 - low[k], high[k] - 1});
    }
    record.percent("density off its rest value, valve open", open, 0.02);
    record.percent("density off its rest value, else", closing, 0.04);
    EXPECT_EQ(run.lost, 0U);
    EXPECT_NEAR(run.end.mass, run.start.mass, 1e-12 * run.start.mass);
    EXPECT_LT(run.momentum_residual, 1e-9);
}

TEST(VeinValve, WithoutLeafletsHardlyAnythingIsPumped) {
    // A cosine starts at the flow's own phase, so no mean flow is left from the start.
    const RunSummary run = run_case(
        "vein_valve",
        {"part.leaflets.enabled=false", "flow.pressure_gradient=[\"-77.09 Pa/m * cos(2*pi*t / 4 s)\", 0]"}, 2 * period);
    const Strokes strokes = second_cycle(run.measures);
    Record("vein_valve", "without leaflets", run)
        .percent("net over forward volume", strokes.net / strokes.forward, 0.1);
}

}  // namespace
}  // namespace dmp::tests::vein_valve_cycles_tests
