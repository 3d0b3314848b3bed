// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <filesystem>

#include <gmock/gmock.h>

#include "base/safe_file.hpp"
#include "cli/run_log.hpp"
#include "tests/modules.hpp"
#include "tests/unit/temporary_files.hpp"

namespace dmp::tests::cli_run_log_tests {
namespace {

using namespace cli;
using testing::HasSubstr;

RunProgress at(double time) {
    return {.time = time,
            .until = 4,
            .step = 20512,
            .dt = 8e-5,
            .largest_speed = 0.081,
            .frames = 43,
            .density_low = 0.999,
            .density_high = 1.002};
}

TEST(RunLog, ALineHasStepTimeStepLengthSpeedDensityFramesAndWhatIsLeft) {
    EXPECT_EQ(log_text(at(1.68), 151),
              "step 20512, t = 1.68 of 4 s (42 %), dt 8e-05 s, at most 0.081 m/s, density -0.1 % to +0.2 %, 43 frames, "
              "2 min 31 s left");
    RunProgress of_spheres = at(1.68);
    of_spheres.density_low = of_spheres.density_high = 0;
    EXPECT_EQ(log_text(of_spheres, INFINITY),
              "step 20512, t = 1.68 of 4 s (42 %), dt 8e-05 s, at most 0.081 m/s, 43 frames");
}

TEST(RunLog, HasALineEveryTwoMinutes) {
    const TemporaryFolder folder;
    RunLog log(folder.path(), "dmp run x");
    std::vector<int> lines;
    for (int wall = 1; wall <= 400; ++wall)
        if (!log.progress(at(0.01 * wall), wall).empty()) lines.push_back(wall);
    EXPECT_THAT(lines, testing::ElementsAre(120, 240, 360));
    const std::string text = read_file(folder.path() / run_log_name);
    EXPECT_THAT(text, testing::AllOf(testing::MatchesRegex("^20[0-9-]+ [0-9:]+ UTC  dmp [^\n]+\ndmp run x\n(.|\n)*"),
                                     HasSubstr(" UTC  step 20512, t = 1.2 of 4 s (30 %), ")));
    EXPECT_THAT(text, HasSubstr(", 4 min 40 s left\n")) << "0.01 s a second, 2.8 s of 4 s left";
}

TEST(RunLog, AWarningOfSeveralLinesStaysTogether) {
    const TemporaryFolder folder;
    RunLog(folder.path(), "dmp run x").warn(": first\nsecond\nthird");
    EXPECT_THAT(read_file(folder.path() / run_log_name), testing::EndsWith("warning: first\n  second\n  third\n"));
}

TEST(RunLog, GrowsWithEachRunWithoutColours) {
    const TemporaryFolder folder;
    RunLog(folder.path(), "dmp run x").add("\033[1mA valve\033[0m\n");
    RunLog(folder.path(), "dmp run x --resume").add("on\n");
    EXPECT_THAT(read_file(folder.path() / run_log_name),
                testing::MatchesRegex("[^\n]+\ndmp run x\n\nA valve\n[^\n]+\ndmp run x --resume\n\non\n"));
    std::filesystem::remove(folder.path() / run_log_name);
    RunLog log(folder.path(), "dmp run x");
    std::filesystem::remove(folder.path() / run_log_name);
    log.add("somebody took it away\n");
    EXPECT_EQ(read_file(folder.path() / run_log_name), "somebody took it away\n");
}

}  // namespace
}  // namespace dmp::tests::cli_run_log_tests
