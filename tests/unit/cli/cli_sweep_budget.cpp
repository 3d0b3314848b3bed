// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>
#include <string>

#include <gmock/gmock.h>

#include "base/safe_file.hpp"
#include "cli/output_folder.hpp"
#include "cli/sweep/sweep_budget.hpp"
#include "cli/sweep/sweep_folder.hpp"
#include "cli/sweep/sweep_table.hpp"
#include "solver/results/plan.hpp"
#include "tests/modules.hpp"
#include "tests/unit/study/study_text.hpp"
#include "tests/unit/temporary_files.hpp"

namespace dmp::tests::sweep_budget_tests {
namespace {

using namespace cli;
constexpr double hour = 3600;  // [s]: what a test takes is nothing beside it

/// Six runs, whose costs are 1, 2, 4, 8, 16 and 32.
class SweepBudgets : public testing::Test {
  protected:
    SweepBudgets() {
        write_file(folder_.path() / sweep_timing_name, "run,wall_s,processor_s,peak_memory_bytes,exit_code\n");
    }
    void took(std::size_t index, double wall_hours, double processor_hours) const {
        append_to_file(folder_.path() / sweep_timing_name, points_.at(index).name + "," +
                                                               std::to_string(wall_hours * hour) + "," +
                                                               std::to_string(processor_hours * hour) + ",0,0\n");
    }
    void ended(std::size_t index) const {
        const auto run = run_folder(folder_.path(), points_.at(index).name);
        std::filesystem::create_directories(run);
        write_file(run / measures_file_name, "time [s]\n0\n");
        write_file(run / summary_file_name, R"({"interrupted": false, "simulated_s": 4})");
    }
    [[nodiscard]] SweepBudget budget(std::optional<double> hours, int jobs = 1, int threads = 1) const {
        if (hours) *hours *= hour;
        return {hours, {1, 2, 4, 8, 16, 32}, points_, folder_.path(), jobs, threads};
    }

    study::Study study_ = study_of(good_study);
    study::Points points_{study_};
    TemporaryFolder folder_;
};

TEST_F(SweepBudgets, ExpectsNothingBeforeARunHasEnded) {
    EXPECT_FALSE(budget({}).expected({0}));
    EXPECT_TRUE(budget(1).may_start(5));
    took(0, 0.5, 0.5);  // of a run that was stopped
    EXPECT_FALSE(budget({}).expected({0}));
}

TEST_F(SweepBudgets, ExpectsByTheMostExpensiveRunThatHasEnded) {
    ended(0);
    took(0, 1, 5);
    ended(1);
    took(1, 1, 2);  // an hour for a cost of 1
    EXPECT_NEAR(*budget({}).expected({2, 3}), 12 * hour, 1);
}

TEST_F(SweepBudgets, StartsWhatIsExpectedToEndWithinIt) {
    ended(1);
    took(1, 2, 2);
    EXPECT_TRUE(budget(6.1).may_start(2)) << "2 h spent, 4 h to come";
    EXPECT_FALSE(budget(5.9).may_start(2));
    EXPECT_TRUE(budget(4.1, 1, 2).may_start(2)) << "on two threads";
    EXPECT_TRUE(budget(5.1, 2).may_start(2)) << "two at a time: 1 h spent";
    EXPECT_TRUE(budget({}).may_start(5));
    EXPECT_FALSE(budget(1.9).may_start(0)) << "spent";
}

TEST_F(SweepBudgets, CountsWhatAStoppedRunHasBehindIt) {
    ended(1);
    took(1, 2, 2);
    took(2, 3, 3);
    EXPECT_TRUE(budget(6.1).may_start(2)) << "5 h spent, 1 h of 4 h to come";
    EXPECT_FALSE(budget(5.9).may_start(2));
}

TEST_F(SweepBudgets, EndsWhenItIsSpent) {
    took(0, 2, 2);
    const auto left = std::chrono::duration<double>(budget(3).end() - WallClock::now()).count();
    EXPECT_LT(left, hour + 1);
    EXPECT_GT(left, 0.5 * hour);
    EXPECT_EQ(budget({}).end(), WallClock::time_point::max());
    EXPECT_EQ(budget(1e12).end(), WallClock::time_point::max());
}

}  // namespace
}  // namespace dmp::tests::sweep_budget_tests
