// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// The single runs of a study: what they leave, and what happens to some of them.
#include <algorithm>
#include <csignal>
#include <fstream>
#include <functional>
#include <iterator>

#include <gmock/gmock.h>

#include "tests/end_to_end/small_studies.hpp"

namespace dmp::tests::runs_of_studies_tests {

namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::SizeIs;

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
    EXPECT_THAT(folder_.read("scene.toml"), testing::StartsWith("# why"));
    EXPECT_THAT(table("out"), SizeIs(3));
    const Outcome stopped = sweep_during("other", [&](pid_t) {
        folder_.replace("scene.toml", "density = \"1056 kg/m^3\"", "density = \"1050 kg/m^3\"");
    });
    EXPECT_EQ(stopped.code, 2);
    EXPECT_THAT(stopped.errors, HasSubstr("scene.toml: the scene was changed while its study ran\n"));
    const Outcome broken = sweep_during("broken", [&](pid_t) { folder_.write("scene.toml", "title = "); });
    EXPECT_EQ(broken.code, 2);
    EXPECT_THAT(broken.errors,
                HasSubstr("scene.toml: the scene was changed while its study ran, and cannot be read: "));
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

}  // namespace dmp::tests::runs_of_studies_tests
