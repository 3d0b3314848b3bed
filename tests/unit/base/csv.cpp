// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "base/csv.hpp"

#include <limits>

#include <gmock/gmock.h>

#include "tests/modules.hpp"

namespace dmp::tests::csv_tests {
namespace {

using testing::ElementsAre;
using testing::Pair;

TEST(Csv, CellsComeBackAsTheyWere) {
    const std::vector<std::string> cells{"plain", "", "a, b", "6\" pipe", " \"x\", y"};
    std::string line;
    for (const std::string& cell : cells) line += (line.empty() ? "" : ",") + csv_cell(cell);
    EXPECT_EQ(line, "plain,,\"a, b\",\"6\"\" pipe\",\" \"\"x\"\", y\"");
    EXPECT_EQ(csv_cells(line), cells);
    EXPECT_THAT(csv_cells(""), ElementsAre(""));
}

TEST(Csv, NumbersAreTheShortestThatReadBack) {
    EXPECT_EQ(csv_number(0.1), "0.1");
    EXPECT_EQ(csv_number(1e-300), "1e-300");
    EXPECT_EQ(csv_number(-std::numeric_limits<double>::quiet_NaN()), "nan");
}

TEST(Csv, HeadingsHaveUnits) {
    EXPECT_EQ(csv_heading("flux", "m^3/s"), "flux [m^3/s]");
    EXPECT_EQ(csv_heading("exit_code", ""), "exit_code");
    EXPECT_THAT(name_and_unit("flux [m^3/s]"), Pair("flux", "m^3/s"));
    EXPECT_THAT(name_and_unit("exit_code"), Pair("exit_code", ""));
}

}  // namespace
}  // namespace dmp::tests::csv_tests
