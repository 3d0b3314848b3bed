// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Two runs that want one folder: one of them gets it, and the other says who has it. A lock that nobody holds any more
// stops nobody.
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <future>
#include <random>
#include <thread>

#include <gmock/gmock.h>

#include "tests/end_to_end/small_valve.hpp"

namespace dmp::tests::locked_folders_tests {

namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::AnyOf;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;

class LockedFolder : public SmallValve {
  protected:
    /// Each pair of runs starts anew; DMP_PAIRS chooses how many.
    [[nodiscard]] static int pairs() {
        const char* chosen = std::getenv("DMP_PAIRS");
        return chosen != nullptr ? std::atoi(chosen) : 4;
    }

    /// Two runs of unlike values into one folder, the second one up to 2 s after the first.
    void expect_one_winner(int number, int ranks) const {
        const std::string out = "pair_" + std::to_string(number);
        std::mt19937 random(static_cast<unsigned>(number));
        const int wait_ms = std::uniform_int_distribution<int>(0, 1)(random) == 0
                                ? std::uniform_int_distribution<int>(0, 100)(random)
                                : std::uniform_int_distribution<int>(0, 2000)(random);
        SCOPED_TRACE(out + ", " + std::to_string(ranks) + " ranks, " + std::to_string(wait_ms) + " ms apart");
        const Words first_one{"--set", "part.blood.viscosity=\"3.5 mPa*s\""},
            second_one{"--set", "part.blood.viscosity=\"4 mPa*s\""};
        auto first = std::async(std::launch::async, [&] { return run(out, first_one, {.ranks = ranks}); });
        std::this_thread::sleep_for(std::chrono::milliseconds(wait_ms));
        const Outcome second = run(out, second_one, {.ranks = ranks});
        const std::array<Outcome, 2> ends{first.get(), second};
        const int winner = ends[0].code == 0 ? 0 : 1;
        ASSERT_EQ(ends[winner].code, 0) << ends[0].errors << ends[1].errors;
        EXPECT_EQ(ends[1 - winner].code, 2) << ends[1 - winner].output << ends[1 - winner].errors;
        // The later one may come when the other is done.
        EXPECT_THAT(ends[1 - winner].errors,
                    AnyOf(AllOf(HasSubstr(out + ": another dmp is writing here: process "), HasSubstr(", since ")),
                          HasSubstr("it holds a finished run of another scene or other values")));
        EXPECT_EQ(hash(out), hash(winner == 0 ? "first" : "second"));
        const std::string whole = winner == 0 ? "first" : "second";
        EXPECT_EQ(files(out), files(whole));
        EXPECT_EQ(files(out + "/frames"), files(whole + "/frames"));
        for (const std::string& frame : files(whole + "/frames"))
            EXPECT_EQ(folder_.read(out + "/frames/" + frame), folder_.read(whole + "/frames/" + frame)) << frame;
        EXPECT_EQ(folder_.read(out + "/fluid.pvd"), folder_.read(whole + "/fluid.pvd"));
        fs::remove_all(folder_.path() / out);
    }

    void expect_one_winner_each_time(int ranks) const {
        ASSERT_EQ(run("first", {"--set", "part.blood.viscosity=\"3.5 mPa*s\""}).code, 0);
        ASSERT_EQ(run("second", {"--set", "part.blood.viscosity=\"4 mPa*s\""}).code, 0);
        for (int number = 0; number < pairs() && !HasFailure(); ++number) expect_one_winner(number, ranks);
    }

    void expect_no_lock(const std::string& out) const {
        for (const std::string& name : files(out)) EXPECT_THAT(name, Not(HasSubstr("dmp.lock")));
    }

    /// Whether the process that has the lock is there.
    [[nodiscard]] bool holder_runs(const std::string& out) const {
        std::ifstream lock(folder_.path() / out / "dmp.lock");
        for (std::string line; std::getline(lock, line);)
            if (line.starts_with("pid = ")) return fs::exists("/proc/" + line.substr(6));
        return false;
    }

    const Words briefly_{"--until", "0.02 s"};
};

TEST_F(LockedFolder, OfTwoRunsOneWins) { expect_one_winner_each_time(0); }

TEST_F(LockedFolder, OfTwoRunsOnTwoRanksOneWins) { expect_one_winner_each_time(2); }

TEST_F(LockedFolder, IsFreeAfterEveryEnd) {
    ASSERT_EQ(run("out", briefly_).code, 0);
    expect_no_lock("out");
    EXPECT_EQ(stopped_run("stopped", {}, 0, SIGINT).code, 130);
    expect_no_lock("stopped");
    EXPECT_EQ(run("diverged", {"--set", "flow.pressure_gradient=[\"-1e6 Pa/m\", 0]"}).code, 3);
    expect_no_lock("diverged");
    EXPECT_EQ(run("of_two", briefly_, {.ranks = 2}).code, 0);
    expect_no_lock("of_two");
    EXPECT_EQ(stopped_run("of_two_stopped", {"--until", "0.5 s"}, 2).code != 0, true);
    expect_no_lock("of_two_stopped");
}

TEST_F(LockedFolder, IsFreeAfterASignalBeforeTheRunHasStarted) {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
        const auto ended =
            run("out", {"--set", "particles.spacing=\"0.1 mm\""}, {.interrupt_at = "out/dmp.lock", .signal = signal});
        EXPECT_EQ(ended.code, 128 + signal);
        expect_no_lock("out");
    }
}

TEST_F(LockedFolder, IsNotConvertedWhileARunWritesThere) {
    ASSERT_EQ(run("out", {"--until", "0.02 s", "--frames", "hdf5"}).code, 0);
    const auto convert = [&] { return run_dmp(folder_.path(), {"convert", "out"}); };
    folder_.write("out/dmp.lock", "host = node17\nmachine = m\npid = 12\nstarted = 3\nsince = some time\ntoken = ab\n");
    const auto refused = convert();
    EXPECT_EQ(refused.code, 2);
    EXPECT_THAT(refused.errors,
                AllOf(HasSubstr("out: another dmp is writing here: process 12 on node17, since some time"),
                      HasSubstr("Wait for its end, or convert a copy of out/frames and out/frames.json in another "
                                "folder.")));
    EXPECT_THAT(files("out"), Not(Contains("fluid.pvd")));
    fs::remove(folder_.path() / "out/dmp.lock");
    EXPECT_EQ(convert().code, 0);
    EXPECT_THAT(files("out"), Contains("fluid.pvd"));
    expect_no_lock("out");
}

TEST_F(LockedFolder, OfAKilledRunIsTakenOver) {
    for (const int ranks : {0, 2}) {
        const std::string out = "killed_" + std::to_string(ranks);
        // mpirun is killed, and ends its ranks before they can do anything.
        const auto killed = run(out, {"--until", "0.5 s", "--checkpoint-every", "0.01 s"},
                                {.interrupt_at = out + "/frames/fluid_000005.vtp", .signal = SIGKILL, .ranks = ranks});
        EXPECT_EQ(killed.code, 128 + SIGKILL);
        if (ranks == 0) {
            EXPECT_THAT(files(out), Contains("dmp.lock"));
        } else {
            for (int k = 0; k < 200 && holder_runs(out); ++k)
                std::this_thread::sleep_for(std::chrono::milliseconds(50));
        }
        const auto resumed = run(out, {"--until", "0.5 s", "--resume"}, {.ranks = ranks});
        EXPECT_EQ(resumed.code, 0) << resumed.errors;
        if (ranks == 0) {
            EXPECT_THAT(resumed.output, HasSubstr("has ended without removing its lock (process "));
        }
        expect_no_lock(out);
    }
}

TEST_F(LockedFolder, OfAnotherMachineIsHeldUntilItIsSilent) {
    const std::string lock = "host = node17\nmachine = m\npid = 12\nstarted = 3\nsince = some time\ntoken = ab\n";
    folder_.write("out/dmp.lock", lock);
    const auto refused = run("out", briefly_);
    EXPECT_EQ(refused.code, 2);
    EXPECT_THAT(refused.errors, AllOf(HasSubstr("another dmp is writing here: process 12 on node17, since some time"),
                                      HasSubstr(" --out out_2\n"), HasSubstr("after 5 min without one")));
    EXPECT_EQ(folder_.read("out/dmp.lock"), lock);
    EXPECT_EQ(run("out", briefly_, {.ranks = 2}).code, 2);
    EXPECT_EQ(mesh("out").code, 2);

    fs::last_write_time(folder_.path() / "out/dmp.lock", fs::file_time_type::clock::now() - std::chrono::minutes(6));
    const auto taken = run("out", briefly_);
    EXPECT_EQ(taken.code, 0) << taken.errors;
    EXPECT_THAT(taken.output, HasSubstr("process 12 on node17"));
    expect_no_lock("out");
}

TEST_F(LockedFolder, ThatAnotherMachineHasTakenEndsTheRun) {
    const std::string lock = "host = node17\nmachine = m\npid = 12\nstarted = 3\nsince = some time\ntoken = ab\n";
    auto suspended = std::async(std::launch::async, [&] { return run("out", {"--until", "1000 s"}); });
    const auto there = [&](const char* file) { return fs::exists(folder_.path() / file); };
    while (!there("out/frames/fluid_000001.vtp")) std::this_thread::sleep_for(std::chrono::milliseconds(5));
    // In one step, as two machines do it.
    folder_.write("taken", lock);
    fs::rename(folder_.path() / "taken", folder_.path() / "out/dmp.lock");
    const Outcome ended = suspended.get();
    EXPECT_EQ(ended.code, 4);
    EXPECT_THAT(ended.errors, HasSubstr("another dmp has taken over out: process 12 on node17"));
    EXPECT_EQ(folder_.read("out/dmp.lock"), lock) << "it is the other's";
}

}  // namespace

}  // namespace dmp::tests::locked_folders_tests
