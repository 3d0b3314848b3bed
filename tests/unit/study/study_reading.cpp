// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include "study/read_result.hpp"
#include "study/varied_value.hpp"
#include "tests/modules.hpp"
#include "tests/unit/study/study_text.hpp"

namespace dmp::tests::study_reading_tests {
namespace {

using testing::ElementsAre;
using testing::SizeIs;

std::vector<std::string> cells(const Vary& vary) {
    std::vector<std::string> all;
    for (const auto& row : vary.rows) all.push_back(row.front().cell);
    return all;
}

std::vector<std::string> texts(const Vary& vary) {
    std::vector<std::string> all;
    for (const auto& row : vary.rows) all.push_back(row.front().toml);
    return all;
}

TEST(ReadStudy, ReadsWhatStandsThereWithItsPlace) {
    const Study study = study_of(good_study);
    EXPECT_EQ(study.name, "dmp_ReadStudy_ReadsWhatStandsThereWithItsPlace_study");
    EXPECT_EQ(study.scene.parts.size(), 3U);
    ASSERT_THAT(study.vary, SizeIs(2));
    EXPECT_EQ(study.vary[0].keys[0].key.location.text(), "study.toml:4:7");
    EXPECT_EQ(study.vary[0].keys[0].unit, "N*m^2");
    EXPECT_THAT(cells(study.vary[0]), ElementsAre("1e-06", "3e-06"));
    EXPECT_THAT(texts(study.vary[0]), ElementsAre("\"1e-6 N*m^2\"", "\"3e-6 N*m^2\""));
    ASSERT_THAT(study.results, SizeIs(2));
    EXPECT_EQ(study.results[0].column_name(), "tip_gap");
    EXPECT_EQ(study.results[0].from, 2.0);
    EXPECT_FALSE(study.results[0].until.given());
    EXPECT_EQ(study.results[1].level->si, 2e-6);
    EXPECT_EQ(study.results[1].reduce.location.text(), "study.toml:20:10");
}

TEST(ReadStudy, RangesHaveBothEndsAndPlainNumbers) {
    EXPECT_THAT(texts(study_of(good_study).vary[1]), ElementsAre("\"0.1 mm\"", "\"0.2 mm\"", "\"0.4 mm\""));
    const std::string linear = R"({ from = "0.1 mm", to = "1 mm", steps = 10 })";
    const Study study = study_of(study_with(R"({ from = "0.1 mm", to = "0.4 mm", steps = 3, scale = "log" })", linear));
    EXPECT_THAT(cells(study.vary[1]), ElementsAre("0.1", "0.2", "0.3", "0.4", "0.5", "0.6", "0.7", "0.8", "0.9", "1"));
    EXPECT_EQ(study.vary[1].keys[0].unit, "mm");
}

TEST(ReadStudy, RangesOfWholeNumbersAreWholeNumbers) {
    const Study study = study_of(
        "scene = \"scene.toml\"\n[[vary]]\nkey = \"particles.seed\"\n"
        "range = { from = 1, to = 5, steps = 3 }\n");
    EXPECT_THAT(texts(study.vary[0]), ElementsAre("1", "3", "5"));
    EXPECT_EQ(study.vary[0].keys[0].unit, "");
}

TEST(ReadStudy, OtherUnitsBecomeThatOfTheFirstValue) {
    const Study study = study_of(
        "scene = \"scene.toml\"\n[[vary]]\nkey = \"numerics.background_pressure\"\n"
        "values = [0, \"1 mmHg\", \"2 kPa\"]\n");
    EXPECT_EQ(study.vary[0].keys[0].unit, "mmHg");
    EXPECT_THAT(cells(study.vary[0]), ElementsAre("0", "1", "15.0012315169131"));
    EXPECT_EQ(study.vary[0].rows[2][0].toml, "\"2 kPa\"") << "runs get what the study says";
}

TEST(VariedValue, NumbersKeepTheirSign) {
    std::string unit;
    EXPECT_EQ(varied_value(parse_toml_value("\"- 2.5e1 mm\"", {}), unit).cell, "-25");
    EXPECT_EQ(varied_value(parse_toml_value("\"+3 mm\"", {}), unit).cell, "3");
    EXPECT_EQ(varied_value(parse_toml_value("\"-1 m\"", {}), unit).cell, "-1000");
    EXPECT_EQ(unit, "mm");
}

TEST(ReadStudy, NamesListsAndTruthAreTheirOwnText) {
    const Study study = study_of(R"(scene = "scene.toml"
combine = "zip"
[[vary]]
key = "particles.arrangement"
values = ["square", "hexagonal"]
[[vary]]
key = "measure.flux_in.to"
values = [["0 mm", "4 mm"], ["0 mm", "3 mm"]]
[[vary]]
key = "part.leaflets.enabled"
values = [true, true]
)");
    EXPECT_THAT(cells(study.vary[0]), ElementsAre("square", "hexagonal"));
    EXPECT_THAT(cells(study.vary[1]), ElementsAre("[\"0 mm\", \"4 mm\"]", "[\"0 mm\", \"3 mm\"]"));
    EXPECT_THAT(texts(study.vary[2]), ElementsAre("true", "true"));
}

TEST(ReadStudy, ATableVariesItsKeysTogether) {
    const Study study = study_of("scene = \"scene.toml\"\n[[vary]]\ntable = \"table.csv\"\n",
                                 "particles.spacing [mm],particles.arrangement\r\n0.1,square\r\n\r\n0.2,hexagonal\r\n");
    ASSERT_THAT(study.vary[0].keys, SizeIs(2));
    EXPECT_EQ(study.vary[0].keys[0].unit, "mm");
    ASSERT_THAT(study.vary[0].rows, SizeIs(2));
    EXPECT_EQ(study.vary[0].rows[1][0].toml, "\"0.2 mm\"");
    EXPECT_EQ(study.vary[0].rows[1][1].toml, "\"hexagonal\"");
}

TEST(ReadStudy, MaySayWhatItsRunsLeaveOut) {
    using enum RunOutput;
    EXPECT_FALSE(study_of(good_study).left_out.given());
    EXPECT_EQ(*study_of("leave_out = [\"page\", \"frames\"]\n" + good_study).left_out, (LeftOut{frames, page}));
    const Study none = study_of("leave_out = []\n" + good_study);
    EXPECT_TRUE(none.left_out.given());
    EXPECT_EQ(*none.left_out, LeftOut{});
}

TEST(ReadStudy, AResultOfEachCycleHasItsWindow) {
    const Study study = study_of(study_with("from = \"2 s\"", "from = \"1 s\"\nevery = \"1.5 s\""));
    ASSERT_EQ(study.results.size(), 3U);
    for (int k = 0; k < 2; ++k) {
        const Result& result = study.results.at(static_cast<std::size_t>(k));
        EXPECT_EQ(*result.name, "opening_" + std::to_string(k + 1));
        EXPECT_EQ(*result.reduce, Reduction::maximum);
        EXPECT_DOUBLE_EQ(*result.from, 1 + 1.5 * k);
        EXPECT_DOUBLE_EQ(*result.until, 2.5 + 1.5 * k);
    }
    EXPECT_EQ(*study.results[2].name, "reached");
}

TEST(ReadStudy, PartsOfAWindowEndWhereItEnds) {
    const Study study = study_of(study_with("from = \"2 s\"", "every = \"1.3333334 s\""));
    ASSERT_EQ(study.results.size(), 4U);
    EXPECT_EQ(*study.results[0].from, 0);
    EXPECT_EQ(*study.results[0].until, *study.results[1].from);
    EXPECT_EQ(*study.results[2].until, 4) << "not after the run";
    const Study crossings = study_of(study_with("level = ", "every = \"2 s\"\nlevel = "));
    EXPECT_EQ(*crossings.results[2].name, "reached_2");
    EXPECT_TRUE(crossings.results[2].level.given());
}

TEST(ReadStudy, ResultsOfCyclesHaveNamesOfTheirOwn) {
    const std::string cycles = study_with("from = \"2 s\"", "every = \"2 s\"");
    std::string twice = cycles;
    twice.replace(twice.find("name = \"reached\""), 16, "name = \"opening_2\"");
    EXPECT_EQ(study_fault(twice),
              "study.toml:18:8: there are two results 'opening_2'\n"
              "  give each result a name of its own: it is a column of results.csv");
    EXPECT_EQ(study_fault(cycles + "[[vary]]\nkey = \"run.duration\"\nvalues = [\"2 s\", \"4 s\"]\n"),
              "study.toml:15:9: result.every: run.duration varies, and with it how many columns there are\n"
              "  add 'until' to the result");
}

TEST(ReadStudy, LevelsAreOfTheMeasuresQuantity) {
    const Study study = study_of(good_study);
    EXPECT_EQ(level_in(study.results[1], "m^3/s"), 2e-6);
    EXPECT_THROW(static_cast<void>(level_in(study.results[1], "m")), InputError);
}

}  // namespace
}  // namespace dmp::tests::study_reading_tests
