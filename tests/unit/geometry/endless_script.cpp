// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Scripts that would keep gmsh busy without end, or fill the memory: refused before it sees them.
#include "geometry/endless_script.hpp"

#include <gmock/gmock.h>

#include "base/errors.hpp"
#include "geometry/script_numbers.hpp"
#include "tests/modules.hpp"
#include "tests/unit/thrown.hpp"

namespace dmp::tests::endless_script_tests {
namespace {

using ::testing::HasSubstr;

std::string fault(const std::string& text) {
    return text_thrown<InputError>([&] { check_that_it_ends(script_tokens(text, "d.geo"), {"d.geo"}); });
}

std::optional<double> value_of(const std::string& text) {
    const std::vector<ScriptToken> tokens = script_tokens(text, "d.geo");
    return ScriptNumbers(tokens).value(0, tokens.size());
}

TEST(ScriptNumbers, AreWorkedOutByPrecedence) {
    EXPECT_EQ(value_of("1 + 2 * 3 ^ 2 - 4 / 8"), 18.5);
    EXPECT_EQ(value_of("-(2 - 5) * +2"), 6);
    EXPECT_EQ(value_of("-2 ^ 2"), -4);
    EXPECT_EQ(value_of("2 ^ 3 ^ 2"), 512);
    EXPECT_NEAR(value_of("2*Pi").value(), 6.283185307179586, 1e-15);
}

TEST(ScriptNumbers, AreNoneWhereMoreStandsThere) {
    for (const char* text : {"", "a", "1 +", "(1", "1 2", "Sqrt(2)", "1 == 2", "#a", "a[0]", "{1}"})
        EXPECT_EQ(value_of(text), std::nullopt) << text;
    EXPECT_EQ(value_of(std::string(100'000, '(')), std::nullopt);
    EXPECT_EQ(value_of(std::string(100'000, '-') + "1"), std::nullopt);
}

TEST(EndlessScript, ListsThatFillTheMemoryAreNamedWithTheirPlace) {
    EXPECT_EQ(fault("b = 1;\na[] = {1:1e12};\n"),
              "d.geo:2:7: this list is of 1e+12 numbers, more than the 1e+07 that dmp lets gmsh begin\n"
              "  Correct its ends, or its step.");
    for (const char* text : {"a() = {0 : 1 : 1e-9};", "a[] = {5, 1e9:1, 7};", "n = 1e6; m = 100 * n; a[] = {1:m};",
                             "Physical Point(\"p\") = {1:1e8};", "a[] = {1:6e6, 1:6e6};", "a[] = {-1e8 : 0};"})
        EXPECT_THAT(fault(text), HasSubstr("this list is of")) << text;
}

TEST(EndlessScript, LoopsOfTooManyRoundsAreNamed) {
    for (const char* text :
         {"For i In {1 : 1e9}\n a = i;\nEndFor\n", "For (1 : 1e9)\n a = 1;\nEndFor\n", "For i In {1:2:1e-9} EndFor",
          "For i In {1:1e4}\nFor j In {1:1e4}\n a = i;\nEndFor\nEndFor\n"})
        EXPECT_THAT(fault(text), HasSubstr("this loop takes ")) << text;
}

TEST(EndlessScript, MacrosThatAlwaysCallThemselvesAreNamed) {
    EXPECT_EQ(fault("Macro f\n  Call f;\nReturn\nCall f;\n"),
              "d.geo:2:3: the macro 'f' has no end: it calls itself each time\n"
              "  Call it within If ... EndIf, by a condition that comes to hold no more.");
    EXPECT_THAT(fault("Macro f\nCall g;\nReturn\nFunction g\nCall h;\nReturn\nMacro h\nCall g;\nReturn\n"),
                HasSubstr(":8:1: the macro 'g' has no end"));
    std::string chain;
    for (int k = 0; k < 20'000; ++k)
        chain += "Macro m" + std::to_string(k) + "\nCall m" + std::to_string(k + 1) + ";\nReturn\n";
    EXPECT_EQ(fault(chain), "nothing was thrown");
    EXPECT_THAT(fault(chain + "Macro m20000\nCall m0;\nReturn\n"), HasSubstr("has no end"));
}

TEST(EndlessScript, WhatEndsOrCannotBeToldIsLetThrough) {
    for (const char* text :
         {"a[] = {1:1e6};", "For i In {1:1000} For j In {1:1000} a = i; EndFor EndFor", "a[] = {1e12, 3};",
          "a[] = {1:10:0};", "n = 1e12; n = 3; a[] = {1:n};", "n = 1; n += 1e12; a[] = {1:n};",
          "DefineConstant[ n = {1e12, Name \"n\"} ]; a[] = {1:n};", "a[] = {b > 1 ? 1 : 1e12};", "Point{:};",
          "For i In {1:1000}\nEndFor\nFor i In {1:1e5}\nEndFor\nFor i In {1:1e5}\nEndFor\n",
          "Macro f\nIf (n > 0)\n n -= 1;\n Call f;\nEndIf\nReturn\n", "Macro f\na = 1;\nReturn\nCall f; Call f;\n",
          "}}}])", "{{{", ":", "For", "EndFor EndFor"})
        EXPECT_EQ(fault(text), "nothing was thrown") << text;
}

}  // namespace
}  // namespace dmp::tests::endless_script_tests
