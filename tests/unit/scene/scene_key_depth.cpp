// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Keys of so many parts that the TOML library would run out of stack.
#include <gmock/gmock.h>

#include "base/errors.hpp"
#include "scene/key_depth.hpp"
#include "tests/modules.hpp"
#include "tests/unit/scene/scene_text.hpp"
#include "tests/unit/thrown.hpp"

namespace dmp::tests::scene_key_depth_tests {
namespace {

std::string deep_key(int parts) {
    std::string key = "a";
    for (int k = 1; k < parts; ++k) key += k % 2 == 0 ? " . \"b.c\"" : ".b";
    return key;
}

std::string fault(const std::string& text) {
    return text_thrown<InputError>([&] { check_key_depth(text, "scene.toml"); });
}

TEST(KeyDepth, a_hundred_thousand_parts_are_refused_wherever_they_stand) {
    const std::string deep = deep_key(100'000);
    for (const std::string& line :
         {deep + " = 1\n", "[" + deep + "]\n", "[[" + deep + "]]\n", "x = { " + deep + " = 1 }"})
        EXPECT_THAT(fault_of(good_scene + line), testing::HasSubstr(": a key of more than 32 parts\n  "));
}

TEST(KeyDepth, says_where) {
    std::string key = "a";
    for (int k = 0; k < 100; ++k) key += ".b";
    EXPECT_EQ(fault("b = 1\n " + key).substr(0, 18), "scene.toml:2:67: a");
    EXPECT_EQ(fault(deep_key(33)), "nothing was thrown");
    EXPECT_NE(fault(deep_key(34)), "nothing was thrown");
}

TEST(KeyDepth, dots_in_texts_comments_and_formulas_are_none_of_keys) {
    const std::string dots(1000, '.');
    for (const std::string& text : {"a = \"" + dots + "\"", "a = '" + dots + "'", "a = \"\"\"\n" + dots + "\n\"\"\"\n",
                                    "a = '''" + dots + "'''", "# " + dots, "a = \"\\\"" + dots + "\""})
        EXPECT_EQ(fault(text), "nothing was thrown") << text;
    std::string sum = "value = 0.1";
    for (int k = 0; k < 100; ++k) sum += " + 0.1*../x";
    EXPECT_EQ(fault(sum), "nothing was thrown");
}

}  // namespace
}  // namespace dmp::tests::scene_key_depth_tests
