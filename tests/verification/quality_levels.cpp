// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// The levels of quality on two flows with closed forms: what docs/accuracy.md says of them.
#include <cmath>
#include <cstdio>
#include <map>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/modules.hpp"
#include "tests/verification/run_case.hpp"

namespace dmp::tests::quality_levels_tests {
namespace {

constexpr double pi = std::numbers::pi;

/// Keeps the fluid of the last frame.
class LastFluid : public FrameSink {
  public:
    void write(const Frame& frame) override {
        time = frame.time;
        fluid = frame.groups.at(0);
    }
    [[nodiscard]] double position(std::size_t k, std::size_t axis) const { return fluid.position[3 * k + axis]; }
    [[nodiscard]] double velocity(std::size_t k, std::size_t axis) const {
        return fluid.fields.at(0).values[3 * k + axis];
    }
    double time = 0;
    FrameGroup fluid;
};

struct Outcome {
    LastFluid last;
    RunSummary summary;
};

Outcome run(const std::string& name, std::vector<std::string> overrides) {
    overrides.emplace_back("output.fields=['velocity']");
    const Scene scene = read_scene(DMP_SOURCE_DIR "/cases/verification/" + name, overrides);
    GeometryOptions cad_geometry;
    cad_geometry.file = scene.directory + "/" + scene.geometry.file.value;
    cad_geometry.unit = scene.geometry.unit;
    for (const auto& [parameter, value] : scene.geometry.parameters) cad_geometry.parameters[parameter] = value;
    Simulation simulation(scene, mesh(read_geometry(cad_geometry), scene).particles, 1);
    Outcome outcome;
    RunOptions options;
    options.sink = &outcome.last;
    outcome.summary = simulation.run(options);
    return outcome;
}

/// Speed at t = 1 s of vortices of this kinematic viscosity (Taylor & Green 1937).
double decay_at_end(double viscosity) { return std::exp(-8 * pi * pi * viscosity); }

/// Mean difference of the speed over the mean speed.
double speed_error_of_vortices(const LastFluid& last, double decay) {
    double difference = 0, sum = 0;
    for (std::size_t k = 0; k < last.fluid.size(); ++k) {
        const double x = 2 * pi * last.position(k, 0), y = 2 * pi * last.position(k, 1);
        const double exact = decay * std::hypot(std::cos(x) * std::sin(y), std::sin(x) * std::cos(y));
        difference += std::abs(std::hypot(last.velocity(k, 0), last.velocity(k, 1)) - exact);
        sum += exact;
    }
    return difference / sum;
}

/// L2 of the profile between plates 1 mm apart, steady.
double error_of_channel(const LastFluid& last) {
    constexpr double width = 1e-3, viscosity = 1e-6, acceleration = 1e-4;
    double square = 0, reference = 0;
    for (std::size_t k = 0; k < last.fluid.size(); ++k) {
        const double y = last.position(k, 1);
        // What is left of the start after 1 s is 5e-5 of it (series of Morris, Fox & Zhu 1997).
        const double exact = acceleration / (2 * viscosity) * y * (width - y) -
                             4 * acceleration * width * width / (viscosity * pi * pi * pi) * std::sin(pi * y / width) *
                                 std::exp(-pi * pi * viscosity * last.time / (width * width));
        square += std::pow(last.velocity(k, 0) - exact, 2) + std::pow(last.velocity(k, 1), 2);
        reference += exact * exact;
    }
    return std::sqrt(square / reference);
}

struct Bounds {
    double energy, speed, channel;
};

/// `viscosity`: of the vortices [Pa s].
void expect_errors_and_costs_in_order(const std::string& scheme, double viscosity, double draft_over_standard_steps,
                                      const std::map<std::string, Bounds>& bounds) {
    const double decay = decay_at_end(viscosity);
    std::map<std::string, double> steps;
    std::map<std::string, double> speed_errors;
    for (const auto& [quality, bound] : bounds) {
        SCOPED_TRACE(quality);
        const Outcome vortices =
            run("taylor_green", {"numerics.scheme=" + scheme, "quality=" + quality, "particles.spacing=0.02 m",
                                 "part.water.viscosity=" + std::to_string(viscosity) + " Pa*s"});
        const double energy = column(vortices.summary.measures, "energy").back() / (0.25 * decay * decay) - 1;
        speed_errors[quality] = speed_error_of_vortices(vortices.last, decay);
        EXPECT_LE(std::abs(energy), bound.energy);
        EXPECT_LE(speed_errors[quality], bound.speed);
        steps[quality] = static_cast<double>(vortices.summary.steps);
        const Outcome channel =
            run("poiseuille", {"numerics.scheme=" + scheme, "quality=" + quality, "part.wall.layers=4"});
        EXPECT_LE(error_of_channel(channel.last), bound.channel);
        std::printf("%-8s  vortices: energy %+.2f %%, speed %.2f %%, %ld steps; channel %.2f %%\n", quality.c_str(),
                    100 * energy, 100 * speed_errors[quality], vortices.summary.steps,
                    100 * error_of_channel(channel.last));
    }
    EXPECT_LT(steps["draft"], draft_over_standard_steps * steps["standard"]);
    EXPECT_LT(steps["standard"], steps["fine"]);
    EXPECT_LT(speed_errors["fine"], speed_errors["standard"]);
    EXPECT_LT(speed_errors["standard"], speed_errors["draft"]);
}

TEST(QualityLevels, keep_the_errors_of_the_table_and_cost_in_their_order) {
    expect_errors_and_costs_in_order(
        "corrected", 0.001, 0.41,
        {{"draft", {0.08, 0.05, 0.005}}, {"standard", {0.018, 0.014, 0.005}}, {"fine", {0.01, 0.008, 0.005}}});
}

TEST(QualityLevels, of_the_plain_scheme_too) {
    expect_errors_and_costs_in_order(
        "plain", 0.01, 0.6,
        {{"draft", {0.035, 0.02, 0.005}}, {"standard", {0.02, 0.01, 0.005}}, {"fine", {0.005, 0.004, 0.003}}});
}

}  // namespace
}  // namespace dmp::tests::quality_levels_tests
