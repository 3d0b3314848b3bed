// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
//
// What a run reached, compared with what it was planned for.
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "small_scenes.hpp"
#include "solver/run/column_pressure.hpp"
#include "solver/run/reached.hpp"
#include "solver/run/sound_speed.hpp"
#include "tests/modules.hpp"

namespace dmp::tests::solver_reached_tests {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;

SoundSpeed by_speed(double value) { return {.value = value, .origin = SoundSpeed::Origin::largest_speed}; }
SoundSpeed by_hand(double value) { return {.value = value}; }

TEST(Reached, warns_once_of_densities_beyond_five_per_cent) {
    const Scene scene = endless_water().scene;  // 1000 kg/m^3, 1 m/s, Mach 0.1
    for (const bool is_high : {false, true}) {
        Reached reached(scene, by_speed(10));
        const auto with = [&](double change) {
            return FluidExtremes{1, is_high ? 1 : 1 - change, is_high ? 1 + change : 1};
        };
        EXPECT_THAT(reached.add(with(0.0499)), IsEmpty());
        EXPECT_THAT(reached.warnings(true), IsEmpty());
        const std::vector<Warning> first = reached.add(with(0.06));
        ASSERT_EQ(first.size(), 1U);
        EXPECT_EQ(first[0].key, "numerics.sound_speed");
        // p = c0^2 rho 0.06
        EXPECT_THAT(first[0].text(), HasSubstr("give flow.largest_pressure = \"6e+03 Pa\" or more"));
        EXPECT_THAT(reached.add(with(0.08)), IsEmpty()) << "it has been said";
        ASSERT_EQ(reached.warnings(false).size(), 1U);
        EXPECT_THAT(reached.warnings(false)[0].problem, HasSubstr(is_high ? "+0.0 % to +8.0 %" : "-8.0 % to +0.0 %"));
    }
    // The pressure that it asks for brings the density back to Mach^2.
    Scene mended = scene;
    mended.flow.largest_pressure = 6000.0;
    EXPECT_NEAR(6000 / (1000 * std::pow(choose_sound_speed(mended, endless_water().particles).value, 2)), 0.01, 1e-12);

    Reached of_own(scene, by_hand(10));
    const std::vector<Warning> asks = of_own.add({1, 0.91, 1});
    ASSERT_EQ(asks.size(), 1U);
    EXPECT_THAT(asks[0].text(), HasSubstr("give numerics.sound_speed = \"30 m/s\" or more"));
}

TEST(Reached, warns_of_flow_that_comes_near_the_speed_of_sound) {
    Scene scene = endless_water().scene;
    Reached reached(scene, by_speed(10));
    EXPECT_THAT(reached.add({1.49, 1, 1}), IsEmpty());
    const std::vector<Warning> first = reached.add({2.6, 1, 1});
    ASSERT_EQ(first.size(), 1U);
    EXPECT_THAT(first[0].text(), AllOf(HasSubstr("is too low, at 10 m/s"), HasSubstr("Mach 0.26"),
                                       HasSubstr("give flow.largest_speed = \"2.6 m/s\" or more")));
    EXPECT_THAT(reached.add({3, 1, 1}), IsEmpty());
    EXPECT_EQ(reached.warnings(true).size(), 1U);

    scene.numerics.mach_number = 0.2;  // as planned
    Reached planned(scene, by_speed(5));
    EXPECT_THAT(planned.add({1.49, 1, 1}), IsEmpty());
    EXPECT_EQ(planned.add({1.51, 1, 1}).size(), 1U);
}

TEST(Reached, says_of_a_complete_run_that_the_flow_was_far_slower_than_given) {
    const Scene scene = endless_water().scene;
    Reached slow(scene, by_speed(10)), enough(scene, by_speed(10)), own(scene, by_hand(10));
    EXPECT_THAT(slow.add({0.05, 1, 1}), IsEmpty());
    EXPECT_THAT(slow.warnings(false), IsEmpty()) << "it may become faster yet";
    ASSERT_EQ(slow.warnings(true).size(), 1U);
    EXPECT_THAT(slow.warnings(true)[0].problem, HasSubstr("0.05 m/s, 5 % of it"));
    enough.add({0.11, 1, 1});
    EXPECT_THAT(enough.warnings(true), IsEmpty());
    own.add({0.05, 1, 1});
    EXPECT_THAT(own.warnings(true), IsEmpty()) << "the speed of sound was chosen by hand, for a pressure maybe";
}

TEST(Reached, a_run_warns_at_once_and_at_its_end) {
    const SceneAndParticles made = endless_water("2.5");  // m/s^2 for 1 s; 1 m/s is expected
    RunOptions options;
    std::vector<std::pair<double, std::string>> said;
    options.warn = [&](double time, const Warning& warning) { said.emplace_back(time, warning.text()); };
    std::vector<std::size_t> rows;
    options.measured = [&](const MeasureSeries& series) { rows.push_back(series.rows.size()); };
    const RunSummary summary = Simulation(made.scene, made.particles, 1).run(options);
    ASSERT_EQ(rows.size(), summary.measures.rows.size()) << "reported one by one";
    for (std::size_t k = 0; k < rows.size(); ++k) EXPECT_EQ(rows[k], k + 1);
    ASSERT_EQ(said.size(), 1U);
    EXPECT_THAT(said[0].second, HasSubstr("is too low"));
    EXPECT_NEAR(said[0].first, 0.6, 0.02);  // a step is 0.0125 s
    ASSERT_EQ(summary.warnings.size(), 1U);
    EXPECT_THAT(summary.warnings[0].text(), HasSubstr("give flow.largest_speed"));
    EXPECT_NEAR(summary.largest_speed, 2.5, 1e-6);
}

double largest(const std::vector<double>& values) { return *std::ranges::max_element(values); }

TEST(ColumnPressures, of_two_liquids_are_those_of_what_is_above_each) {
    const SceneAndParticles made = case_of("verification/two_liquids", {});
    const std::vector<double> pressures = column_pressures(made.scene, made.particles);
    const auto of = [&](const char* part) { return pressures.at(made.particles.part_named(part)); };
    // 0.5 m of each, the light one on top.
    EXPECT_NEAR(of("light"), 100 * 9.81 * 0.5, 1e-6 * of("light"));
    EXPECT_NEAR(of("heavy"), (100 + 1000) * 9.81 * 0.5, 1e-6 * of("heavy"));
    EXPECT_EQ(of("wall"), 0);

    Scene scene = made.scene;
    scene.flow.largest_speed = 1e-3;
    const SoundSpeed chosen = choose_sound_speed(scene, made.particles);
    EXPECT_EQ(chosen.origin, SoundSpeed::Origin::column_pressure);
    EXPECT_NEAR(chosen.value, 10 * std::sqrt(of("heavy") / 1000), 1e-9);
}

TEST(ColumnPressures, along_a_periodic_axis_need_something_in_the_way) {
    const SceneAndParticles cylinders = case_of("verification/cylinders", {});
    EXPECT_NEAR(largest(column_pressures(cylinders.scene, cylinders.particles)), 1 * 1e-3, 1e-12);  // 1 Pa/m, 1 mm
    EXPECT_EQ(choose_sound_speed(cylinders.scene, cylinders.particles).origin, SoundSpeed::Origin::column_pressure);
    const SceneAndParticles channel = case_of("verification/poiseuille", {});
    EXPECT_EQ(largest(column_pressures(channel.scene, channel.particles)), 0);
}

/// Water driven past cylinders, with 1 mPa over a cell: 0.01 m/s at Mach 0.1.
std::vector<Warning> past_cylinders(const std::string& setting) {
    const auto [scene, set] = case_of("verification/cylinders", {"particles.spacing=\"50 um\"", setting});
    return sound_speed_warnings(scene, set, choose_sound_speed(scene, set));
}

TEST(SoundSpeedWarnings, compare_what_is_given_with_the_pressure_of_the_drive) {
    // Both gave a flux too large by 113 and 42 %: sound does not cross the cell in the time of the run.
    const auto by_speed = past_cylinders("numerics.sound_speed=\"0.001 m/s\"");
    ASSERT_EQ(by_speed.size(), 1U);
    EXPECT_THAT(by_speed[0].text(), AllOf(HasSubstr("numerics.sound_speed is too low"), HasSubstr("0.001 Pa"),
                                          HasSubstr("changes the density by 100 %"), HasSubstr("give \"0.01 m/s\"")));
    const auto by_pressure = past_cylinders("flow.largest_pressure=\"0.0001 Pa\"");
    ASSERT_EQ(by_pressure.size(), 1U);
    EXPECT_THAT(by_pressure[0].text(), AllOf(HasSubstr("flow.largest_pressure is too low"), HasSubstr("by 10 %"),
                                             HasSubstr("give \"0.001 Pa\" or more")));
    EXPECT_EQ(past_cylinders("flow.largest_pressure=\"1e-6 Pa\"").size(), 1U) << "the largest speed rules";
    EXPECT_THAT(past_cylinders("numerics.sound_speed=\"0.005 m/s\""), IsEmpty()) << "4 %";
    EXPECT_THAT(past_cylinders("flow.largest_pressure=\"0.001 Pa\""), IsEmpty());
    EXPECT_THAT(past_cylinders("numerics.mach_number=0.3"), IsEmpty()) << "as planned";
    auto [scene, set] = case_of("verification/cylinders", {"particles.spacing=\"50 um\"", "numerics.mach_number=0.3"});
    scene.flow.largest_pressure = 0.001;
    EXPECT_THAT(sound_speed_warnings(scene, set, choose_sound_speed(scene, set)), IsEmpty()) << "as advised";
}

TEST(SoundSpeedWarnings, the_valves_that_give_one_need_none) {
    for (const std::string name : {"vein_valve", "heart_valve", "double_vein_valve"}) {
        const auto [scene, set] = case_of(name, {});
        EXPECT_THAT(sound_speed_warnings(scene, set, choose_sound_speed(scene, set)), IsEmpty()) << name;
    }
}

}  // namespace
}  // namespace dmp::tests::solver_reached_tests
