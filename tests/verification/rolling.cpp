// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// A ball that slides and rolls on a floor, against Coulomb's law.
#include <cmath>

#include <gtest/gtest.h>

#include "tests/modules.hpp"
#include "tests/verification/record.hpp"
#include "tests/verification/run_case.hpp"

namespace dmp::tests::rolling_tests {
namespace {

constexpr double radius = 0.01, g = 9.81, friction = 0.3, start = 1;

// v = v0 - mu g t and omega = 5/2 mu g t / R until v = omega R, at t = 2 v0 / (7 mu g); from then on v = 5/7 v0.
TEST(Rolling, FollowsOnSliding) {
    constexpr double rolls = 2 * start / (7 * friction * g);
    const RunSummary run =
        run_case("verification/rolling", {set_to("output.measure_every", rolls / 100, "s")}, 2 * rolls, nullptr, 1);
    const auto velocity = column(run.measures, "velocity_x"), spin = column(run.measures, "spin_y");
    const auto slip = [&](std::size_t row) { return velocity[row] - spin[row] * radius; };
    Record record("rolling", "slides, then rolls", run);
    record.percent("velocity half-way, over the first one, less 6/7", velocity.at(50) / start - 6.0 / 7, 0.001);
    record.percent("velocity of the surface half-way, over the first one, less 1/2", slip(50) / start - 0.5, 0.001);
    std::size_t row = 0;
    while (slip(row) > 0.01 * start) ++row;
    const double until = run.measures.time[row - 1] + slip(row - 1) / (3.5 * friction * g);
    record.percent("time at which it rolls", until / rolls - 1, 0.001);
    record.percent("velocity when it rolls, over 5/7 of the first one", velocity.back() / (5.0 / 7 * start) - 1, 0.001);
    record.percent("the same of its spin", spin.back() * radius / (5.0 / 7 * start) - 1, 0.001);
}

// A torque of mu_r R m g against the spin: omega = omega0 - 5 mu_r g t / (2 R) where nothing else turns it, and v = v0
// - 5/7 mu_r g t on the roll.
TEST(Rolling, SlowsDownByRollingFriction) {
    constexpr double rolling = 0.02, time = 0.4;
    for (const std::string law : {"constant", "spring"}) {
        const std::vector<std::string> common{set_to("contact_pair.touch.rolling_friction", rolling),
                                              "contact_pair.touch.rolling=" + law,
                                              set_to("part.ball.initial_spin", {0, start / radius, 0}, "rad/s")};
        std::vector<std::string> spins = common, rolls = common;
        spins.insert(spins.end(), {"contact_pair.touch.friction=0", "part.ball.initial_velocity=[0, 0, 0]"});
        const RunSummary spun = run_case("verification/rolling", spins, time, nullptr, 1);
        const RunSummary rolled = run_case("verification/rolling", rolls, time, nullptr, 1);
        const double lost = start / radius - column(spun.measures, "spin_y").back(),
                     slower = start - column(rolled.measures, "velocity_x").back();
        Record record("rolling", "rolling friction, law '" + law + "'", rolled);
        record.percent("spin lost where it turns on the spot", lost / (2.5 * rolling * g * time / radius) - 1, 0.001);
        record.percent("velocity lost on the roll", slower / (5.0 / 7 * rolling * g * time) - 1, 0.001);
    }
}

}  // namespace
}  // namespace dmp::tests::rolling_tests
