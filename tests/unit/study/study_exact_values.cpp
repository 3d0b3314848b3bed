// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// What measures should be, by formulas and files, and how far series are from it.
#include <cmath>

#include <gmock/gmock.h>

#include "study/exact_values.hpp"
#include "tests/modules.hpp"
#include "tests/unit/scene/scene_text.hpp"

namespace dmp::tests::study_exact_values_tests {
namespace {

const std::string flow = R"([[measure]]
name = "flow"
kind = "probe"
point = ["1 mm", "1 mm"]

[[reference]]
measure = "flow"
column = "x"
source = "a closed form"
)";

/// Of flow_x; `table` becomes values.csv, which is read at once.
TimeSeries exact(const std::string& more, const std::vector<double>& times, const std::string& table = "") {
    const Folder folder;
    Folder::write(good_scene + flow + more);
    if (!table.empty()) Folder::write(table, "values.csv");
    const Scene scene = read_scene("scene.toml");
    return exact_series(scene, *reference_of(scene, "flow_x"), times);
}

std::string fault_of_table(const std::string& table) {
    try {
        exact("file = \"values.csv\"\n", {0}, table);
    } catch (const InputError& error) {
        return error.what();
    }
    return "no error";
}

TEST(ExactValues, OfAFormulaAreItsValuesAtTheTimes) {
    const std::vector<double> times{0, 0.1, 0.25, 3};
    const TimeSeries series = exact("formula = \"20 cm/s * exp(-t / 500 ms)\"\n", times);
    EXPECT_EQ(series.time, times);
    for (std::size_t i = 0; i < times.size(); ++i)
        EXPECT_NEAR(series.value[i], 0.2 * std::exp(-2 * times[i]), 1e-16) << times[i];
}

TEST(ExactValues, AreNoneOutsideFromAndUntil) {
    const TimeSeries series =
        exact("formula = \"1 m/s\"\nfrom = \"100 ms\"\nuntil = \"300 ms\"\n", {0, 0.09, 0.1, 0.2, 0.1 + 0.2, 0.31});
    EXPECT_TRUE(std::isnan(series.value[0]) && std::isnan(series.value[1]) && std::isnan(series.value[5]));
    EXPECT_EQ(series.value[2], 1);
    EXPECT_EQ(series.value[3], 1);
    EXPECT_EQ(series.value[4], 1) << "rounding errors of times";
}

TEST(ExactValues, OfAFileAreOnStraightLinesBetweenItsRows) {
    const std::string table = "time [ms],other,flow_x [cm/s]\n100,a,1\n\n200,b,3\n400,c,-1\n";
    const TimeSeries series =
        exact("file = \"values.csv\"\n", {0, 0.1, 0.15, 0.2, 0.25, 0.4, 0.4 + 1e-12, 0.41}, table);
    const std::vector<double> wanted{NAN, 0.01, 0.02, 0.03, 0.02, -0.01, -0.01, NAN};
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        EXPECT_EQ(std::isnan(series.value[i]), std::isnan(wanted[i])) << series.time[i];
        if (std::isnan(wanted[i])) continue;
        EXPECT_NEAR(series.value[i], wanted[i], 1e-12) << series.time[i];
    }
    const TimeSeries part = exact("file = \"values.csv\"\nfrom = \"0.2 s\"\n", {0.15, 0.25}, table);
    EXPECT_TRUE(std::isnan(part.value[0]));
    EXPECT_NEAR(part.value[1], 0.02, 1e-12);
}

TEST(ExactValues, AreThoseOfTheColumn) {
    const Scene scene = read_text(good_scene + flow + "formula = \"1 m/s\"\n");
    ASSERT_NE(reference_of(scene, "flow_x"), nullptr);
    EXPECT_EQ(*reference_of(scene, "flow_x")->source, "a closed form");
    EXPECT_EQ(reference_of(scene, "flow_y"), nullptr);
    EXPECT_EQ(reference_of(scene, "flow"), nullptr);
}

TEST(ExactValues, OfAWrongFileSayWhatIsWrong) {
    EXPECT_EQ(fault_of_table(""),
              "scene.toml:55:8: reference.file: there is no file './values.csv'\n"
              "  give a CSV file relative to the folder of the scene");
    EXPECT_EQ(fault_of_table("\n0\n"),
              "./values.csv:1:1: the table has no column 'time', for the times\n"
              "  its columns are '': write the heading as 'time [UNIT]'");
    EXPECT_EQ(fault_of_table("time [s],flow [m/s]\n0,1\n"),
              "./values.csv:1:1: the table has no column 'flow_x', of the measure\n"
              "  its columns are 'time' and 'flow': write the heading as 'flow_x [UNIT]'");
    EXPECT_EQ(fault_of_table("time [s],flow_x [m]\n0,1\n1,1\n"),
              "./values.csv:1:1: 'flow_x' is a length here, expected a speed\n"
              "  give it in m/s, or another unit of the same quantity");
    EXPECT_EQ(fault_of_table("time,flow_x [m/s]\n0,1\n1,1\n"),
              "./values.csv:1:1: 'time' is a number here, expected a time\n"
              "  give it in s, or another unit of the same quantity");
    EXPECT_EQ(fault_of_table("time [s],flow_x [m/s]\n"),
              "./values.csv:1:1: the table has a heading only\n  write a line for each point below it");
    EXPECT_EQ(fault_of_table("time [s],flow_x [m/s]\n0,1\n"),
              "./values.csv:2:1: the table has one line, and a curve needs two\n"
              "  add lines, or write a constant as a formula");
    EXPECT_EQ(fault_of_table("time [s],flow_x [m/s]\n0,1\n1,1,1\n"),
              "./values.csv:3:1: found 3 values, expected 2\n  give each line a value for each column of the heading");
    for (const char* second : {"0,2", "-1,2"})
        EXPECT_EQ(fault_of_table(std::string("time [s],flow_x [m/s]\n0,1\n") + second + "\n"),
                  std::string("./values.csv:3:1: the time ") + std::string(second, std::string(second).find(',')) +
                      " does not come after the one before\n  sort the lines by time, and keep one of each");
    for (const char* value : {"nan", "inf", "fast", "", "1e999"})
        EXPECT_THAT(fault_of_table(std::string("time [s],flow_x [m/s]\n0,1\n1,") + value + "\n"),
                    testing::StartsWith("./values.csv:3:1: "))
            << value;
}

/// Of sin(t) over a period.
TimeSeries wave(double factor) {
    TimeSeries series;
    for (int i = 0; i <= 1000; ++i) series.add(2 * M_PI * i / 1000, factor * std::sin(2 * M_PI * i / 1000));
    return series;
}

TEST(ErrorsOf, AColumnAreThoseOfItsSeries) {
    const std::vector<SeriesError> errors = errors_of({"a", "b"}, {wave(1.05), wave(1)}, {wave(1), TimeSeries{}});
    EXPECT_NEAR(errors[0].whole, 0.05, 1e-12);
    EXPECT_NEAR(errors[0].peak, 0.05, 1e-12);
    EXPECT_NEAR(errors[0].largest(), 0.05, 1e-12);
    EXPECT_TRUE(std::isnan(errors[1].largest())) << "nothing is known of it";
}

TEST(ErrorsOf, AComponentAreInTheSizeOfItsVector) {
    const auto errors = [](const std::string& x, const std::string& y) {
        return errors_of({x, y}, {wave(3), wave(0.06)}, {wave(3), wave(0)});
    };
    EXPECT_NEAR(errors("flow_x", "flow_y")[1].whole, 0.02, 1e-12);
    EXPECT_TRUE(std::isnan(errors("flow_x", "other_y")[1].whole)) << "a size of 0";
}

}  // namespace
}  // namespace dmp::tests::study_exact_values_tests
