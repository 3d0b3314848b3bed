// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Start-up in a round pipe (Szymanski 1932), with r in radii and t in radii^2 over nu.
#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "tests/modules.hpp"
#include "tests/verification/record.hpp"
#include "tests/verification/run_case.hpp"

namespace dmp::tests::pipe_tests {
namespace {

constexpr double radius = 5e-4, viscosity = 1e-6, speed = 1.25e-5;  // the speed on the axis at last

/// Over the final speed on the axis.
double startup(double r, double t) {
    constexpr std::array zeros{2.404825557695773,  5.520078110286311, 8.653727912911013,
                               11.791534439014281, 14.93091770848779, 18.071063967910924};
    double u = 1 - r * r;
    for (const double zero : zeros)
        u -= 8 * std::cyl_bessel_j(0, zero * r) / (std::pow(zero, 3) * std::cyl_bessel_j(1, zero)) *
             std::exp(-zero * zero * t);
    return u;
}

/// Keeps the relative L2 errors of the velocity: the largest of all frames but the first, and the last.
class ProfileError : public FrameSink {
  public:
    void write(const Frame& frame) override {
        if (frame.time == 0) return;
        const FrameGroup& fluid = required_group(frame, "fluid");
        const std::vector<float>& velocity = required_field(fluid, "velocity").values;
        double square = 0, reference = 0;
        for (std::size_t k = 0; k < fluid.size(); ++k) {
            const double r = std::hypot(fluid.position[3 * k + 1], fluid.position[3 * k + 2]) / radius;
            const double exact = speed * startup(r, frame.time * viscosity / (radius * radius));
            square += std::pow(velocity[3 * k] - exact, 2) + std::pow(velocity[3 * k + 1], 2) +
                      std::pow(velocity[3 * k + 2], 2);
            reference += exact * exact;
        }
        last = std::sqrt(square / reference);
        largest = std::max(largest, last);
    }
    double largest = 0, last = 0;
};

struct Setting {
    std::string name;
    std::vector<std::string> overrides;
    double bound;
};

class Pipe : public testing::TestWithParam<Setting> {};

TEST_P(Pipe, FollowsItsSeriesFromRest) {
    std::vector<std::string> overrides{"output.every=0.02 s"};
    for (const std::string& more : GetParam().overrides) overrides.push_back(more);
    ProfileError error;
    const RunSummary run = run_case("verification/pipe", overrides, 0.5, &error);
    Record record("pipe", GetParam().name, run);
    record.percent("velocity, largest L2 error from nu t / R^2 = 0.08 to 2", error.largest, GetParam().bound);
    record.percent("velocity, L2 error at nu t / R^2 = 2", error.last, GetParam().bound);
    record.at_most("momentum that came from nowhere, over all impulses", run.momentum_residual, 1e-12);
    EXPECT_EQ(run.end.mass, run.start.mass);
    EXPECT_EQ(run.lost, 0U);
}

INSTANTIATE_TEST_SUITE_P(
    Start, Pipe,
    // Half a per cent of the radius is a per cent of the speed: a lattice does not follow a round wall closely enough.
    testing::Values(Setting{"20 across, relaxed from a cubic lattice", {"particles.fill=relaxed"}, 0.01},
                    Setting{
                        "20 across, relaxed from fcc", {"particles.fill=relaxed", "particles.arrangement=fcc"}, 0.015},
                    Setting{"20 across, sampled", {"particles.fill=sampled"}, 0.01},
                    Setting{"20 across, cubic lattice", {}, 0.03}));

}  // namespace
}  // namespace dmp::tests::pipe_tests
