// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// A liquid at rest under its own weight, with Tait's equation of state.
#include <cmath>

#include <gtest/gtest.h>

#include "models/sph/tait.hpp"
#include "tests/modules.hpp"
#include "tests/verification/record.hpp"
#include "tests/verification/run_case.hpp"

namespace dmp::tests::hydrostatic_tests {
namespace {

constexpr double g = 9.81, height = 1, width = 0.4;

/// dp/dy = -rho g with Tait's equation: (rho/rho0)^6 = C - 6 g y / c0^2, for the C that gives the fluid its mass.
class Column {
  public:
    Column(const TaitEquation& state, double mass) : state_(state) {
        double low = 0.5, high = 2;
        for (int step = 0; step < 100; ++step) {
            constant_ = 0.5 * (low + high);
            (mass_now() < mass ? low : high) = constant_;
        }
    }
    [[nodiscard]] double pressure(double y) const { return state_.pressure(density(y)); }

  private:
    [[nodiscard]] double density(double y) const {
        return state_.rest_density *
               std::pow(constant_ - 6 * g * y / (state_.sound_speed * state_.sound_speed), 1.0 / 6);
    }
    [[nodiscard]] double mass_now() const {
        constexpr int slices = 1000;
        double sum = 0;
        for (int k = 0; k < slices; ++k) sum += density(height * (k + 0.5) / slices) * height * width / slices;
        return sum;
    }
    TaitEquation state_;
    double constant_ = 1;
};

TEST(Hydrostatic, PressureIsTheWeightOfTheWater) {
    LastFrame last;
    const RunSummary run = run_case("verification/hydrostatic", {}, 0, &last);
    const Column column({run.sound_speed, 1000}, run.end.mass);
    const FrameGroup& fluid = required_group(last.frame, "fluid");
    const std::vector<float>& pressure = required_field(fluid, "pressure").values;
    double largest_error = 0, square = 0;
    for (std::size_t k = 0; k < fluid.size(); ++k) {
        const double error = (pressure[k] - column.pressure(fluid.position[3 * k + 1])) / (1000 * g * height);
        largest_error = std::max(largest_error, std::abs(error));
        square += error * error;
    }
    const double speed = std::sqrt(2 * tests::column(run.measures, "energy").back() / run.end.mass);
    Record record("hydrostatic", "50 high", run);
    record.percent("pressure after 4 s, root mean square error over rho g H",
                   std::sqrt(square / static_cast<double>(fluid.size())), 0.005);
    record.percent("pressure after 4 s, largest error of a particle over rho g H", largest_error, 0.02);
    record.percent("mean speed left, over sqrt(g H)", speed / std::sqrt(g * height), 0.005);
    EXPECT_EQ(run.end.mass, run.start.mass);
    EXPECT_EQ(run.lost, 0U);
}

}  // namespace
}  // namespace dmp::tests::hydrostatic_tests
