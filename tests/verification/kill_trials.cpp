// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Runs that are killed, again and again, and go on: in the end nothing may tell them from a run that nobody disturbed.
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <map>
#include <optional>
#include <random>

#include <gmock/gmock.h>

#include "tests/end_to_end/small_valve.hpp"

namespace dmp::tests::kill_trials_tests {

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr int resumed_kills_wanted = 50;
constexpr int killed = 128 + SIGKILL;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

/// The file that a killed run was writing in a folder; "" if none.
std::string unfinished_in(const fs::path& folder) {
    std::error_code gone;  // the run makes and removes files while they are listed
    for (fs::directory_iterator entry(folder, gone); !gone && entry != fs::directory_iterator(); entry.increment(gone))
        if (entry->path().filename().string().ends_with(".unfinished")) return entry->path().filename().string();
    return "";
}

class KillTrials : public SmallValve {
  protected:
    KillTrials() {
        if (const char* chosen = std::getenv("DMP_SEED"))
            seed_ = static_cast<unsigned>(std::strtoul(chosen, nullptr, 10));
        random_.seed(seed_);
    }

    int any(int from, int to) { return std::uniform_int_distribution<int>(from, to)(random_); }

    [[nodiscard]] bool has_checkpoint(const std::string& out) const {
        std::error_code gone;  // the run makes and removes the folder while it is listed
        for (fs::directory_iterator entry(folder_.path() / out / "checkpoints", gone);
             !gone && entry != fs::directory_iterator(); entry.increment(gone))
            if (entry->path().filename().string().starts_with("step_")) return true;
        return false;
    }

    /// Starts or goes on with the run in `out` and kills it at a moment by chance: at some time, or while a file is
    /// being written in one of its folders; nine times out of ten when there is a checkpoint to go on from.
    Outcome run_and_kill(const std::string& out, const Words& more) {
        const std::string position = std::vector<std::string>{"", "/checkpoints", "/frames"}[any(0, 2)];
        const bool needs_checkpoint = any(0, 9) > 0;
        const double wait = 1e-3 * any(0, longest_wait_ms_), into_the_file = 1e-6 * any(0, 3000);
        const auto start = Clock::now();
        std::optional<Clock::time_point> seen;  // since when a file has been written
        const auto is_time = [&] {
            if (seconds_since(start) < wait || (needs_checkpoint && !has_checkpoint(out))) return false;
            if (position.empty()) return true;
            if (unfinished_in(folder_.path() / (out + position)).empty()) {
                seen.reset();
                return false;
            }
            if (!seen) seen = Clock::now();
            return position == "/frames" || seconds_since(*seen) >= into_the_file;
        };
        return run(out, more, {.interrupt_when = is_time, .signal = SIGKILL});
    }

    /// What the kill hit, by what it left.
    [[nodiscard]] std::string moment(const std::string& out) const {
        if (!unfinished_in(folder_.path() / out / "checkpoints").empty()) return "while a checkpoint was being written";
        if (!unfinished_in(folder_.path() / out / "frames").empty() || !unfinished_in(folder_.path() / out).empty())
            return "while a frame or a list of frames was being written";
        return "at another moment";
    }

    void expect_same(const std::string& out, const std::string& whole) const {
        EXPECT_EQ(hash(out), hash(whole));
        ASSERT_EQ(files(out + "/frames"), files(whole + "/frames"));
        for (const auto& frame : files(whole + "/frames"))
            EXPECT_EQ(folder_.read(out + "/frames/" + frame), folder_.read(whole + "/frames/" + frame)) << frame;
        for (const std::string file : {"fluid.pvd", "solid.pvd", "walls.vtp", "measures.csv", "scene.resolved.toml"})
            EXPECT_EQ(folder_.read(out + "/" + file), folder_.read(whole + "/" + file)) << file;
    }

    unsigned seed_ = 1;
    std::mt19937 random_;
    int longest_wait_ms_ = 0;
};

TEST_F(KillTrials, FiftyKillsLeaveNoTrace) {
    std::cout << "seed " << seed_ << " (DMP_SEED chooses another)\n";
    const auto begin = Clock::now();
    ASSERT_EQ(run("whole").code, 0);
    longest_wait_ms_ = static_cast<int>(1e3 * seconds_since(begin));

    std::map<std::string, int> moments;  // of the kills that were resumed
    int runs = 0, resumed = 0, on_other_threads = 0, on_two_ranks = 0, started_anew = 0, killed_at_the_end = 0;
    while (resumed < resumed_kills_wanted) {
        const std::string out = "run_" + std::to_string(++runs);
        SCOPED_TRACE(out);
        const Words often{"--checkpoint-every", std::vector<std::string>{"0.0001 s", "0.01 s", "0.05 s"}[any(0, 2)]};
        Words how = often;
        Outcome outcome;
        for (int kills_left = any(1, 3);; --kills_left) {
            const int ranks = kills_left <= 0 && any(0, 5) == 0 ? 2 : 0;
            outcome = kills_left > 0 ? run_and_kill(out, how) : run(out, how, {.ranks = ranks});
            if (outcome.code != killed) {
                on_two_ranks += ranks > 0 ? 1 : 0;
                break;
            }
            const std::string threads = std::to_string(any(1, 3));
            how = often;
            how.insert(how.end(), {"--threads", threads});
            if (!has_checkpoint(out)) {
                ++started_anew;
                how.emplace_back("--overwrite");
                continue;
            }
            how.emplace_back("--resume");
            ++resumed;
            ++moments[moment(out)];
            on_other_threads += threads != "1" ? 1 : 0;
        }
        // The results of a run that was killed while its page was being written are whole.
        const bool at_its_end =
            outcome.errors.find("it holds a run that is finished at t = 0.1 s") != std::string::npos;
        ASSERT_EQ(outcome.code, at_its_end ? 2 : 0) << outcome.output << outcome.errors;
        killed_at_the_end += at_its_end ? 1 : 0;
        expect_same(out, "whole");
        if (HasFailure()) return;
        fs::remove_all(folder_.path() / out);
    }
    std::cout << resumed << " kills resumed, in " << runs << " runs, " << seconds_since(begin) << " s in all\n";
    for (const auto& [hit, count] : moments) std::cout << "  " << count << ' ' << hit << '\n';
    std::cout << "  " << on_other_threads << " resumed on 2 or 3 threads, " << on_two_ranks
              << " runs ended on 2 ranks; " << started_anew
              << " more kills before there was a checkpoint, started anew; " << killed_at_the_end
              << " runs killed when their results were there, and refused\n";
    EXPECT_GE(moments["while a checkpoint was being written"], 5) << "the trials missed what they are for";
}

}  // namespace

}  // namespace dmp::tests::kill_trials_tests
