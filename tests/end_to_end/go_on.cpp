// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Finished runs that go on to a later end.
#include <gmock/gmock.h>

#include "tests/end_to_end/small_valve.hpp"

namespace dmp::tests::go_on_tests {

namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

class GoOn : public SmallValve {
  protected:
    /// Every file that both runs leave but for their own accounts.
    void expect_same_files(const std::string& one, const std::string& other) const {
        EXPECT_EQ(files(one + "/frames"), files(other + "/frames"));
        for (const auto& frame : files(one + "/frames"))
            EXPECT_EQ(folder_.read(one + "/frames/" + frame), folder_.read(other + "/frames/" + frame)) << frame;
        for (const std::string file : {"fluid.pvd", "solid.pvd", "walls.vtp", "measures.csv", "scene.resolved.toml"})
            EXPECT_EQ(folder_.read(one + "/" + file), folder_.read(other + "/" + file)) << file;
    }
};

TEST_F(GoOn, ToALaterEndGivesWhatALongerRunGives) {
    const Words fields = all_fields();
    Words longer = fields;
    longer.insert(longer.end(), {"--until", "0.06 s"});
    ASSERT_EQ(run("whole", longer).code, 0);
    // At a frame, between two frames, and within the last step before one.
    for (const std::string first : {"0.03 s", "0.0333 s", "0.02999999 s"}) {
        const std::string out = "from_" + first.substr(0, first.find(' '));
        Words shorter = fields;
        shorter.insert(shorter.end(), {"--until", first});
        ASSERT_EQ(run(out, shorter).code, 0);
        EXPECT_NE(hash(out), hash("whole"));
        Words again = longer;
        again.emplace_back("--resume");
        const auto resumed = run(out, again);
        ASSERT_EQ(resumed.code, 0) << resumed.errors;
        EXPECT_THAT(resumed.output, HasSubstr("Going on in " + out + " from step "));
        EXPECT_EQ(hash(out), hash("whole")) << first;
        EXPECT_EQ(summary(out)["steps"], summary("whole")["steps"]) << first;
        expect_same_files(out, "whole");
    }
}

TEST_F(GoOn, WithALongerDurationGivesWhatALongerRunGives) {
    // A constant drive: what changes with time may be judged by the whole duration.
    const Words with{"--set", "flow.pressure_gradient=[\"-50 Pa/m\", 0]"};
    Words shorter = with, longer = with;
    shorter.insert(shorter.end(), {"--set", "run.duration=\"0.03 s\"", "--until", "0.03 s"});
    longer.insert(longer.end(), {"--set", "run.duration=\"0.06 s\"", "--until", "0.06 s"});
    ASSERT_EQ(run("whole", longer).code, 0);
    ASSERT_EQ(run("parts", shorter).code, 0);
    longer.emplace_back("--resume");
    const auto resumed = run("parts", longer);
    ASSERT_EQ(resumed.code, 0) << resumed.errors;
    EXPECT_EQ(hash("parts"), hash("whole"));
}

TEST_F(GoOn, MayWriteAndMeasureOtherThings) {
    ASSERT_EQ(run("out", {"--until", "0.03 s"}).code, 0);
    const std::string before = folder_.read("out/measures.csv");
    folder_.replace("scene.toml", "name = \"tip_gap\"\nkind = \"gap\"\npart = \"leaflets\"",
                    "name = \"energy\"\nkind = \"kinetic_energy\"");
    const Words changed{
        "--until",      "0.05 s", "--set", "output.every=\"5 ms\"", "--set", "output.fields=['velocity']",
        "--wall-limit", "1 h"};
    const auto refused = run("out", changed);
    EXPECT_EQ(refused.code, 2);
    EXPECT_THAT(
        refused.errors,
        AllOf(HasSubstr("it holds this run, finished at t = 0.03 s; this one would end at 0.05 s; these values may "
                        "change as it goes on:"),
              HasSubstr("output.every: was \"0.01 s\", is \"0.005 s\""), HasSubstr(" --resume\n")));
    Words again = changed;
    again.emplace_back("--resume");
    const auto resumed = run("out", again);
    ASSERT_EQ(resumed.code, 0) << resumed.errors;
    EXPECT_EQ(files("out/frames").size(), 2 * (4 + 4)) << "fluid and solid, four frames each before and after";
    EXPECT_EQ(folder_.read("out/measures_1.csv"), before);
    const std::string table = folder_.read("out/measures.csv");
    EXPECT_THAT(table, AllOf(HasSubstr(",energy [J]"), Not(HasSubstr("tip_gap")), HasSubstr(",nan")));
    EXPECT_THAT(resumed.output, HasSubstr("it is kept in out/measures_1.csv"));
}

TEST_F(GoOn, NotWithOtherPhysics) {
    ASSERT_EQ(run("out", {"--until", "0.01 s"}).code, 0);
    const auto before = folder_.read("out/summary.json");
    const auto refused = run("out", {"--until", "0.02 s", "--resume", "--set", "part.blood.viscosity=\"4 mPa*s\"",
                                     "--set", "output.every=\"5 ms\""});
    EXPECT_EQ(refused.code, 2);
    EXPECT_THAT(refused.errors, AllOf(HasSubstr("the scene is not the one this run was started with:\n  "
                                                "part.blood.viscosity: was \"0.0035 "),
                                      Not(HasSubstr("output.every"))));
    EXPECT_EQ(folder_.read("out/summary.json"), before);
}

TEST_F(GoOn, NotWithADurationThatChangesWhatIsChosenByIt) {
    const Words drive{"--set", "flow.pressure_gradient=[\"-50 Pa/m * sin(100 s^-2 * t^2)\", 0]"};
    Words shorter = drive, longer = drive;
    shorter.insert(shorter.end(), {"--set", "run.duration=\"0.01 s\"", "--until", "0.01 s"});
    longer.insert(longer.end(), {"--set", "run.duration=\"10 s\"", "--until", "0.02 s", "--resume"});
    ASSERT_EQ(run("out", shorter).code, 0);
    const auto refused = run("out", longer);
    EXPECT_EQ(refused.code, 2);
    EXPECT_THAT(refused.errors, AllOf(HasSubstr(" was chosen for the run's first duration as "),
                                      HasSubstr("give the later end with --until")));
}

TEST_F(GoOn, NotToAnEndThatIsBehindIt) {
    ASSERT_EQ(run("out", {"--until", "0.02 s"}).code, 0);
    for (const std::string until : {"0.02 s", "0.01 s"}) {
        const auto refused = run("out", {"--until", until, "--resume"});
        EXPECT_EQ(refused.code, 2);
        EXPECT_THAT(refused.errors,
                    HasSubstr("it holds a run that is finished at t = 0.02 s, and is asked to end at " + until));
    }
    ASSERT_EQ(stopped_run("stopped").code, 143);
    const auto refused = run("stopped", {"--until", "0.01 s", "--resume"});
    EXPECT_EQ(refused.code, 2);
    EXPECT_THAT(refused.errors,
                AllOf(HasSubstr("the run has got to t = 0.0"), HasSubstr("and is asked to end at 0.01 s"),
                      HasSubstr("Resume it with a later --until")));
}

TEST_F(GoOn, ARunThatIsKilledAsItGoesOnIsNotTheFinishedOne) {
    ASSERT_EQ(run("out", {"--until", "0.02 s"}).code, 0);
    ASSERT_EQ(run("out", {"--resume"}, {.interrupt_at = "out/frames/fluid_000005.vtp", .signal = SIGKILL}).code, 137);
    const auto refused = run("out");
    EXPECT_THAT(refused.errors, HasSubstr("it holds this run, unfinished"));
    EXPECT_EQ(run("out", {"--resume"}).code, 0);
}

}  // namespace

}  // namespace dmp::tests::go_on_tests
