// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Studies: many runs of one scene, stopped, killed and damaged in every way, and one table at the end.
#include <algorithm>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <future>
#include <map>

#include <gmock/gmock.h>

#include "tests/end_to_end/small_studies.hpp"

namespace dmp::tests::studies_tests {

namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::SizeIs;
using testing::StartsWith;

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
    const Outcome refused = sweep("out", {"--resume"});
    EXPECT_EQ(refused.code, 2);
    EXPECT_THAT(refused.errors, HasSubstr("the measure 'density' has no column 'lowest', only 'low' and 'high'"));
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

}  // namespace

}  // namespace dmp::tests::studies_tests
