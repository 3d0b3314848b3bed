// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Runs that start from the state of another run, and what they may change.
#include <filesystem>

#include <gmock/gmock.h>

#include "tests/end_to_end/small_valve.hpp"

namespace dmp::tests::start_from_tests {

namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::SizeIs;

class StartFrom : public SmallValve {
  protected:
    /// A run that has got to 0.03 s.
    void run_first() const { ASSERT_EQ(run("first", {"--until", "0.03 s"}).code, 0); }
    [[nodiscard]] Outcome start(const std::string& out, Words more = {}, const Surroundings& with = {}) const {
        if (std::ranges::find(more, "--from") == more.end()) more.insert(more.end(), {"--from", "first"});
        more.insert(more.end(), {"--until", "0.06 s"});
        return run(out, more, with);
    }
    /// Two checkpoints, and what is said of the one for a time.
    [[nodiscard]] std::string start_line(const std::string& from) const {
        const Outcome started = start("of_time", {"--from", from, "--overwrite"});
        EXPECT_EQ(started.code, 0) << started.errors;
        const auto at = started.output.find("Starting from");
        return started.output.substr(at, started.output.find('\n', at) - at);
    }
};

TEST_F(StartFrom, WithTheSameValuesGivesWhatALongerRunGives) {
    run_first();
    ASSERT_EQ(run("whole", {"--until", "0.06 s"}).code, 0);
    for (const int ranks : {0, 2, 4}) {
        const std::string out = "on_" + std::to_string(ranks);
        const Outcome started = start(out, {}, {.ranks = ranks});
        ASSERT_EQ(started.code, 0) << started.errors;
        EXPECT_EQ(hash(out), hash("whole")) << ranks << " ranks";
    }
}

TEST_F(StartFrom, SaysWhereItStartedAndHasFilesOfItsOwn) {
    run_first();
    const std::string before = folder_.read("first/summary.json");
    const Outcome started = start("second", {"--set", "part.blood.viscosity=\"4 mPa*s\"", "--set",
                                             "part.leaflets.bending_stiffness=\"2e-6 N*m^2\"", "--set",
                                             "flow.pressure_gradient=[\"-50 Pa/m\", 0]"});
    ASSERT_EQ(started.code, 0) << started.errors;
    const std::string checkpoint = "first/checkpoints/" + files("first/checkpoints").back();
    EXPECT_THAT(started.output,
                AllOf(HasSubstr("Starting from the state of " + checkpoint + ", step "),
                      HasSubstr(" s: time goes on from there, to 0.06 s, with other values:\n"),
                      HasSubstr("part.blood.viscosity: was \"0.0035 "), HasSubstr("bending_stiffness: was \"3e-06 "),
                      HasSubstr("flow.pressure_gradient: was ")));
    EXPECT_THAT(folder_.read("second/run.log"), HasSubstr("Starting from the state of " + checkpoint));
    const auto start_of = summary("second")["started_from"];
    EXPECT_EQ(start_of["checkpoint"], checkpoint);
    EXPECT_EQ(start_of["time_s"], 0.03);
    EXPECT_EQ(start_of["step"], summary("first")["steps"]);
    EXPECT_EQ(summary("second")["simulated_s"], 0.06);
    EXPECT_THAT(folder_.read("second/scene.resolved.toml"), HasSubstr("## Started from the state of " + checkpoint));
    EXPECT_EQ(folder_.read("first/summary.json"), before);
    // A first frame and row of the state, then what is due: 0.04, 0.05 and 0.06 s.
    EXPECT_EQ(files("second/frames").size(), 2U * 4U) << "fluid and solid";
    const std::string table = folder_.read("second/measures.csv");
    const double first_row = std::stod(table.substr(table.find('\n') + 1));
    EXPECT_DOUBLE_EQ(first_row, start_of["time_s"]);

    // The scene that it leaves reads as one.
    const Outcome explained = run_dmp(folder_.path(), {"explain", "second/scene.resolved.toml", "--no-measure"});
    EXPECT_EQ(explained.code, 0) << explained.errors;
}

TEST_F(StartFrom, IsResumedLikeAnyRun) {
    run_first();
    const Words changed{"--set", "part.blood.viscosity=\"4 mPa*s\""};
    ASSERT_EQ(start("whole", changed).code, 0);
    const Outcome stopped =
        start("parts", changed, {.interrupt_at = "parts/frames/fluid_000002.vtp", .signal = SIGTERM});
    ASSERT_EQ(stopped.code, 143) << stopped.errors;
    const auto line = stopped.output.find("Go on with the same command");
    EXPECT_THAT(stopped.output.substr(line), AllOf(HasSubstr(" --resume\n"), Not(HasSubstr("--from"))));
    Words again = changed;
    again.insert(again.end(), {"--until", "0.06 s", "--resume"});
    ASSERT_EQ(run("parts", again).code, 0);
    EXPECT_EQ(hash("parts"), hash("whole"));
    EXPECT_EQ(folder_.read("parts/measures.csv"), folder_.read("whole/measures.csv"));
    EXPECT_EQ(summary("parts")["started_from"], summary("whole")["started_from"]);
    EXPECT_EQ(summary("parts")["conserved"]["start"], summary("whole")["conserved"]["start"]);
}

TEST_F(StartFrom, TakesTheCheckpointOfATimeOrTheOneBefore) {
    ASSERT_EQ(stopped_run("first", {"--checkpoint-every", "0.01 s"}).code, 143);
    ASSERT_THAT(files("first/checkpoints"), SizeIs(2));
    const std::string newest = start_line("first"), oldest = files("first/checkpoints").front();
    EXPECT_THAT(newest, HasSubstr(files("first/checkpoints").back()));
    EXPECT_EQ(start_line("first@1 s"), newest);
    const auto time_at = newest.find("t = ") + 4;
    const double last = std::stod(newest.substr(time_at));
    EXPECT_THAT(start_line("first@" + std::to_string(last - 1e-5) + " s"), HasSubstr(oldest));
    const Outcome too_early = start("too_early", {"--from", "first@1 us"});
    EXPECT_EQ(too_early.code, 2);
    EXPECT_THAT(too_early.errors,
                AllOf(HasSubstr("first: it holds no checkpoint of t = 1e-06 s or before; those there are:\n  0.0"),
                      HasSubstr(", step ")));
}

TEST_F(StartFrom, NotWhereTheStateWouldBeOfOtherParticlesOrMeanSomethingElse) {
    run_first();
    const auto refused = [&](const Words& set) {
        const Outcome outcome = start("second", set);
        EXPECT_EQ(outcome.code, 2);
        EXPECT_FALSE(std::filesystem::exists(folder_.path() / "second"));
        return outcome.errors;
    };
    EXPECT_THAT(refused({"--set", "particles.spacing=\"0.4 mm\"", "--set", "part.blood.density=\"1000 kg/m^3\"",
                         "--set", "part.blood.viscosity=\"4 mPa*s\""}),
                AllOf(HasSubstr("this scene cannot start from that state, for which these values must be the same:\n  "
                                "particles.spacing: was \"5e-04 m\", is \"4e-04 m\": the particles would be others\n"),
                      HasSubstr("part.blood.density: was "), Not(HasSubstr("viscosity"))));
    EXPECT_THAT(
        refused({"--set", "numerics.equation_of_state=\"linear\""}),
        HasSubstr("numerics.equation_of_state: was \"tait\", is \"linear\": the state would mean something else"));
    EXPECT_THAT(refused({"--set", "flow.initial_velocity=[\"1 mm/s\", 0]"}),
                HasSubstr("it acts at the start of a run"));
}

TEST_F(StartFrom, NotWithAnotherSpeedOfSound) {
    run_first();
    const Outcome refused = start("second", {"--set", "numerics.sound_speed=\"4 m/s\""});
    EXPECT_EQ(refused.code, 2);
    EXPECT_THAT(refused.errors, AllOf(HasSubstr("the speed of sound [m/s] is 3 in the state that the run is to start "
                                                "from, and 4 would be chosen for it"),
                                      HasSubstr("Keep it with --set numerics.sound_speed='\"3 m/s\"'.")));
}

TEST_F(StartFrom, NotFromNothingNorFromTheFutureNorFromItself) {
    run_first();
    EXPECT_THAT(start("second", {"--from", "nothing"}).errors, HasSubstr("nothing: there is no checkpoint here"));
    EXPECT_THAT(run("second", {"--from", "first", "--until", "0.02 s"}).errors,
                HasSubstr(", and the run is asked to end at 0.02 s"));
    EXPECT_THAT(start("first", {"--overwrite"}).errors,
                HasSubstr("first: it is the folder that the results of this run go to"));
    EXPECT_THAT(files("first/checkpoints"), SizeIs(1));
    EXPECT_THAT(start("second", {"--resume"}).errors, HasSubstr("--from"));
    EXPECT_THAT(start("second", {"--from", "first@soon"}).errors, HasSubstr("--from"));
}

}  // namespace

}  // namespace dmp::tests::start_from_tests
