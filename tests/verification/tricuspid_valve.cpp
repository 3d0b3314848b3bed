// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Three shells in a tube, through one cycle of a drive to and fro: they part, and close again.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "tests/modules.hpp"
#include "tests/verification/record.hpp"
#include "tests/verification/run_case.hpp"

namespace dmp::tests::tricuspid_valve_tests {
namespace {

constexpr double cycle = 0.4, spacing = 0.625e-3;
constexpr double closed_from = 0.24;  // blood has turned at 0.21 s and taken the leaflets along

/// Follows the three places that were drawn nearest to the axis.
class Tips : public FrameSink {
  public:
    void write(const Frame& frame) override {
        const FrameGroup& nodes = required_group(frame, "solid");
        const auto from_axis = [&](std::size_t node) {
            return std::hypot(nodes.position[3 * node + 1], nodes.position[3 * node + 2]);
        };
        if (time.empty()) {
            std::array<double, 3> least;
            least.fill(std::numeric_limits<double>::infinity());
            for (std::size_t node = 0; node < nodes.size(); ++node) {
                // The first leaflet is in the third about +y.
                const double turned =
                    std::atan2(nodes.position[3 * node + 2], nodes.position[3 * node + 1]) / (2 * std::numbers::pi / 3);
                const auto leaflet = static_cast<std::size_t>((static_cast<int>(std::lround(turned)) + 3) % 3);
                if (from_axis(node) >= least[leaflet]) continue;
                least[leaflet] = from_axis(node);
                tips_[leaflet] = node;
            }
        }
        const std::array<double, 3> now{from_axis(tips_[0]), from_axis(tips_[1]), from_axis(tips_[2])};
        time.push_back(frame.time);
        nearest.push_back(*std::ranges::min_element(now));
        farthest.push_back(*std::ranges::max_element(now));
    }
    std::vector<double> time, nearest, farthest;  ///< of the three from the axis [m]

  private:
    std::array<std::size_t, 3> tips_{};
};

TEST(TricuspidValve, OpensAndClosesOnce) {
    Tips tips;
    const RunSummary run = run_case("tricuspid_valve", {}, cycle, &tips);
    double widest = 0, sum_when_closed = 0, frames_when_closed = 0;
    for (std::size_t k = 0; k < tips.time.size(); ++k) {
        widest = std::max(widest, tips.nearest[k]);
        if (tips.time[k] <= closed_from) continue;
        sum_when_closed += tips.farthest[k];
        ++frames_when_closed;
    }
    const MeasureSeries& series = run.measures;
    const std::vector<double> flux = column(series, "flux");
    double forward = 0, net = 0, while_closed = 0;
    for (std::size_t k = 0; k + 1 < flux.size(); ++k) {
        const double volume = (series.time[k + 1] - series.time[k]) * (flux[k] + flux[k + 1]) / 2;
        net += volume;
        forward += std::max(0.0, volume);
        if (series.time[k] > closed_from) while_closed += volume;
    }
    Record record("tricuspid_valve", "16 across, draft", run);
    record.at_least("tips open to, all three, over their distance from the axis at the start", widest / tips.nearest[0],
                    2);
    // A tip that goes first may be pushed past the axis for a moment: the mean over time.
    record.at_most("farthest tip from the axis while closed, in spacings",
                   sum_when_closed / frames_when_closed / spacing, 1);
    record.percent("volume through the closed valve over that of the forward stroke", while_closed / forward, 0.1);
    record.at_least("net over forward volume", net / forward, 0.7);
    EXPECT_EQ(run.lost, 0U);
    EXPECT_LT(run.momentum_residual, 1e-9);
}

}  // namespace
}  // namespace dmp::tests::tricuspid_valve_tests
