// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "small_scenes.hpp"

namespace dmp {
namespace {

using testing_solver::case_of;

RunSummary run_on(const testing_solver::SceneAndParticles& made, int threads, double until) {
    Simulation simulation(made.scene, made.particles, threads);
    RunOptions options;
    options.until = until;
    return simulation.run(options);
}

void expect_same_bits_on_two_threads(const testing_solver::SceneAndParticles& made, double until) {
    const RunSummary one = run_on(made, 1, until), again = run_on(made, 1, until), two = run_on(made, 2, until);
    EXPECT_EQ(one.state_hash.size(), 16U);
    EXPECT_EQ(one.state_hash, again.state_hash);
    EXPECT_EQ(one.state_hash, two.state_hash);
    EXPECT_EQ(one.steps, two.steps);
    EXPECT_EQ(one.measures.rows, two.measures.rows);
    EXPECT_EQ(one.threads, 1);
    EXPECT_EQ(two.threads, 2);
    EXPECT_GT(one.steps, 10);
}

TEST(Reproducible, poiseuille_flow_on_one_and_two_threads) {
    expect_same_bits_on_two_threads(case_of("verification/poiseuille", {}), 0.1);
}

TEST(Reproducible, vein_valve_on_one_and_two_threads) {
    for (const std::string stepping : {"implicit", "subcycled"})
        expect_same_bits_on_two_threads(
            case_of("vein_valve", {"particles.spacing=0.4 mm", "accuracy.spring_stepping=" + stepping}), 0.005);
}

TEST(Reproducible, the_hash_tells_states_apart) {
    const auto made = case_of("verification/poiseuille", {});
    EXPECT_NE(run_on(made, 1, 0.01).state_hash, run_on(made, 1, 0.02).state_hash);
}

TEST(VeinValve, keeps_mass_and_accounts_for_all_momentum) {
    const RunSummary summary = run_on(case_of("vein_valve", {"particles.spacing=0.4 mm"}), 1, 0.005);
    EXPECT_EQ(summary.start.mass, summary.end.mass);
    EXPECT_LT(summary.momentum_residual, 1e-12);
    EXPECT_EQ(summary.lost, 0U);
    EXPECT_GT(summary.impulse_of_body_forces[0], 0);
    EXPECT_GT(summary.particles.at("springs"), 50U);
}

}  // namespace
}  // namespace dmp
