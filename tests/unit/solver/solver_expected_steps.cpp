// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Steps that end where output is due, and the output of a run's end.
#include <limits>
#include <vector>

#include <gmock/gmock.h>

#include "small_scenes.hpp"
#include "solver/results/expected_steps.hpp"
#include "tests/modules.hpp"

namespace dmp::tests::solver_expected_steps_tests {
namespace {

TEST(StepsOf, AreCountedUpAndNeverBeyondWhatCanBeCounted) {
    EXPECT_EQ(steps_of(1, 0.3), 4);
    EXPECT_EQ(steps_of(0, 0.3), 0);
    EXPECT_EQ(steps_of(1e150, 1e-6), std::numeric_limits<long>::max());
}

TEST(ExpectedSteps, end_where_frames_and_rows_are_due) {
    Scene scene;
    scene.output.every = 1.0;
    const auto steps = [&](double dt, double until = 2) { return expected_steps(scene, dt, until); };
    EXPECT_EQ(steps(0.1), 8 * 3) << "four rows a frame, 0.25 s in three steps";
    scene.output.measure_every = 0.4;
    EXPECT_EQ(steps(1), 6) << "0.4, 0.8, 1, 1.2, 1.6, 2 and no step over them";
    EXPECT_EQ(steps(1, 1.1), 4);
    EXPECT_EQ(steps(0.3), 2 + 2 + 1 + 1 + 2 + 2);
    scene.output.measure_every = 1e-7;
    EXPECT_EQ(steps(1), 20'000'000);
    EXPECT_EQ(steps(1e-300), std::numeric_limits<long>::max());
    EXPECT_EQ(expected_frames(scene, 2), 3);
    EXPECT_EQ(expected_frames(scene, 2.5), 4) << "one at the end";
    EXPECT_EQ(expected_frames(scene, 0.5), 2);
}

TEST(Measures, have_a_row_at_the_end_where_none_is_due) {
    SceneAndParticles made = endless_water("0.5");
    made.scene.output.every = 1.0;
    Measure& measure = made.scene.measures.emplace_back();
    measure.name = {"fastest", {}};
    measure.kind = {MeasureKind::largest_speed, {}};
    for (const double every : {0.3, 0.25, 5.0}) {
        made.scene.output.measure_every = every;
        const RunSummary summary = Simulation(made.scene, made.particles, 1).run({});
        std::vector<double> wanted;  // [s]
        for (int k = 0; k * every < 1 - 1e-12; ++k) wanted.push_back(k * every);
        wanted.push_back(1);
        EXPECT_THAT(summary.measures.time, testing::Pointwise(testing::DoubleEq(), wanted)) << every;
        const auto planned = static_cast<double>(Simulation(made.scene, made.particles, 1).plan().steps);
        EXPECT_NEAR(static_cast<double>(summary.steps), planned, 0.1 * planned) << every;
    }
}

}  // namespace
}  // namespace dmp::tests::solver_expected_steps_tests
