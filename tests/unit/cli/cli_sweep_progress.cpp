// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <gtest/gtest.h>

#include "cli/sweep_progress.hpp"
#include "tests/modules.hpp"

namespace dmp::tests::sweep_progress_tests {
namespace {

using namespace cli;

TEST(SweepProgress, SaysHowManyAreDoneAndWhatIsLeft) {
    SweepCounts counts{.runs = 1200, .done = 300, .failed = 0, .running = 2, .ended_now = 0};
    EXPECT_TRUE(std::isinf(seconds_left(counts, 50))) << "nothing has ended in this process yet";
    EXPECT_EQ(progress_text(counts, seconds_left(counts, 50)), " 25 %  300 of 1 200 done, 2 running");
    counts = {.runs = 1200, .done = 305, .failed = 5, .running = 2, .ended_now = 10};
    EXPECT_DOUBLE_EQ(seconds_left(counts, 50), 5 * 890);
    EXPECT_EQ(progress_text(counts, seconds_left(counts, 50)),
              " 25 %  305 of 1 200 done, 2 running, 5 failed  1 h 14 min left");
    EXPECT_EQ(progress_text({.runs = 0}, 0), "100 %  0 of 0 done, 0 running  0 us left");
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
