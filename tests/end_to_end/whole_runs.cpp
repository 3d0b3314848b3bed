// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// From a scene to files, through the command a user types.
#include <filesystem>
#include <sstream>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "tests/end_to_end/program.hpp"

namespace dmp::tests::whole_runs_tests {

namespace {

using testing::HasSubstr;

class Poiseuille : public testing::Test {
  protected:
    Poiseuille() { folder_.copy_case("verification/poiseuille"); }

    [[nodiscard]] Outcome dmp(const std::vector<std::string>& arguments, const Surroundings& surroundings = {}) const {
        return run_dmp(folder_.path(), arguments, surroundings);
    }
    [[nodiscard]] bool has(const std::string& file) const { return std::filesystem::exists(folder_.path() / file); }
    [[nodiscard]] nlohmann::json summary(const std::string& folder) const {
        return nlohmann::json::parse(folder_.read(folder + "/summary.json"));
    }

    CaseFolder folder_;
};

TEST_F(Poiseuille, RunLeavesFramesMeasuresSummaryAndPictures) {
    const auto outcome = dmp({"run", ".", "--out", "out", "--threads", "1"});
    ASSERT_EQ(outcome.code, 0) << outcome.errors;
    EXPECT_EQ(outcome.errors, "") << "a run off a terminal is quiet";
    EXPECT_THAT(outcome.output, testing::AllOf(HasSubstr("sound speed"), HasSubstr("time step"), HasSubstr("ruled by"),
                                               HasSubstr("Done: 1 s simulated"), HasSubstr("Results in out")));
    for (const char* file : {"fluid.pvd", "walls.vtp", "measures.csv", "summary.json", "scene.resolved.toml",
                             "last_frame.png", "cycle.png", "measures.png", "frames/fluid_000010.vtp"}) {
        EXPECT_TRUE(has(std::string("out/") + file)) << file;
    }
}

TEST_F(Poiseuille, SummaryHoldsWhatScriptsWant) {
    ASSERT_EQ(
        dmp({"run", ".", "--out", "out", "--threads", "1", "--until", "0.1 s", "--set", "output.pictures=false"}).code,
        0);
    const auto summary = this->summary("out");
    for (const char* key : {"particles", "steps", "simulated_s", "wall_s", "particle_steps_per_s", "threads", "ranks",
                            "dt_limits", "ruling_limit", "conserved", "lost", "measures", "state_hash"}) {
        EXPECT_TRUE(summary.contains(key)) << key;
    }
    EXPECT_NEAR(summary["simulated_s"].get<double>(), 0.1, 1e-9);
    EXPECT_EQ(summary["lost"], 0);
    EXPECT_EQ(summary["threads"], 1);
}

TEST_F(Poiseuille, TheVelocityIsThatOfTheStartUpSeries) {
    ASSERT_EQ(dmp({"run", ".", "--out", "out", "--threads", "1", "--set", "output.pictures=false"}).code, 0);
    // Centre velocity after 1 s, steady to 4 digits: -dp/dx h^2 / (8 mu) with h = 1 mm, dp/dx = -0.1 Pa/m, mu = 1 mPa
    // s.
    std::istringstream lines(folder_.read("out/measures.csv"));
    std::string line;
    std::string last;
    while (std::getline(lines, line)) last = line;
    const double velocity = std::stod(last.substr(last.find(',') + 1));
    EXPECT_NEAR(velocity, 1.25e-5, 0.03 * 1.25e-5);
}

TEST_F(Poiseuille, TheSameRunAgainGivesTheSameStateAndReplacesTheFirst) {
    std::vector<std::string> run{"run", ".",       "--out",  "out",   "--threads",
                                 "1",   "--until", "0.05 s", "--set", "output.pictures=false"};
    ASSERT_EQ(dmp(run).code, 0);
    run.emplace_back("--overwrite");
    const auto first = summary("out")["state_hash"];
    const auto again = dmp(run);
    ASSERT_EQ(again.code, 0);
    EXPECT_THAT(again.output, HasSubstr("of an earlier run"));
    EXPECT_EQ(summary("out")["state_hash"], first);
}

TEST_F(Poiseuille, TwoThreadsGiveTheSameBitsAsOne) {
    const std::vector<std::string> rest{"--until", "0.05 s", "--set", "output.pictures=false"};
    for (const char* threads : {"1", "2"}) {
        std::vector<std::string> run{"run", ".", "--out", std::string("out") + threads, "--threads", threads};
        run.insert(run.end(), rest.begin(), rest.end());
        ASSERT_EQ(dmp(run).code, 0);
    }
    EXPECT_EQ(summary("out1")["state_hash"], summary("out2")["state_hash"]);
}

TEST_F(Poiseuille, TheNarrowestVectorUnitGivesTheSameBitsAsTheWidest) {
    if (dmp({"doctor"}).output.find("avx2") == std::string::npos) GTEST_SKIP() << "no x86 processor";
    const std::vector<std::string> rest{"--until", "0.05 s", "--threads", "1", "--set", "output.pictures=false"};
    std::vector<std::string> widest{"run", ".", "--out", "widest"};
    std::vector<std::string> narrowest{"run", ".", "--out", "narrowest", "--vector-unit", "avx2"};
    for (auto* run : {&widest, &narrowest}) {
        run->insert(run->end(), rest.begin(), rest.end());
        ASSERT_EQ(dmp(*run).code, 0);
    }
    EXPECT_EQ(summary("widest")["state_hash"], summary("narrowest")["state_hash"]);
}

TEST_F(Poiseuille, TheResolvedSceneRunsAsItStandsToTheSameState) {
    ASSERT_EQ(
        dmp({"run", ".", "--out", "out", "--threads", "1", "--until", "0.0217 s", "--set", "output.pictures=false"})
            .code,
        0);
    const auto outcome = dmp({"run", "out/scene.resolved.toml", "--out", "out2", "--threads", "1"});
    ASSERT_EQ(outcome.code, 0) << outcome.errors;
    EXPECT_EQ(summary("out2")["simulated_s"], 0.0217);
    EXPECT_EQ(summary("out")["state_hash"], summary("out2")["state_hash"]);
}

TEST_F(Poiseuille, PicturesAreDrawnAgain) {
    ASSERT_EQ(
        dmp({"run", ".", "--out", "out", "--threads", "1", "--until", "0.2 s", "--set", "output.pictures=false"}).code,
        0);
    EXPECT_FALSE(has("out/measures.png"));
    const auto drawn = dmp({"pictures", "out", "--film", "--set", "output.picture_field=pressure"});
    ASSERT_EQ(drawn.code, 0) << drawn.errors;
    EXPECT_THAT(drawn.output, HasSubstr("out/measures.png\n"));
    EXPECT_TRUE(has("out/measures.png"));
    EXPECT_EQ(has("out/film.png"), has("out/last_frame.png")) << "both need a display, or Xvfb";
    const auto refused = dmp({"pictures", "."});
    EXPECT_EQ(refused.code, 2);
    EXPECT_THAT(refused.errors, HasSubstr("there is no run here: it has no scene.resolved.toml"));
}

TEST_F(Poiseuille, WithoutOutTheFolderCarriesTheScenesName) {
    folder_.write("my_channel.toml", folder_.read("scene.toml"));
    const auto outcome =
        dmp({"run", "my_channel.toml", "--threads", "1", "--until", "0.01 s", "--set", "output.pictures=false"});
    ASSERT_EQ(outcome.code, 0) << outcome.errors;
    EXPECT_TRUE(has("out/my_channel/summary.json"));
}

TEST_F(Poiseuille, FramesThatRuleTheStepsAreWarnedOf) {
    const auto outcome =
        dmp({"run", ".", "--dry-run", "--threads", "1", "--until", "0.1 ms", "--set", "output.every=\"1 us\""});
    ASSERT_EQ(outcome.code, 0) << outcome.errors;
    EXPECT_THAT(outcome.errors, HasSubstr("output.every is shorter than the time step, "));
}

TEST_F(Poiseuille, WhatATitleHoldsDoesNotReachTheTerminal) {
    const auto outcome =
        dmp({"run", ".", "--dry-run", "--threads", "1", "--set", R"(title="a\u001b[2Jb\u0007\u009b2J")"});
    ASSERT_EQ(outcome.code, 0) << outcome.errors;
    EXPECT_THAT(outcome.output, HasSubstr("a\\x1b[2Jb\\x07\\xc2\\x9b2J\n"));
    EXPECT_EQ(outcome.output.find_first_of("\033\007"), std::string::npos);
}

#ifndef __SANITIZE_ADDRESS__  // which takes terabytes of addresses for itself
TEST_F(Poiseuille, WhereMemoryIsTooLittleForPicturesTheRestIsThere) {
    const auto outcome = dmp({"run", ".", "--out", "out", "--threads", "1", "--until", "0.01 s"},
                             {.environment = {"DISPLAY="}, .most_memory = 900L << 20});
    ASSERT_EQ(outcome.code, 0) << outcome.errors;
    EXPECT_THAT(outcome.errors, HasSubstr("no pictures of the frames: rendering may take 1 GiB of memory"));
    EXPECT_TRUE(has("out/fluid.pvd"));
    EXPECT_FALSE(has("out/last_frame.png"));
}
#endif

TEST_F(Poiseuille, AnInterruptedRunWritesWhatThereIs) {
    const auto outcome = dmp({"run", ".", "--out", "out", "--threads", "1", "--set", "run.duration=\"10000 s\""},
                             {.interrupt_at = "out/frames/fluid_000001.vtp"});
    EXPECT_EQ(outcome.code, 130);
    EXPECT_THAT(outcome.output, HasSubstr("Interrupted: "));
    EXPECT_TRUE(has("out/fluid.pvd"));
    EXPECT_TRUE(has("out/measures.csv"));
    EXPECT_LT(summary("out")["simulated_s"].get<double>(), 10000);
}

TEST_F(Poiseuille, ARunThatDivergesEndsWithThreeAndLeavesTheFramesUpToThere) {
    const auto outcome =
        dmp({"run", ".", "--out", "out", "--threads", "1", "--set", "flow.pressure_gradient=[\"-10 kPa/m\", 0]"});
    EXPECT_EQ(outcome.code, 3) << outcome.output;
    EXPECT_THAT(outcome.errors, testing::AllOf(testing::StartsWith("error: "), HasSubstr("diverged"),
                                               HasSubstr("particle"), HasSubstr("is below what the drive produces"),
                                               HasSubstr("The frames up to there are in out")));
    EXPECT_TRUE(has("out/fluid.pvd"));
    EXPECT_FALSE(has("out/summary.json"));
}

TEST_F(Poiseuille, DryRunWritesNothing) {
    const auto outcome = dmp({"run", ".", "--dry-run", "--threads", "1"});
    ASSERT_EQ(outcome.code, 0) << outcome.errors;
    EXPECT_THAT(outcome.output,
                testing::AllOf(HasSubstr("160 particles"), HasSubstr("memory"), HasSubstr("viscosity"),
                               HasSubstr("<- rules"), HasSubstr("of computing"), HasSubstr("Nothing was written")));
    EXPECT_FALSE(has("out"));
}

TEST_F(Poiseuille, MeshLeavesParticlesToLookAt) {
    const auto outcome = dmp({"mesh", ".", "--out", "particles"});
    ASSERT_EQ(outcome.code, 0) << outcome.errors;
    EXPECT_THAT(outcome.output, testing::AllOf(HasSubstr("water"), HasSubstr("wall"), HasSubstr("160")));
    EXPECT_TRUE(has("particles/fluid.pvd"));
    EXPECT_TRUE(has("particles/walls.vtp"));
    const auto report = nlohmann::json::parse(folder_.read("particles/mesh_report.json"));
    EXPECT_EQ(report["leak_test"]["tight"], true);
    EXPECT_NEAR(report["surfaces"][0]["from_particles"]["rms"].get<double>(), 0, 1e-9);
}

TEST_F(Poiseuille, ExplainNamesModelsSourcesFieldsAndLimits) {
    const auto outcome = dmp({"explain", "."});
    ASSERT_EQ(outcome.code, 0) << outcome.errors;
    EXPECT_THAT(outcome.output,
                testing::AllOf(HasSubstr("Models"), HasSubstr("Morris"), HasSubstr("why"), HasSubstr("source"),
                               HasSubstr("Largest time steps"), HasSubstr("Margins of what sets the steps"),
                               HasSubstr("Fields that several models need"), HasSubstr(" B a particle")));
    EXPECT_THAT(outcome.output, testing::AllOf(HasSubstr("fields  fluid: shift, 16 bytes"), HasSubstr("Measured\n"),
                                               HasSubstr("whole step"), HasSubstr(" ns a particle and step"),
                                               HasSubstr("quality      standard (quality, default)"),
                                               HasSubstr("rows wall    3 (part.wall.layers, ")));
    EXPECT_THAT(outcome.output, testing::Not(HasSubstr("Warnings")));
}

TEST_F(Poiseuille, ExplainMeasuresNothingWhenToldSo) {
    const auto outcome = dmp({"explain", ".", "--no-measure"});
    ASSERT_EQ(outcome.code, 0) << outcome.errors;
    EXPECT_THAT(outcome.output, testing::AllOf(HasSubstr("Models"), testing::Not(HasSubstr("Measured"))));
}

TEST_F(Poiseuille, ExplainAndRunWarnOfWhatHasNoEffect) {
    const std::string problem =
        "--set numerics.spring_stepping=subcycled: numerics.spring_stepping has no effect: no part is elastic; leave "
        "it "
        "out\n";
    const auto explained = dmp({"explain", ".", "--no-measure", "--set", "numerics.spring_stepping=subcycled"});
    EXPECT_THAT(explained.output, HasSubstr("Warnings\n  " + problem));
    const auto outcome = dmp({"run", ".", "--until", "0.01 s", "--out", "warned", "--set", "output.pictures=false",
                              "--set", "numerics.spring_stepping=subcycled"});
    EXPECT_EQ(outcome.code, 0);
    EXPECT_EQ(outcome.errors, "warning: " + problem);
}

TEST_F(Poiseuille, ExplainSaysWhatTheQualityHasChosen) {
    const auto outcome =
        dmp({"explain", ".", "--no-measure", "--set", "quality=draft", "--set", "numerics.scheme=plain"});
    ASSERT_EQ(outcome.code, 0) << outcome.errors;
    EXPECT_THAT(outcome.output, testing::AllOf(HasSubstr("draft (quality, --set quality=draft)"),
                                               HasSubstr("lucy (numerics.kernel, numerics.scheme = \"plain\" at --set "
                                                         "numerics.scheme=plain, quality = \"draft\" at "
                                                         "--set quality=draft)")));
}

TEST(BentChannel, ADifferentDrawingNeedsNoNewCode) {
    const CaseFolder folder;
    folder.copy_case("bent_channel");
    const auto outcome = run_dmp(folder.path(), {"mesh", ".", "--out", "particles"});
    ASSERT_EQ(outcome.code, 0) << outcome.errors;
    EXPECT_TRUE(std::filesystem::exists(folder.path() / "particles/solid.pvd"));
}

TEST(Carrier, ShedsItsDrugOnAWallAndLeavesSpheresToLookAt) {
    const CaseFolder folder;
    folder.copy_case("carrier");
    const auto outcome = run_dmp(folder.path(), {"run", ".", "--out", "out", "--until", "2 us"});
    ASSERT_EQ(outcome.code, 0) << outcome.errors;
    EXPECT_THAT(outcome.output, testing::AllOf(HasSubstr("883 spheres"), HasSubstr("adhesion bradley")));
    for (const char* file : {"spheres.pvd", "walls.vtp", "measures.csv", "cycle.png", "frames/spheres_000004.vtp"})
        EXPECT_TRUE(std::filesystem::exists(folder.path() / "out" / file)) << file;
    const auto summary = nlohmann::json::parse(folder.read("out/summary.json"));
    EXPECT_EQ(summary["particles"]["spheres"], 883);
    EXPECT_EQ(summary["lost"], 0);
    const auto on_two =
        run_dmp(folder.path(),
                {"run", ".", "--out", "two", "--until", "2 us", "--threads", "1", "--set", "output.pictures=false"},
                {.ranks = 2});
    ASSERT_EQ(on_two.code, 0) << on_two.errors;
    EXPECT_EQ(nlohmann::json::parse(folder.read("two/summary.json"))["state_hash"], summary["state_hash"]);
}

TEST(Clotting, OfAllLiquidLeavesNoDensityToTell) {
    CaseFolder folder;
    folder.copy_case("verification/chain");
    const auto outcome = run_dmp(folder.path(), {"run", ".", "--out", "out", "--until", "0.1 s", "--set",
                                                 "output.pictures=false", "--set", "solidify.chain.reach=\"20 mm\""});
    ASSERT_EQ(outcome.code, 0) << outcome.errors;
    EXPECT_THAT(outcome.output, HasSubstr("of no fluid: all of it turned solid"));
}

}  // namespace

}  // namespace dmp::tests::whole_runs_tests
