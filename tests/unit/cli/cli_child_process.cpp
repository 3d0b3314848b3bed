// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Processes of this program: here of the tests themselves.
#include <atomic>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <string>
#include <thread>
#include <vector>

#include <fcntl.h>
#include <gmock/gmock.h>
#include <pthread.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/safe_file.hpp"
#include "cli/stop_signals.hpp"
#include "cli/sweep/child_process.hpp"
#include "tests/modules.hpp"
#include "tests/unit/temporary_files.hpp"

namespace dmp::tests::child_process_tests {
namespace {

using namespace cli;
using testing::HasSubstr;

ChildEnd waited_for(ChildProcess& process) {
    while (!process.end()) wait_for_any({&process}, 1000);
    return *process.end();
}

/// Runs until it is stopped: no test, again and again.
const std::vector<std::string> endless{"test_cli", "--gtest_filter=NoSuchTest", "--gtest_repeat=-1"};

/// Until the file has this text.
void wait_for_text(const std::filesystem::path& file, const std::string& text) {
    while (!std::filesystem::exists(file) || read_file(file).find(text) == std::string::npos)
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
}

TEST(ChildProcess, SaysHowItEndedAndWhatItSaid) {
    const TemporaryFolder folder;
    ChildProcess fine({"test_cli", "--gtest_filter=NoSuchTest"}, folder.path() / "fine.log");
    setenv("GTEST_TOTAL_SHARDS", "2", 1);  // without an index, which GoogleTest refuses
    ChildProcess failing({"test_cli"}, folder.path() / "failing.log");
    unsetenv("GTEST_TOTAL_SHARDS");
    EXPECT_EQ(waited_for(fine).exit_code, 0);
    EXPECT_EQ(waited_for(failing).exit_code, 1);
    EXPECT_EQ(failing.end()->signal, 0);
    EXPECT_GT(failing.end()->peak_memory, 1e6);
    EXPECT_THAT(read_file(folder.path() / "failing.log"), HasSubstr("GTEST_SHARD_INDEX"));
}

TEST(ChildProcess, SaysWhyAProgramCannotBeStarted) {
    const TemporaryFolder folder;
    ChildProcess missing({"it"}, folder.path() / "missing.log", (folder.path() / "nothing").string());
    EXPECT_EQ(waited_for(missing).exit_code, 127);
    EXPECT_EQ(read_file(folder.path() / "missing.log"),
              "error: '" + (folder.path() / "nothing").string() + "' cannot be started: No such file or directory\n");
    ChildProcess crowded({"test_cli", std::string(200'000, 'x')},
                         folder.path() / "crowded.log");  // 128 KiB are allowed
    EXPECT_EQ(waited_for(crowded).exit_code, 127);
    EXPECT_THAT(read_file(folder.path() / "crowded.log"), HasSubstr("cannot be started: Argument list too long"));
}

TEST(ChildProcess, MayBeACopyThatHasNoneOfTheOpenFiles) {
    const TemporaryFolder folder;
    const std::filesystem::path other = folder.path() / "other";
    write_file(other, "");
    const int file = open(other.c_str(), O_WRONLY);
    ASSERT_GE(file, 0);
    int value = 1;
    ChildProcess copy(
        [&] {
            value = 2;
            std::cout << "said" << std::endl;
            return ::write(file, "x", 1) < 0 && errno == EBADF ? 17 : 1;
        },
        folder.path() / "log");
    EXPECT_EQ(waited_for(copy).exit_code, 17);
    EXPECT_EQ(read_file(folder.path() / "log"), "said\n");
    EXPECT_EQ(value, 1) << "it has memory of its own";
    close(file);
}

TEST(ChildProcess, ACopyThatIsKilledLeavesTheOthers) {
    const TemporaryFolder folder;
    ChildProcess killed([] { return ::raise(SIGKILL); }, folder.path() / "killed.log");
    ChildProcess crashing([] { return ::raise(SIGSEGV); }, folder.path() / "crashing.log");
    ChildProcess fine([] { return 0; }, folder.path() / "fine.log");
    EXPECT_EQ(waited_for(killed).exit_code, 128 + SIGKILL);
    EXPECT_EQ(waited_for(crashing).signal, SIGSEGV);
    EXPECT_EQ(waited_for(fine).exit_code, 0);
}

TEST(ChildProcess, IsStoppedBySigterm) {
    const TemporaryFolder folder;
    ChildProcess process(endless, folder.path() / "log");
    wait_for_text(folder.path() / "log", "Repeating");
    EXPECT_FALSE(process.end());
    process.stop();
    EXPECT_EQ(waited_for(process).signal, SIGTERM);
    EXPECT_EQ(process.end()->exit_code, 143);
    { const ChildProcess another(endless, folder.path() / "another"); }  // is stopped, too: this ends
}

TEST(ChildProcess, EndsWithTheProcessThatStartedIt) {
    const TemporaryFolder folder;
    const std::filesystem::path log = folder.path() / "inner.log";
    const pid_t parent = fork();
    ASSERT_GE(parent, 0);
    if (parent == 0) {
        const ChildProcess process(endless, log);
        while (true) pause();
    }
    wait_for_text(log, "Repeating");
    // The inner process has this file open until it ends.
    const auto holders = [&] {
        std::vector<pid_t> found;
        std::error_code none;
        for (const auto& process : std::filesystem::directory_iterator("/proc"))
            if (std::filesystem::read_symlink(process.path() / "fd/1", none) == log)
                found.push_back(std::stoi(process.path().filename()));
        return found;
    };
    ASSERT_EQ(holders().size(), 1U);
    kill(parent, SIGKILL);
    waitpid(parent, nullptr, 0);
    constexpr int patience = 20000;  // looks: of a machine that is busy with other things
    for (int looks = 0; looks < patience && !holders().empty(); ++looks)
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    for (const pid_t left : holders()) {
        ADD_FAILURE() << "it outlives the process that started it";
        kill(left, SIGKILL);
    }
}

TEST(ChildProcess, EndsAlsoWhereTheEndsOfChildrenAreIgnored) {
    const TemporaryFolder folder;
    std::signal(SIGCHLD, SIG_IGN);  // as whoever starts dmp may have left it
    ChildProcess process({"test_cli", "--gtest_filter=NoSuchTest"}, folder.path() / "log");
    constexpr int patience = 2000;
    for (int looks = 0; looks < patience && !process.end(); ++looks) wait_for_any({&process}, 20);
    std::signal(SIGCHLD, SIG_DFL);
    ASSERT_TRUE(process.end());
    EXPECT_EQ(process.end()->exit_code, 0);
}

std::atomic<bool> signal_after_fork = false;
std::atomic<int> noted = 0;

TEST(ChildProcess, ASignalBetweenForkAndExecIsNotLost) {
    const TemporaryFolder folder;
    // In the new process, before anything else of it is done.
    static const int added = pthread_atfork(nullptr, nullptr, [] {
        if (signal_after_fork) kill(getpid(), SIGTERM);
    });
    ASSERT_EQ(added, 0);
    auto* const before = std::signal(SIGTERM, [](int) { ++noted; });
    signal_after_fork = true;
    ChildProcess process({"test_cli", "--gtest_filter=NoSuchTest"}, folder.path() / "log");
    signal_after_fork = false;
    EXPECT_EQ(waited_for(process).signal, SIGTERM);
    std::signal(SIGTERM, before);
    EXPECT_EQ(noted, 0);
}

/// What ChildProcess.IsAskedToStopOnce starts: it writes at the first SIGTERM, and ends when the file is there.
TEST(ChildProcess, DISABLED_StopsSlowly) {
    const StopSignals signals;
    std::cout << "begun" << std::endl;
    while (!signals.flag()) std::this_thread::sleep_for(std::chrono::milliseconds(5));
    std::cout << "stopping" << std::endl;
    while (!std::filesystem::exists(std::getenv("DMP_TEST_END")))
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
}

TEST(ChildProcess, IsAskedToStopOnce) {
    const TemporaryFolder folder;
    const std::filesystem::path end = folder.path() / "end", log = folder.path() / "log";
    setenv("DMP_TEST_END", end.c_str(), 1);
    ChildProcess process(
        {"test_cli", "--gtest_also_run_disabled_tests", "--gtest_filter=ChildProcess.DISABLED_StopsSlowly"}, log);
    wait_for_text(log, "begun");
    process.stop();
    wait_for_text(log, "stopping");
    process.stop();  // a second SIGTERM would end it at once
    write_file(end, "");
    EXPECT_EQ(waited_for(process).exit_code, 0);
    EXPECT_EQ(process.end()->signal, 0);
}

}  // namespace
}  // namespace dmp::tests::child_process_tests
