// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// [[plot]]: what it may say, each mistake, and what is plotted without it.
#include <ostream>

#include <gmock/gmock.h>

#include "study/read_plot.hpp"
#include "study/values_taken.hpp"
#include "tests/modules.hpp"
#include "tests/unit/study/study_text.hpp"

namespace dmp::tests::study_plots_tests {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

constexpr const char* reference = "part.leaflets.bending_stiffness [mN*mm^2],opening [mm],note\n1000,2,a\n2000,2.5,b\n";

/// good_study with a [[plot]] at its end, from line 22 on.
std::string with_plot(const std::string& lines) { return good_study + "\n[[plot]]\n" + lines; }

const std::string good_plot =
    "result = \"opening\"\nkey = \"part.leaflets.bending_stiffness\"\nlines_by = \"particles.spacing\"\n";

struct PlotFault {
    const char* name;
    const char* lines;
    const char* table;
    const char* message;
};

void PrintTo(const PlotFault& fault, std::ostream* stream) { *stream << fault.name; }

class BadPlot : public testing::TestWithParam<PlotFault> {};

TEST_P(BadPlot, SaysWhereWhatAndWhatToDo) {
    EXPECT_EQ(study_fault(with_plot(GetParam().lines), GetParam().table), GetParam().message);
}

INSTANTIATE_TEST_SUITE_P(
    Study, BadPlot,
    testing::ValuesIn(std::vector<PlotFault>{
        {"no_result", "key = \"particles.spacing\"", "",
         "study.toml:23:1: missing key: plot.result\n"
         "  add 'result': a name of letters, digits and '_'"},
        {"unknown_result", "result = \"openin\"\nkey = \"particles.spacing\"", "",
         "study.toml:24:10: the study has no result 'openin'\n"
         "  did you mean 'opening'?"},
        {"unknown_word", "result = \"opening\"\nkey = \"particles.spacing\"\nline_by = \"x\"", "",
         "study.toml:26:1: unknown key 'line_by' in [[plot]]\n"
         "  did you mean 'lines_by'?"},
        {"key_that_does_not_vary", "result = \"opening\"\nkey = \"part.blood.viscosity\"", "",
         "study.toml:25:7: the study does not vary 'part.blood.viscosity'\n"
         "  it varies 'part.leaflets.bending_stiffness' and 'particles.spacing'"},
        {"misspelt_key", "result = \"opening\"\nkey = \"particles.spacin\"", "",
         "study.toml:25:7: the study does not vary 'particles.spacin'\n"
         "  did you mean 'particles.spacing'?"},
        {"lines_by_the_same_key", "result = \"opening\"\nkey = \"particles.spacing\"\nlines_by = \"particles.spacing\"",
         "",
         "study.toml:26:12: 'particles.spacing' is along x already\n"
         "  give another key for the lines, or leave 'lines_by' out"},
        {"unknown_axis", "result = \"opening\"\nkey = \"particles.spacing\"\nlog = [\"z\"]", "",
         "study.toml:26:8: plot.log: found \"z\", expected one of 'x' and 'y'\n"
         "  did you mean \"x\"?"},
        {"missing_reference", "result = \"opening\"\nkey = \"particles.spacing\"\nreference = \"no.csv\"", "",
         "study.toml:26:13: plot.reference: there is no file 'no.csv'\n"
         "  give a CSV file relative to the folder of the study"},
        {"reference_without_the_result", "result = \"opening\"\nkey = \"particles.spacing\"\nreference = \"table.csv\"",
         "particles.spacing [mm],gap [m]\n1,2\n",
         "table.csv:1:1: the table has no column 'opening', the plot's result\n"
         "  its columns are 'particles.spacing' and 'gap': write the heading as 'opening [UNIT]'"},
        {"reference_with_another_unit", "result = \"opening\"\nkey = \"particles.spacing\"\nreference = \"table.csv\"",
         "particles.spacing [mm],opening [kg]\n1,2\n",
         "table.csv:1:1: 'opening' is a mass here, expected a length\n"
         "  give it in m, or another unit of the same quantity"},
        {"reference_without_a_unit", "result = \"opening\"\nkey = \"particles.spacing\"\nreference = \"table.csv\"",
         "particles.spacing,opening [m]\n1,2\n",
         "table.csv:1:1: 'particles.spacing' is a number here, expected a length\n"
         "  give it in m, or another unit of the same quantity"},
        {"reference_that_is_no_number", "result = \"opening\"\nkey = \"particles.spacing\"\nreference = \"table.csv\"",
         "particles.spacing [mm],opening [m]\n1,2\n2,wide\n",
         "table.csv:3:1: expected a number in \"wide m\"\n"
         "  write a number and its unit, such as \"0.1 mm\""},
        {"reference_without_points", "result = \"opening\"\nkey = \"particles.spacing\"\nreference = \"table.csv\"",
         "particles.spacing [mm],opening [m]\n",
         "table.csv:1:1: the table has a heading only\n"
         "  write a line for each point below it"},
        {"reference_of_zero_on_a_logarithmic_axis",
         "result = \"opening\"\nkey = \"particles.spacing\"\nlog = [\"y\"]\nreference = \"table.csv\"",
         "particles.spacing [mm],opening [m]\n1,0\n",
         "table.csv:2:1: 'opening': 0 has no place on a logarithmic axis\n"
         "  remove the line, or the axis from the plot's 'log'"},
    }),
    [](const auto& tested) { return tested.param.name; });

TEST(BadPlots, OfOtherStudies) {
    const std::string study =
        "scene = \"scene.toml\"\n[[result]]\nname = \"a\"\nmeasure = \"tip_gap\"\nreduce = \"last\"\n";
    const auto plotted = [&](const std::string& key, const std::string& values, const std::string& more) {
        return study_fault(study + "[[vary]]\nkey = \"" + key + "\"\n" + values + "\n[[vary]]\nkey = \"quality\"\n" +
                           "values = [\"draft\", \"standard\"]\n[[plot]]\nresult = \"a\"\n" + more);
    };
    EXPECT_EQ(plotted("particles.disorder", "range = { from = 0, to = 0.4, steps = 3 }",
                      "key = \"particles.disorder\"\nlog = [\"x\"]"),
              "study.toml:15:7: 'particles.disorder' takes the value 0, which has no place on a logarithmic axis\n"
              "  remove \"x\" from 'log', or take a key with numbers above 0");
    EXPECT_EQ(plotted("particles.disorder", "values = [0.1]", "key = \"quality\"\nlog = [\"x\"]"),
              "study.toml:15:7: 'quality' takes the value draft, which has no place on a logarithmic axis\n"
              "  remove \"x\" from 'log', or take a key with numbers above 0");
    EXPECT_EQ(plotted("particles.disorder", "values = [0.1]", "key = \"particles.disorder\""),
              "study.toml:14:7: 'particles.disorder' has the same value in all runs\n"
              "  these vary: 'quality'");
    EXPECT_EQ(plotted("particles.disorder", "range = { from = 0, to = 0.4, steps = 13 }",
                      "key = \"quality\"\nlines_by = \"particles.disorder\""),
              "study.toml:15:12: 'particles.disorder' takes 13 values, and no more than 12 lines can be told apart\n"
              "  give a key with fewer values");
    EXPECT_EQ(plotted("particles.disorder", "values = [0.1]", "key = \"quality\"\nreference = \"table.csv\""),
              "study.toml:15:13: plot.reference: the values of 'quality' are no numbers\n"
              "  remove it: there is no place for its points");
    EXPECT_EQ(study_fault("scene = \"scene.toml\"\n[[vary]]\nkey = \"particles.disorder\"\nvalues = [0, 0.1]\n"
                          "[[plot]]\nresult = \"a\"\nkey = \"particles.disorder\"\n"),
              "study.toml:6:10: the study has no result 'a'\n"
              "  it has none at all: add [[result]]");
}

TEST(Plots, AreReadWithPointsInTheUnitsOfTheStudy) {
    const Study study =
        study_of(with_plot(good_plot + "title = \"Opening\"\nlog = [\"y\"]\nreference = \"table.csv\"\n"), reference);
    ASSERT_THAT(study.plots, SizeIs(1));
    const Plot& plot = study.plots.front();
    EXPECT_EQ(plot.title, "Opening");
    EXPECT_EQ(plot.lines_by, "particles.spacing");
    EXPECT_FALSE(plot.log_x);
    EXPECT_TRUE(plot.log_y);
    ASSERT_TRUE(plot.reference);
    EXPECT_THAT(plot.reference->x, ElementsAre(1e-6, 2e-6)) << "N*m^2, as the study gives the key";
    EXPECT_THAT(plot.reference->y, ElementsAre(0.002, 0.0025)) << "SI";
}

TEST(Plots, OverARangeOfEqualRatiosAreLogarithmicUnlessTheStudySaysOtherwise) {
    const std::string over = "result = \"opening\"\nkey = \"particles.spacing\"\n";
    EXPECT_TRUE(study_of(with_plot(over)).plots.front().log_x);
    EXPECT_FALSE(study_of(with_plot(over + "log = []\n")).plots.front().log_x);
}

TEST(Plots, DoNotMakeAnotherStudyOfIt) {
    EXPECT_EQ(identity_of(study_of(good_study)),
              identity_of(study_of("title = \"T\"\npurpose = \"P\"\n" + with_plot(good_plot))));
}

struct Expected {
    std::string result, key, lines_by;
    bool operator==(const Expected&) const = default;
};

std::vector<Expected> defaults_of(const std::string& text) {
    const Study study = study_of(text);
    std::vector<Expected> found;
    for (const Plot& plot : default_plots(study, Points(study)))
        found.push_back({plot.result, plot.key, plot.lines_by});
    return found;
}

TEST(DefaultPlots, AreOverTheKeyThatTakesMostValues) {
    EXPECT_THAT(defaults_of(good_study),
                ElementsAre(Expected{"opening", "particles.spacing", "part.leaflets.bending_stiffness"},
                            Expected{"reached", "particles.spacing", "part.leaflets.bending_stiffness"}));
}

TEST(DefaultPlots, PutSeedsNamesAndFormulasLast) {
    const std::string head =
        "scene = \"scene.toml\"\n[[result]]\nname = \"a\"\nmeasure = \"tip_gap\"\nreduce = \"last\"\n"
        "[[vary]]\nkey = \"particles.seed\"\nrange = { from = 1, to = 20, steps = 20 }\n";
    EXPECT_THAT(defaults_of(head), ElementsAre(Expected{"a", "particles.seed", ""}));
    EXPECT_THAT(defaults_of(head + "[[vary]]\nkey = \"particles.disorder\"\nvalues = [0, 0.1]\n"
                                   "[[vary]]\nkey = \"contact.range\"\nformula = \"1 + particles.disorder\"\n"),
                ElementsAre(Expected{"a", "particles.disorder", ""}));
    EXPECT_THAT(defaults_of(head + "[[vary]]\nkey = \"quality\"\nvalues = [\"draft\", \"standard\", \"fine\"]\n"
                                   "[[vary]]\nkey = \"particles.disorder\"\nvalues = [0, 0.1]\n"),
                ElementsAre(Expected{"a", "particles.disorder", "quality"}));
}

TEST(DefaultPlots, OfALatinHypercubeAreOverEachKeyAndOfAZipOverTheFirst) {
    const std::string keys =
        "scene = \"scene.toml\"\n[[result]]\nname = \"a\"\nmeasure = \"tip_gap\"\nreduce = \"last\"\n"
        "[[vary]]\nkey = \"particles.spacing\"\nVALUES1\n[[vary]]\nkey = \"particles.disorder\"\nVALUES2\n";
    const auto filled = [&](const std::string& first, const std::string& second) {
        std::string text = keys;
        text.replace(text.find("VALUES1"), 7, first);
        return text.replace(text.find("VALUES2"), 7, second);
    };
    EXPECT_THAT(defaults_of("combine = \"latin_hypercube\"\nsamples = 30\n" +
                            filled("range = { from = \"0.1 mm\", to = \"1 mm\" }", "range = { from = 0, to = 0.1 }")),
                ElementsAre(Expected{"a", "particles.spacing", ""}, Expected{"a", "particles.disorder", ""}));
    EXPECT_THAT(defaults_of("combine = \"zip\"\n" + filled("values = [\"0.1 mm\", \"0.2 mm\"]", "values = [0, 0.1]")),
                ElementsAre(Expected{"a", "particles.spacing", ""}));
}

TEST(DefaultPlots, AreNoneWithoutResults) {
    EXPECT_THAT(defaults_of("scene = \"scene.toml\"\n[[vary]]\nkey = \"particles.disorder\"\nvalues = [0, 0.1]\n"),
                IsEmpty());
}

TEST(ValuesTakenByFormulas, AreThoseOfTheRuns) {
    const Study study = study_of(
        "scene = \"scene.toml\"\n[[vary]]\nkey = \"particles.disorder\"\nvalues = [0, 0.1, 0.2]\n"
        "[[vary]]\nkey = \"contact.range\"\nformula = \"1 + 2 * particles.disorder\"\n");
    const std::vector<ValuesTaken> taken = values_taken(study, Points(study));
    ASSERT_THAT(taken, SizeIs(2));
    EXPECT_EQ(taken[1].count, 3U);
    EXPECT_TRUE(taken[1].is_formula);
    EXPECT_EQ(taken[1].values[2].cell, "1.4");
}

}  // namespace
}  // namespace dmp::tests::study_plots_tests
