// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Runs that were stopped, and how they go on.
#include <filesystem>
#include <map>

#include <gmock/gmock.h>

#include "base/seal.hpp"
#include "solver/state/checkpoint_file.hpp"
#include "tests/end_to_end/small_valve.hpp"

namespace dmp::tests::resume_tests {

namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::SizeIs;

class Resume : public SmallValve {
  protected:
    /// A stopped run that leaves two checkpoints, by name.
    [[nodiscard]] Words two_checkpoints(const std::string& out) const {
        EXPECT_EQ(stopped_run(out, {"--checkpoint-every", "0.01 s"}).code, 143);
        return files(out + "/checkpoints");
    }
    void truncate(const std::string& file) const {
        std::filesystem::resize_file(folder_.path() / file, std::filesystem::file_size(folder_.path() / file) / 2);
    }
    void flip_a_bit(const std::string& file) const {
        std::string bytes = folder_.read(file);
        bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 4);
        folder_.write(file, bytes);
    }
};

TEST_F(Resume, GivesWhatAnUndisturbedRunGives) {
    const Words fields = all_fields();
    ASSERT_EQ(run("whole", fields).code, 0);
    const auto stopped = stopped_run("parts", fields);
    ASSERT_EQ(stopped.code, 143) << stopped.errors;
    EXPECT_THAT(stopped.output,
                AllOf(HasSubstr("Go on with the same command and --resume.\n  "), HasSubstr(" --resume\n")));
    EXPECT_LT(summary("parts")["simulated_s"], 0.1);
    EXPECT_THAT(files("parts/checkpoints"), SizeIs(1));

    Words again = fields;
    again.emplace_back("--resume");
    const auto resumed = run("parts", again);
    ASSERT_EQ(resumed.code, 0) << resumed.errors;
    EXPECT_THAT(resumed.output, HasSubstr("Going on in parts from step "));
    EXPECT_EQ(hash("parts"), hash("whole"));
    EXPECT_EQ(files("parts/frames"), files("whole/frames"));
    for (const auto& frame : files("whole/frames"))
        EXPECT_EQ(folder_.read("parts/frames/" + frame), folder_.read("whole/frames/" + frame)) << frame;
    for (const std::string file : {"fluid.pvd", "solid.pvd", "walls.vtp", "measures.csv", "scene.resolved.toml"})
        EXPECT_EQ(folder_.read("parts/" + file), folder_.read("whole/" + file)) << file;
}

TEST_F(Resume, MayUseOtherThreads) {
    ASSERT_EQ(run("whole").code, 0);
    ASSERT_EQ(stopped_run("parts").code, 143);
    ASSERT_EQ(run("parts", {"--resume", "--threads", "2", "--set", "run.threads=3"}).code, 0);
    EXPECT_EQ(hash("parts"), hash("whole"));
}

TEST_F(Resume, EverySignalThatEndsARunLeavesACheckpointAndWhichItWas) {
    ASSERT_EQ(run("whole").code, 0);
    const std::map<int, std::string> names{
        {SIGINT, "Ctrl-C"}, {SIGUSR1, "SIGUSR1"}, {SIGHUP, "SIGHUP"}, {SIGPIPE, "SIGPIPE"}};
    for (const auto& [signal, name] : names) {
        const auto stopped = stopped_run(name, {}, 0, signal);
        EXPECT_EQ(stopped.code, 128 + signal) << name;
        EXPECT_THAT(stopped.output, HasSubstr("Stopped before its end, by " + name + ". Go on with the same command"));
        EXPECT_THAT(files(name + "/checkpoints"), SizeIs(1));
        ASSERT_EQ(run(name, {"--resume"}).code, 0);
        EXPECT_EQ(hash(name), hash("whole")) << name;
    }
}

/// What counts is the particles that it gives: a remark in its file changes none.
TEST_F(Resume, WithAnotherGeometryIsRefused) {
    ASSERT_EQ(run("whole").code, 0);
    ASSERT_EQ(stopped_run("parts").code, 143);
    const std::string drawn = folder_.read("vein_valve.geo");
    folder_.replace("vein_valve.geo", "tip_gap        = {0.002, ", "tip_gap        = {0.0021,");
    const auto refused = run("parts", {"--resume"});
    EXPECT_EQ(refused.code, 2);
    EXPECT_THAT(refused.errors,
                AllOf(HasSubstr("parts/checkpoints/step_"),
                      HasSubstr("the particles of this run are others than those that this state belongs to: a file "
                                "of the geometry was changed"),
                      HasSubstr("Put the geometry back as it was")));
    EXPECT_EQ(run("other", {"--from", "parts"}).code, 2);
    folder_.write("vein_valve.geo", drawn + "\n// a remark\n");
    ASSERT_EQ(run("parts", {"--resume"}).code, 0);
    EXPECT_EQ(hash("parts"), hash("whole"));
}

TEST_F(Resume, WithOtherParticlesOfAFileIsRefused) {
    ASSERT_EQ(mesh("mesh", {"--particles", "made.h5"}).code, 0);
    ASSERT_EQ(stopped_run("parts", {"--particles", "made.h5"}).code, 143);
    folder_.replace("vein_valve.geo", "tip_gap        = {0.002, ", "tip_gap        = {0.0021,");
    ASSERT_EQ(mesh("mesh", {"--particles", "other.h5"}).code, 0);
    EXPECT_EQ(run("parts", {"--resume", "--particles", "other.h5"}).code, 2);
    EXPECT_EQ(run("parts", {"--resume", "--particles", "made.h5"}).code, 0);
}

TEST_F(Resume, SaysWhereTheCheckpointIsOfAnotherVersion) {
    ASSERT_EQ(stopped_run("parts").code, 143);
    const std::filesystem::path file = folder_.path() / "parts/checkpoints" / files("parts/checkpoints").front();
    const std::string now = DMP_PROJECT_VERSION, other = "0.0.7";
    ASSERT_EQ(solver::CheckpointReader(file).contents().text("dmp_version"), now);
    ASSERT_EQ(now.size(), other.size());
    const std::string name = "parts/checkpoints/" + file.filename().string();
    std::string bytes = folder_.read(name);
    for (auto at = bytes.find(now); at != std::string::npos; at = bytes.find(now, at)) bytes.replace(at, 5, other);
    folder_.write(name, bytes);
    seal(file, solver::checkpoint_kind, file);
    const auto resumed = run("parts", {"--resume"});
    ASSERT_EQ(resumed.code, 0) << resumed.errors;
    const std::string note =
        "The checkpoint is of dmp " + other + ", and this is dmp " + now + ": what follows may differ";
    EXPECT_THAT(resumed.output, HasSubstr(note));
    EXPECT_THAT(folder_.read("parts/run.log"), HasSubstr(note));
}

TEST_F(Resume, TheLogHasBothPartsOfARun) {
    ASSERT_EQ(stopped_run("out").code, 143);
    ASSERT_EQ(run("out", {"--resume"}).code, 0);
    EXPECT_THAT(folder_.read("out/run.log"),
                testing::ContainsRegex("^20[0-9-]+ [0-9:]+ UTC  dmp [^\n]+\n[^\n]*dmp run \\. .*\n\n"
                                       "(.*\n)*Writing to out\n(.*\n)*Interrupted: (.*\n)*"
                                       "Stopped before its end, by SIGTERM(.*\n)*Going on in out (.*\n)*Done: "));
    ASSERT_EQ(run("out", {"--until", "0.01 s", "--overwrite"}).code, 0);
    EXPECT_THAT(folder_.read("out/run.log"), Not(HasSubstr("SIGTERM"))) << "of the run that was replaced";
}

TEST_F(Resume, AStoppedRunLeavesItsPicturesToo) {
    const auto stopped = stopped_run("out", {"--set", "output.pictures=true"});
    ASSERT_EQ(stopped.code, 143);
    EXPECT_THAT(files("out"), testing::Contains("measures.png"));  // the others need a display, or Xvfb
    ASSERT_EQ(run("out", {"--set", "output.pictures=true", "--resume"}).code, 0);
}

TEST_F(Resume, AWallLimitEndsTheRunWithFiveAndACheckpointAfterAStepAtLeast) {
    const auto limited = run("out", {"--until", "100 s", "--wall-limit", "0.001 s"});
    EXPECT_EQ(limited.code, 5);
    EXPECT_THAT(limited.output, HasSubstr("Stopped before its end, out of its wall time. Go on with the same command "
                                          "and --resume."));
    EXPECT_THAT(files("out/checkpoints"), SizeIs(1));
    const long steps = summary("out")["steps"];
    EXPECT_EQ(run("out", {"--until", "100 s", "--wall-limit", "0.001 s", "--resume"}).code, 5);
    EXPECT_GT(summary("out")["steps"], steps);
}

TEST_F(Resume, RefusesAnotherSceneAndNamesTheLines) {
    ASSERT_EQ(stopped_run("out").code, 143);
    const auto before = files("out/frames");
    const auto refused = run("out", {"--resume", "--set", "part.blood.viscosity=\"4 mPa*s\""});
    EXPECT_EQ(refused.code, 2);
    EXPECT_THAT(refused.errors, AllOf(HasSubstr("the scene is not the one this run was started with"),
                                      HasSubstr("\n  part.blood.viscosity: was \"0.0035 "), HasSubstr(", is \"0.004 "),
                                      Not(HasSubstr("density"))));
    EXPECT_EQ(files("out/frames"), before) << "a refused run must change nothing";
}

TEST_F(Resume, WithoutACheckpointIsRefused) {
    const auto refused = run("out", {"--resume"});
    EXPECT_EQ(refused.code, 2);
    EXPECT_THAT(refused.errors, HasSubstr("there is no checkpoint in out"));
}

TEST_F(Resume, UsesTheCheckpointBeforeABrokenOneAndSaysSo) {
    ASSERT_EQ(run("whole").code, 0);
    const auto names = two_checkpoints("truncated");
    ASSERT_THAT(names, SizeIs(2));
    copy("truncated", "flipped");
    truncate("truncated/checkpoints/" + names[1]);
    flip_a_bit("flipped/checkpoints/" + names[1]);
    for (const std::string out : {"truncated", "flipped"}) {
        const auto resumed = run(out, {"--resume"});
        ASSERT_EQ(resumed.code, 0) << resumed.errors;
        EXPECT_THAT(resumed.output, AllOf(HasSubstr(names[1] + " is "), HasSubstr("; using the one before it, step ")));
        EXPECT_EQ(hash(out), hash("whole")) << out;
    }
}

TEST_F(Resume, WithBrokenCheckpointsOnlyIsRefused) {
    const auto names = two_checkpoints("out");
    ASSERT_THAT(names, SizeIs(2));
    flip_a_bit("out/checkpoints/" + names[0]);
    truncate("out/checkpoints/" + names[1]);
    const auto refused = run("out", {"--resume"});
    EXPECT_EQ(refused.code, 2);
    EXPECT_THAT(refused.errors,
                AllOf(HasSubstr("none of its checkpoints can be used"), HasSubstr(names[0]), HasSubstr(names[1])));
    EXPECT_EQ(files("out/checkpoints"), names) << "they may still be of use to somebody";
}

TEST_F(Resume, DoesNotTakeUpARunThatAnotherOneReplaced) {
    ASSERT_THAT(two_checkpoints("out"), SizeIs(2));
    const auto fresh = run("out", {"--until", "0.01 s", "--checkpoint-every", "0 s", "--overwrite"});
    ASSERT_EQ(fresh.code, 0) << fresh.errors;
    EXPECT_THAT(files("out/checkpoints"), SizeIs(1)) << "that of its end";
    const auto resumed = run("out", {"--resume", "--until", "0.02 s"});
    ASSERT_EQ(resumed.code, 0) << resumed.errors;
    EXPECT_THAT(resumed.output, HasSubstr(", t = 0.01 s"));
}

}  // namespace

}  // namespace dmp::tests::resume_tests
