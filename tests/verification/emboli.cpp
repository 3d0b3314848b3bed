// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// The coarse form of cases/double_vein_valve/published.toml: a small disc passes the valve, one as wide as the channel
// does not.
#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/modules.hpp"
#include "tests/verification/record.hpp"
#include "tests/verification/run_case.hpp"

namespace dmp::tests::emboli_tests {
namespace {

constexpr double tips = -10.46e-3, roots = -20e-3;  // of valve 1: x [m]
constexpr double period = 3;                        // of the squeezing [s]

RunSummary with_disc(double diameter, double until) {
    return run_case("double_vein_valve/published_scene.toml",
                    {set_to("geometry.parameters.embolus_length", diameter, "m"),
                     set_to("geometry.parameters.embolus_height", diameter, "m")},
                    until);
}

TEST(Emboli, SmallDiscPassesTheValve) {
    constexpr double diameter = 2.6e-3;
    const RunSummary run = with_disc(diameter, period);
    Record record("double_vein_valve", "disc of 2.6 mm, 0.8 mm", run);
    const auto x = column(run.measures, "embolus_x");
    record.at_least("its hind end beyond the tips after a cycle", 1e3 * (x.back() - diameter / 2 - tips), 0, "mm");
    record.percent("change of its shape",
                   std::max(largest(column(run.measures, "embolus_largest_stretch")) - 1,
                            1 - smallest(column(run.measures, "embolus_least_stretch"))),
                   0.01);
    const double peak = largest(column(run.measures, "velocity_1_x"));
    record.at_most("peak velocity before valve 1, off 0.035 m/s", peak - 0.035, 0.01, "m/s");
    record.at_least("net volume through valve 1", 1e4 * period * mean(column(run.measures, "flux_1")), 1, "cm^2");
}

TEST(Emboli, DiscAsWideAsTheChannelIsHeldAtTheValve) {
    const RunSummary run = with_disc(7.8e-3, 2 * period);
    Record record("double_vein_valve", "disc of 7.8 mm, 0.8 mm", run);
    const auto x = column(run.measures, "embolus_x");
    record.at_least("it comes near the roots of the valve", 1e3 * (largest(x) - roots), -2, "mm");
    record.at_most("and no further", 1e3 * (largest(x) - roots), 3, "mm");
}

}  // namespace
}  // namespace dmp::tests::emboli_tests
