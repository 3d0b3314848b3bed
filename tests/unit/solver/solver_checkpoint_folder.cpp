// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <csignal>
#include <random>
#include <thread>

#include <gmock/gmock.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/errors.hpp"
#include "base/safe_file.hpp"
#include "solver/state/checkpoint_file.hpp"
#include "solver/state/checkpoint_folder.hpp"
#include "tests/modules.hpp"
#include "tests/unit/damage.hpp"
#include "tests/unit/temporary_files.hpp"
#include "tests/unit/thrown.hpp"

namespace dmp::tests::solver_checkpoint_folder_tests {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

constexpr std::size_t length = 100000;

class Checkpoints : public ::testing::Test {
  protected:
    Checkpoints() { checkpoints_.make(); }

    /// A checkpoint in which every number is its step.
    void write(long step) const {
        CheckpointWriter writer(checkpoints_.path_for(step));
        writer.contents().write_array<double>("values", std::vector<double>(length, static_cast<double>(step)));
        writer.finish();
    }
    void truncate(long step, std::uintmax_t bytes) const { fs::resize_file(checkpoints_.path_for(step), bytes); }
    void damage(long step) const { flip_bit(checkpoints_.path_for(step), 8 * 5000); }
    [[nodiscard]] std::vector<std::string> files() const { return files_in(folder_.path() / "checkpoints"); }

    TemporaryFolder folder_;
    CheckpointFolder checkpoints_{folder_.path()};
};

TEST_F(Checkpoints, AreNamedForTheirSteps) {
    EXPECT_EQ(checkpoints_.path_for(1234), folder_.path() / "checkpoints/step_000001234.h5");
    EXPECT_EQ(checkpoints_.path_for(12345678901), folder_.path() / "checkpoints/step_12345678901.h5");
}

TEST_F(Checkpoints, NoneWhereThereAreNone) {
    EXPECT_FALSE(checkpoints_.newest_good());
    EXPECT_FALSE(CheckpointFolder(folder_.path() / "nowhere").newest_good());
    for (const char* other : {"notes.txt", "step_12.h5", "step_00000000x.h5", ".step_000000001.h5.unfinished"})
        put_bytes(folder_.path() / "checkpoints" / other, "x");
    EXPECT_FALSE(checkpoints_.newest_good());
}

TEST_F(Checkpoints, TheNewestIsTheOneOfTheLatestStep) {
    for (const long step : {1000000000L, 7L, 999999999L}) write(step);
    const auto found = checkpoints_.newest_good();
    ASSERT_TRUE(found);
    EXPECT_EQ(found->step, 1000000000);
    EXPECT_EQ(found->file, checkpoints_.path_for(1000000000));
    EXPECT_THAT(found->messages, IsEmpty());
}

TEST_F(Checkpoints, ABadOneIsNamedAndTheOneBeforeItUsed) {
    for (const long step : {1, 2}) write(step);
    const std::string whole = std::to_string(fs::file_size(checkpoints_.path_for(2)));
    truncate(2, 1000);
    const auto found = checkpoints_.newest_good();
    ASSERT_TRUE(found);
    EXPECT_EQ(found->step, 1);
    EXPECT_THAT(found->messages, ElementsAre(checkpoints_.path_for(2).string() + " is truncated: 1000 of " + whole +
                                             " bytes; using the one before it, step 1"));
}

TEST_F(Checkpoints, EachBadOneIsNamed) {
    for (const long step : {1, 2, 3}) write(step);
    truncate(2, 0);
    damage(3);
    const auto found = checkpoints_.newest_good();
    ASSERT_TRUE(found);
    EXPECT_EQ(found->step, 1);
    ASSERT_THAT(found->messages, SizeIs(2));
    EXPECT_THAT(found->messages[0], HasSubstr("3.h5 is damaged: its checksum differs; using an earlier one, step 1"));
    EXPECT_THAT(found->messages[1], HasSubstr("2.h5 is empty; using the one before it, step 1"));
}

TEST_F(Checkpoints, OnlyBadOnesAreAnError) {
    for (const long step : {1, 2}) write(step);
    truncate(1, 0);
    damage(2);
    EXPECT_THAT(text_thrown<InputError>([&] { (void)checkpoints_.newest_good(); }),
                ::testing::AllOf(HasSubstr("checkpoints: none of its checkpoints can be used"),
                                 HasSubstr("step_000000001.h5 is empty"), HasSubstr("step_000000002.h5 is damaged"),
                                 HasSubstr("run the scene from its start")));
}

TEST_F(Checkpoints, TheLastTwoStay) {
    for (const long step : {1, 2, 3, 4}) write(step);
    for (const char* other : {"notes.txt", ".step_000000009.h5.unfinished", ".other.unfinished"})
        put_bytes(folder_.path() / "checkpoints" / other, "x");
    checkpoints_.keep_last_two(4);
    EXPECT_THAT(files(), ElementsAre(".other.unfinished", "notes.txt", "step_000000003.h5", "step_000000004.h5"));
}

TEST_F(Checkpoints, TheOneWrittenStaysThoughBadOnesOfLaterStepsAreThere) {
    for (const long step : {100, 200, 300}) write(step);
    damage(200);
    truncate(300, 10);
    ASSERT_EQ(checkpoints_.newest_good()->step, 100);
    write(150);  // the run goes on from step 100
    checkpoints_.keep_last_two(150);
    EXPECT_THAT(files(), ElementsAre("step_000000100.h5", "step_000000150.h5"));
}

TEST_F(Checkpoints, ABadOneDoesNotCountAsOneOfTheTwo) {
    for (const long step : {1, 2, 3}) write(step);
    damage(2);
    checkpoints_.keep_last_two(3);
    EXPECT_THAT(files(), ElementsAre("step_000000001.h5", "step_000000003.h5"));
}

TEST_F(Checkpoints, AFolderThatCannotBeMadeIsAnInputError) {
    put_bytes(folder_.path() / "file", "x");
    EXPECT_THROW(CheckpointFolder(folder_.path() / "file").make(), InputError);
    put_bytes(folder_.path() / "out", "x");
    fs::remove_all(folder_.path() / "checkpoints");
    put_bytes(folder_.path() / "checkpoints", "x");
    EXPECT_THAT(text_thrown<InputError>([&] { (void)checkpoints_.newest_good(); }), HasSubstr("cannot be looked into"));
}

/// Kills processes that write checkpoints, at random moments.
class KilledWriter : public Checkpoints {
  protected:
    /// A process that goes on from `step`; it ends only when it is killed, or with a code when something goes wrong.
    [[nodiscard]] pid_t start(long step) {
        const pid_t child = fork();
        if (child != 0) return child;
        try {
            while (true) {
                write(++step);
                checkpoints_.keep_last_two(step);
            }
        } catch (...) {
            _exit(1);
        }
    }

    /// Whether a checkpoint is being written, or was left so.
    [[nodiscard]] bool has_unfinished() const {
        return std::ranges::any_of(files(), [](const std::string& name) { return finished_name(name).has_value(); });
    }
    /// Kills the process in the middle of the n-th write that is seen, after it has finished a checkpoint.
    void kill_in_write(pid_t child, int n) const {
        for (int seen = 0; seen < n; ++seen) {
            while (seen > 0 && has_unfinished()) std::this_thread::yield();
            while (!has_unfinished()) std::this_thread::yield();
        }
        kill(child, SIGKILL);
        int status = 0;
        waitpid(child, &status, 0);
        EXPECT_TRUE(WIFSIGNALED(status)) << "the writer failed";
    }
};

TEST_F(KilledWriter, LeavesAGoodCheckpointWheneverItDies) {
    std::mt19937 random(5);
    long last = 0;
    for (int cut_short = 0; cut_short < 10;) {
        if (last > 0) checkpoints_.keep_last_two(last);  // removes what the one before left unfinished
        const pid_t child = start(last);
        ASSERT_GT(child, 0);
        // The first one finishes one, so that there is something to lose.
        kill_in_write(child, last == 0 ? 3 : 1 + static_cast<int>(random() % 4));
        if (has_unfinished()) ++cut_short;  // else it was faster than the signal

        const auto found = checkpoints_.newest_good();
        ASSERT_TRUE(found);
        EXPECT_THAT(found->messages, IsEmpty());
        EXPECT_GE(found->step, last);
        last = found->step;
        const CheckpointReader reader(found->file);
        EXPECT_EQ(reader.contents().array<double>("values"), std::vector<double>(length, static_cast<double>(last)));
    }
    checkpoints_.keep_last_two(last);
    EXPECT_THAT(files(), SizeIs(::testing::Le(2U)));
    for (const std::string& name : files()) EXPECT_FALSE(finished_name(name)) << name;
}

}  // namespace
}  // namespace dmp::tests::solver_checkpoint_folder_tests
