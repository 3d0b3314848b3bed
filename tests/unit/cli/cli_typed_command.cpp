// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <fstream>

#include <gmock/gmock.h>

#include "base/errors.hpp"
#include "cli/arguments.hpp"
#include "cli/typed_command.hpp"
#include "tests/modules.hpp"
#include "tests/unit/temporary_files.hpp"

namespace dmp::tests::cli_typed_command_tests {
namespace {

using namespace cli;

TEST(TypedCommand, GetsAnOption) {
    const TypedCommand typed({"./dmp", "run", "my case", "--set", "part.a.b=\"1 mm\""});
    EXPECT_EQ(typed.with("--resume"), "./dmp run 'my case' --set 'part.a.b=\"1 mm\"' --resume");
    EXPECT_EQ(typed.on_ranks(4).with("--overwrite"),
              "mpirun -n 4 ./dmp run 'my case' --set 'part.a.b=\"1 mm\"' --overwrite");
    EXPECT_EQ(typed.on_ranks(1).with("--resume"), typed.with("--resume"));
}

TEST(TypedCommand, LosesWhatTheOptionExcludes) {
    const TypedCommand typed({"dmp", "run", "x", "--resume", "--out", "there", "--threads", "2"});
    EXPECT_EQ(typed.with("--overwrite"), "dmp run x --out there --threads 2 --overwrite");
    EXPECT_EQ(typed.with("--resume"), "dmp run x --out there --threads 2 --resume");
}

TEST(TypedCommand, IsNotStartedAgainWhereItIsResumed) {
    const TypedCommand typed({"dmp", "run", "x", "--from", "out/y@1 s", "--out", "there"});
    EXPECT_EQ(typed.with("--resume"), "dmp run x --out there --resume");
    EXPECT_EQ(typed.with("--overwrite"), "dmp run x --from 'out/y@1 s' --out there --overwrite");
    EXPECT_EQ(TypedCommand({"dmp", "run", "--from=out/y", "x"}).with("--resume"), "dmp run x --resume");
}

TEST(TypedCommand, GetsAnotherFolder) {
    EXPECT_EQ(TypedCommand({"dmp", "run", "x", "--out", "a b", "--overwrite"}).into("a b_2"),
              "dmp run x --out 'a b_2'");
    EXPECT_EQ(TypedCommand({"dmp", "run", "--out=there", "x"}).into("out/x_2"), "dmp run x --out out/x_2");
}

TEST(NextFree, IsTheFirstThatIsNotThere) {
    const TemporaryFolder folder;
    EXPECT_EQ(next_free(folder.path() / "valve"), folder.path() / "valve_2");
    std::filesystem::create_directory(folder.path() / "valve_2");
    std::ofstream(folder.path() / "valve_3") << "a file";
    EXPECT_EQ(next_free(folder.path() / "valve"), folder.path() / "valve_4");
    EXPECT_EQ(next_free(folder.path() / "valve/"), folder.path() / "valve_4");
}

TEST(Arguments, OverwriteExcludesResumeAndTheLineIsKept) {
    const std::vector<const char*> line{"./dmp", "run", "x", "--overwrite"};
    const auto run = std::get<RunCommand>(read_arguments(line));
    EXPECT_TRUE(run.overwrite);
    EXPECT_EQ(run.typed.with("--resume"), "./dmp run x --resume");
    const std::vector<const char*> both{"dmp", "run", "x", "--overwrite", "--resume"};
    EXPECT_THROW((void)read_arguments(both), InputError);
}

}  // namespace
}  // namespace dmp::tests::cli_typed_command_tests
