// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Walls that cut the lattice of the particles: flow between coaxial cylinders (Taylor 1923), and through a square array
// of cylinders (Sangani & Acrivos 1982).
#include <cmath>

#include <gtest/gtest.h>

#include "tests/modules.hpp"
#include "tests/verification/record.hpp"
#include "tests/verification/run_case.hpp"

namespace dmp::tests::curved_walls_tests {
namespace {

/// L2 error of the velocity, where the fluid turns with turning(r^2) [rad/s] around the axis.
template <class Turning>
double error_of_turning(const Frame& frame, const Turning& turning_at) {
    const FrameGroup& fluid = required_group(frame, "fluid");
    const std::vector<float>& velocity = required_field(fluid, "velocity").values;
    double square = 0, reference = 0;
    for (std::size_t k = 0; k < fluid.size(); ++k) {
        const double x = fluid.position[3 * k], y = fluid.position[3 * k + 1];
        const double turning = turning_at(x * x + y * y);
        square += std::pow(velocity[3 * k] + turning * y, 2) + std::pow(velocity[3 * k + 1] - turning * x, 2);
        reference += turning * turning * (x * x + y * y);
    }
    return std::sqrt(square / reference);
}

/// Between r = a, which turns with 1 rad/s, and r = b, which rests: v = A r + B / r around the axis.
double taylor_couette_error(const Frame& frame) {
    constexpr double a = 0.5e-3, b = 1e-3;
    return error_of_turning(frame, [](double square) { return a * a / (b * b - a * a) * (b * b / square - 1); });
}

TEST(TaylorCouette, TurnsAsBetweenRoundWalls) {
    LastFrame last;
    const RunSummary sliding = run_case("verification/taylor_couette", {}, 0.2, &last);
    Record("taylor_couette", "20 across, the inner surface slides", sliding)
        .percent("velocity (L2)", taylor_couette_error(last.frame), 0.005);
    const RunSummary turning =
        run_case("verification/taylor_couette",
                 {"part.inner_cylinder.surface_velocity=[0, 0]", "part.inner_cylinder.spin=1 rad/s"}, 0.2, &last);
    Record("taylor_couette", "20 across, the inner cylinder turns", turning)
        .percent("velocity (L2)", taylor_couette_error(last.frame), 0.005);
    const RunSummary both = run_case("verification/taylor_couette",
                                     {"part.inner_cylinder.surface_velocity=[0, 0]", "part.inner_cylinder.spin=1 rad/s",
                                      "part.outer_cylinder.spin=1 rad/s", "flow.largest_speed=1 mm/s"},
                                     0.2, &last);
    Record("taylor_couette", "20 across, both cylinders turn as one", both)
        .percent("velocity (L2)", error_of_turning(last.frame, [](double) { return 1.0; }), 0.001);
    for (const RunSummary& run : {sliding, turning, both}) EXPECT_EQ(run.lost, 0U);
}

/// The mean velocity of slow flow through a square array, in units of G L^2 / mu, is one over the drag that Sangani &
/// Acrivos give.
void expect_permeability(const std::string& setting, double radius_mm, double drag, double bound) {
    constexpr double side = 1e-3, viscosity = 1e-3, gradient = 1;
    const RunSummary run =
        run_case("verification/cylinders",
                 {"geometry.parameters={side=\"1 mm\", radius=\"" + quantity(radius_mm, "mm") + "\"}"}, 0.3);
    const double mean = column(run.measures, "flux").back() / side;
    Record("cylinders", setting, run)
        .percent("mean velocity", mean * drag * viscosity / (gradient * side * side) - 1, bound);
    EXPECT_EQ(run.lost, 0U);
}

TEST(Cylinders, LetThroughWhatSanganiAndAcrivosSay) {
    expect_permeability("a fifth of the area, 40 across", 0.252313, 51.53, 0.02);
    expect_permeability("two fifths of the area, 40 across", 0.356825, 217.89, 0.02);
}

}  // namespace
}  // namespace dmp::tests::curved_walls_tests
