// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include "base/safe_file.hpp"
#include "cli/sweep/sweep_table.hpp"
#include "postproc/tables.hpp"
#include "tests/modules.hpp"
#include "tests/unit/study/study_text.hpp"
#include "tests/unit/temporary_files.hpp"

namespace dmp::tests::sweep_table_tests {
namespace {

using namespace cli;
using testing::HasSubstr;
using testing::StartsWith;

class SweepTables : public testing::Test {
  protected:
    /// The run at this index, with this measures.csv.
    [[nodiscard]] SweepRow row(std::size_t index, const std::string& measures) const {
        write_file(folder_.path() / measures_file_name, measures);
        return finished_row(study_, points_.at(index), folder_.path());
    }
    [[nodiscard]] std::string name(std::size_t index) const { return points_.at(index).name; }

    Study study_ = study_of(good_study);
    Points points_{study_};
    TemporaryFolder folder_;
};

const std::string measured =
    "time [s],flux_in [m^3/s],tip_gap [m]\n0,0,0.1\n1,1e-06,0.5\n2,3e-06,0.2\n3,4e-06,0.3\n4,4e-06,0.25\n";

TEST_F(SweepTables, RowsAreInTheOrderOfTheStudyWhateverOrderTheyComeIn) {
    SweepTable table(study_, points_.size());
    const std::string heading =
        "run,part.leaflets.bending_stiffness [N*m^2],particles.spacing [mm],opening,reached,exit_code,error\n";
    EXPECT_EQ(table.text(), heading);
    table.set(4, failed_row(points_.at(4), 3, "Writing\nerror: it diverged, at once\n  Try something\n"));
    EXPECT_EQ(table.text(), heading + name(4) + ",3e-06,0.2,,,3,\"it diverged, at once\"\n");
    table.set(1, row(1, measured));
    EXPECT_EQ(table.text(),
              "run,part.leaflets.bending_stiffness [N*m^2],particles.spacing [mm],opening [m],reached [s],exit_code,"
              "error\n" +
                  name(1) + ",1e-06,0.2,0.3,1.5,0,\n" + name(4) + ",3e-06,0.2,,,3,\"it diverged, at once\"\n");
}

TEST_F(SweepTables, WhatAResultCannotBeTakenFromIsTheRowsError) {
    const SweepRow other = row(0, "time [s],flux_in [m^3/s]\n0,0\n");
    EXPECT_TRUE(other.failed());
    EXPECT_EQ(other.error, "study.toml:13:11: measures.csv has no column 'tip_gap'");
    EXPECT_EQ(other.exit_code, 0);
    EXPECT_THAT(row(0, "time [s],flux_in [m^3/s],tip_gap [m]\n0,0,x\n4,0,1\n").error, HasSubstr("'x' is not a number"));
    EXPECT_THAT(row(0, "time [s],flux_in [1],tip_gap [m]\n0,0,1\n4,0,1\n").error,
                StartsWith("study.toml:21:9: result.level: found a volume flow, but 'flux_in' is a number"));
    std::filesystem::remove(folder_.path() / measures_file_name);
    EXPECT_THAT(finished_row(study_, points_.at(0), folder_.path()).error, HasSubstr("measures.csv"));
}

TEST_F(SweepTables, NoNumberIsNanAndAnotherUnitIsAnError) {
    SweepTable table(study_, points_.size());
    table.set(0, row(0, "time [s],flux_in [m^3/s],tip_gap [m]\n0,0,0.1\n4,1e-06,nan\n"));
    table.set(1, row(1, "time [s],flux_in [m^3/s],tip_gap [1]\n0,0,0.1\n4,4e-06,0.2\n"));
    EXPECT_THAT(table.text(), HasSubstr(name(0) + ",1e-06,0.1,nan,nan,0,\n"));
    EXPECT_THAT(table.text(), HasSubstr(name(1) + ",1e-06,0.2,,2,0,\"result 'opening' is in 1, that of others in m\""));
    EXPECT_FALSE(table.rows()[0]->failed());
    EXPECT_TRUE(table.rows()[1]->failed());
    EXPECT_EQ(table.rows()[1]->error, "result 'opening' is in 1, that of others in m");
}

TEST_F(SweepTables, AWindowThatTheRunDoesNotReachIsAnError) {
    EXPECT_EQ(row(0, "time [s],flux_in [m^3/s],tip_gap [m]\n0,0,0.1\n1.5,1e-06,0.2\n").error,
              "study.toml:15:8: result 'opening': the run ended at 1.5 s, before 2 s");
    study_.results[0].until = Value<double>(4.0, SourceLocation{"study.toml", 1, 1});
    EXPECT_EQ(row(0, "time [s],flux_in [m^3/s],tip_gap [m]\n0,0,0.1\n3,1e-06,0.2\n").error,
              "study.toml:1:1: result 'opening': the run ended at 3 s, before 4 s");
    write_file(folder_.path() / "summary.json", R"({"interrupted": false, "simulated_s": 4})");
    EXPECT_EQ(row(0, "time [s],flux_in [m^3/s],tip_gap [m]\n0,0,0.1\n3,1e-06,0.2\n").error, "")
        << "the last row may come before the end";
}

TEST_F(SweepTables, AColumnIsOfTheMeasureWithTheLongestName) {
    Measure longer = study_.scene.measures.front();
    longer.name = Value<std::string>("tip_gap_low");
    study_.scene.measures.push_back(longer);
    study_.results[0].column = Value<std::string>("low", SourceLocation{"study.toml", 1, 1});
    EXPECT_EQ(row(0, "time [s],flux_in [m^3/s],tip_gap_low [m],tip_gap_high [m]\n0,0,1,1\n4,0,1,1\n").error,
              "study.toml:1:1: result 'opening': the columns of measure 'tip_gap' are 'high'");
}

TEST_F(SweepTables, EarlierFailuresAreReadFromIt) {
    SweepTable table(study_, points_.size());
    table.set(1, row(1, measured));
    table.set(4, failed_row(points_.at(4), 3, "error: it diverged, \"at once\"\n"));
    write_file(folder_.path() / "results.csv", table.text());
    const auto failures = earlier_failures(folder_.path() / "results.csv");
    ASSERT_EQ(failures.size(), 1U);
    EXPECT_EQ(failures.at(name(4)).exit_code, 3);
    EXPECT_EQ(failures.at(name(4)).error, "it diverged, \"at once\"");
    EXPECT_TRUE(earlier_failures(folder_.path() / "none.csv").empty());
}

TEST(LastError, IsOneLineThatTerminalsMayShow) {
    EXPECT_EQ(last_error("a\nerror: one\n  do\nerror: two: \x1b[31mred\n  do this\n"), "two: \\x1b[31mred");
    EXPECT_EQ(last_error("Writing to x\nterminate called\n\n"), "terminate called");
    EXPECT_EQ(last_error(""), "");
}

}  // namespace
}  // namespace dmp::tests::sweep_table_tests
