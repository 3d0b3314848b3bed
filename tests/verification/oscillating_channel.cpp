// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// A pressure gradient that oscillates between two plates, from rest (Womersley 1955, plane).
#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/modules.hpp"
#include "tests/verification/record.hpp"
#include "tests/verification/run_case.hpp"

namespace dmp::tests::oscillating_channel_tests {
namespace {

constexpr double pi = std::numbers::pi, width = 20e-3, nu = 1e-6, acceleration = 0.01, omega = 1;

/// The series of modes that a drive by cos(omega t) moves from rest.
double velocity_at(double y, double t) {
    double u = 0;
    for (int n = 1; n < 400; n += 2) {
        const double k = n * pi / width, decay = nu * k * k;
        const double follows = decay * std::cos(omega * t) + omega * std::sin(omega * t) - decay * std::exp(-decay * t);
        u += 4 / (n * pi) * acceleration * std::sin(k * y) * follows / (decay * decay + omega * omega);
    }
    return u;
}

/// Relative errors (L2) over all frames from 1 s on, of all particles and of those within a tenth of the half width
/// of a plate.
class Errors : public FrameSink {
  public:
    void write(const Frame& frame) override {
        if (frame.time < 1) return;
        const FrameGroup& fluid = required_group(frame, "fluid");
        const std::vector<float>& velocity = required_field(fluid, "velocity").values;
        for (std::size_t k = 0; k < fluid.size(); ++k) {
            const double y = fluid.position[3 * k + 1], exact = velocity_at(y, frame.time);
            const double square = std::pow(velocity[3 * k] - exact, 2) + std::pow(velocity[3 * k + 1], 2);
            all_.add(square, exact);
            if (std::min(y, width - y) < width / 20) near_walls_.add(square, exact);
        }
    }
    [[nodiscard]] double of_all() const { return all_.relative(); }
    [[nodiscard]] double near_walls() const { return near_walls_.relative(); }

  private:
    struct Sum {
        double square = 0, reference = 0;
        void add(double error, double exact) {
            square += error;
            reference += exact * exact;
        }
        [[nodiscard]] double relative() const { return std::sqrt(square / reference); }
    };
    Sum all_, near_walls_;
};

TEST(OscillatingChannel, FollowsItsSeriesFromRest) {
    Errors errors;
    const RunSummary run = run_case("verification/oscillating_channel", {}, 12.5, &errors);
    Record record("oscillating_channel", "80 across, alpha 10", run);
    record.percent("velocity (L2)", errors.of_all(), 0.0025);
    record.percent("velocity within 1 mm of the plates (L2)", errors.near_walls(), 0.01);
    EXPECT_EQ(run.lost, 0U);
}

}  // namespace
}  // namespace dmp::tests::oscillating_channel_tests
