// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Free bodies in slow flows: how fast a disc and a drop turn in shear flow, how fast a disc sinks between plates
// (Faxen 1946), and that one of the liquid's density hovers.
#include <Eigen/Dense>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/modules.hpp"
#include "tests/verification/record.hpp"
#include "tests/verification/run_case.hpp"

namespace dmp::tests::free_bodies_tests {
namespace {

constexpr double pi = std::numbers::pi;

struct Cloud {
    std::vector<Eigen::Vector2d> position, velocity;
};

Cloud cloud_of(const FrameGroup& group, const std::vector<bool>& chosen) {
    const std::vector<float>& velocity = required_field(group, "velocity").values;
    Cloud cloud;
    for (std::size_t k = 0; k < group.size(); ++k) {
        if (!chosen[k]) continue;
        cloud.position.emplace_back(group.position[3 * k], group.position[3 * k + 1]);
        cloud.velocity.emplace_back(velocity[3 * k], velocity[3 * k + 1]);
    }
    return cloud;
}

Cloud solid_of(const Frame& frame) {
    const FrameGroup& solid = required_group(frame, "solid");
    return cloud_of(solid, std::vector<bool>(solid.size(), true));
}

/// The gradient of the linear velocity field that fits the cloud best.
Eigen::Matrix2d velocity_gradient(const Cloud& cloud) {
    Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
    Eigen::Matrix<double, 3, 2> right = Eigen::Matrix<double, 3, 2>::Zero();
    for (std::size_t k = 0; k < cloud.position.size(); ++k) {
        const Eigen::Vector3d base(1e-3, cloud.position[k].x(), cloud.position[k].y());
        matrix += base * base.transpose();
        right += base * cloud.velocity[k].transpose();
    }
    return matrix.ldlt().solve(right).bottomRows<2>().transpose();
}

Eigen::Vector2d mean(const std::vector<Eigen::Vector2d>& values) {
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    for (const auto& value : values) sum += value;
    return sum / static_cast<double>(values.size());
}

/// Angular velocity, anticlockwise [rad/s].
double turning(const Cloud& cloud) {
    const Eigen::Matrix2d g = velocity_gradient(cloud);
    return (g(1, 0) - g(0, 1)) / 2;
}

constexpr double shear_rate = 10;  // [1/s]

TEST(DiscInShear, TurnsAtHalfOfTheShearRate) {
    LastFrame last;
    const RunSummary run = run_case("verification/body_in_shear", {}, 0.03, &last);
    Record record("body_in_shear", "disc, 16 across, box 4 d", run);
    // Unbounded, half of the shear rate. In this box, periodic in x: Stokes flow by multipoles and channel modes.
    record.percent("angular velocity", -turning(solid_of(last.frame)) / shear_rate / 0.4856 - 1, 0.01);
}

TEST(DropInShear, TurnsAtHalfOfTheShearRate) {
    LastFrame last;
    const RunSummary run = run_case("verification/body_in_shear/drop.toml", {}, 8e-3, &last);
    const FrameGroup& fluid = required_group(last.frame, "fluid");
    std::vector<bool> chosen;
    for (const auto part : fluid.part) chosen.push_back(last.frame.parts.at(static_cast<std::size_t>(part)) == "body");
    const Cloud drop = cloud_of(fluid, chosen);
    ASSERT_GT(drop.position.size(), 150U);
    Record record("body_in_shear", "drop ten times as viscous, 16 across", run);
    record.percent("angular velocity over half of the shear rate, at rate x t = 0.08",
                   -turning(drop) / shear_rate / 0.5 - 1, 0.03);
}

/// Speed of a disc in the middle between two plates, by the pull on 1 m of its length [m/s] (Faxen 1946).
double faxen(double pull, double viscosity, double diameter_over_width) {
    const double k = diameter_over_width, k2 = k * k;
    const double resistance =
        4 * pi / (-std::log(k) - 0.9157 + k2 * (1.7244 + k2 * (-1.7302 + k2 * (2.4056 - 4.5913 * k2))));
    return pull / (resistance * viscosity);
}

constexpr double diameter = 1e-3, plates = 5e-3, viscosity = 0.1;
/// Of 1 m of its length, in the liquid [N].
constexpr double weight = 1500 * 9.81 * pi / 4 * diameter * diameter;

/// Its velocity upwards at 50 ms, where it has long been steady.
struct Fall {
    RunSummary run;
    double velocity;
};
Fall fall_of(const std::string& scene, const std::vector<std::string>& overrides = {}) {
    LastFrame last;
    RunSummary run = run_case("verification/sinking_disc" + scene, overrides, 0.05, &last);
    const Cloud disc = solid_of(last.frame);
    return {std::move(run), mean(disc.velocity).y()};
}

TEST(SinkingDisc, FallsAsFaxenSaysWithAndWithoutTheHydrostaticPressure) {
    const Fall sinking = fall_of(""), pulled = fall_of("/pulled.toml");
    Record record("sinking_disc", "16 across, plates 5 d apart", sinking.run);
    record.percent("speed", -sinking.velocity / faxen(weight, viscosity, diameter / plates) - 1, 0.005);
    record.percent("speed, from that of the disc that is pulled without gravity",
                   sinking.velocity / pulled.velocity - 1, 0.002);
}

TEST(HoveringDisc, StaysWhereItIs) {
    const Fall hovering = fall_of("", {"part.disc.density=1000 kg/m^3"});
    const double sinking = faxen(weight, viscosity, diameter / plates);
    Record record("sinking_disc", "of the liquid's density", hovering.run);
    record.at_most("speed, over that of a disc 2.5 times as dense", std::abs(hovering.velocity) / sinking, 1e-4);
}

}  // namespace
}  // namespace dmp::tests::free_bodies_tests
