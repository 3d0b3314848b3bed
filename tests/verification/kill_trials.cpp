// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Runs that are killed, again and again, and go on: in the end nothing may tell them from a run that nobody disturbed.
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <map>
#include <random>

#include <gmock/gmock.h>

#include "tests/end_to_end/small_valve.hpp"

namespace {

using namespace dmp::end_to_end;
using testing::HasSubstr;

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr int kills_wanted = 50;
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

    /// Starts or goes on with the run in `out` and kills it at a moment by chance: at some time, or while a file is
    /// being written below one of its folders.
    Outcome run_and_kill(const std::string& out, const Words& more) {
        const std::string place = std::vector<std::string>{"", "/checkpoints", "/frames"}[any(0, 2)];
        const auto start = Clock::now();
        const double wait = 1e-3 * any(1, place.empty() ? longest_wait_ms_ : longest_wait_ms_ / 2);
        const double into_the_file = 1e-6 * any(0, 3000);
        std::optional<Clock::time_point> seen;
        return run(out, more,
                   {.interrupt_when =
                        [&, folder = folder_.path() / (out + place)] {
                            if (seconds_since(start) < wait) return false;
                            if (place.empty()) return true;
                            const bool writing = !unfinished_in(folder).empty();
                            if (writing && !seen) seen = Clock::now();
                            // Nothing is being written any more: the next file.
                            if (!writing && seen) seen.reset();
                            return seen && seconds_since(*seen) >= (place == "/frames" ? 0 : into_the_file);
                        },
                    .signal = SIGKILL});
    }

    /// What the kill hit, by what it left.
    [[nodiscard]] std::string moment(const std::string& out) const {
        if (!unfinished_in(folder_.path() / out / "checkpoints").empty()) return "while a checkpoint was being written";
        if (!unfinished_in(folder_.path() / out / "frames").empty() || !unfinished_in(folder_.path() / out).empty())
            return "while a frame or a list of frames was being written";
        return files(out + "/checkpoints").empty() ? "before the first checkpoint" : "at another moment";
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
    const auto begin = Clock::now();
    std::cout << "seed " << seed_ << " (DMP_SEED chooses another)\n";
    ASSERT_EQ(run("whole").code, 0);
    longest_wait_ms_ = static_cast<int>(1e3 * seconds_since(begin));

    std::map<std::string, int> moments;
    int kills = 0, trials = 0, resumed_on_other_threads = 0, started_anew = 0;
    while (kills < kills_wanted && !HasFailure()) {
        const std::string out = "trial_" + std::to_string(++trials);
        SCOPED_TRACE(out);
        const Words often{"--checkpoint-every", std::vector<std::string>{"0.0001 s", "0.01 s", "0.1 s"}[any(0, 2)]};
        Words how = often;
        Outcome outcome;
        // One to three kills, then to the end.
        for (int left = any(1, 3);; --left) {
            outcome = left > 0 ? run_and_kill(out, how) : run(out, how);
            if (outcome.code != killed) break;
            ++kills;
            const std::string hit = moment(out);
            ++moments[hit];
            how = often;
            const bool can_go_on = hit != "before the first checkpoint" &&
                                   std::ranges::any_of(files(out + "/checkpoints"), [](const std::string& name) {
                                       return name.starts_with("step_");
                                   });
            const std::string threads = std::to_string(any(1, 3));
            how.insert(how.end(), {"--threads", threads});
            if (can_go_on) {
                how.emplace_back("--resume");
                resumed_on_other_threads += threads != "1" ? 1 : 0;
            } else {
                ++started_anew;
            }
        }
        ASSERT_EQ(outcome.code, 0) << outcome.output << outcome.errors;
        expect_same(out, "whole");
        fs::remove_all(folder_.path() / out);
    }
    std::cout << kills << " kills in " << trials << " runs, " << seconds_since(begin) << " s in all\n";
    for (const auto& [hit, count] : moments) std::cout << "  " << count << ' ' << hit << '\n';
    std::cout << "  " << resumed_on_other_threads << " resumed on 2 or 3 threads, " << started_anew
              << " started anew for want of a checkpoint\n";
    RecordProperty("seed", static_cast<int>(seed_));
    RecordProperty("while_a_checkpoint_was_written", moments["while a checkpoint was being written"]);
    EXPECT_GE(moments["while a checkpoint was being written"], 5) << "the trials missed what they are for";
}

}  // namespace
