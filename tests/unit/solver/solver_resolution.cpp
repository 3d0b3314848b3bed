// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <string>

#include <gmock/gmock.h>

#include "solver/run/resolution.hpp"
#include "tests/modules.hpp"
#include "tests/unit/solver/small_scenes.hpp"

namespace dmp::tests::solver_resolution_tests {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// A channel 1 mm wide with this many particles across.
SceneAndParticles channel(const std::string& spacing) {
    return case_of("verification/poiseuille",
                   {"particles.spacing=\"" + spacing + "\"", "geometry.parameters.length=\"4 mm\""});
}

TEST(NarrowGaps, are_as_wide_as_the_channel) {
    const auto [scene, set] = channel("0.25 mm");
    const auto gap = narrowest_gap(set, 1.1e-3);
    ASSERT_TRUE(gap);
    EXPECT_NEAR(gap->width, 1e-3, 0.02e-3);
    EXPECT_GT(gap->particles, set.count(PartKind::fluid) / 2);
    EXPECT_FALSE(narrowest_gap(set, 0.95e-3)) << "it is wider";
}

TEST(NarrowGaps, corners_are_none) {
    const auto [scene, set] = case_of("verification/cavity", {"particles.spacing=\"0.05 m\""});
    EXPECT_FALSE(narrowest_gap(set, 0.9));
}

TEST(Resolution, warns_of_few_particles_across) {
    const auto [scene, set] = channel("0.25 mm");
    std::vector<std::string> texts;
    for (const Warning& warning : resolution_warnings(scene, set)) texts.push_back(warning.text());
    EXPECT_THAT(texts, ElementsAre(AllOf(HasSubstr("particles.spacing leaves 4 particles across"),
                                         HasSubstr("6.2 % too strong"), HasSubstr("take 0.1 mm or less"))));
    const auto finer = channel("0.2 mm");
    EXPECT_THAT(resolution_warnings(finer.scene, finer.particles), IsEmpty());
}

TEST(Resolution, warning_is_in_the_summary) {
    auto [scene, set] = channel("0.25 mm");
    scene.run.duration = 1e-3;
    Simulation simulation(scene, set, 1);
    ASSERT_FALSE(simulation.plan().warnings.empty());
    const RunSummary summary = simulation.run({});
    ASSERT_FALSE(summary.warnings.empty());
    EXPECT_THAT(summary.warnings[0].text(), HasSubstr("particles across the narrowest gap"));
}

TEST(Resolution, of_the_shipped_cases_needs_no_warning) {
    for (const std::string name : {"vein_valve", "heart_valve", "bent_channel"}) {
        const auto [scene, set] = case_of(name, {});
        EXPECT_THAT(resolution_warnings(scene, set), IsEmpty()) << name;
    }
}

}  // namespace
}  // namespace dmp::tests::solver_resolution_tests
