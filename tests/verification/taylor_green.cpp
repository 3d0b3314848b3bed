// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Decaying vortices in a periodic square (Taylor & Green 1937): the shape stays, the speed falls as exp(-8 pi^2 nu t).
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/modules.hpp"
#include "tests/verification/record.hpp"
#include "tests/verification/run_case.hpp"

namespace dmp::tests::taylor_green_tests {
namespace {

constexpr double pi = std::numbers::pi, viscosity = 0.01;

double decay(double t) { return std::exp(-8 * pi * pi * viscosity * t); }

double exact_speed(double x, double y, double t) {
    return decay(t) *
           std::hypot(std::cos(2 * pi * x) * std::sin(2 * pi * y), std::sin(2 * pi * x) * std::cos(2 * pi * y));
}

/// Mean difference of the speeds over the mean speed, at the particles.
double speed_error(const Frame& frame) {
    const FrameGroup& fluid = required_group(frame, "fluid");
    const std::vector<float>& velocity = required_field(fluid, "velocity").values;
    double difference = 0, speed = 0;
    for (std::size_t k = 0; k < fluid.size(); ++k) {
        const double exact = exact_speed(fluid.position[3 * k], fluid.position[3 * k + 1], frame.time);
        difference += std::abs(std::hypot(velocity[3 * k], velocity[3 * k + 1]) - exact);
        speed += exact;
    }
    return difference / speed;
}

struct Setting {
    std::string name, spacing, disorder;
    double energy_bound, speed_bound;
    std::vector<std::string> more{};
};

class TaylorGreen : public testing::TestWithParam<Setting> {};

TEST_P(TaylorGreen, DecaysAsItShould) {
    std::vector<std::string> overrides{"particles.spacing=" + GetParam().spacing,
                                       "particles.disorder=" + GetParam().disorder};
    overrides.insert(overrides.end(), GetParam().more.begin(), GetParam().more.end());
    LastFrame last;
    const RunSummary run = run_case("verification/taylor_green", overrides, 1, &last);
    const double energy = column(run.measures, "energy").back() / (0.25 * decay(1) * decay(1)) - 1;
    Record record("taylor_green", GetParam().name, run);
    record.percent("kinetic energy at t = 1 s", energy, GetParam().energy_bound);
    record.percent("speed at t = 1 s (L1)", speed_error(last.frame), GetParam().speed_bound);
    EXPECT_EQ(run.end.mass, run.start.mass);
}

/// A wider kernel and stronger shifting: half of the error, for 1.3 times the time.
const std::vector<std::string> plain{"numerics.scheme=plain"};
const std::vector<std::string> fine{"numerics.scheme=plain", "numerics.support=4", "numerics.shifting=6"};

INSTANTIATE_TEST_SUITE_P(
    PlainScheme, TaylorGreen,
    testing::Values(Setting{"50 x 50, lattice, plain", "0.02 m", "0", 0.02, 0.01, plain},
                    Setting{"50 x 50, disordered, plain", "0.02 m", "0.2", 0.02, 0.01, plain},
                    Setting{"100 x 100, lattice, plain", "0.01 m", "0", 0.01, 0.005, plain},
                    Setting{"100 x 100, disordered, plain", "0.01 m", "0.2", 0.01, 0.005, plain},
                    Setting{"50 x 50, lattice, support 4, shifting 6, plain", "0.02 m", "0", 0.01, 0.005, fine},
                    Setting{"50 x 50, disordered, support 4, shifting 6, plain", "0.02 m", "0.2", 0.01, 0.005, fine},
                    Setting{"100 x 100, lattice, support 4, shifting 6, plain", "0.01 m", "0", 0.005, 0.0025, fine},
                    Setting{"100 x 100, disordered, support 4, shifting 6, plain", "0.01 m", "0.2", 0.005, 0.0025,
                            fine}));

INSTANTIATE_TEST_SUITE_P(
    Starts, TaylorGreen,
    testing::Values(
        Setting{"50 x 50, lattice", "0.02 m", "0", 0.005, 0.0025},
        Setting{"50 x 50, disordered", "0.02 m", "0.2", 0.007, 0.004},
        Setting{"100 x 100, lattice", "0.01 m", "0", 0.002, 0.001},
        Setting{"100 x 100, disordered", "0.01 m", "0.2", 0.002, 0.0015},
        Setting{"50 x 50, disordered, c0 = 20 U", "0.02 m", "0.2", 0.008, 0.004, {"numerics.sound_speed=20 m/s"}},
        Setting{"50 x 50, disordered, c0 = 40 U", "0.02 m", "0.2", 0.01, 0.005, {"numerics.sound_speed=40 m/s"}},
        Setting{"50 x 50, disordered, level 10 rho U^2",
                "0.02 m",
                "0.2",
                0.007,
                0.004,
                {"numerics.background_pressure=10 Pa", "numerics.sound_speed=10 m/s"}},
        Setting{"50 x 50, disordered, level 100 rho U^2",
                "0.02 m",
                "0.2",
                0.007,
                0.004,
                {"numerics.background_pressure=100 Pa", "numerics.sound_speed=10 m/s"}}));

}  // namespace
}  // namespace dmp::tests::taylor_green_tests
