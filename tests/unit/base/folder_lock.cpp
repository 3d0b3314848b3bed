// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "base/folder_lock.hpp"

#include <array>
#include <chrono>
#include <csignal>
#include <fstream>
#include <thread>

#include <gmock/gmock.h>
#include <sys/wait.h>

#include "base/errors.hpp"
#include "base/safe_file.hpp"
#include "tests/modules.hpp"
#include "tests/unit/temporary_files.hpp"
#include "tests/unit/thrown.hpp"

namespace dmp::tests::folder_lock_tests {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// A process that has ended; with `wait`, its parent knows.
pid_t ended_process(bool wait) {
    const pid_t child = fork();
    if (child == 0) _exit(0);
    siginfo_t facts{};
    waitid(P_PID, static_cast<id_t>(child), &facts, WEXITED | WNOWAIT);
    if (wait) waitpid(child, nullptr, 0);
    return child;
}

class Lock : public testing::Test {
  protected:
    [[nodiscard]] FolderLock::Outcome take() const { return FolderLock::take(folder_.path()); }
    [[nodiscard]] fs::path file() const { return folder_.path() / lock_file_name; }

    void put(const ProcessIdentity& process, const std::string& token = "0123") const {
        std::ofstream(file()) << "host = " << process.host << "\nmachine = " << process.machine
                              << "\npid = " << process.pid << "\nstarted = " << process.started
                              << "\nsince = 2026-01-02 03:04:05 UTC\ntoken = " << token << '\n';
    }
    /// As if its last sign of life had come so long ago.
    void silent_for(double seconds) const {
        fs::last_write_time(
            file(), fs::file_time_type::clock::now() - std::chrono::milliseconds(static_cast<long>(1e3 * seconds)));
    }
    [[nodiscard]] static ProcessIdentity elsewhere() { return {"node17", "another boot pid:[1]", 4711, 99}; }
    void expect_taken_over() const {
        const auto outcome = take();
        EXPECT_TRUE(outcome.lock);
        EXPECT_TRUE(outcome.taken_from);
        EXPECT_THAT(files_in(folder_.path()), ElementsAre(lock_file_name)) << "nothing else may be left";
    }
    void expect_held() const {
        const std::string before = read_file(file());
        const auto outcome = take();
        EXPECT_FALSE(outcome.lock);
        EXPECT_TRUE(outcome.holder);
        EXPECT_EQ(read_file(file()), before);
        EXPECT_THAT(files_in(folder_.path()), ElementsAre(lock_file_name));
    }

    TemporaryFolder folder_;
};

TEST_F(Lock, IsForOneAndGoesWithIt) {
    auto first = take();
    ASSERT_TRUE(first.lock);
    EXPECT_FALSE(first.taken_from);
    const auto second = take();
    EXPECT_FALSE(second.lock);
    ASSERT_TRUE(second.holder);
    EXPECT_EQ(second.holder->process, this_process());
    EXPECT_THAT(second.holder->text(), HasSubstr("process " + std::to_string(getpid()) + " on "));
    first.lock.reset();
    EXPECT_THAT(files_in(folder_.path()), IsEmpty());
    EXPECT_TRUE(take().lock);
}

TEST_F(Lock, OfAnEndedProcessIsTakenOver) {
    for (const bool wait : {false, true}) {
        ProcessIdentity process = this_process();
        process.pid = ended_process(wait);
        process.started = 0;
        put(process);
        expect_taken_over();
    }
}

TEST_F(Lock, OfAZombieIsTakenOver) {
    const pid_t child = ended_process(false);
    ProcessIdentity process = this_process();
    process.pid = child;
    std::ifstream stat("/proc/" + std::to_string(child) + "/stat");
    for (int value = 1; value < 22; ++value) stat.ignore(1000, ' ');
    stat >> process.started;
    EXPECT_EQ(state_of(process), ProcessState::ended);
    waitpid(child, nullptr, 0);
}

TEST_F(Lock, OfANumberThatWentToAnotherProcessIsTakenOver) {
    ProcessIdentity process = this_process();
    process.started -= 1;
    put(process);
    expect_taken_over();
}

TEST_F(Lock, OfARunningProcessIsHeldHoweverSilentItIs) {
    put(this_process());
    silent_for(10 * FolderLock::silence_limit_s);
    expect_held();
}

TEST_F(Lock, OfAnotherMachineIsHeldUntilItIsSilentTooLong) {
    put(elsewhere());
    expect_held();
    EXPECT_EQ(take().holder->text(), "process 4711 on node17, since 2026-01-02 03:04:05 UTC");
    silent_for(0.5 * FolderLock::silence_limit_s);
    expect_held();
    silent_for(-1000);  // a clock that is ahead
    expect_held();
    silent_for(1.5 * FolderLock::silence_limit_s);
    expect_taken_over();
}

TEST_F(Lock, ThatCannotBeReadIsHeldUntilItIsSilentTooLong) {
    std::ofstream(file()) << "";
    expect_held();
    silent_for(1.5 * FolderLock::silence_limit_s);
    expect_taken_over();
}

TEST_F(Lock, IsTakenOverAlsoWhereSomebodyWasKilledDoingSo) {
    ProcessIdentity process = this_process();
    process.pid = ended_process(true);
    put(process, "aaaa");
    fs::copy(file(), folder_.path() / ".dmp.lock.aaaa");
    put(process, "bbbb");
    fs::rename(file(), folder_.path() / ".dmp.lock.aaaa");
    put(process, "aaaa");
    expect_taken_over();
}

TEST_F(Lock, WhoseRightToRemoveSomebodyHasIsNotRemoved) {
    ProcessIdentity process = this_process();
    process.pid = ended_process(true);
    put(this_process(), "bbbb");
    fs::rename(file(), folder_.path() / ".dmp.lock.aaaa");
    put(process, "aaaa");
    EXPECT_FALSE(take().lock) << "another process is about to take over";
    EXPECT_THAT(read_file(file()), HasSubstr("token = aaaa"));
}

TEST_F(Lock, GivesSignsOfLife) {
    const auto outcome = take();
    silent_for(1000);
    const auto before = fs::last_write_time(file());
    outcome.lock->renew();
    EXPECT_GT(fs::last_write_time(file()), before);
    outcome.lock->check();
}

TEST_F(Lock, ThatSomebodyRemovedIsMadeAgain) {
    const auto outcome = take();
    fs::remove(file());
    outcome.lock->renew();
    EXPECT_TRUE(fs::exists(file()));
    EXPECT_FALSE(take().lock);
}

TEST_F(Lock, ThatAnotherHasTakenIsAnErrorAndStaysTheirs) {
    auto outcome = take();
    fs::remove(file());
    put(elsewhere());
    outcome.lock->renew();
    const std::string text = text_thrown<ResourceError>([&] { outcome.lock->check(); });
    EXPECT_THAT(text, testing::AllOf(HasSubstr("another dmp has taken over"), HasSubstr("process 4711 on node17"),
                                     HasSubstr("--out")));
    outcome.lock.reset();
    EXPECT_THAT(read_file(file()), HasSubstr("pid = 4711"));
}

TEST_F(Lock, IsRemovedByASignalHandler) {
    const auto outcome = take();
    remove_held_lock();
    EXPECT_THAT(files_in(folder_.path()), IsEmpty());
    remove_held_lock();
}

/// Many processes want the lock until they have it. Each then writes a file, must be the only one with a file, and ends
/// as if it were killed, so that every lock but the first is taken over from a stale one while others try to.
TEST_F(Lock, WhichManyTakeOverIsNeverWithTwo) {
    constexpr int alone = 7, not_alone = 8, processes = 40;
    const TemporaryFolder held;
    std::array<pid_t, processes> children{};
    for (pid_t& child : children) {
        child = fork();
        if (child != 0) continue;
        auto outcome = take();
        while (!outcome.lock) outcome = take();
        const fs::path own = held.path() / std::to_string(getpid());
        std::ofstream(own) << "here";
        bool is_alone = files_in(held.path()).size() == 1;
        std::this_thread::sleep_for(std::chrono::milliseconds(2));
        is_alone = is_alone && files_in(held.path()).size() == 1;
        fs::remove(own);
        _exit(is_alone ? alone : not_alone);
    }
    int were_alone = 0;
    for (const pid_t child : children) {
        int status = 0;
        waitpid(child, &status, 0);
        were_alone += WIFEXITED(status) && WEXITSTATUS(status) == alone ? 1 : 0;
    }
    EXPECT_EQ(were_alone, processes);
    EXPECT_THAT(files_in(folder_.path()), ElementsAre(lock_file_name)) << "the last one's";
}

TEST_F(Lock, NeedsAFolderThatCanBeWritten) {
    EXPECT_THAT(text_thrown<ResourceError>([&] { (void)FolderLock::take(folder_.path() / "none"); }),
                HasSubstr("cannot write"));
}

}  // namespace
}  // namespace dmp::tests::folder_lock_tests
