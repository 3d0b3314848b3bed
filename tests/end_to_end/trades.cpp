// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// dmp trade: settings of a scene, their costs and errors.
#include <algorithm>
#include <csignal>
#include <filesystem>

#include <gmock/gmock.h>

#include "tests/end_to_end/small_valve.hpp"

namespace dmp::tests::trades_tests {

namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::SizeIs;

/// The vein valve with coarse particles, for a short time.
class Trades : public SmallValve {
  protected:
    Trades() {
        folder_.replace("scene.toml", "spacing = \"0.2 mm\"", "spacing = \"0.4 mm\"");
        folder_.replace("scene.toml", "every = \"40 ms\"", "every = \"10 ms\"");
        fs::remove(folder_.path() / "trade.json");  // of the case as it is
        // At half its speed of sound, the Mach number would be too large.
        folder_.replace("scene.toml", "largest_speed = \"0.1 m/s\"", "largest_speed = \"0.4 m/s\"");
    }
    [[nodiscard]] Outcome trade(const Words& more, const Surroundings& with = {}) const {
        Words words{"trade", "scene.toml"};
        if (std::ranges::find(more, "--until") == more.end()) words.insert(words.end(), {"--until", "60 ms"});
        words.insert(words.end(), more.begin(), more.end());
        return run_dmp(folder_.path(), words, with);
    }
    [[nodiscard]] bool has_all_errors(const std::string& out) const {
        return std::ranges::all_of(result(out)["settings"], [](const auto& each) {
            return each.contains("error") && each["error"].is_number();
        });
    }
    [[nodiscard]] nlohmann::json result(const std::string& out) const {
        return nlohmann::json::parse(folder_.read(out + "/trade.json"));
    }
};

TEST_F(Trades, SayWhatEachSettingCostsAndHowWrongItIs) {
    const Outcome ended = trade({"--out", "out", "--measures", "inlet_flux", "--tolerance", "30 %", "0.0001"});
    EXPECT_EQ(ended.code, 0) << ended.errors;
    EXPECT_THAT(ended.output, HasSubstr("6 settings of scene.toml"));
    EXPECT_THAT(ended.output, HasSubstr("For 0.01 %: not reachable: the smallest error is "));
    EXPECT_THAT(ended.output, HasSubstr("run scene.toml --set 'particles.spacing=\""));
    const nlohmann::json found = result("out");
    ASSERT_THAT(found["settings"], SizeIs(6));
    ASSERT_THAT(found["measures"], SizeIs(1));
    EXPECT_EQ(found["measures"][0]["name"], "inlet_flux");
    EXPECT_EQ(found["simulated_s"], 0.06);
    EXPECT_EQ(found["duration_s"], 4.0);
    EXPECT_EQ(found["set_in_all"], nlohmann::json::array());
    EXPECT_TRUE(found["measures"][0]["scatter"].is_number());
    EXPECT_TRUE(found["measures"][0]["error_of_reference"].is_number());
    for (const auto& setting : found["settings"]) {
        EXPECT_GT(setting["processor_s"], 0);
        EXPECT_GE(setting["error"], found["measures"][0]["scatter"]);
        EXPECT_GE(setting["error"], found["measures"][0]["error_of_reference"]);
    }
    EXPECT_GT(found["settings"][0]["error"], found["settings"][5]["error"]) << "the coarsest, the finest";
    EXPECT_EQ(found["settings"][5]["run"], found["reference"]);
    EXPECT_EQ(found["settings"][5]["distance"]["inlet_flux"]["whole"], 0);
    EXPECT_EQ(found["settings"][5]["set"],
              nlohmann::json::array({"particles.spacing=\"0.2828 mm\"", "numerics.sound_speed=\"3 m/s\""}));
    const std::string picture = folder_.read("out/trade.svg"), page = folder_.read("out/report.html");
    EXPECT_THAT(picture, AllOf(HasSubstr("error over processor time of 0.06 s simulated"), HasSubstr(">0.28 mm</text>"),
                               HasSubstr(">" + folder_.path().filename().string() + "</text>")));
    EXPECT_THAT(page, AllOf(HasSubstr("<h2 id=\"trade-heading\">Cost and error</h2>"), HasSubstr(picture),
                            HasSubstr("--set &#39;particles.spacing=&quot;")));
    fs::remove(folder_.path() / "out/report.html");
    EXPECT_EQ(run_dmp(folder_.path(), {"report", "out"}).code, 0);
    EXPECT_EQ(folder_.read("out/report.html"), page) << "of what lies in the folder";

    EXPECT_THAT(trade({"--out", "out"}).errors, HasSubstr("it holds this study, 6 of 6 runs done"));
    const Outcome again = trade({"--out", "out", "--measures", "inlet_flux", "--resume"});
    EXPECT_EQ(again.code, 0);
    EXPECT_EQ(result("out"), found) << "the same runs, which are not run again";
}

TEST_F(Trades, AreTheStudyThatLiesInTheirFolder) {
    ASSERT_EQ(trade({"--out", "out"}).code, 0);
    const Outcome sweep = run_dmp(folder_.path(), {"sweep", "out/study.toml", "--out", "sweep"});
    EXPECT_EQ(sweep.code, 0) << sweep.errors;
    EXPECT_EQ(folder_.read("sweep/results.csv"), folder_.read("out/results.csv"));
}

TEST_F(Trades, KeepToTheirBudgetAndGoOnWithALargerOne) {
    const Outcome small = trade({"--out", "out", "--budget", "1 ms"});
    EXPECT_EQ(small.code, 2);
    EXPECT_THAT(small.errors,
                AllOf(HasSubstr("--budget: 1 ms is too little to compare settings: "), HasSubstr("--resume")));
    const Outcome all = trade({"--out", "out", "--budget", "10 h", "--resume"});
    EXPECT_EQ(all.code, 0) << all.errors;
    EXPECT_THAT(all.output, Not(HasSubstr("not done within")));
    EXPECT_TRUE(has_all_errors("out"));
}

TEST_F(Trades, AreStoppedBySignalsAndGoOn) {
    const auto has_begun = [this] { return fs::exists(folder_.path() / "out/timing.csv"); };
    const Outcome stopped = trade({"--out", "out"}, {.interrupt_when = has_begun, .signal = SIGINT});
    EXPECT_EQ(stopped.code, 130);
    EXPECT_THAT(stopped.output, HasSubstr("Stopped before its end, by Ctrl-C"));
    EXPECT_EQ(trade({"--out", "out", "--resume"}).code, 0);
    EXPECT_TRUE(has_all_errors("out"));
}

TEST_F(Trades, HaveARowForWhatIsRefused) {
    folder_.replace("scene.toml", "spacing = \"0.4 mm\"", "spacing = \"0.8 mm\"");
    const Outcome ended = trade({"--out", "out"});
    EXPECT_EQ(ended.code, 0) << ended.errors;
    EXPECT_THAT(ended.output, HasSubstr("1.6 mm     sound speed 3 m/s  failed"));
    const nlohmann::json coarsest = result("out")["settings"][0];
    EXPECT_THAT(std::string(coarsest["failure"]), HasSubstr("stand on top of each other"));
    EXPECT_FALSE(coarsest.contains("error"));
    EXPECT_EQ(trade({"--out", "out", "--resume", "--budget", "1 ms"}).code, 0);
    EXPECT_EQ(result("out")["settings"][0]["failure"], coarsest["failure"]) << "not begun again";
}

TEST_F(Trades, GiveARunTheSettingForItsTolerance) {
    const auto run = [&](const Words& more) {
        Words words{"run", "scene.toml", "--until", "20 ms", "--out", "run"};
        words.insert(words.end(), more.begin(), more.end());
        return run_dmp(folder_.path(), words);
    };
    const Outcome without = run({"--tolerance", "5 %"});
    EXPECT_EQ(without.code, 2);
    EXPECT_THAT(without.errors, AllOf(HasSubstr("there is no trade of this scene"), HasSubstr(" trade scene.toml")));
    ASSERT_EQ(trade({"--measures", "inlet_flux"}).code, 0);  // into its default folder
    const std::string name = folder_.path().filename().string();
    const nlohmann::json found = result("out/" + name + "_trade");
    const double coarsest = found["settings"][0]["error"];
    const Outcome ended = run({"--tolerance", std::to_string(100 * coarsest + 0.01) + " %"});
    EXPECT_EQ(ended.code, 0) << ended.errors;
    EXPECT_THAT(ended.output, AllOf(HasSubstr("particles.spacing=\"0.8 mm\" numerics.sound_speed=\"3 m/s\" (error "),
                                    HasSubstr(" up to 60 ms of 4 s, about ")));
    EXPECT_EQ(summary("run")["particles"],
              summary("out/" + name + "_trade/runs/" + std::string(found["settings"][0]["run"]))["particles"]);
    EXPECT_THAT(run({"--overwrite", "--tolerance", "1e-9"}).errors, HasSubstr("no setting has an error of at most"));
    EXPECT_THAT(run({"--overwrite", "--tolerance", "5 %", "--set", "part.blood.viscosity=\"4 mPa*s\""}).errors,
                HasSubstr("it is of another scene, or of this one with other values"));
    for (const char* damaged : {"{", "{\"identity\": 1e999}", "[]"}) {
        folder_.write("out/" + name + "_trade/trade.json", damaged);
        EXPECT_EQ(run({"--overwrite", "--tolerance", "5 %"}).code, 2) << damaged;
    }
    folder_.write("out/" + name + "_trade/trade.json", found.dump());
    folder_.write("vein_valve.geo", folder_.read("vein_valve.geo") + "// changed\n");
    EXPECT_THAT(run({"--overwrite", "--tolerance", "5 %"}).errors, HasSubstr("it is of another scene"));
    folder_.write("out/" + name + "_trade/trade.json", "{");
    EXPECT_EQ(run({"--overwrite", "--tolerance", "5 %"}).code, 2);
}

TEST_F(Trades, AdviseLowerSpeedsOfSoundOnlyForTimesThatTheyHaveSeen) {
    folder_.replace("scene.toml", "largest_speed = \"0.4 m/s\"", "largest_speed = \"0.2 m/s\"");
    const auto lowest_is_on_front = [&](const std::string& out) {
        const nlohmann::json found = result(out);
        EXPECT_THAT(found["settings"], SizeIs(10));
        EXPECT_EQ(found["levels"], nlohmann::json::array({"sound speed 1.5 m/s", "sound speed 3 m/s"}));
        EXPECT_EQ(found["settings"][0]["level"], "sound speed 1.5 m/s");
        return std::ranges::find(found["front"], found["settings"][0]["run"]) != found["front"].end();
    };
    const Outcome shortened = trade({"--out", "out", "--measures", "inlet_flux"});
    EXPECT_EQ(shortened.code, 0) << shortened.errors;
    EXPECT_THAT(shortened.output, HasSubstr("Lower levels than sound speed 3 m/s are not advised"));
    EXPECT_FALSE(lowest_is_on_front("out"));
    const Outcome whole = run_dmp(folder_.path(), {"trade", "scene.toml", "--set", "run.duration=\"60 ms\"", "--out",
                                                   "whole", "--measures", "inlet_flux"});
    EXPECT_EQ(whole.code, 0) << whole.errors;
    EXPECT_TRUE(lowest_is_on_front("whole"));
    const Outcome run = run_dmp(folder_.path(), {"run", "scene.toml", "--tolerance", "99 %", "--trade", "whole"});
    EXPECT_EQ(run.code, 2);
    EXPECT_THAT(run.errors, HasSubstr("it is of runs to 60 ms, but the scene goes on to 4 s"));
}

TEST_F(Trades, TakeASpacingThatIsSetAndFoldersAnywhere) {
    const Outcome ended =
        trade({"--out", "../" + folder_.path().filename().string() + "/out", "--set", " particles.spacing = \"0.5 mm\"",
               "--set", "run.duration=\"1 s\"", "--set", "run.threads=1", "--budget", "1e12 s"});
    EXPECT_EQ(ended.code, 0) << ended.errors;
    EXPECT_EQ(result("out")["settings"][0]["set"][0], "particles.spacing=\"1 mm\"");
    EXPECT_EQ(result("out")["duration_s"], 1.0);
    const Outcome anew = trade({"--out", "out", "--overwrite", "--budget", "1 ms"});
    EXPECT_EQ(anew.code, 2);
    for (const char* name : {"trade.json", "trade.svg"})
        EXPECT_FALSE(fs::exists(folder_.path() / "out" / name)) << "that of the trade that was removed";
}

TEST_F(Trades, NeedTwoSettingsThatEnd) {
    folder_.replace("scene.toml", "spacing = \"0.4 mm\"", "spacing = \"10 mm\"");
    const Outcome ended = trade({"--out", "out"});
    EXPECT_EQ(ended.code, 2);
    EXPECT_THAT(ended.errors,
                AllOf(HasSubstr("fewer than two settings have come to their end"), HasSubstr("results.csv")));
}

TEST_F(Trades, OfASceneWithoutMeasuresTakeItsKineticEnergy) {
    const std::string scene = folder_.read("scene.toml");
    folder_.write("scene.toml", scene.substr(0, scene.find("[[measure]]")));
    const Outcome ended = trade({"--out", "out", "--tolerance", "99 %"});
    EXPECT_EQ(ended.code, 0) << ended.errors;
    EXPECT_THAT(ended.output, HasSubstr("The scene measures nothing; its runs are compared by 'kinetic_energy'."));
    EXPECT_THAT(ended.output, Not(HasSubstr("--set 'measure.")));
    EXPECT_EQ(result("out")["measures"][0]["name"], "kinetic_energy");
    const Outcome run = run_dmp(folder_.path(), {"run", "scene.toml", "--until", "20 ms", "--tolerance", "99 %",
                                                 "--trade", "out", "--out", "run"});
    EXPECT_EQ(run.code, 0) << run.errors;
    EXPECT_THAT(run.output, HasSubstr("For an error of 99 %, by out/trade.json: "));
}

TEST_F(Trades, AreComparedWithAReferenceThatIsGiven) {
    const Words run{"run", "scene.toml", "--until", "60 ms", "--out", "fine", "--set"};
    const auto run_with = [&](const std::string& setting, const std::string& out) {
        Words words = run;
        words[5] = out;
        words.push_back(setting);
        ASSERT_EQ(run_dmp(folder_.path(), words).code, 0);
    };
    run_with("particles.spacing=\"0.25 mm\"", "fine");
    run_with("part.blood.viscosity=\"4 mPa*s\"", "other");
    ASSERT_EQ(trade({"--out", "out", "--measures", "inlet_flux"}).code, 0);
    const nlohmann::json before = result("out");
    const Outcome ended = trade({"--out", "out", "--measures", "inlet_flux", "--resume", "--reference", "fine"});
    EXPECT_EQ(ended.code, 0) << ended.errors;
    EXPECT_THAT(ended.output, HasSubstr("the reference, given"));
    const nlohmann::json found = result("out");
    ASSERT_THAT(found["settings"], SizeIs(7));
    EXPECT_EQ(found["reference"], "fine");
    EXPECT_EQ(found["settings"][6]["is_reference_given"], true);
    EXPECT_EQ(found["settings"][6]["distance"]["inlet_flux"]["whole"], 0);
    EXPECT_GT(found["settings"][5]["distance"]["inlet_flux"]["whole"], 0);
    EXPECT_LT(found["measures"][0]["error_of_reference"], before["measures"][0]["error_of_reference"]);
    EXPECT_THAT(
        trade({"--out", "out", "--resume", "--reference", "other"}).errors,
        AllOf(HasSubstr("other: this reference is a run of another scene:"), HasSubstr("part.blood.viscosity")));
    EXPECT_THAT(trade({"--out", "out", "--resume", "--reference", "out"}).errors,
                HasSubstr("'out' is no folder of a run that has ended"));
}

TEST_F(Trades, RefuseWhatMakesNoSense) {
    const std::vector<std::pair<Words, std::string>> wrong{
        {{"--measures", "flux"}, "--measures: the scene has no measure 'flux'"},
        {{"--tolerance", "0"}, "--tolerance: '0' is no error above 0 and below 100 %"},
        {{"--tolerance", "5 kg"}, "--tolerance: '5 kg' is no error above 0 and below 100 %"},
        {{"--tolerance", "5"}, "--tolerance: '5' is no error above 0 and below 100 %"},
        {{"--budget", "0 s"}, "--budget: '0 s' is no time above 0"},
        {{"--budget", "5 kg"}, "--budget: found \"5 kg\" (mass)"},
        {{"--budget", "-1 s"}, "--budget: '-1 s' is no time above 0"},
        {{"--resume"}, "there is no study to go on with"},
        {{"--until", "3 ms"},
         "--until: runs to 3 ms have fewer than two rows of measures, which are written every 10 ms"},
        {{"--slurm", "--budget", "1 h"}, "--budget excludes --slurm"},
        {{"--partition", "long"}, "are of jobs of Slurm"},
        {{"--set", "particles.spacing=5"}, "particles.spacing"},
    };
    for (const auto& [words, said] : wrong) {
        const Outcome ended = trade(words);
        EXPECT_EQ(ended.code, 2) << said;
        EXPECT_THAT(ended.errors, HasSubstr(said));
    }
    EXPECT_FALSE(fs::exists(folder_.path() / "out"));
}

}  // namespace
}  // namespace dmp::tests::trades_tests
