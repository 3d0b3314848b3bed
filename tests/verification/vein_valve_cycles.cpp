// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <gtest/gtest.h>

#include "tests/verification/run_case.hpp"

namespace dmp {
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

    const double peak = largest(between(series, "inlet_velocity_x", period, 2 * period));
    EXPECT_NEAR(peak, 0.07, 0.007);

    EXPECT_GT(largest(between(series, "tip_gap", period, 2 * period)), 0.4 * channel_width);
    EXPECT_LT(smallest(between(series, "tip_gap", period, 2 * period)), 3 * spacing);

    const Strokes strokes = second_cycle(series);
    RecordProperty("net_over_forward", std::to_string(strokes.net / strokes.forward));
    EXPECT_GT(strokes.net, 0.3 * strokes.forward);

    const auto gap = column(series, "tip_gap");
    const auto low = column(series, "density_low"), high = column(series, "density_high");
    for (std::size_t k = 0; k < gap.size(); ++k) {
        const bool open = gap[k] > 0.4 * channel_width;
        EXPECT_GT(low[k], open ? 0.98 : 0.96) << "at t = " << series.time[k];
        EXPECT_LT(high[k], open ? 1.02 : 1.04) << "at t = " << series.time[k];
    }
    EXPECT_EQ(run.lost, 0U);
    EXPECT_NEAR(run.end.mass, run.start.mass, 1e-12 * run.start.mass);
    EXPECT_LT(run.momentum_residual, 1e-9);
}

TEST(VeinValve, WithoutLeafletsHardlyAnythingIsPumped) {
    // A cosine starts at the flow's own phase, so no mean flow is left from the start.
    const RunSummary run = run_case(
        "vein_valve", {"part.leaflets.enabled=false", "flow.acceleration=[\"0.073 m/s^2 * cos(2*pi*t / 4 s)\", 0]"},
        2 * period);
    const Strokes strokes = second_cycle(run.measures);
    EXPECT_LT(std::abs(strokes.net), 0.1 * strokes.forward);
}

}  // namespace
}  // namespace dmp
