// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// cases/verification/mucus_over_water: its steady profile, at any step and on any number of ranks.
#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/end_to_end/program.hpp"
#include "tests/unit/solver/layered_channel.hpp"

namespace dmp {
namespace {

using testing_solver::case_of;
using testing_solver::KeptFrames;
using testing_solver::profile_error;

constexpr double water = 1.32e-6, mucus = 0.66e-6, speed = 1e-4;

double steady(double y) { return speed * std::min({1.0, y / water, (2 * water + mucus - y) / water}); }

double error_of(const std::vector<std::string>& overrides) {
    const auto made = case_of("verification/mucus_over_water", overrides);
    KeptFrames kept;
    RunOptions options;
    options.sink = &kept;
    const RunSummary summary = Simulation(made.scene, made.particles).run(options);
    EXPECT_LT(summary.momentum_residual, 1e-12);
    return profile_error(kept.frames.back(), steady);
}

TEST(MucusOverWater, has_its_steady_profile_with_20_and_40_rows_of_water) {
    EXPECT_LT(error_of({}), 0.01);
    EXPECT_LT(error_of({"particles.spacing=\"0.033 um\""}), 0.01);
}

TEST(MucusOverWater, has_it_with_the_longest_step_that_sound_allows) {
    EXPECT_LT(error_of({"accuracy.step_factor=0.1"}), 0.01);
}

TEST(MucusOverWater, needs_the_harmonic_mean) {
    EXPECT_GT(error_of({"accuracy.viscosity_mean=arithmetic", "accuracy.step_factor=0.1"}), 0.03);
}

TEST(MucusOverWater, is_the_same_bits_on_one_rank_and_on_four) {
    using namespace end_to_end;
    const TemporaryFolder folder;
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
}  // namespace dmp
