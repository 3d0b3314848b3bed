// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "base/shell_word.hpp"

#include <gtest/gtest.h>

#include "tests/modules.hpp"

namespace dmp::tests::shell_word_tests {
namespace {

TEST(ShellWord, IsQuotedWhereAShellWouldReadIt) {
    EXPECT_EQ(shell_word("cases/vein_valve"), "cases/vein_valve");
    EXPECT_EQ(shell_word("particles.spacing=0.4"), "particles.spacing=0.4");
    EXPECT_EQ(shell_word("0.2 s"), "'0.2 s'");
    EXPECT_EQ(shell_word(""), "''");
    EXPECT_EQ(shell_word("$(rm x)"), "'$(rm x)'");
    EXPECT_EQ(shell_word("it's"), R"('it'\''s')");
    EXPECT_EQ(shell_word("~/out"), "'~/out'");
}

TEST(QuotedCommand, CanBePastedWhateverTheFileIsCalled) {
    EXPECT_EQ(quoted_command("gmsh", "part.geo"), "'gmsh part.geo'");
    EXPECT_EQ(quoted_command("gmsh", "my part.geo"), "gmsh 'my part.geo'");
    EXPECT_EQ(quoted_command("dmp inspect", "$(rm x).stl"), "dmp inspect '$(rm x).stl'");
}

}  // namespace
}  // namespace dmp::tests::shell_word_tests
