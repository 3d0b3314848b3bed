// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// A drug particle that adhesion holds, on a carrier or a wall: how fast it must be to leave.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/modules.hpp"
#include "tests/verification/record.hpp"
#include "tests/verification/run_case.hpp"

namespace dmp::tests::adhesion_tests {
namespace {

constexpr double pull_off = 2.58e-7, mass = 8.44e-14, z0 = 4e-10, drug = 2.5e-6, carrier = 50e-6;
constexpr double compliance = (1 - 0.3 * 0.3) / 2.15e9 + (1 - 0.24 * 0.24) / 63e9;  // 1/E*

/// A particle where the adhesion's well is deepest.
struct Seat {
    double effective_radius;
    std::vector<std::string> overrides;

    /// Hertz' force is the pull-off force there.
    [[nodiscard]] double overlap() const {
        return std::pow(pull_off / (4.0 / 3 / compliance * std::sqrt(effective_radius)), 2.0 / 3);
    }
    /// m v^2 / 2 = F_c (16/7 z0 + 3/5 d0), less what is cut off beyond a range of the adhesion.
    [[nodiscard]] double escape_speed(double range = INFINITY) const {
        return std::sqrt(2 * pull_off * (16.0 / 7 * z0 + 0.6 * overlap() - 4.0 / 3 * z0 * z0 / range) / mass);
    }
    [[nodiscard]] RunSummary run(double speed, double until, double measure_every, double step) const {
        std::vector<std::string> all = overrides;
        all.insert(all.end(), {"part.drug.centres=[[0, 0, \"" + quantity(-overlap(), "m") + "\"]]",
                               set_to("part.drug.initial_velocity", {0, 0, speed}, "m/s"),
                               set_to("output.every", until, "s"), set_to("output.measure_every", measure_every, "s")});
        if (step > 0) all.push_back(set_to("numerics.contact_step", step, "s"));
        return run_case("verification/adhesion", all, until, nullptr, 1);
    }
};

const Seat on_carrier{drug * carrier / (drug + carrier), {}};
const Seat on_wall{drug, {"part.carrier.enabled=false", "part.wall.enabled=true"}};

/// Thrown off at this speed; one that is held turns back within five microseconds.
RunSummary throw_off(const Seat& seat, double speed, double step) { return seat.run(speed, 5e-6, 2e-8, step); }
bool escapes(const RunSummary& run) { return smallest(column(run.measures, "velocity_z")) > 0; }

TEST(Adhesion, IsLeftAtTheSpeedThatEnergyGives) {
    constexpr double range = 50 * z0;
    for (const auto& [name, seat] : {std::pair{"carrier", on_carrier}, {"wall", on_wall}})
        for (const double step : {0.0, 1e-9, 1e-10}) {
            double low = 0.08, high = 0.13;
            RunSummary last;
            EXPECT_FALSE(escapes(throw_off(seat, low, step)));
            EXPECT_TRUE(escapes(throw_off(seat, high, step)));
            while (high - low > 1e-5) {
                const double middle = (low + high) / 2;
                last = throw_off(seat, middle, step);
                (escapes(last) ? high : low) = middle;
            }
            const std::string steps = step == 0      ? "steps as chosen"
                                      : step == 1e-9 ? "steps of 1 ns"
                                                     : "steps of 0.1 ns";
            Record record("adhesion", std::string("off a ") + name + ", " + steps, last);
            record.percent("escape speed", low / seat.escape_speed() - 1, 0.01);
            record.percent("the same, less what the adhesion's range leaves out", low / seat.escape_speed(range) - 1,
                           0.002);
        }
}

// Hertz' slope 3/2 F_c / d0 alone holds it there, as the adhesion of surfaces that touch does not change.
TEST(Adhesion, HoldsAParticleThatSwings) {
    constexpr double step = 1e-10, until = 2e-6;
    const RunSummary run = on_carrier.run(1e-5, until, step, step);
    const auto velocity = column(run.measures, "velocity_z");
    double first = 0, last = 0;
    int swings = -1;
    for (std::size_t row = 1; row < velocity.size(); ++row)
        if (velocity[row - 1] > 0 && velocity[row] <= 0) {
            last = run.measures.time[row - 1] + step * velocity[row - 1] / (velocity[row - 1] - velocity[row]);
            if (++swings == 0) first = last;
        }
    const double found = 2 * std::numbers::pi * swings / (last - first);
    Record record("adhesion", "swings in its seat", run);
    record.percent("frequency", found / std::sqrt(1.5 * pull_off / on_carrier.overlap() / mass) - 1, 0.003);
}

}  // namespace
}  // namespace dmp::tests::adhesion_tests
