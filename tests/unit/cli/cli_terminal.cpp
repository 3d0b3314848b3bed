// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "cli/terminal.hpp"
#include "tests/modules.hpp"

namespace dmp::tests::cli_terminal_tests {

namespace {

using namespace cli;

TEST(Printable, TextStaysAsItIs) {
    const std::string text = "5 \xC2\xB5m, na\xC3\xAFve \xE2\x88\x87p, \xF0\x9F\x8C\x8A\n\tin two lines\n";
    EXPECT_EQ(printable(text, false), text);
}

TEST(Printable, WhatATerminalWouldDoIsShown) {
    EXPECT_EQ(printable("a\033[2Jb", false), "a\\x1b[2Jb");
    EXPECT_EQ(printable("\033]0;title\007", false), "\\x1b]0;title\\x07");
    EXPECT_EQ(printable("over\rwritten\b\x7f", false), "over\\x0dwritten\\x08\\x7f");
    EXPECT_EQ(printable("\xC2\x9B"
                        "2J",
                        false),
              "\\xc2\\x9b2J")
        << "U+009B begins sequences too";
}

TEST(Printable, BytesThatAreNoUtf8AreShown) {
    EXPECT_EQ(printable("\x9b"
                        "2J\xE9",
                        false),
              "\\x9b2J\\xe9");
    EXPECT_EQ(printable("cut \xE2\x88", false), "cut \\xe2\\x88");
    EXPECT_EQ(printable("\xC0\x9B", false), "\\xc0\\x9b");
}

TEST(Printable, OnlyTheMarksOfStyleStayAndOnlyWhereItMakesThem) {
    const std::string marked = Style(true).error("error:") + " " + Style(true).strong("here");
    EXPECT_EQ(printable(marked, true), marked);
    EXPECT_EQ(printable(marked, false), "\\x1b[1;31merror:\\x1b[0m \\x1b[1mhere\\x1b[0m");
    EXPECT_EQ(printable("\033[8mhidden", true), "\\x1b[8mhidden");
}

TEST(ErasedLine, IsErasedByTheTerminal) {
    testing::internal::CaptureStderr();
    print_error("step 1");
    erase_error_line();
    print_error("step 2\033[2J");
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "step 1\r\033[Kstep 2\\x1b[2J");
}

TEST(WithoutMarks, TextKeepsAllElse) {
    const std::string marked = Style(true).error("error:") + " a\033[2Jb, an m";
    EXPECT_EQ(without_marks(marked), "error: a\033[2Jb, an m");
}

}  // namespace

}  // namespace dmp::tests::cli_terminal_tests
