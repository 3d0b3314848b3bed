// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// `dmp report` and the page at the end of a run.
#include <filesystem>

#include <gmock/gmock.h>

#include "tests/end_to_end/small_valve.hpp"

namespace dmp::tests::pages_tests {

namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::Not;

class Pages : public SmallValve {
  protected:
    [[nodiscard]] Outcome report(const std::string& folder, const Surroundings& with = {}) const {
        return run_dmp(folder_.path(), {"report", folder}, with);
    }
    [[nodiscard]] std::string page() const { return folder_.read("out/report.html"); }
    void remove(const std::string& name) const { fs::remove_all(folder_.path() / name); }
};

TEST_F(Pages, ARunLeavesItsPage) {
    folder_.replace("scene.toml", "title = \"", "title = \"<script>alert(1)</script> ");
    const Outcome outcome = run("out");
    ASSERT_EQ(outcome.code, 0) << outcome.errors;
    EXPECT_THAT(outcome.output, HasSubstr("out/report.html   the page of the run"));
    EXPECT_THAT(summary("out")["files"], Contains("report.html"));
    EXPECT_THAT(page(), AllOf(HasSubstr("<h1>&lt;script&gt;alert(1)&lt;/script&gt; "), Not(HasSubstr("<script>alert")),
                              HasSubstr("Complete: 0.1 s simulated"), HasSubstr("inlet_flux [m^3/s]"),
                              HasSubstr("<dt>sound speed</dt>"), HasSubstr("Models that ran"),
                              HasSubstr("EA lowered from"), HasSubstr("--until &#39;0.1 s&#39;")));
    EXPECT_LT(page().size(), 5'000'000U);
    EXPECT_GT(summary("out")["chosen"].size(), 5U);
}

TEST_F(Pages, TheSamePageIsWrittenAgainAlsoOnAMachineWithoutVtk) {
    ASSERT_EQ(run("out", {"--frames", "hdf5"}).code, 0);
    const std::string first = page();
    for (const bool for_clusters : {false, true}) {
        remove("out/report.html");
        const Outcome again = report("out", {.for_clusters = for_clusters});
        EXPECT_EQ(again.code, 0) << again.errors;
        EXPECT_EQ(again.output, "out/report.html\n");
        EXPECT_EQ(page(), first);
    }
}

TEST_F(Pages, WithoutVtkSaysWhyTheParticlesAreLeftOutOfParaViewFiles) {
    ASSERT_EQ(run("out").code, 0);
    EXPECT_THAT(page(), HasSubstr("id=\"particle-data\""));
    ASSERT_EQ(report("out", {.for_clusters = true}).code, 0);
    EXPECT_THAT(page(),
                AllOf(Not(HasSubstr("id=\"particle-data\"")),
                      HasSubstr("the frames are ParaView files, and this dmp was built for clusters, without VTK")));
}

TEST_F(Pages, AStoppedRunSaysSoUntilItIsComplete) {
    ASSERT_EQ(stopped_run("out").code, 128 + SIGTERM);
    EXPECT_THAT(page(), HasSubstr("Interrupted: stopped before its end"));
    ASSERT_EQ(run("out", {"--resume"}).code, 0);
    EXPECT_THAT(page(), AllOf(HasSubstr("Complete: 0.1 s simulated"), HasSubstr("<dt>resumed</dt>")));
}

TEST_F(Pages, AKilledRunGetsItsPageWhenAsked) {
    ASSERT_EQ(stopped_run("out", {}, 0, SIGKILL).code, 128 + SIGKILL);
    EXPECT_FALSE(fs::exists(folder_.path() / "out/report.html"));
    const Outcome outcome = report("out");
    EXPECT_EQ(outcome.code, 0) << outcome.errors;
    EXPECT_THAT(page(), AllOf(HasSubstr("Not complete: killed before its end, or it runs still; its measures end at"),
                              HasSubstr("inlet_flux [m^3/s]"), HasSubstr("What it said")));
    ASSERT_EQ(run("out", {"--overwrite"}).code, 0);
    EXPECT_THAT(page(), AllOf(HasSubstr("Complete: 0.1 s simulated"), Not(HasSubstr("killed before"))));
}

TEST_F(Pages, ARunThatDivergesLeavesAPageThatSaysWhy) {
    const Outcome outcome =
        run("out", {"--set", "flow.pressure_gradient=[\"-1056 Pa/m * sqrt(0.0151 - t / 1 s)\", 0]"});
    ASSERT_EQ(outcome.code, 3) << outcome.errors;
    EXPECT_THAT(outcome.output, HasSubstr("out/report.html   the page of the run"));
    EXPECT_THAT(page(), AllOf(HasSubstr("<p class=\"state failed\">Failed: ended by an error"),
                              HasSubstr("<pre class=\"error\">"), HasSubstr("The frames up to there are in out")));
    const std::string first = page();
    EXPECT_EQ(report("out").code, 0);
    EXPECT_EQ(page(), first);
}

TEST_F(Pages, APageThatCannotBeWrittenIsAWarning) {
    const auto take_its_name = [this] {
        if (fs::exists(folder_.path() / "out/frames/fluid_000003.vtp"))
            fs::create_directories(folder_.path() / "out/report.html/taken");
        return false;
    };
    const Outcome outcome = run("out", {}, {.interrupt_when = take_its_name});
    EXPECT_EQ(outcome.code, 0);
    EXPECT_THAT(outcome.errors, HasSubstr("warning: the run's page report.html was not written: "));
    EXPECT_THAT(summary("out")["files"], Not(Contains("report.html")));
}

TEST_F(Pages, WhatIsNoRunOrIsDamagedIsBadInput) {
    const auto expect = [this](const std::string& folder, const auto& text) {
        const Outcome outcome = report(folder);
        EXPECT_EQ(outcome.code, 2);
        EXPECT_THAT(outcome.errors, text);
    };
    expect("nowhere", AllOf(HasSubstr("nowhere"), HasSubstr("there is no such folder")));
    expect(".", HasSubstr("there is no summary.json in it, and no run.log"));
    ASSERT_EQ(run("out").code, 0);
    remove("out/report.html");
    folder_.replace("out/measures.csv", "\n0.01,", "\n0.01;");
    expect("out", HasSubstr("out/measures.csv:3"));
    folder_.replace("out/summary.json", "\"version\":", "\"version\"");
    expect("out", AllOf(HasSubstr("out/summary.json:3:"), HasSubstr("not valid JSON")));
    EXPECT_FALSE(fs::exists(folder_.path() / "out/report.html"));
}

}  // namespace

}  // namespace dmp::tests::pages_tests
