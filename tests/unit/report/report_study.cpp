// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// The page of a study, of what its folder holds.
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "base/errors.hpp"
#include "report/html.hpp"
#include "report/study_facts.hpp"
#include "report/study_files.hpp"
#include "report/study_page.hpp"
#include "report/study_table.hpp"
#include "report/write_report.hpp"
#include "tests/unit/report/run_folder.hpp"
#include "tests/unit/thrown.hpp"

namespace dmp::tests::report_study_tests {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::SizeIs;

/// A study of four runs, of which one failed, in which everything has a mark-up character in it.
class PageOfAStudy : public testing::Test {
  protected:
    PageOfAStudy() {
        make_folder(path());
        facts_.title = "Valves <script>alert('title')</script>";
        facts_.purpose = "Is a < b?";
        facts_.scene_file = "scene.toml";
        facts_.combination = "4 runs: each value with each.";
        facts_.runs = 4;
        facts_.keys = {{"particles.spacing", "mm", "0.1, 0.2", false}, {"quality", "", "draft, <fine>", false}};
        facts_.results = {{"gap", "maximum of <gap>"}, {"flux", "last of flux"}};
        facts_.plots = {{"Gap <b>", "gap", "particles.spacing", "quality", true, false, {{"a.csv", {0.1}, {1}, ""}}},
                        {"", "flux", "quality", "", false, false, {{"b.csv", {1}, {1}, "they are a <mass>"}}},
                        {"", "unknown", "quality", "", false, false, {}}};
        write("results.csv",
              "run,particles.spacing [mm],quality,gap [m],flux [m^3/s],exit_code,error\n"
              "0001_aaaaaaaa,0.1,draft,0.5,1e-6,0,\n0002_bbbbbbbb,0.1,<fine>,0.25,nan,0,\n"
              "0003_cccccccc,0.2,draft,0.125,2e-6,0,\n0004_dddddddd,0.2,<fine>,,,3,\"particle 12 <flew>, away\"\n");
        write("timing.csv",
              "run,wall_time [s],processor_time [s],peak_memory [B],exit_code\n0001_aaaaaaaa,10,8,1000000,0\n"
              "0002_bbbbbbbb,30,28,3000000,0\n0003_cccccccc,20,18,2000000,0\n");
        write("sweep.log",
              "2026-11-26 23:34:03 UTC  dmp 0.1.0\ndmp sweep '<valve>'\n\n"
              "2026-11-27 08:00:00 UTC  dmp 0.1.1\ndmp sweep valve --resume\n\n");
        write("study.toml", "title = \"</code><script>alert('study')</script>\"\n");
        write("scene.toml", "title = \"</code><script>alert('scene')</script>\"\n");
        write_facts();
    }

    void write(const std::string& name, const std::string& text) const {
        make_folder((path() / name).parent_path());
        write_file(path() / name, text);
    }
    void write_facts() const { write_study_facts(path(), facts_); }
    [[nodiscard]] std::filesystem::path path() const { return folder_.path() / "out"; }
    [[nodiscard]] StudyFiles read() const { return read_study_files(path()); }
    [[nodiscard]] std::string page() const { return study_page(read()); }
    [[nodiscard]] nlohmann::json data() const { return nlohmann::json::parse(study_data(read())); }
    [[nodiscard]] std::string error() const {
        return text_thrown<InputError>([&] { static_cast<void>(read()); });
    }

    StudyFacts facts_;

  private:
    TemporaryFolder folder_;
};

TEST_F(PageOfAStudy, ShowsEverythingFromFilesAsText) {
    EXPECT_THAT(page(), AllOf(HasSubstr("<h1>Valves &lt;script&gt;"), HasSubstr("Is a &lt; b?"),
                              HasSubstr("maximum of &lt;gap&gt;"), HasSubstr("Gap &lt;b&gt;"),
                              HasSubstr("they are a &lt;mass&gt;"), HasSubstr("particle 12 &lt;flew&gt;, away"),
                              HasSubstr("&#39;&lt;valve&gt;&#39;")));
    EXPECT_THAT(page(), AllOf(Not(HasSubstr("alert('")), Not(HasSubstr("<fine>")), HasSubstr("\\u003cfine>")));
}

TEST_F(PageOfAStudy, NeedsNoNetworkAndNoFile) {
    EXPECT_THAT(page(), HasSubstr("default-src 'none'"));
    for (const char* from : {"src=\"http", "href=\"http", "url(", "@import", "src=\"/", "<link", "<iframe"})
        EXPECT_THAT(page(), Not(HasSubstr(from)));
    EXPECT_THAT(page(), AllOf(HasSubstr("var uPlot="), HasSubstr("The MIT License")));
}

TEST_F(PageOfAStudy, SaysWhatWasStudiedAndWhatBecameOfIt) {
    const std::string text = page();
    EXPECT_THAT(text, HasSubstr("<p class=\"state interrupted\">Complete: 4 runs, 1 failed</p>"));
    EXPECT_THAT(text, HasSubstr("<dt>started</dt><dd>2026-11-26 23:34:03 UTC</dd>"));
    EXPECT_THAT(text, HasSubstr("<dt>resumed</dt><dd>2026-11-27 08:00:00 UTC</dd>"));
    EXPECT_THAT(text, HasSubstr("<dt>dmp version</dt><dd>0.1.1</dd>"));
    EXPECT_THAT(text, HasSubstr("<th scope=\"row\">particles.spacing [mm]</th><td>0.1, 0.2</td>"));
    EXPECT_THAT(text, HasSubstr("<th scope=\"row\">gap [m]</th><td>maximum of &lt;gap&gt;</td>"));
    EXPECT_THAT(text, HasSubstr("<dd>54 s of processor time, 60 s of wall time together</dd>"));
    EXPECT_THAT(text, HasSubstr("<dd>30 s (0002_bbbbbbbb)</dd>"));
    EXPECT_THAT(text, HasSubstr("<dd>3 MB</dd>"));
    EXPECT_THAT(text, HasSubstr("dmp sweep valve --resume"));
}

TEST_F(PageOfAStudy, OfAStudyThatWasStoppedSaysHowFarItCame) {
    facts_.runs = 10;
    write_facts();
    EXPECT_THAT(page(), HasSubstr("state interrupted\">Not complete: 4 of 10 runs ended, 1 failed"));
    facts_.title.clear();
    write_facts();
    EXPECT_THAT(page(), HasSubstr("<h1>out</h1>")) << "without a title the folder's name";
}

TEST_F(PageOfAStudy, HasTheTableAndThePlotsAsData) {
    const nlohmann::json found = data();
    EXPECT_EQ(found["runs"], (nlohmann::json{"0001_aaaaaaaa", "0002_bbbbbbbb", "0003_cccccccc", "0004_dddddddd"}));
    EXPECT_EQ(found["keys"][0]["values"], (nlohmann::json{"0.1", "0.1", "0.2", "0.2"}));
    EXPECT_EQ(found["keys"][1]["values"][1], "<fine>");
    EXPECT_EQ(found["results"][0]["unit"], "m");
    EXPECT_EQ(found["results"][0]["values"], (nlohmann::json{0.5, 0.25, 0.125, nullptr}));
    EXPECT_EQ(found["results"][1]["values"], (nlohmann::json{1e-6, nullptr, 2e-6, nullptr}));
    EXPECT_EQ(found["failures"], (nlohmann::json{{"3", {3, 0}}}));
    EXPECT_EQ(found["errors"], (nlohmann::json{"particle 12 <flew>, away"}));
    EXPECT_EQ(found["pages"], "0000");
    ASSERT_THAT(found["plots"], SizeIs(2)) << "none of a result that nobody knows";
    EXPECT_EQ(found["plots"][0]["result"], 0);
    EXPECT_EQ(found["plots"][0]["key"], 0);
    EXPECT_EQ(found["plots"][0]["lines_by"], 1);
    EXPECT_EQ(found["plots"][0]["log_x"], true);
    EXPECT_EQ(found["plots"][0]["reference"]["file"], "a.csv");
    EXPECT_EQ(found["plots"][1]["lines_by"], -1);
    EXPECT_FALSE(found["plots"][1].contains("reference")) << "of another quantity";
}

TEST_F(PageOfAStudy, LinksTheRunsThatHaveAPageAndShowsTheirPictures) {
    write("runs/0003_cccccccc/report.html", "page");
    write("runs/0001_aaaaaaaa/last_frame.png", png_file());
    write("runs/0003_cccccccc/last_frame.png", png_file());
    EXPECT_EQ(data()["pages"], "0010");
    const std::string text = page();
    EXPECT_THAT(text, HasSubstr("src=\"data:image/png;base64," + base64(png_file())));
    EXPECT_THAT(text, HasSubstr("<figcaption><a href=\"runs/0003_cccccccc/report.html\">0003_cccccccc</a>: "
                                "particles.spacing 0.2 mm, quality draft</figcaption>"));
    EXPECT_THAT(text, HasSubstr("<figcaption>0001_aaaaaaaa: "));
    EXPECT_THAT(text, Not(HasSubstr("evenly spaced")));
}

TEST_F(PageOfAStudy, LimitsThePicturesAndSaysHowManyAreLeftOut) {
    std::string table = "run,particles.spacing [mm],quality,gap [m],flux [m^3/s],exit_code,error\n";
    for (int k = 100; k < 140; ++k) {
        const std::string name = "0" + std::to_string(k) + "_aaaaaaaa";
        table += name + ",0.1,draft,0.5,1e-6,0,\n";
        write("runs/" + name + "/last_frame.png", png_file());
    }
    write("results.csv", table);
    EXPECT_THAT(read().pictures, SizeIs(most_run_pictures));
    EXPECT_EQ(read().pictures.front().row, 0U);
    EXPECT_EQ(read().pictures.back().row, 39U);
    EXPECT_THAT(page(), HasSubstr("24 of 40, evenly spaced: the pictures of 16 runs are left out"));
    for (int k = 100; k < 140; ++k)
        write("runs/0" + std::to_string(k) + "_aaaaaaaa/last_frame.png", png_file(7, 5, 400'000));
    EXPECT_THAT(read().pictures, SizeIs(4)) << "of 2 MB at most";
    EXPECT_THAT(page(), HasSubstr("the pictures of 36 runs are left out"));
    EXPECT_LT(page().size(), 5'000'000U);
    write("runs/0100_aaaaaaaa/last_frame.png", "none");
    EXPECT_THAT(read().notes, Contains("0100_aaaaaaaa/last_frame.png is not a whole PNG file"));
}

TEST_F(PageOfAStudy, FailuresThatDifferInNumbersOnlyStandTogether) {
    write("results.csv",
          "run,particles.spacing [mm],quality,gap [m],flux [m^3/s],exit_code,error\n"
          "a,0.1,draft,,,3,particle 12 left at 0.5 s\nb,0.1,draft,,,3,particle 7 left at 1e-3 s\n"
          "c,0.1,draft,,,2,no such file\n");
    EXPECT_THAT(page(), AllOf(HasSubstr("<dt>2 runs, exit code 3</dt><dd>particle 12 left at 0.5 s (of the first one; "
                                        "others with other numbers)<br>a, b</dd>"),
                              HasSubstr("<dt>1 run, exit code 2</dt><dd>no such file<br>c</dd>")));
}

TEST_F(PageOfAStudy, OfManyThousandRunsStaysSmall) {
    std::string table = "run,particles.spacing [mm],quality,gap [m],flux [m^3/s],exit_code,error\n";
    for (int k = 0; k < 9600; ++k) {
        const std::string number = std::to_string(10000 + k);
        table +=
            number + "_" + std::to_string(10000000 + k) + "," + std::to_string(0.001 * k) + ",draft," +
            std::to_string(1.234567891 / (k + 1)) + "," + std::to_string(std::sin(k)) +
            (k % 3 == 0 ? ",3,particle " + number + " has left the validity of its equations at step 12\n" : ",0,\n");
    }
    write("results.csv", table);
    EXPECT_THAT(rows_of_page(read()), SizeIs(9600)) << "all of them";
    EXPECT_LT(page().size(), 2'000'000U);
}

TEST_F(PageOfAStudy, OfFarTooManyRunsShowsSomeEvenlySpaced) {
    StudyFiles study = read();
    study.rows.resize(most_table_cells, study.rows.front());
    const std::vector<std::size_t> rows = rows_of_page(study);
    EXPECT_THAT(rows, SizeIs(most_table_cells / 6));
    EXPECT_EQ(rows.front(), 0U);
    EXPECT_EQ(rows.back(), study.rows.size() - 1);
    EXPECT_THAT(runs_section(study), HasSubstr("This page has 41666 of the 250000 runs, evenly spaced"));
}

TEST_F(PageOfAStudy, BeforeAnyRunHasEndedSaysSo) {
    for (const char* name : {"results.csv", "timing.csv", "sweep.log", "study.toml"})
        std::filesystem::remove(path() / name);
    EXPECT_THAT(page(), AllOf(HasSubstr("No run has ended yet."), HasSubstr("There is nothing to plot."),
                              HasSubstr("results.csv is not in the folder"), HasSubstr("Not complete: 0 of 4 runs"),
                              Not(HasSubstr("<script"))));
}

TEST_F(PageOfAStudy, DamageIsNamedWithItsPlace) {
    write("results.csv", "run,particles.spacing [mm],quality,gap [m],flux [m^3/s],exit_code,error\na,0.1,draft,0\n");
    EXPECT_THAT(error(), AllOf(HasSubstr("results.csv:2"), HasSubstr("found 4 values, expected 7")));
    write("results.csv", "run,quality,gap [m],flux [m^3/s],exit_code,error\na,draft,0,0,0,\n");
    EXPECT_THAT(error(), AllOf(HasSubstr("results.csv:1"), HasSubstr("no column 'particles.spacing'")));
    write("results.csv", "run,particles.spacing,quality,gap [m],flux [m^3/s],exit_code,error\na,1,draft,big,0,0,\n");
    EXPECT_THAT(error(), AllOf(HasSubstr("results.csv:2"), HasSubstr("'big' is not a number")));
    write("study.json", "{\"runs\": \"many\"}");
    EXPECT_THAT(error(), AllOf(HasSubstr("study.json"), HasSubstr("'runs' is not a number")));
    std::filesystem::remove(path() / "study.json");
    EXPECT_THAT(error(), AllOf(HasSubstr("there is no study.json in it"), HasSubstr("--resume")));
    EXPECT_THROW(write_study_report(path()), InputError);
}

TEST_F(PageOfAStudy, ANameThatLeadsElsewhereIsNoLink) {
    write("report.html", "page");
    write("results.csv",
          "run,particles.spacing [mm],quality,gap [m],flux [m^3/s],exit_code,error\n..,0.1,draft,0,0,0,\n");
    EXPECT_EQ(data()["pages"], "0");
}

TEST_F(PageOfAStudy, FactsAreReadAsTheyWereWritten) {
    const StudyFacts read = read_study_facts(path());
    EXPECT_EQ(read.title, facts_.title);
    EXPECT_EQ(read.runs, 4U);
    ASSERT_THAT(read.plots, SizeIs(3));
    EXPECT_THAT(read.plots[0].references[0].x, ElementsAre(0.1));
    EXPECT_EQ(read.plots[1].references[0].problem, "they are a <mass>");
    EXPECT_THAT(read.plots[2].references, IsEmpty());
}

}  // namespace
}  // namespace dmp::tests::report_study_tests
