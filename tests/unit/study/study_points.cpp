// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <set>

#include <gmock/gmock.h>

#include "study/points.hpp"
#include "tests/modules.hpp"
#include "tests/unit/study/study_text.hpp"
#include "tests/unit/thrown.hpp"

namespace dmp::tests::study_points_tests {
namespace {

using testing::ElementsAre;
using testing::MatchesRegex;

std::vector<std::string> cells(const Point& point) {
    std::vector<std::string> all;
    for (const VariedValue& value : point.values) all.push_back(value.cell);
    return all;
}

TEST(Points, AGridIsEachWithEachTheLastKeyFastest) {
    const Study study = study_of(good_study);
    const Points points(study);
    ASSERT_EQ(points.size(), 6U);
    EXPECT_THAT(cells(points.at(0)), ElementsAre("1e-06", "0.1"));
    EXPECT_THAT(cells(points.at(1)), ElementsAre("1e-06", "0.2"));
    EXPECT_THAT(cells(points.at(3)), ElementsAre("3e-06", "0.1"));
    EXPECT_THAT(cells(points.at(5)), ElementsAre("3e-06", "0.4"));
    EXPECT_THROW(static_cast<void>(points.at(6)), std::out_of_range);
}

TEST(Points, NamesFollowFromSceneAndValuesAlone) {
    const Study study = study_of(good_study);
    std::set<std::string> names;
    for (std::size_t i = 0; i < 6; ++i) {
        EXPECT_THAT(Points(study).at(i).name, MatchesRegex("000" + std::to_string(i + 1) + "_[0-9a-f]{8}"));
        names.insert(Points(study).at(i).name.substr(5));
    }
    EXPECT_EQ(names.size(), 6U);
    const Study other_results = study_of(study_with("reduce = \"maximum\"", "reduce = \"mean\""));
    EXPECT_EQ(Points(other_results).at(4).name, Points(study).at(4).name);
    EXPECT_EQ(identity_of(other_results), identity_of(study));
    const Study other_values = study_of(study_with("1e-6 N*m^2", "2e-6 N*m^2"));
    EXPECT_NE(Points(other_values).at(0).name, Points(study).at(0).name);
    EXPECT_EQ(Points(other_values).at(5).name, Points(study).at(5).name);
    EXPECT_NE(identity_of(other_values), identity_of(study));
}

TEST(Points, ZippedKeysGoTogether) {
    const Study study = study_of("combine = \"zip\"\n" + study_with("steps = 3", "steps = 2"));
    const Points points(study);
    ASSERT_EQ(points.size(), 2U);
    EXPECT_THAT(cells(points.at(1)), ElementsAre("3e-06", "0.4"));
}

const std::string hypercube = R"(scene = "scene.toml"
combine = "latin_hypercube"
samples = 50
seed = 3
[[vary]]
key = "particles.spacing"
range = { from = "1e-9 mm", to = "1 mm" }
[[vary]]
key = "part.leaflets.bending_stiffness"
range = { from = "1e-6 N*m^2", to = "1e-4 N*m^2", scale = "log" }
[[vary]]
key = "particles.arrangement"
values = ["square", "hexagonal"]
)";

TEST(Points, ALatinHypercubeHasOneSampleInEachPartOfEachRange) {
    std::string text = hypercube;
    const Study study = study_of(text);
    const Points points(study);
    ASSERT_EQ(points.size(), 50U);
    std::set<int> linear, logarithmic;
    int squares = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Point point = points.at(i);
        linear.insert(static_cast<int>(point.values[0].quantity->si * 1e3 * 50));
        logarithmic.insert(static_cast<int>(std::log10(point.values[1].quantity->si * 1e6) / 2 * 50));
        squares += point.values[2].cell == "square" ? 1 : 0;
    }
    EXPECT_EQ(linear.size(), 50U);
    EXPECT_EQ(logarithmic.size(), 50U);
    EXPECT_EQ(squares, 25);
    const Points again(study);
    EXPECT_EQ(again.at(17).name, points.at(17).name);
    text.replace(text.find("seed = 3"), 8, "seed = 4");
    const Study other = study_of(text);
    EXPECT_NE(Points(other).at(17).values[0].cell, points.at(17).values[0].cell);
}

TEST(Points, FormulasFollowTheKeysAboveThem) {
    const Study study = study_of(good_study + R"(
[[vary]]
key = "contact.range"
formula = "particles.spacing / 1 mm + 0.5"
[[vary]]
key = "part.leaflets.axial_stiffness"
formula = "part.leaflets.bending_stiffness / (particles.spacing * contact.range)^2"
)");
    const Points points(study);
    ASSERT_EQ(points.size(), 6U);
    const Point last = points.at(5);
    EXPECT_EQ(last.values[2].toml, "0.9");
    EXPECT_DOUBLE_EQ(last.values[3].quantity->si, 3e-6 / std::pow(0.4e-3 * 0.9, 2));
    EXPECT_EQ(study.keys()[3].unit, "N");
}

TEST(Points, NamesOfTheStudysOwnAreForFormulas) {
    const Study study = study_of(R"(scene = "scene.toml"
[[vary]]
name = "factor"
values = [2, 3]
[[vary]]
name = "width"
range = { from = "1 mm", to = "2 mm", steps = 2 }
[[vary]]
key = "particles.spacing"
formula = "width / factor / 10"
)");
    const Points points(study);
    ASSERT_EQ(points.size(), 4U);
    const Point last = points.at(3);
    EXPECT_EQ(last.values[0].cell, "3");
    EXPECT_EQ(last.values[1].cell, "2");
    EXPECT_EQ(study.keys()[1].unit, "mm");
    EXPECT_DOUBLE_EQ(last.values[2].quantity->si, 2e-3 / 30);
    const std::vector<std::string> set = overrides(study, last);
    ASSERT_EQ(set.size(), 1U) << "the scene knows nothing of names";
    EXPECT_EQ(set[0].substr(0, 18), "particles.spacing=");
    EXPECT_NE(points.at(0).name.substr(5), points.at(1).name.substr(5));
}

TEST(Points, HaveWhatIsSetInAllRunsBesides) {
    const std::string text = "scene = \"scene.toml\"\n[[vary]]\nkey = \"particles.seed\"\nvalues = [1, 2]\n";
    const Folder folder;
    Folder::write(good_scene);
    const Study plain = parse_study(text, "study.toml");
    const std::string spacing = "particles.spacing=\"0.3 mm\"";
    const Study set = parse_study(text, "study.toml", {spacing});
    EXPECT_DOUBLE_EQ(*set.scene.particles.spacing, 0.3e-3);
    EXPECT_EQ(overrides(set, Points(set).at(1)), (std::vector<std::string>{spacing, "particles.seed=2"}));
    EXPECT_NE(identity_of(set), identity_of(plain));
    EXPECT_NE(Points(set).at(1).name, Points(plain).at(1).name);
    EXPECT_THAT(text_thrown<InputError>([&] { parse_study(text, "study.toml", {" particles.seed = 3"}); }),
                testing::HasSubstr("the study varies 'particles.seed'"));
    EXPECT_EQ(text_thrown<InputError>([&] { parse_study(text, "study.toml", {"particles.seed=3"}); }),
              "--set particles.seed=3: the study varies 'particles.seed', at study.toml:3:7\n"
              "  choose runs with --only, or change its values in the study");
}

TEST(Points, AListMayHaveAFormulaForEachValue) {
    const Study study = study_of(R"(scene = "scene.toml"
[[vary]]
name = "angle"
values = ["0 deg", "90 deg"]
[[vary]]
key = "flow.acceleration"
formula = ["sin(angle) * 1 m/s^2", "-9.81 m/s^2"]
)");
    EXPECT_EQ(Points(study).at(0).values[1].toml, R"(["0 m/s^2", "-9.81 m/s^2"])");
    EXPECT_EQ(Points(study).at(1).values[1].cell, R"(["1 m/s^2", "-9.81 m/s^2"])");
}

TEST(Points, ABareZeroHasTheUnitOfTheOthers) {
    const Study study = study_of(R"(scene = "scene.toml"
[[vary]]
key = "numerics.background_pressure"
values = ["0", "1 kPa"]
[[vary]]
key = "flow.largest_pressure"
formula = "numerics.background_pressure + 10 Pa"
)");
    EXPECT_EQ(Points(study).at(0).values[1].cell, "10");
    EXPECT_EQ(Points(study).at(1).values[1].cell, "1010");
}

TEST(StudyPoints, FormulasOfTheSameNumbersAreWorkedOutOnce) {
    const Study study = study_of(study_with("[[result]]",
                                            "[[vary]]\nkey = \"run.duration\"\n"
                                            "formula = \"particles.spacing / 0.1 mm * 2 s\"\n\n[[result]]"));
    const Points points(study);
    ASSERT_EQ(points.size(), 6U);
    for (std::size_t index = 0; index < points.size(); ++index)
        EXPECT_EQ(points.values_at(index)[2].cell, std::vector<std::string>({"2", "4", "8"})[index % 3]);
    EXPECT_EQ(points.formulas_worked_out(), 3U) << "one for each spacing";
}

}  // namespace
}  // namespace dmp::tests::study_points_tests
