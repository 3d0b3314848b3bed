// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <vector>

#include "cli/process_memory.hpp"
#include "cli/sweep/sweep_memory.hpp"
#include "tests/modules.hpp"
#include "tests/unit/study/study_text.hpp"

namespace dmp::tests::sweep_memory_tests {
namespace {

using namespace cli;

constexpr double program = 80e6;

TEST(SweepMemory, GrowsWithTheNumberOfParticles) {
    const Study study = study_of(good_study);  // a plane; spacings of 0.1, 0.2 and 0.4 mm
    const Points points(study);
    SweepMemory memory(study, program);
    EXPECT_EQ(memory.expected(points.at(0)), 0) << "not known";
    memory.take_trial(points.at(1), 180e6);
    EXPECT_DOUBLE_EQ(memory.expected(points.at(1)), 180e6);
    EXPECT_NEAR(memory.expected(points.at(0)), 480e6, 1);
    EXPECT_NEAR(memory.expected(points.at(2)), 105e6, 1);
}

TEST(SweepMemory, WhatWasTakenCountsMoreThanATrial) {
    const Study study = study_of(good_study);
    const Points points(study);
    SweepMemory memory(study, program);
    memory.take_trial(points.at(0), 500e6);
    memory.take_end(points.at(0), 200e6);
    EXPECT_DOUBLE_EQ(memory.expected(points.at(0)), 200e6);
    memory.take_end(points.at(3), 300e6);
    memory.take_end(points.at(0), 100e6);
    EXPECT_DOUBLE_EQ(memory.expected(points.at(0)), 300e6) << "the largest of those that ended";
}

TEST(SweepMemory, ARunFitsBesideOnesThatMayStillGrow) {
    using Running = SweepMemory::Running;
    EXPECT_TRUE(SweepMemory::fits(9e9, 1e9, {})) << "one on its own is tried";
    EXPECT_TRUE(SweepMemory::fits(1e9, 1.5e9, {Running{1e9, 0.6e9}}));
    EXPECT_FALSE(SweepMemory::fits(1e9, 1.5e9, {Running{1e9, 0.4e9}}));
    EXPECT_TRUE(SweepMemory::fits(1e9, 1.5e9, {Running{1e9, 3e9}})) << "which holds more than was expected";
    EXPECT_FALSE(SweepMemory::fits(1e9, 2e9, {Running{1e9, 0.4e9}, Running{1e9, 0.3e9}}));
}

TEST(ProcessMemory, IsThatOfThisProcess) {
    const double before = own_memory().most;
    EXPECT_GT(before, 1e6);
    {
        const std::vector<double> held(20'000'000, 1.0);  // written, so that it is there
        EXPECT_GT(own_memory().now, 160e6 + held.front());
    }
    EXPECT_GE(own_memory().most, before + 100e6);
    EXPECT_EQ(memory_of(0).now, 0) << "no such process";
}

}  // namespace
}  // namespace dmp::tests::sweep_memory_tests
