// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Start-up between two plates (series of Morris, Fox & Zhu 1997), with y in widths and t in widths^2 over nu.
#include <cmath>
#include <functional>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/modules.hpp"
#include "tests/verification/record.hpp"
#include "tests/verification/run_case.hpp"

namespace dmp::tests::channel_flows_tests {
namespace {

constexpr double pi = std::numbers::pi, width = 1e-3, viscosity = 1e-6;

/// Driven by a body force, over the final speed in the middle.
double poiseuille(double y, double t) {
    double u = 4 * y * (1 - y);
    for (int n = 0; n < 60; ++n) {
        const double k = (2 * n + 1) * pi;
        u -= 32 / (k * k * k) * std::sin(k * y) * std::exp(-k * k * t);
    }
    return u;
}

/// Dragged along by the upper plate, over that plate's speed.
double couette(double y, double t) {
    double u = y;
    for (int n = 1; n < 120; ++n)
        u += (n % 2 == 0 ? 2 : -2) / (n * pi) * std::sin(n * pi * y) * std::exp(-n * n * pi * pi * t);
    return u;
}

/// Keeps the largest relative L2 error of the velocity over all frames but the first.
class ProfileError : public FrameSink {
  public:
    ProfileError(std::function<double(double, double)> series, double speed)
        : series_(std::move(series)), speed_(speed) {}

    void write(const Frame& frame) override {
        if (frame.time == 0) return;
        const FrameGroup& fluid = required_group(frame, "fluid");
        const std::vector<float>& velocity = required_field(fluid, "velocity").values;
        double square = 0, reference = 0;
        for (std::size_t k = 0; k < fluid.size(); ++k) {
            const double exact =
                speed_ * series_(fluid.position[3 * k + 1] / width, frame.time * viscosity / (width * width));
            square += std::pow(velocity[3 * k] - exact, 2) + std::pow(velocity[3 * k + 1], 2);
            reference += exact * exact;
        }
        largest = std::max(largest, std::sqrt(square / reference));
    }
    double largest = 0;

  private:
    std::function<double(double, double)> series_;
    double speed_;
};

struct Setting {
    std::string name, case_name, spacing;
    double speed, bound;
    std::vector<std::string> more{};
};

std::string text_of(double speed) { return std::to_string(speed * 1e6) + " um/s"; }

class ChannelFlow : public testing::TestWithParam<Setting> {};

TEST_P(ChannelFlow, FollowsItsSeriesFromRest) {
    const Setting& setting = GetParam();
    std::vector<std::string> overrides{"particles.spacing=" + setting.spacing, "output.every=0.05 s",
                                       "flow.largest_speed=" + text_of(setting.speed)};
    const bool is_couette = setting.case_name == "couette";
    if (is_couette)
        overrides.push_back("part.lid.surface_velocity=[\"" + text_of(setting.speed) + "\", 0]");
    else
        // The density is 1000 kg/m^3.
        overrides.push_back("flow.pressure_gradient=[\"" +
                            std::to_string(-8 * viscosity * setting.speed / (width * width) * 1e6) + " mPa/m\", 0]");
    for (const std::string& more : setting.more) overrides.push_back(more);
    ProfileError error(is_couette ? couette : poiseuille, setting.speed);
    const RunSummary run = run_case("verification/" + setting.case_name, overrides, 1, &error);

    Record record(setting.case_name, setting.name, run);
    record.percent("velocity, largest L2 error from nu t / L^2 = 0.05 to 1", error.largest, setting.bound);
    record.at_most("momentum that came from nowhere, over all impulses", run.momentum_residual, 1e-12);
    EXPECT_EQ(run.end.mass, run.start.mass);
    EXPECT_EQ(run.lost, 0U);
}

constexpr double slow = 1.25e-5, fast = 0.1;  // Re = 0.0125 and 100 [m/s]
const std::vector<std::string> plain{"numerics.scheme=plain"};
/// Shifting carries momentum from fast layers to slow ones; where the flow itself does not pull particles apart, little
/// of it will do.
const std::vector<std::string> gentle{"numerics.scheme=plain", "numerics.shifting=1"};

INSTANTIATE_TEST_SUITE_P(
    PlainPoiseuille, ChannelFlow,
    testing::Values(Setting{"20 across, Re 0.0125, plain", "poiseuille", "0.05 mm", slow, 0.01, plain},
                    Setting{"40 across, Re 0.0125, plain", "poiseuille", "0.025 mm", slow, 0.005, plain},
                    Setting{"20 across, Re 100, shifting 1, plain", "poiseuille", "0.05 mm", fast, 0.01, gentle},
                    Setting{"40 across, Re 100, shifting 1, plain", "poiseuille", "0.025 mm", fast, 0.005, gentle}));
INSTANTIATE_TEST_SUITE_P(
    PlainCouette, ChannelFlow,
    testing::Values(Setting{"20 across, Re 0.0125, plain", "couette", "0.05 mm", slow, 0.01, plain},
                    Setting{"40 across, Re 0.0125, plain", "couette", "0.025 mm", slow, 0.005, plain},
                    Setting{"20 across, Re 100, shifting 1, plain", "couette", "0.05 mm", fast, 0.01, gentle},
                    Setting{"40 across, Re 100, shifting 1, plain", "couette", "0.025 mm", fast, 0.005, gentle}));

INSTANTIATE_TEST_SUITE_P(StartUp, ChannelFlow,
                         testing::Values(Setting{"20 across, Re 0.0125", "poiseuille", "0.05 mm", slow, 0.003},
                                         Setting{"40 across, Re 0.0125", "poiseuille", "0.025 mm", slow, 0.0015},
                                         Setting{"20 across, Re 100", "poiseuille", "0.05 mm", fast, 0.003},
                                         Setting{"40 across, Re 100", "poiseuille", "0.025 mm", fast, 0.0015},
                                         Setting{"20 across, Re 0.0125", "couette", "0.05 mm", slow, 0.0015},
                                         Setting{"20 across, Re 100", "couette", "0.05 mm", fast, 0.005},
                                         Setting{"40 across, Re 100", "couette", "0.025 mm", fast, 0.0015}));

}  // namespace
}  // namespace dmp::tests::channel_flows_tests
