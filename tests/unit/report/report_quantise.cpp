// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <limits>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "report/quantise.hpp"
#include "tests/modules.hpp"

namespace dmp::tests::report_quantise_tests {
namespace {

const double none = std::numeric_limits<double>::quiet_NaN();

TEST(StepOf, IsTheNearestOf65536) {
    EXPECT_EQ(step_of(-1, -1, 3), 0);
    EXPECT_EQ(step_of(3, -1, 3), 65535);
    EXPECT_EQ(step_of(1, -1, 3), 32768);
    EXPECT_EQ(step_of(5, 5, 5), 0) << "all in one plane";
    for (double x = 2; x <= 9; x += 0.001) {
        const double back = 2 + 7.0 * step_of(x, 2, 9.001) / 65535 * (7.001 / 7.0);
        EXPECT_NEAR(back, x, 0.51 * 7.001 / 65535);
    }
}

TEST(StepOf, RefusesWhatIsOutside) {
    EXPECT_THROW(static_cast<void>(step_of(3.1, -1, 3)), std::invalid_argument);
    EXPECT_THROW(static_cast<void>(step_of(none, -1, 3)), std::invalid_argument);
}

TEST(ColourRangeOf, GoesFromThe1stToThe99thPercentile) {
    std::vector<float> values;
    for (int k = 0; k <= 100; ++k) values.push_back(static_cast<float>(1000 + k));
    values[7] = std::numeric_limits<float>::infinity();
    values[8] = std::numeric_limits<float>::quiet_NaN();
    const ColourRange range = colour_range(values, false);
    EXPECT_TRUE(range.any);
    EXPECT_FALSE(range.diverging);
    EXPECT_NEAR(range.low, 1000, 1.1);
    EXPECT_NEAR(range.high, 1100, 2.1);
}

TEST(ColourRangeOf, GoesToZeroWhereThatIsNearAndIsEvenAroundIt) {
    std::vector<float> speeds{1, 2, 3, 40}, both{-3, 0, 1}, pressures{5, 6}, below{-9, -2, -1};
    EXPECT_EQ(colour_range(speeds, false).low, 0);
    const ColourRange range = colour_range(both, false);
    EXPECT_TRUE(range.diverging);
    EXPECT_EQ(range.low, -range.high);
    EXPECT_EQ(range.high, 3);
    EXPECT_TRUE(colour_range(pressures, true).diverging);
    EXPECT_EQ(colour_range(below, false).high, 0);
    std::vector<float> empty{std::numeric_limits<float>::quiet_NaN()};
    EXPECT_FALSE(colour_range(empty, false).any);
}

TEST(ColourOf, IsTheNearestAndThatOfTheEndBeyond) {
    const ColourRange range{10, 20, false, true};
    EXPECT_EQ(colour_of(10, range), 0);
    EXPECT_EQ(colour_of(20, range), 254);
    EXPECT_EQ(colour_of(15, range), 127);
    EXPECT_EQ(colour_of(-5, range), 0);
    EXPECT_EQ(colour_of(std::numeric_limits<double>::infinity(), range), 254);
    EXPECT_EQ(colour_of(none, range), colour_of_nan);
    EXPECT_EQ(colour_of(3, {3, 3, false, true}), 127) << "a constant";
}

TEST(Append, PutsTheLowByteFirst) {
    std::string bytes;
    append(bytes, std::uint16_t{0x1234});
    append(bytes, std::uint32_t{0x89abcdef});
    EXPECT_EQ(bytes, "\x34\x12\xef\xcd\xab\x89");
}

}  // namespace
}  // namespace dmp::tests::report_quantise_tests
