// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "small_scenes.hpp"
#include "tests/modules.hpp"

namespace dmp::tests::solver_reproducible_tests {
namespace {

RunSummary run_on(const SceneAndParticles& made, const Resources& resources, double until) {
    Simulation simulation(made.scene, made.particles, resources);
    RunOptions options;
    options.until = until;
    return simulation.run(options);
}

/// Runs about `steps` steps on every vector unit and on 1, 2 and 3 threads.
void expect_same_bits(const SceneAndParticles& made, long steps) {
    const double until = static_cast<double>(steps) * Simulation(made.scene, made.particles, 1).plan().dt;
    const RunSummary first = run_on(made, 1, until);
    EXPECT_EQ(first.state_hash.size(), 16U);
    EXPECT_NEAR(static_cast<double>(first.steps), static_cast<double>(steps), 0.1 * static_cast<double>(steps));
    EXPECT_FALSE(first.measures.rows.empty());
    std::vector<Resources> all{2, 3};
    for (const VectorUnit unit : available_vector_units()) {
        all.emplace_back(1);
        all.back().vector_unit = unit;
    }
    for (const Resources& resources : all) {
        SCOPED_TRACE(std::string(to_string(resources.vector_unit)) + ", threads: " + std::to_string(resources.threads));
        const RunSummary other = run_on(made, resources, until);
        EXPECT_EQ(other.state_hash, first.state_hash);
        EXPECT_EQ(other.steps, first.steps);
        EXPECT_EQ(other.measures.rows, first.measures.rows);
        EXPECT_EQ(other.threads, resources.threads);
    }
}

TEST(Reproducible, poiseuille_flow) { expect_same_bits(case_of("verification/poiseuille", {}), 100); }

TEST(Reproducible, vein_valve) { expect_same_bits(case_of("vein_valve", {"particles.spacing=0.5 mm"}), 200); }

TEST(Reproducible, vein_valve_with_subcycled_springs_and_plain_walls) {
    expect_same_bits(case_of("vein_valve", {"particles.spacing=0.5 mm", "numerics.spring_stepping=subcycled",
                                            "numerics.scheme=plain", "numerics.walls=plain", "numerics.kernel=lucy"}),
                     40);
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
    EXPECT_GT(summary.particles.at("elastic"), 50U);
}

}  // namespace
}  // namespace dmp::tests::solver_reproducible_tests
