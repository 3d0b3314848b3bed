// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <limits>

#include <gtest/gtest.h>

#include "cli/text.hpp"
#include "tests/modules.hpp"

namespace dmp::tests::cli_text_tests {

namespace {

using namespace cli;

TEST(Text, CountsAreGroupedByThousands) {
    EXPECT_EQ(count_text(0), "0");
    EXPECT_EQ(count_text(999), "999");
    EXPECT_EQ(count_text(1000), "1 000");
    EXPECT_EQ(count_text(1234567), "1 234 567");
    EXPECT_EQ(count_text(1, "particle"), "1 particle");
    EXPECT_EQ(count_text(94567, "particle"), "94 567 particles");
}

TEST(Text, DurationsUseTheUnitAPersonWould) {
    EXPECT_EQ(duration_text(4.2e-5), "42 us");
    EXPECT_EQ(duration_text(0.004), "4 ms");
    EXPECT_EQ(duration_text(12.34), "12.3 s");
    EXPECT_EQ(duration_text(59.96), "1 min 0 s");
    EXPECT_EQ(duration_text(192), "3 min 12 s");
    EXPECT_EQ(duration_text(7300), "2 h 1 min");
    EXPECT_EQ(duration_text(200000), "2 days 7 h");
    EXPECT_EQ(duration_text(std::numeric_limits<double>::infinity()), "unknown");
}

TEST(Text, BytesInPowersOf1024) {
    EXPECT_EQ(bytes_text(100), "100 B");
    EXPECT_EQ(bytes_text(1536), "1.5 KiB");
    EXPECT_EQ(bytes_text(1.4 * 1024 * 1024 * 1024), "1.4 GiB");
}

TEST(Text, QuantitiesAndPercents) {
    EXPECT_EQ(quantity_text(2.2, "m/s"), "2.2 m/s");
    EXPECT_EQ(quantity_text(8.16497e-5, "s"), "8.165e-05 s");
    EXPECT_EQ(percent_text(0.013), "+1.3 %");
    EXPECT_EQ(percent_text(-0.0002), "-0.02 %");
}

TEST(Text, AListingAlignsItsTexts) {
    Listing list;
    EXPECT_TRUE(list.empty());
    list.add("a", "one");
    list.add("longer", "two");
    EXPECT_EQ(list.text(), "  a       one\n  longer  two\n");
}

}  // namespace

}  // namespace dmp::tests::cli_text_tests
