// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Studies: many runs of one scene, stopped, killed and damaged in every way, and one table at the end.
#include <algorithm>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <functional>
#include <future>
#include <iterator>
#include <map>
#include <sstream>

#include <gmock/gmock.h>

#include "base/csv.hpp"
#include "tests/end_to_end/small_valve.hpp"

namespace dmp::tests::studies_tests {

namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::SizeIs;
using testing::StartsWith;

/// The vein valve with coarse particles: four runs, of which the last two cannot be meshed.
class Studies : public SmallValve {
  protected:
    Studies() {
        folder_.replace("scene.toml", "spacing = \"0.2 mm\"", "spacing = \"0.8 mm\"");
        folder_.replace("scene.toml", "duration = \"4 s\"", "duration = \"0.2 s\"");
        folder_.replace("scene.toml", "every = \"40 ms\"", "every = \"10 ms\"\npictures = false");
        folder_.write("valve.toml", R"(scene = "scene.toml"

[[vary]]
key = "particles.spacing"
values = ["0.8 mm", "30 mm"]

[[vary]]
key = "part.blood.viscosity"
values = ["3.5 mPa*s", "4 mPa*s"]

[[result]]
name = "fastest"
measure = "largest_speed"
reduce = "maximum"

[[result]]
name = "volume"
measure = "inlet_flux"
reduce = "integral"
from = "0.05 s"
)");
    }

    [[nodiscard]] Outcome sweep(const std::string& out, const Words& more = {}, const Surroundings& with = {}) const {
        Words words{"sweep", "valve.toml", "--out", out};
        words.insert(words.end(), more.begin(), more.end());
        return run_dmp(folder_.path(), words, with);
    }
    /// The cells of results.csv, without its heading.
    [[nodiscard]] std::vector<Words> table(const std::string& out) const {
        std::vector<Words> rows;
        std::istringstream lines(folder_.read(out + "/results.csv"));
        for (std::string line; std::getline(lines, line);) rows.push_back(csv_cells(line));
        if (!rows.empty()) rows.erase(rows.begin());
        return rows;
    }
    /// Names of the runs that have a folder.
    [[nodiscard]] Words runs(const std::string& out) const {
        Words names;
        for (const std::string& name : files(out + "/runs"))
            if (name.find('.') == std::string::npos) names.push_back(name);  // no log, nor a file that is being written
        return names;
    }
    /// Whether the study's run with this number has its frame at 0.05 s.
    [[nodiscard]] bool is_half_way(const std::string& out, const std::string& number) const {
        const Words names = runs(out);
        return std::ranges::any_of(names, [&](const std::string& name) {
            return name.starts_with(number) &&
                   fs::exists(folder_.path() / out / "runs" / name / "frames/fluid_000005.vtp");
        });
    }
    /// A study that is ended by a signal in the middle of its second run.
    [[nodiscard]] Outcome ended_sweep(const std::string& out, int signal, const Words& more = {"--jobs", "1"}) const {
        return sweep(out, more, {.interrupt_when = [this, out] { return is_half_way(out, "0002"); }, .signal = signal});
    }
    [[nodiscard]] double maximum(const std::string& run, const std::string& measure) const {
        return summary(run)["measures"][measure]["max"];
    }
};

TEST_F(Studies, EndWithATableInTheirOrder) {
    const Outcome ended = sweep("out", {"--jobs", "3"});
    EXPECT_EQ(ended.code, 2) << "that of the run that failed";
    EXPECT_THAT(folder_.read("out/results.csv"),
                StartsWith("run,particles.spacing [mm],part.blood.viscosity [mPa*s],fastest [m/s],"
                           "volume [m^3],exit_code,error\n"));
    const std::vector<Words> rows = table("out");
    ASSERT_THAT(rows, SizeIs(4));
    for (const auto& [index, viscosity] : std::map<std::size_t, std::string>{{0, "3.5 mPa*s"}, {1, "4 mPa*s"}}) {
        ASSERT_EQ(run_dmp(folder_.path(), {"run", "scene.toml", "--set", "part.blood.viscosity=" + viscosity, "--out",
                                           "alone" + std::to_string(index), "--threads", "1"})
                      .code,
                  0);
        const std::string alone = "alone" + std::to_string(index);
        EXPECT_EQ(rows[index][0].substr(0, 5), "000" + std::to_string(index + 1) + "_");
        EXPECT_EQ(rows[index][2] + " mPa*s", viscosity);
        EXPECT_EQ(rows[index][3], csv_number(maximum(alone, "largest_speed")));
        EXPECT_EQ(rows[index][5], "0");
        EXPECT_EQ(rows[index][6], "");
        EXPECT_EQ(hash("out/runs/" + rows[index][0]), hash(alone));
        EXPECT_FALSE(fs::exists(folder_.path() / "out/runs" / (rows[index][0] + ".log")));
    }
    for (const std::size_t index : {2U, 3U}) {
        EXPECT_EQ(rows[index][3] + rows[index][4], "");
        EXPECT_EQ(rows[index][5], "2");
        EXPECT_THAT(rows[index][6], HasSubstr("scene.toml:36:13: the period along x is 92 mm, shorter than"));
        EXPECT_THAT(folder_.read("out/runs/" + rows[index][0] + ".log"), HasSubstr(rows[index][6]));
        EXPECT_THAT(ended.output, HasSubstr("  " + rows[index][0] + "  code 2: " + rows[index][6]));
    }
    EXPECT_THAT(ended.output,
                AllOf(HasSubstr("valve: 4 runs of scene.toml\n"), HasSubstr("Done: 2 of 4 runs done, 2 failed")));
    EXPECT_THAT(files("out"), testing::ElementsAre("report.html", "results.csv", "runs", "scene.toml", "study.json",
                                                   "study.toml", "sweep.log", "sweep.toml", "timing.csv"));
    ASSERT_EQ(sweep("one_by_one", {"--jobs", "1"}).code, 2);
    EXPECT_EQ(folder_.read("one_by_one/results.csv"), folder_.read("out/results.csv"));
}

TEST_F(Studies, KilledOnesGoOnToTheSameTable) {
    ASSERT_EQ(sweep("whole").code, 2);
    const Outcome killed = ended_sweep("out", SIGKILL);
    ASSERT_EQ(killed.code, 128 + SIGKILL);
    const Words begun = runs("out");
    ASSERT_THAT(begun, SizeIs(2));
    const std::string first = hash("out/runs/" + begun[0]);
    const auto written = fs::last_write_time(folder_.path() / "out/runs" / begun[0] / "summary.json");
    // At once: the run that the killed study has left may still write its checkpoint.
    const Outcome resumed = sweep("out", {"--jobs", "1", "--resume"});
    ASSERT_EQ(resumed.code, 2) << resumed.errors;
    EXPECT_EQ(folder_.read("out/results.csv"), folder_.read("whole/results.csv"));
    EXPECT_EQ(fs::last_write_time(folder_.path() / "out/runs" / begun[0] / "summary.json"), written)
        << "a finished run is not run again";
    EXPECT_THAT(folder_.read("out/runs/" + begun[1] + "/run.log"), HasSubstr("Going on in "));
}

TEST_F(Studies, SignalsStopThemWithCheckpoints) {
    ASSERT_EQ(sweep("whole").code, 2);
    for (const int signal : {SIGINT, SIGTERM}) {
        const std::string out = "by_" + std::to_string(signal);
        const Outcome stopped = ended_sweep(out, signal, {"--jobs", "2"});
        EXPECT_EQ(stopped.code, 128 + signal) << stopped.errors;
        EXPECT_THAT(stopped.output,
                    AllOf(HasSubstr("Interrupted: "), HasSubstr("Go on with the same command and --resume.\n"),
                          HasSubstr(" --resume\n")));
        EXPECT_THAT(files(out), Not(testing::Contains("dmp.lock")));
        const Words names = runs(out);
        EXPECT_TRUE(std::ranges::any_of(names, [&](const std::string& name) {
            return folder_.read(out + "/runs/" + name + "/run.log").find("Stopped before its end, by SIGTERM") !=
                   std::string::npos;
        }));
        ASSERT_EQ(sweep(out, {"--resume"}).code, 2);
        EXPECT_EQ(folder_.read(out + "/results.csv"), folder_.read("whole/results.csv"));
    }
}

TEST_F(Studies, MendRunsThatWereDamaged) {
    ASSERT_EQ(sweep("out").code, 2);
    const std::string before = folder_.read("out/results.csv");
    const Words names = runs("out");
    fs::remove(folder_.path() / "out/runs" / names[0] / "summary.json");
    for (const auto& file : fs::directory_iterator(folder_.path() / "out/runs" / names[0] / "checkpoints"))
        fs::resize_file(file, 100);
    fs::remove_all(folder_.path() / "out/runs" / names[1]);
    fs::remove(folder_.path() / "out/results.csv");
    const Outcome resumed = sweep("out", {"--resume"});
    EXPECT_THAT(resumed.errors, HasSubstr("run " + names[0] + " cannot go on from its checkpoint, and starts anew: "));
    EXPECT_EQ(folder_.read("out/results.csv"), before);
}

TEST_F(Studies, AStoppedOneKeepsTheRowsOfThoseThatEnded) {
    ASSERT_EQ(sweep("out").code, 2);
    const std::vector<Words> whole = table("out");
    const fs::path first = folder_.path() / "out/runs" / runs("out")[0];
    fs::remove_all(first);
    // The first one runs again, and is stopped in it.
    const Outcome stopped = sweep("out", {"--jobs", "1", "--resume"},
                                  {.interrupt_when = [this] { return is_half_way("out", "0001"); }, .signal = SIGINT});
    EXPECT_EQ(stopped.code, 130) << stopped.errors;
    EXPECT_THAT(stopped.output, HasSubstr("Interrupted: 1 of 4 runs done"));
    const std::vector<Words> rows = table("out");
    ASSERT_FALSE(rows.empty());
    EXPECT_EQ(rows[0], whole[1]);
}

TEST_F(Studies, AnotherGeometryIsNotMixedWithTheFirst) {
    const Outcome killed = ended_sweep("out", SIGTERM);
    ASSERT_EQ(killed.code, 143) << killed.errors;
    const Words begun = runs("out");
    const std::string before = hash("out/runs/" + begun[0]), table_before = folder_.read("out/results.csv");
    folder_.write("vein_valve.geo", folder_.read("vein_valve.geo") + "\n// changed\n");
    const Outcome refused = sweep("out", {"--resume"});
    EXPECT_EQ(refused.code, 2);
    EXPECT_THAT(refused.errors, HasSubstr("out: its runs were made with other contents of 'vein_valve.geo'"));
    EXPECT_EQ(hash("out/runs/" + begun[0]), before);
    EXPECT_EQ(folder_.read("out/results.csv"), table_before);
}

TEST_F(Studies, MayBeDoneInParts) {
    ASSERT_EQ(sweep("whole").code, 2);
    ASSERT_EQ(sweep("out", {"--only", "part.blood.viscosity=4 mPa*s", "--only", "particles.spacing=0.8 mm"}).code, 0);
    EXPECT_THAT(table("out"), SizeIs(1));
    ASSERT_EQ(sweep("out", {"--only", "part.blood.viscosity=3.5 mPa*s", "--resume"}).code, 2);
    EXPECT_THAT(table("out"), SizeIs(3)) << "those of before are in the table, too";
    ASSERT_EQ(sweep("out", {"--only", "particles.spacing=0.8 mm", "--resume"}).code, 0) << "none of these failed";
    EXPECT_THAT(table("out"), SizeIs(3)) << "also the one that failed";
    ASSERT_EQ(sweep("out", {"--resume"}).code, 2);
    EXPECT_EQ(folder_.read("out/results.csv"), folder_.read("whole/results.csv"));
}

TEST_F(Studies, OtherResultsNeedNoOtherRuns) {
    ASSERT_EQ(sweep("out").code, 2);
    folder_.replace("valve.toml", "measure = \"inlet_flux\"\nreduce = \"integral\"",
                    "measure = \"density\"\ncolumn = \"lowest\"\nreduce = \"last\"");
    ASSERT_EQ(sweep("out", {"--resume"}).code, 2);
    EXPECT_THAT(table("out")[0].back(),
                HasSubstr("result 'volume': the columns of measure 'density' are 'low' and 'high'"));
    folder_.replace("valve.toml", "lowest", "low");
    ASSERT_EQ(sweep("out", {"--resume"}).code, 2);
    EXPECT_EQ(table("out")[0].back(), "");
    EXPECT_THAT(folder_.read("out/results.csv"), HasSubstr(",volume [1],"));
}

TEST_F(Studies, RefuseWhatTheyWouldDestroy) {
    ASSERT_EQ(sweep("out").code, 2);
    const std::string before = folder_.read("out/results.csv");
    EXPECT_THAT(sweep("out").errors, HasSubstr("out: it holds this study, 2 of 4 runs done"));
    folder_.replace("scene.toml", "density = \"1056 kg/m^3\"", "density = \"1050 kg/m^3\"");
    EXPECT_THAT(sweep("out").errors, HasSubstr("it holds another study, or this one with another scene"));
    EXPECT_THAT(sweep("out", {"--resume"}).errors, HasSubstr("it holds another study"));
    EXPECT_EQ(folder_.read("out/results.csv"), before);
    ASSERT_EQ(run("a_run").code, 0);
    EXPECT_THAT(sweep("a_run").errors, HasSubstr("the output folder holds files that are not dmp's"));
    EXPECT_EQ(sweep("out", {"--overwrite"}).code, 2);
    EXPECT_NE(folder_.read("out/results.csv"), before);
}

TEST_F(Studies, TwoCannotWriteIntoOneFolder) {
    std::promise<void> locked;
    auto first = std::async(std::launch::async, [&] {
        return sweep("out", {}, {.interrupt_when = [&, told = false]() mutable {
                         if (!told && is_half_way("out", "0001")) {
                             locked.set_value();
                             told = true;
                         }
                         return false;
                     }});
    });
    locked.get_future().wait();
    const Outcome second = sweep("out", {"--resume"});
    EXPECT_EQ(second.code, 2);
    EXPECT_THAT(second.errors, HasSubstr("out: another dmp is writing here: process "));
    EXPECT_EQ(first.get().code, 2);
    EXPECT_THAT(table("out"), SizeIs(4));
}

TEST_F(Studies, TheDryRunSaysWhatThereIsToDoAndWritesNothing) {
    const Outcome dry = sweep("out", {"--dry-run", "--jobs", "2"});
    EXPECT_EQ(dry.code, 0) << dry.errors;
    EXPECT_THAT(dry.output,
                testing::ContainsRegex("valve: 4 runs of scene.toml\n"
                                       "  run +particles.spacing \\[mm\\]  part.blood.viscosity "
                                       "\\[mPa\\*s\\]\n  0001_[0-9a-f]+ +0.8 +3.5\n(.*\n)+  0004_[0-9a-f]+ +30 +4\n"));
    EXPECT_THAT(dry.output, AllOf(HasSubstr("all runs  about "), HasSubstr(", 2 at a time on 1 thread each"),
                                  HasSubstr("21 a run, 84 in all"), HasSubstr("  disk      about "),
                                  HasSubstr("Nothing was written.\n")));
    EXPECT_FALSE(fs::exists(folder_.path() / "out"));
}

TEST_F(Studies, AWrongStudyWritesNothing) {
    folder_.replace("valve.toml", "part.blood.viscosity", "part.blood.viscosty");
    const Outcome wrong = sweep("out");
    EXPECT_EQ(wrong.code, 2);
    EXPECT_THAT(wrong.errors, HasSubstr("valve.toml:8:7: unknown key 'part.blood.viscosty'\n"));
    EXPECT_FALSE(fs::exists(folder_.path() / "out"));
}

/// A study of runs that leave nothing but numbers, and what happens to some of them.
class SmallRuns : public Studies {
  protected:
    SmallRuns() {
        folder_.replace("valve.toml", "values = [\"0.8 mm\", \"30 mm\"]", "values = [\"0.8 mm\"]");
        folder_.replace("valve.toml", "\"4 mPa*s\"]", "\"4 mPa*s\", \"4.5 mPa*s\"]");
    }
    void leave_out(const std::string& list) const {
        folder_.replace("valve.toml", "scene = \"scene.toml\"", "scene = \"scene.toml\"\nleave_out = " + list);
    }
    /// The process of the study's run with this number; 0: it does not run.
    [[nodiscard]] pid_t process_of(const std::string& out, const std::string& number) const {
        for (const std::string& name : runs(out)) {
            if (!name.starts_with(number)) continue;
            const std::string lock = folder_.read(out + "/runs/" + name + "/dmp.lock");
            if (const auto at = lock.find("\npid = "); at != std::string::npos) return std::stoi(lock.substr(at + 7));
        }
        return 0;
    }
    [[nodiscard]] static std::string facts_of(pid_t process, const std::string& name) {
        std::ifstream file("/proc/" + std::to_string(process) + "/" + name);
        return {std::istreambuf_iterator<char>(file), {}};
    }
    [[nodiscard]] static pid_t parent_of(pid_t process) {
        const std::string facts = facts_of(process, "status");
        const auto at = facts.find("\nPPid:");
        return at == std::string::npos ? 0 : std::stoi(facts.substr(at + 6));
    }
    /// A study during whose second run something is done, once.
    Outcome sweep_during(const std::string& out, const std::function<void(pid_t)>& act) const {
        return sweep(out, {"--jobs", "1"}, {.interrupt_when = [&, done = false]() mutable {
                         const pid_t run = done ? 0 : process_of(out, "0002");
                         if (run != 0 && is_half_way(out, "0002")) {
                             act(run);
                             done = true;
                         }
                         return false;
                     }});
    }
};

TEST_F(SmallRuns, MayHaveAnotherValueOfTheScene) {
    const std::string shorter = "run.duration=0.08 s";
    ASSERT_EQ(sweep("out", {"--set", shorter, "--only", "part.blood.viscosity=4 mPa*s"}).code, 0);
    ASSERT_EQ(sweep("out", {"--set", shorter, "--run", "1"}).code, 0) << "as a job of a queueing system does it";
    EXPECT_THAT(runs("out"), SizeIs(2));
    for (const std::string& run : runs("out")) EXPECT_NEAR(summary("out/runs/" + run)["simulated_s"], 0.08, 1e-9);
    EXPECT_THAT(sweep("out", {"--resume"}).errors, HasSubstr("it holds another study"));
}

TEST_F(SmallRuns, GoOnWhenAScenesCommentsChangeAndStopWhenItsValuesDo) {
    EXPECT_EQ(
        sweep_during("out", [&](pid_t) { folder_.write("scene.toml", "# why\n" + folder_.read("scene.toml")); }).code,
        0);
    EXPECT_THAT(table("out"), SizeIs(3));
    const Outcome stopped = sweep_during("other", [&](pid_t) {
        folder_.replace("scene.toml", "density = \"1056 kg/m^3\"", "density = \"1050 kg/m^3\"");
    });
    EXPECT_EQ(stopped.code, 2);
    EXPECT_THAT(stopped.errors, HasSubstr("scene.toml: the scene was changed while its study ran"));
}

TEST_F(SmallRuns, AreCopiesOfOneProcess) {
    std::vector<pid_t> parents;
    std::string words;
    const auto note = [&](pid_t run) {
        parents.push_back(parent_of(run));
        words = facts_of(run, "cmdline");
    };
    ASSERT_EQ(sweep_during("out", note).code, 0);
    ASSERT_THAT(parents, SizeIs(1));
    EXPECT_THAT(words, HasSubstr("start-runs")) << "it was not started as a program of its own";
    EXPECT_NE(parents[0], 0);
}

TEST_F(SmallRuns, OneThatIsKilledIsARowAndTheOthersGoOn) {
    ASSERT_EQ(sweep("whole").code, 0);
    const Outcome ended = sweep_during("out", [](pid_t run) { kill(run, SIGKILL); });
    EXPECT_EQ(ended.code, 128 + SIGKILL);
    const std::vector<Words> rows = table("out"), whole = table("whole");
    ASSERT_THAT(rows, SizeIs(3));
    EXPECT_EQ(rows[0], whole[0]);
    EXPECT_EQ(rows[2], whole[2]);
    EXPECT_EQ(rows[1][5], "137");
    EXPECT_THAT(rows[1][6], HasSubstr("it was ended by signal 9 (Killed)"));
    ASSERT_EQ(sweep("out", {"--resume"}).code, 0);
    EXPECT_EQ(folder_.read("out/results.csv"), folder_.read("whole/results.csv"));
}

TEST_F(SmallRuns, GoOnWhenTheProcessThatStartsThemIsKilled) {
    ASSERT_EQ(sweep("whole").code, 0);
    const Outcome ended = sweep_during("out", [](pid_t run) { kill(parent_of(run), SIGKILL); });
    EXPECT_EQ(ended.code, 0) << ended.errors;
    EXPECT_THAT(ended.errors, HasSubstr("The process that starts the runs was ended from outside. "));
    EXPECT_EQ(folder_.read("out/results.csv"), folder_.read("whole/results.csv"));
    EXPECT_THAT(folder_.read("out/runs/" + runs("out")[1] + "/run.log"), HasSubstr("Going on in "));
}

TEST_F(SmallRuns, LeaveNumbersOnlyWhereTheStudySaysSo) {
    ASSERT_EQ(sweep("whole").code, 0);
    EXPECT_THAT(files("whole/runs/" + runs("whole")[0]),
                testing::IsSupersetOf({"checkpoints", "frames", "report.html"}));
    leave_out("[\"frames\", \"page\", \"checkpoint\"]");
    const Outcome ended = sweep("out");
    EXPECT_EQ(ended.code, 0) << ended.errors;
    EXPECT_THAT(ended.output, HasSubstr("The runs leave out 'frames', 'page' and 'checkpoint'\n"));
    for (const std::string& name : runs("out"))
        EXPECT_THAT(files("out/runs/" + name),
                    testing::ElementsAre("measures.csv", "run.log", "scene.resolved.toml", "summary.json"));
    EXPECT_EQ(folder_.read("out/results.csv"), folder_.read("whole/results.csv"));
    ASSERT_EQ(sweep("out", {"--resume"}).code, 0) << "they count as finished";
}

TEST_F(SmallRuns, ThatLeaveNumbersOnlyGoOnFromTheirCheckpoints) {
    folder_.replace("scene.toml", "duration = \"0.2 s\"",
                    "duration = \"0.6 s\"");  // so that it is stopped before its end
    leave_out("[\"frames\", \"page\", \"checkpoint\"]");
    ASSERT_EQ(sweep("whole").code, 0);
    const auto has_measured = [this] {
        const Words names = runs("out");
        return names.size() == 2 &&
               std::ranges::count(folder_.read("out/runs/" + names[1] + "/measures.csv"), '\n') > 9;
    };
    const Outcome stopped = sweep("out", {"--jobs", "1"}, {.interrupt_when = has_measured, .signal = SIGTERM});
    ASSERT_EQ(stopped.code, 143) << stopped.errors;
    ASSERT_THAT(runs("out"), SizeIs(2)) << stopped.output << stopped.errors;
    const std::string second = "out/runs/" + runs("out")[1];
    EXPECT_THAT(files(second), testing::Contains("checkpoints"));
    ASSERT_EQ(sweep("out", {"--resume"}).code, 0);
    EXPECT_EQ(folder_.read("out/results.csv"), folder_.read("whole/results.csv"));
    EXPECT_THAT(folder_.read(second + "/run.log"), HasSubstr("Going on in "));
    EXPECT_THAT(files(second), Not(testing::Contains("checkpoints")));
}

TEST_F(SmallRuns, OfMoreThanAHundredHaveNoPages) {
    folder_.replace("valve.toml", "values = [\"3.5 mPa*s\", \"4 mPa*s\", \"4.5 mPa*s\"]",
                    "range = { from = \"3.5 mPa*s\", to = \"4.5 mPa*s\", steps = 101 }");
    const Outcome ended = sweep("out", {"--only", "part.blood.viscosity=3.5 mPa*s"});
    EXPECT_EQ(ended.code, 0) << ended.errors;
    EXPECT_THAT(ended.output,
                HasSubstr("The runs leave out 'pictures' and 'page', as they are more than 100; 'leave_out "
                          "= []' in the study keeps all\n"));
    const Words left = files("out/runs/" + runs("out")[0]);
    EXPECT_THAT(left, AllOf(testing::Contains("frames"), Not(testing::Contains("report.html"))));
    leave_out("[]");
    ASSERT_EQ(sweep("out", {"--only", "part.blood.viscosity=3.51 mPa*s", "--resume"}).code, 0);
    EXPECT_THAT(files("out/runs/" + runs("out")[1]), testing::Contains("report.html"));
}

TEST_F(SmallRuns, ADivergingOneIsARow) {
    // The second one gets a time step far too long.
    folder_.write("diverge.toml", R"(scene = "scene.toml"
leave_out = ["frames", "page", "checkpoint"]
[[vary]]
key = "flow.acceleration"
values = [["0 m/s^2", "0 m/s^2"], ["1e6 m/s^2", "1e6 m/s^2"], ["0.1 m/s^2", "0 m/s^2"]]
)");
    const Outcome ended = run_dmp(folder_.path(), {"sweep", "diverge.toml", "--out", "out"});
    EXPECT_EQ(ended.code, 3) << ended.errors;
    const std::vector<Words> rows = table("out");
    ASSERT_THAT(rows, SizeIs(3));
    EXPECT_EQ(rows[0][2] + rows[1][2] + rows[2][2], "030");
    EXPECT_THAT(rows[1][3], HasSubstr("the simulation diverged"));
}

}  // namespace

}  // namespace dmp::tests::studies_tests
