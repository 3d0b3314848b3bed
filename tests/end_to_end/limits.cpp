// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// dmp limits: where the models of a scene end.
#include <algorithm>
#include <csignal>
#include <filesystem>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "base/csv.hpp"
#include "tests/end_to_end/program.hpp"

namespace dmp::tests::limits_tests {

namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::SizeIs;
using Words = std::vector<std::string>;

/// Taylor-Green vortices, 20 x 20 particles.
class Limits : public testing::Test {
  protected:
    Limits() {
        folder_.copy_case("verification/taylor_green");
        folder_.replace("scene.toml", "spacing = \"0.01 m\"", "spacing = \"0.05 m\"");
        folder_.replace("scene.toml", "duration = \"1 s\"", "duration = \"1 s\"\nthreads = 1");
    }
    [[nodiscard]] Outcome limits(const Words& more, const Surroundings& with = {}) const {
        Words words{"limits", "scene.toml", "--out", "out"};
        words.insert(words.end(), more.begin(), more.end());
        return run_dmp(folder_.path(), words, with);
    }
    [[nodiscard]] nlohmann::json result() const { return nlohmann::json::parse(folder_.read("out/limits.json")); }
    [[nodiscard]] static nlohmann::json dial(const nlohmann::json& found, const std::string& name,
                                             const std::string& side) {
        for (const auto& each : found["dials"])
            if (each["dial"] == name && each["side"] == side) return each;
        return {};
    }
    /// Of a run, as results.csv has it; "": it has no row.
    [[nodiscard]] std::string exit_code_of(const std::string& run) const {
        std::istringstream table(folder_.read("out/results.csv"));
        std::string line;
        if (!std::getline(table, line)) return "";
        const std::vector<std::string> names = csv_cells(line);
        const auto column = std::ranges::find(names, "exit_code") - names.begin();
        while (std::getline(table, line))
            if (const auto row = csv_cells(line); row.front() == run) return row.at(static_cast<std::size_t>(column));
        return "";
    }
    [[nodiscard]] std::size_t runs() const {
        std::size_t count = 0;
        for (const auto& entry : fs::directory_iterator(folder_.path() / "out/runs")) count += entry.is_directory();
        return count;
    }

    CaseFolder folder_;
};

TEST_F(Limits, SayWhereEachDialEnds) {
    const Outcome ended = limits({"--dials", "step_factor", "numerics.support", "spacing"});
    EXPECT_EQ(ended.code, 0) << ended.errors;
    EXPECT_THAT(ended.output, AllOf(HasSubstr("4 limits of scene.toml, by runs of "), HasSubstr("numerics.step_factor"),
                                    HasSubstr("last clean"), Not(HasSubstr("Not done"))));
    const nlohmann::json found = result();
    ASSERT_THAT(found["dials"], SizeIs(4));
    EXPECT_EQ(found["tolerance"], 0.05);
    EXPECT_EQ(found["set_in_all"], nlohmann::json::array());
    EXPECT_LT(found["simulated_s"], 1.01);
    for (const auto& each : found["dials"]) {
        EXPECT_NE(each["ends"], "not_measured") << each;
        EXPECT_GE(each["margin"], 1) << each;
    }
    const auto step = dial(found, "numerics.step_factor", "up");
    EXPECT_EQ(step["ends"], "breaks") << step;
    EXPECT_THAT(std::string(step["cause"]), HasSubstr("the simulation diverged"));
    EXPECT_GT(step["first_bad"], step["last_clean"]);
    EXPECT_EQ(exit_code_of(step["first_bad_run"]), "3");
    EXPECT_EQ(exit_code_of(step["last_clean_run"]), "0");
    const auto spacing = dial(found, "particles.spacing", "up");
    EXPECT_LT(spacing["first_bad"], 1) << "the whole box";
    EXPECT_GT(spacing["first_bad"], spacing["last_clean"]);
    const auto support = dial(found, "numerics.support", "up");
    EXPECT_LE(support["last_clean"], 6);
    if (support["ends"] == "refused") {
        EXPECT_TRUE(support["first_bad"].is_null()) << support;
    }
    EXPECT_THAT(std::string(support["stated_by"]), HasSubstr("numerics.support"));
    EXPECT_LE(runs(), 2U + 3 * 5 + 1) << "few of all values";

    const std::string picture = folder_.read("out/limits.svg"), page = folder_.read("out/report.html");
    EXPECT_THAT(picture, AllOf(HasSubstr("where its models end"), HasSubstr(">numerics.step_factor</text>")));
    EXPECT_THAT(page, AllOf(HasSubstr("<h2 id=\"limits-heading\">Limits</h2>"), HasSubstr(picture)));
    fs::remove(folder_.path() / "out/report.html");
    EXPECT_EQ(run_dmp(folder_.path(), {"report", "out"}).code, 0);
    EXPECT_EQ(folder_.read("out/report.html"), page) << "of what lies in the folder";

    EXPECT_THAT(limits({}).errors, HasSubstr("it holds this study"));
    const std::string results = folder_.read("out/results.csv");
    const Outcome again = limits({"--dials", "step_factor", "numerics.support", "spacing", "--resume"});
    EXPECT_EQ(again.code, 0) << again.errors;
    EXPECT_EQ(result(), found) << "the same runs, which are not run again";
    EXPECT_EQ(folder_.read("out/results.csv"), results);
}

TEST_F(Limits, AreStoppedBySignalsAndGoOnToTheSameTable) {
    const Words dials{"--dials", "step_factor", "shifting", "--jobs", "1"};
    const auto has_some = [this] {
        return fs::exists(folder_.path() / "out/runs") &&
               std::distance(fs::directory_iterator(folder_.path() / "out/runs"), fs::directory_iterator()) > 3;
    };
    const Outcome stopped = limits(dials, {.interrupt_when = has_some, .signal = SIGINT});
    EXPECT_EQ(stopped.code, 130) << stopped.output << stopped.errors;
    EXPECT_THAT(stopped.output, HasSubstr("Stopped before its end, by Ctrl-C"));
    Words resume = dials;
    resume.emplace_back("--resume");
    EXPECT_EQ(limits(resume).code, 0);
    const nlohmann::json found = result();
    Words anew = dials;
    anew.emplace_back("--overwrite");
    EXPECT_EQ(limits(anew).code, 0);
    EXPECT_EQ(result(), found);
}

TEST_F(Limits, KeepToTheirBudgetAndGoOnWithALargerOne) {
    const Words dials{"--dials", "step_factor"};
    const auto with = [&](const Words& more) {
        Words words = dials;
        words.insert(words.end(), more.begin(), more.end());
        return limits(words);
    };
    const Outcome small = with({"--budget", "1 ms"});
    EXPECT_EQ(small.code, 2);
    EXPECT_THAT(small.errors, AllOf(HasSubstr("--budget: 1 ms is too little to find a limit: it takes "),
                                    HasSubstr(" runs at most"), HasSubstr("--resume")));
    const Outcome all = with({"--budget", "10 h", "--resume"});
    EXPECT_EQ(all.code, 0) << all.errors;
    EXPECT_THAT(all.output, Not(HasSubstr("Not done")));
    const nlohmann::json step = dial(result(), "numerics.step_factor", "up");
    EXPECT_NE(step["ends"], "not_measured");
    const Outcome more = limits({"--dials", "mach_number", "--resume"});
    EXPECT_EQ(more.code, 0) << more.errors;
    EXPECT_THAT(result()["dials"], SizeIs(2)) << "those of both starts";
    EXPECT_EQ(dial(result(), "numerics.step_factor", "up"), step);
    EXPECT_EQ(dial(result(), "numerics.mach_number", "up")["stated"], 0.3);
}

TEST_F(Limits, OfASceneThatDoesNotRunSaySo) {
    const Outcome diverged = limits({"--set", "numerics.step_factor=1", "--dials", "viscosity"});
    EXPECT_EQ(diverged.code, 3) << diverged.output;
    EXPECT_THAT(diverged.errors, AllOf(HasSubstr("the scene does not run at its own settings: "),
                                       HasSubstr("the simulation diverged"), HasSubstr("out/runs/0001_")));
    EXPECT_EQ(runs(), 1U) << "no other run";
    EXPECT_FALSE(fs::exists(folder_.path() / "out/limits.json"));
    folder_.replace("square.geo", "Physical Surface", "Physical Curve");
    const Outcome refused = limits({"--overwrite"});
    EXPECT_EQ(refused.code, 2);
    EXPECT_THAT(refused.errors, HasSubstr("the scene does not run at its own settings: "));
}

TEST_F(Limits, OfADryRunAreTheDialsAndWhatTheyTake) {
    const Outcome ended = limits({"--dry-run"});
    EXPECT_EQ(ended.code, 0) << ended.errors;
    EXPECT_THAT(ended.output, AllOf(HasSubstr("part.water.viscosity"), HasSubstr("Mach number, which sets"),
                                    HasSubstr("all runs"), HasSubstr("Nothing was written")));
    EXPECT_FALSE(fs::exists(folder_.path() / "out"));
}

TEST_F(Limits, RefuseWhatMakesNoSense) {
    const std::vector<std::pair<Words, std::string>> wrong{
        {{"--dials", "numerics.step_facto"}, "the scene has no dial 'numerics.step_facto'"},
        {{"--dials", "steps_per_contact"}, "Its dials are 'numerics.step_factor', "},
        {{"--tolerance", "0"}, "--tolerance: '0' is no error above 0"},
        {{"--budget", "0 s"}, "--budget: '0 s' is no time above 0"},
        {{"--until", "5 kg"}, "--until: found \"5 kg\" (mass)"},
        {{"--resume"}, "there is no study to go on with"},
        {{"--slurm"}, "limits are not found in jobs of Slurm"},
        {{"--set", "particles.spacing=5"}, "particles.spacing"},
    };
    for (const auto& [words, said] : wrong) {
        const Outcome ended = limits(words);
        EXPECT_EQ(ended.code, 2) << said;
        EXPECT_THAT(ended.errors, HasSubstr(said));
    }
    EXPECT_FALSE(fs::exists(folder_.path() / "out"));
}

}  // namespace
}  // namespace dmp::tests::limits_tests
