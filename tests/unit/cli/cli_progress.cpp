// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <gtest/gtest.h>

#include "cli/progress.hpp"
#include "tests/modules.hpp"

namespace dmp::tests::cli_progress_tests {

namespace {

using namespace cli;

TEST(TimeLeft, KnowsNothingBeforeTheFirstProgress) { EXPECT_TRUE(std::isinf(TimeLeft().seconds())); }

TEST(TimeLeft, IsExactForSteadyProgress) {
    TimeLeft left;
    for (int k = 1; k <= 20; ++k) left.update(0.5 * k, 0.01 * k, 1.0);  // 0.02 simulated seconds a second
    EXPECT_NEAR(left.seconds(), (1.0 - 0.2) / 0.02, 1e-9);
}

TEST(TimeLeft, FollowsAChangeOfPace) {
    TimeLeft left;
    double wall = 0;
    double time = 0;
    for (int k = 0; k < 100; ++k) left.update(wall += 1, time += 0.01, 10.0);
    for (int k = 0; k < 100; ++k) left.update(wall += 1, time += 0.02, 10.0);  // twice as fast for 100 s
    EXPECT_NEAR(left.seconds(), (10.0 - time) / 0.02, 0.01 * (10.0 - time) / 0.02);
}

TEST(Progress, TextNamesPercentTimeStepsSpeedFramesAndWhatIsLeft) {
    const RunProgress progress{
        .time = 1.68, .until = 4, .step = 20512, .dt = 8e-5, .largest_speed = 0.081, .frames = 43};
    EXPECT_EQ(progress_text(progress, 151),
              " 42 %  1.68 of 4 s  20 512 steps  0.081 m/s at most  43 frames  2 min 31 s left");
    EXPECT_EQ(progress_text(progress, INFINITY), " 42 %  1.68 of 4 s  20 512 steps  0.081 m/s at most  43 frames");
}

TEST(Progress, NothingIsWrittenWhenStderrIsNoTerminal) {
    testing::internal::CaptureStderr();
    {
        ProgressLine line;
        line.show(RunProgress{.time = 1, .until = 2});
        line.show("geometry pictures");
    }
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

}  // namespace

}  // namespace dmp::tests::cli_progress_tests
