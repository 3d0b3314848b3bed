// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/errors.hpp"
#include "report/html.hpp"
#include "report/run_page.hpp"
#include "report/write_report.hpp"
#include "tests/unit/report/run_folder.hpp"
#include "tests/unit/thrown.hpp"

namespace dmp::tests::report_run_page_tests {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

class RunPage : public testing::Test {
  protected:
    [[nodiscard]] std::string page() const { return run_page(folder_.read()); }
    RunFolder folder_;
};

TEST_F(RunPage, ShowsEverythingFromFilesAsText) {
    const std::string text = page();
    EXPECT_THAT(text, AllOf(HasSubstr("<h1>Valve &lt;script&gt;alert(&#39;title&#39;)&lt;/script&gt;</h1>"),
                            HasSubstr("<title>Valve &lt;script&gt;"), HasSubstr("EA &lt;lowered&gt;"),
                            HasSubstr("at 0.1 s: too &lt;fast&gt;"), HasSubstr("too &lt;fast&gt; at the end"),
                            HasSubstr("a=&lt;b&gt;"), HasSubstr("extrapolated &lt;numerics.walls&gt;"),
                            HasSubstr("a &lt; b"), HasSubstr("&lt;/code&gt;&lt;script&gt;")));
    EXPECT_THAT(text, Not(HasSubstr("alert('")));
}

TEST_F(RunPage, NeedsNoNetworkAndNoFile) {
    const std::string text = page();
    EXPECT_THAT(text, HasSubstr("default-src 'none'"));
    for (const char* from : {"src=\"http", "href=\"http", "url(", "@import", "src=\"/", "<link", "<iframe"})
        EXPECT_THAT(text, Not(HasSubstr(from)));
    EXPECT_THAT(text, HasSubstr("src=\"data:image/png;base64," + base64(png_file()) + "\" width=\"7\" height=\"5\""));
    EXPECT_THAT(text, AllOf(HasSubstr("var uPlot="), HasSubstr("The MIT License"))) << "with the licence it asks for";
}

TEST_F(RunPage, SaysWhatRanAndWhatItConserved) {
    const std::string text = page();
    EXPECT_THAT(text, HasSubstr("<p class=\"state complete\">Complete: 0.5 s simulated</p>"));
    EXPECT_THAT(text, HasSubstr("<dt>started</dt><dd>2026-11-26 23:34:03 UTC</dd>"));
    EXPECT_THAT(text, HasSubstr("<dt>resumed</dt><dd>2026-11-27 08:00:00 UTC</dd>"));
    EXPECT_THAT(text, HasSubstr("100 fluid, 8 elastic"));
    EXPECT_THAT(text, HasSubstr("<dt>walls</dt><dd>extrapolated &lt;numerics.walls&gt;</dd>\n<dd>and more</dd>"));
    EXPECT_THAT(text, HasSubstr("<th scope=\"row\">Tait</th><td>default</td><td>Tait (1888)</td>"));
    EXPECT_THAT(text, HasSubstr("<th scope=\"row\">impulse of body forces</th><td class=\"number\">2.5</td>"));
    EXPECT_THAT(text, HasSubstr("1e-15 of the sum of the impulses' magnitudes"));
    EXPECT_THAT(text, HasSubstr("<th scope=\"row\">drug [mol]</th><td class=\"number\">4</td>"));
    EXPECT_THAT(text, HasSubstr("<td class=\"number\">0.875</td>")) << "the sum of the energies at the end";
    EXPECT_THAT(text, HasSubstr("<th scope=\"row\">forces</th><td class=\"number\">7</td><td "
                                "class=\"number\">70.0</td></tr>\n<tr><th scope=\"row\">kick</th>"));
    EXPECT_THAT(text, HasSubstr("<th scope=\"row\">everything else</th><td class=\"number\">1</td>"));
    EXPECT_THAT(text, HasSubstr("<dd>400, ruled by sound</dd>"));
    EXPECT_THAT(text, HasSubstr("<dd>fedcba9876543210</dd>"));
}

TEST_F(RunPage, OfAnInterruptedRunSaysSo) {
    folder_.write("summary.json", R"({"title": "", "interrupted": true, "simulated_s": 0.25})");
    const std::string text = page();
    EXPECT_THAT(text, HasSubstr("state interrupted\">Interrupted: stopped before its end, at 0.25 s simulated"));
    EXPECT_THAT(text, HasSubstr("<h1>out</h1>")) << "without a title the folder's name";
    EXPECT_THAT(text, HasSubstr("Not kept in summary.json"));
}

TEST_F(RunPage, OfAKilledRunSaysSoAndWhatItHasMeasured) {
    folder_.remove("summary.json");
    const std::string text = page();
    EXPECT_THAT(text,
                HasSubstr("<p class=\"state interrupted\">Not complete: killed before its end, or it runs still; its "
                          "measures end at 0.5 s</p>"));
    EXPECT_THAT(text, AllOf(HasSubstr("with --resume goes on from it"), HasSubstr("flux [m^3/s]"),
                            HasSubstr("What it said"), HasSubstr("warning at 0.1 s: too &lt;fast&gt;"),
                            HasSubstr("<dt>dmp version</dt><dd>0.1.1</dd>"), Not(HasSubstr("What was conserved"))));
}

TEST_F(RunPage, OfARunThatDivergedSaysWhy) {
    folder_.remove("summary.json");
    folder_.write(
        "run.log",
        "2026-11-26 23:34:03 UTC  dmp 0.1.0\ndmp run valve\n\nerror: particle 12 <flew> away\n  Look at it.\n");
    EXPECT_THAT(page(),
                AllOf(HasSubstr("<p class=\"state failed\">Failed: ended by an error; its measures end at 0.5 s"),
                      HasSubstr("<pre class=\"error\">particle 12 &lt;flew&gt; away\nLook at it.</pre>")));
}

TEST_F(RunPage, WithoutMeasuresNeedsNoScript) {
    folder_.remove("measures.csv");
    folder_.remove("fluid.pvd");
    const std::string text = page();
    EXPECT_THAT(text, Not(HasSubstr("<script")));
    EXPECT_THAT(text, HasSubstr("No frames are there of which particles could be shown."));
    EXPECT_THAT(text, HasSubstr("measures.csv is not in the folder"));
}

TEST_F(RunPage, ShowsParticlesWithoutMeasures) {
    EXPECT_THAT(page(), AllOf(HasSubstr("id=\"particle-data\">{\"flat\":true"),
                              HasSubstr("All 2 frames are shown with all their particles."), HasSubstr("var THREE="),
                              HasSubstr("Copyright © 2010-2026 three.js authors")));
    folder_.remove("measures.csv");
    EXPECT_THAT(page(), AllOf(HasSubstr("particle-data"), HasSubstr("var THREE="), Not(HasSubstr("var uPlot=")),
                              Not(HasSubstr("page-data"))));
}

TEST_F(RunPage, SaysHowManyParticlesAreShown) {
    RunFiles run = folder_.read();
    run.particles.frames_of_run = 300;
    run.particles.groups[0].every = 12;
    EXPECT_THAT(run_page(run),
                HasSubstr("2 of the 300 frames are shown; of fluid every 12th particle, the same ones in all frames."));
}

TEST_F(RunPage, AValueOfAnotherTypeIsAnError) {
    folder_.write("summary.json", R"({"conserved": {"start": {"mass": "heavy"}}})");
    EXPECT_THAT(text_thrown<InputError>([&] { static_cast<void>(page()); }),
                AllOf(HasSubstr("summary.json"), HasSubstr("'conserved.start.mass' is not a number")));
    EXPECT_THROW(write_run_report(folder_.path(), RunFolder::made_frames), InputError);
    EXPECT_FALSE(std::filesystem::exists(folder_.path() / report_file_name));
}

TEST_F(RunPage, IsWrittenBesideTheRun) {
    write_run_report(folder_.path(), RunFolder::made_frames);
    EXPECT_EQ(read_file(folder_.path() / "report.html"), page());
}

}  // namespace
}  // namespace dmp::tests::report_run_page_tests
