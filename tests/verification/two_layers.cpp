// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// cases/verification/two_layers: the steady profile of two fluids that flow side by side.
#include <cmath>

#include <gtest/gtest.h>

#include "tests/modules.hpp"
#include "tests/verification/record.hpp"
#include "tests/verification/run_case.hpp"

namespace dmp::tests::two_layers_tests {
namespace {

constexpr double height = 1e-3, interface = 0.5e-3, below = 1e-3, above = 3e-3, drive = 100;  // [m], [Pa s], [Pa/m]

/// The shear stress is continuous and falls by the drive; so is the velocity, which is 0 at the walls.
double steady(double y) {
    const double h = interface, upper = height - h, h2 = h * h;
    const double at_wall = drive / 2 * (h2 / below + (height * height - h2) / above) / (h / below + upper / above);
    const auto lower_layer = [&](double z) { return (at_wall * z - drive * z * z / 2) / below; };
    if (y <= h) return lower_layer(y);
    return lower_layer(h) + (at_wall * (y - h) - drive * (y * y - h2) / 2) / above;
}

void expect_steady_profile(const std::string& setting, const std::vector<std::string>& overrides, double bound) {
    LastFrame last;
    const RunSummary run = run_case("verification/two_layers", overrides, 1.5, &last);
    const FrameGroup& fluid = required_group(last.frame, "fluid");
    const std::vector<float>& velocity = required_field(fluid, "velocity").values;
    double square = 0, reference = 0;
    for (std::size_t k = 0; k < fluid.size(); ++k) {
        const double exact = steady(fluid.position[3 * k + 1]);
        square += std::pow(velocity[3 * k] - exact, 2) + std::pow(velocity[3 * k + 1], 2);
        reference += exact * exact;
    }
    Record("two_layers", setting, run).percent("velocity at 1.5 s (L2)", std::sqrt(square / reference), bound);
    EXPECT_LT(run.momentum_residual, 1e-11);
}

TEST(TwoLayers, FlowWithTheirSteadyProfile) {
    expect_steady_profile("20 across", {}, 0.005);
    expect_steady_profile("40 across", {"particles.spacing=0.025 mm"}, 0.002);
}

}  // namespace
}  // namespace dmp::tests::two_layers_tests
