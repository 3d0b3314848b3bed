// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Concentrations that leave their bounds.
#include <algorithm>

#include <gmock/gmock.h>

#include "tests/modules.hpp"
#include "tests/unit/solver/dissolved.hpp"
#include "tests/unit/thrown.hpp"

namespace dmp::tests::solver_concentrations_tests {
namespace {

/// A step of a concentration, with steps of this fraction of the largest stable one.
RunSummary run_of_step(double fraction, double steps) {
    WalledWater made = strip(24, 6);
    made.scene.species = {species_of("drug", 1, "x < 1.2 ? 1 : 0")};
    made.scene.numerics.species_step_factor = {fraction, {"scene.toml", 4, 1}};
    made.scene.run.duration = 1000;
    const Simulation probe(made.scene, made.particles, 1);
    made.scene.run.duration = steps * probe.plan().dt;
    return run_of(made);
}

TEST(Concentrations, that_steps_too_long_let_grow_end_the_run) {
    EXPECT_THAT(
        text_thrown<DivergenceError>([] { (void)run_of_step(1.5, 60); }),
        testing::AllOf(testing::HasSubstr("the concentration of 'drug' in particle"),
                       testing::HasSubstr("beyond ten times what it can have been given"),
                       testing::HasSubstr("numerics.species_step_factor = 1.5 is too large; its stated limit is 1")));
    // It ends between two looks at the particles.
    EXPECT_THAT(text_thrown<DivergenceError>([] { (void)run_of_step(1.5, 30); }),
                testing::HasSubstr("the concentration of 'drug'"));
}

TEST(Concentrations, beyond_what_is_given_are_warned_of) {
    const auto warned = [](const RunSummary& run) {
        return std::ranges::any_of(run.warnings, [](const Warning& warning) {
            return warning.key == "species.drug" && warning.problem.find("left the range from 0") != std::string::npos;
        });
    };
    EXPECT_FALSE(warned(run_of_step(0.5, 60)));
    EXPECT_TRUE(warned(run_of_step(1.5, 8)));
}

}  // namespace
}  // namespace dmp::tests::solver_concentrations_tests
