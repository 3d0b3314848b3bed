// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Two liquids of unlike density at rest in a closed tank: the hydrostatic pressure of each.
#include <cmath>

#include <gtest/gtest.h>

#include "tests/modules.hpp"
#include "tests/verification/record.hpp"
#include "tests/verification/run_case.hpp"

namespace dmp::tests::two_liquids_tests {
namespace {

constexpr double half_height = 0.5, heavy = 1000, g = 9.81;

/// Root mean square error of the pressure, but for its mean, over its largest value.
double pressure_error(const Frame& frame, double light) {
    const FrameGroup& fluid = required_group(frame, "fluid");
    const std::vector<float>& pressure = required_field(fluid, "pressure").values;
    double sum = 0, square = 0;
    for (std::size_t k = 0; k < fluid.size(); ++k) {
        const double above = half_height - fluid.position[3 * k + 1];  // of the interface, downwards
        const double error = pressure[k] - g * above * (above > 0 ? heavy : light);
        sum += error;
        square += error * error;
    }
    const auto count = static_cast<double>(fluid.size());
    return std::sqrt(square / count - std::pow(sum / count, 2)) / ((heavy + light) * g * half_height);
}

void expect_hydrostatic_pressure(const std::string& setting, double light, double bound) {
    LastFrame last;
    const RunSummary run =
        run_case("verification/two_liquids", {set_to("part.light.density", light, "kg/m^3")}, 4, &last);
    Record record("two_liquids", setting, run);
    record.percent("pressure, root mean square error over the pressure at the bottom",
                   pressure_error(last.frame, light), bound);
    record.at_most("largest speed at the end, over sqrt(g H)", column(run.measures, "speed").back() / std::sqrt(g),
                   0.01);
    EXPECT_EQ(run.lost, 0U);
}

TEST(TwoLiquids, AtRestHaveTheirHydrostaticPressure) {
    expect_hydrostatic_pressure("1.5 times as dense", heavy / 1.5, 0.003);
    expect_hydrostatic_pressure("10 times as dense", heavy / 10, 0.01);
}

}  // namespace
}  // namespace dmp::tests::two_liquids_tests
