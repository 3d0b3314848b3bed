// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "base/nearest_name.hpp"

#include <vector>

#include <gtest/gtest.h>

#include "tests/modules.hpp"

namespace dmp::tests::nearest_name_tests {
namespace {

std::string nearest(std::string_view name, const std::vector<std::string>& candidates) {
    return nearest_name(name, candidates);
}

TEST(NearestName, OneEditInAShortWord) {
    EXPECT_EQ(nearest("titel", {"dimension", "title"}), "title");  // a swap
    EXPECT_EQ(nearest("ttile", {"title"}), "title");
    EXPECT_EQ(nearest("itle", {"title"}), "title");
    EXPECT_EQ(nearest("tittle", {"title"}), "title");
    EXPECT_EQ(nearest("tytle", {"title"}), "title");
    EXPECT_EQ(nearest("title", {"title"}), "title");
    EXPECT_EQ(nearest("ba", {"ab"}), "ab");  // one edit is always near
}

TEST(NearestName, AThirdOfTheLongerWordMayChange) {
    EXPECT_EQ(nearest("abcxef", {"abcdef"}), "abcdef");
    EXPECT_EQ(nearest("abxxef", {"abcdef"}), "abcdef");  // 2 of 6
    EXPECT_EQ(nearest("axxxef", {"abcdef"}), "");        // 3 of 6
    EXPECT_EQ(nearest("abxxe", {"abcde"}), "");          // 2 of 5
    EXPECT_EQ(nearest("bacdfe", {"abcdef"}), "abcdef");  // two swaps
    EXPECT_EQ(nearest("badcfe", {"abcdef"}), "");        // three swaps
    EXPECT_EQ(nearest("abcdefghi", {"abcdef"}), "abcdef");
    EXPECT_EQ(nearest("cab", {"abc"}), "");  // c moves over two letters: two edits
}

TEST(NearestName, TheNearestWinsAndOfEqualsTheFirst) {
    EXPECT_EQ(nearest("leaflet", {"leaves", "leafletts", "leaflets"}), "leaflets");
    EXPECT_EQ(nearest("wall", {"ball", "wells", "tall"}), "ball");
    EXPECT_EQ(nearest("wall", {"ball", "wall"}), "wall");
}

TEST(NearestName, NothingToChooseFrom) {
    EXPECT_EQ(nearest("title", {}), "");
    EXPECT_EQ(nearest("title", {"", "x"}), "");
    EXPECT_EQ(nearest("", {"title"}), "");
    EXPECT_EQ(nearest("", {}), "");
}

TEST(QuotedList, ReadsLikeASentence) {
    EXPECT_EQ(quoted_list({}), "nothing");
    EXPECT_EQ(quoted_list(std::vector<std::string>{"a"}), "'a'");
    EXPECT_EQ(quoted_list(std::vector<std::string>{"a", "b"}), "'a' and 'b'");
    EXPECT_EQ(quoted_list(std::vector<std::string>{"a", "b", "c"}), "'a', 'b' and 'c'");
}

}  // namespace
}  // namespace dmp::tests::nearest_name_tests
