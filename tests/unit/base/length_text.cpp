// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "base/length_text.hpp"

#include <gtest/gtest.h>

#include "tests/modules.hpp"

namespace dmp::tests::length_text_tests {
namespace {

TEST(LengthText, has_the_unit_that_reads_well) {
    EXPECT_EQ(length_text(1.5), "1.5 m");
    EXPECT_EQ(length_text(0.25), "250 mm");
    EXPECT_EQ(length_text(2e-4), "0.2 mm");
    EXPECT_EQ(length_text(4e-6), "4 um");
    EXPECT_EQ(length_text(6.6e-8), "66 nm");
    EXPECT_EQ(length_text(0), "0 m");
    EXPECT_EQ(length_text(-2e-4), "-0.2 mm");
}

TEST(LengthText, among_others_has_theirs) {
    EXPECT_EQ(length_text(2e-5, 0.01), "0.02 mm");
    EXPECT_EQ(length_text(1e-17, 0.01), "0 mm");
}

TEST(LengthText, of_a_place_is_in_one_unit) {
    EXPECT_EQ(position_text({0.0005, 0, -0.00325}), "(0.5, 0, -3.25) mm");
    EXPECT_EQ(position_text({0.0005, 2, 0}, 2), "(0.0005, 2) m");
    EXPECT_EQ(position_text({3.99988, 1.015625, 0}, 2), "(3.9999, 1.0156) m");
    EXPECT_EQ(position_text(Vec::Zero()), "(0, 0, 0) m");
}

TEST(LengthText, of_a_box_is_its_extent) {
    const Box box{{1, 1, 1}, {1.04, 1.008, 1.008}};
    EXPECT_EQ(extent_text(box), "40 x 8 x 8 mm");
    EXPECT_EQ(extent_text(box, 2), "40 x 8 mm");
}

}  // namespace
}  // namespace dmp::tests::length_text_tests
