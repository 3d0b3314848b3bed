// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// cases/verification/mucus_over_water: its steady profile, at any step and on any number of ranks.
#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/end_to_end/program.hpp"
#include "tests/modules.hpp"
#include "tests/unit/solver/layered_channel.hpp"
#include "tests/verification/record.hpp"

namespace dmp::tests::mucus_over_water_tests {
namespace {

constexpr double water = 1.32e-6, mucus = 0.66e-6, speed = 1e-4;

double steady(double y) { return speed * std::min({1.0, y / water, (2 * water + mucus - y) / water}); }

/// A run and its last profile's root of the mean square error over that of the speed.
struct Profiled {
    RunSummary summary;
    double error;
};

Profiled run_with(const std::vector<std::string>& overrides) {
    const auto made = case_of("verification/mucus_over_water", overrides);
    KeptFrames kept;
    RunOptions options;
    options.sink = &kept;
    RunSummary summary = Simulation(made.scene, made.particles).run(options);
    EXPECT_LT(summary.momentum_residual, 1e-12);
    return {std::move(summary), profile_error(kept.frames.back(), steady)};
}

void expect_steady_profile(const std::string& setting, const std::vector<std::string>& overrides) {
    const auto [summary, error] = run_with(overrides);
    Record("mucus_over_water", setting, summary).percent("off the steady profile", error, 0.01);
}

TEST(MucusOverWater, has_its_steady_profile_with_20_and_40_rows_of_water) {
    expect_steady_profile("20 rows of water", {});
    expect_steady_profile("40 rows of water", {"particles.spacing=\"0.033 um\""});
}

TEST(MucusOverWater, has_it_with_the_longest_step_that_sound_allows) {
    expect_steady_profile("the longest step that sound allows", {"numerics.step_factor=0.1"});
}

TEST(MucusOverWater, needs_the_harmonic_mean) {
    const auto [summary, error] = run_with({"numerics.viscosity_mean=arithmetic", "numerics.step_factor=0.1"});
    Record("mucus_over_water", "arithmetic mean of viscosities, which is wrong", summary)
        .at_least("off the steady profile", 100 * error, 3, "%");
}

TEST(MucusOverWater, is_the_same_bits_on_one_rank_and_on_four) {
    const CaseFolder folder;
    const auto summary_on = [&](int ranks) {
        const std::string out = "out" + std::to_string(ranks);
        const std::string scene = DMP_SOURCE_DIR "/cases/verification/mucus_over_water";
        const auto outcome = run_dmp(
            folder.path(),
            {"run", scene, "--out", out, "--set", "output.pictures=false", "--until", "0.5 us", "--threads", "1"},
            {.ranks = ranks});
        EXPECT_EQ(outcome.code, 0) << outcome.errors;
        return nlohmann::json::parse(folder.read(out + "/summary.json"));
    };
    const auto one = summary_on(1), four = summary_on(4);
    EXPECT_EQ(one["state_hash"], four["state_hash"]);
    EXPECT_EQ(one["steps"], 50);
    EXPECT_EQ(four["ranks"], 4);
    EXPECT_EQ(one["implicit_viscosity"], four["implicit_viscosity"]);
}

}  // namespace
}  // namespace dmp::tests::mucus_over_water_tests
