// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "cli/sweep/sweep_progress.hpp"
#include "tests/modules.hpp"

namespace dmp::tests::sweep_progress_tests {
namespace {

using namespace cli;

TEST(SweepProgress, SaysHowManyAreDoneAndWhatIsLeft) {
    SweepCounts counts{.runs = 1200, .done = 300, .failed = 0, .running = 2};
    EXPECT_EQ(progress_text(counts, std::numeric_limits<double>::infinity()), " 25 %  300 of 1 200 done, 2 running");
    counts = {.runs = 1200, .done = 305, .failed = 5, .running = 2};
    EXPECT_EQ(counts.left(), 890U);
    EXPECT_EQ(progress_text(counts, 4450), " 25 %  305 of 1 200 done, 2 running, 5 failed  1 h 14 min left");
    EXPECT_EQ(progress_text({.runs = 0}, 0), "100 %  0 of 0 done, 0 running");
}

TEST(SweepProgress, WhatRunningRunsHaveDoneIsNoLongerLeft) {
    EXPECT_TRUE(std::isinf(seconds_left(0, {3, 4}, 10, 2))) << "nothing has ended yet";
    EXPECT_DOUBLE_EQ(seconds_left(10, {}, 6, 2), 30);
    EXPECT_DOUBLE_EQ(seconds_left(10, {4, 2}, 6, 2), (60 + 6 + 8) / 2.0);
    EXPECT_DOUBLE_EQ(seconds_left(10, {25}, 0, 2), 0) << "longer than the others";
    EXPECT_DOUBLE_EQ(seconds_left(10, {4}, 0, 8), 6) << "one run is not shared among jobs";
    EXPECT_DOUBLE_EQ(seconds_left(10, {}, 0, 2), 0);
}

TEST(SweepProgress, WithoutATerminalALineComesEveryTwoMinutes) {
    LineEvery lines;
    EXPECT_FALSE(lines.is_due(119));
    EXPECT_TRUE(lines.is_due(121));
    EXPECT_FALSE(lines.is_due(239));
    EXPECT_TRUE(lines.is_due(500));
    EXPECT_FALSE(lines.is_due(599));
}

}  // namespace
}  // namespace dmp::tests::sweep_progress_tests
