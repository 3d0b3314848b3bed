// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Settings of a trade, errors of measures, convergence with the spacing, and the front of cost and error.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <numbers>
#include <set>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "base/safe_file.hpp"
#include "scene/read_scene.hpp"
#include "study/front.hpp"
#include "study/measure_columns.hpp"
#include "study/points.hpp"
#include "study/read_study.hpp"
#include "study/series_error.hpp"
#include "study/trade_errors.hpp"
#include "study/trade_settings.hpp"
#include "tests/modules.hpp"
#include "tests/unit/scene/scene_text.hpp"

namespace dmp::tests::study_trade_tests {
namespace {

using study::CostAndError;
using study::error_of;
using study::SeriesError;
using study::TimeSeries;
using study::TradeColumn;
using study::TradeRole;
using study::TradeRun;
using study::TradeSetting;
using study::TradeSettings;
using testing::ElementsAre;
using testing::SizeIs;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

template <class Value>
TimeSeries sampled(int rows, const Value& value_at) {
    TimeSeries series;
    for (int i = 0; i <= rows; ++i) {
        series.time.push_back(static_cast<double>(i) / rows);
        series.value.push_back(value_at(series.time.back()));
    }
    return series;
}

double sine(double t) { return std::sin(2 * std::numbers::pi * t); }

TEST(SeriesError, OfAMeasureThatIsTenPercentTooLarge) {
    const auto error = error_of(sampled(200, [](double t) { return 1.1 * sine(t) + 2.2; }),
                                sampled(300, [](double t) { return sine(t) + 2; }));
    EXPECT_NEAR(error.whole, 0.1, 1e-4);
    EXPECT_NEAR(error.end, 0.2 / 3, 1e-4);
    EXPECT_NEAR(error.peak, 0.1, 1e-4);
    EXPECT_NEAR(error.integral, 0.1, 1e-4);
    EXPECT_DOUBLE_EQ(error.largest(), std::max(error.whole, error.peak));
}

TEST(SeriesError, OfAShiftInTimeIsSeenByTheWholeAlone) {
    const auto error =
        error_of(sampled(400, [](double t) { return sine(t - 0.05); }), sampled(400, [](double t) { return sine(t); }));
    EXPECT_NEAR(error.whole, 2 * std::sin(std::numbers::pi * 0.05), 1e-3);
    EXPECT_NEAR(error.peak, 0, 1e-3);
    EXPECT_NEAR(error.integral, 0, 1e-3);
}

TEST(SeriesError, TakesTheTimeOfTheReferenceAndLeavesOutRowsWithoutValue) {
    TimeSeries longer{{0, 1, 2, 3, 4}, {1, nan, 1, 1, 100}};
    EXPECT_DOUBLE_EQ(error_of(longer, {{0.5, 3}, {1, 1}}).largest(), 0);
    EXPECT_DOUBLE_EQ(error_of({{0.1, 3}, {1, 1}}, {{0, 1, 2, 3}, {2, 2, 2, 2}}).largest(), 0.5);
    EXPECT_TRUE(std::isnan(error_of({{0.5, 3}, {1, 1}}, {{0, 1, 2, 3}, {2, 2, 2, 2}}).largest()))
        << "a sixth is missing";
}

TEST(SeriesError, IsNotANumberWithoutTimeInCommonOrAReferenceThatIsZero) {
    EXPECT_TRUE(std::isnan(error_of({{0, 1}, {1, 1}}, {{1, 2}, {1, 1}}).largest()));
    EXPECT_TRUE(std::isnan(error_of({{0, 1}, {1, 1}}, {{0, 1}, {0, 0}}).largest()));
    EXPECT_TRUE(std::isnan(error_of({{0}, {1}}, {{0, 1}, {1, 1}}).largest()));
}

TEST(Front, HasWhatNothingBeats) {
    const std::vector<CostAndError> tried{{1, 0.3},   {2, 0.1},   {2, 0.2},  {3, 0.1},
                                          {0.5, nan}, {10, 0.01}, {4, 0.05}, {nan, 0}};
    EXPECT_THAT(front_of(tried), ElementsAre(0, 1, 6, 5));
    EXPECT_EQ(cheapest_within(tried, 0.05), 6U);
    EXPECT_EQ(cheapest_within(tried, 0.06), 6U);
    EXPECT_EQ(cheapest_within(tried, 1), 0U);
    EXPECT_FALSE(cheapest_within(tried, 0.001));
    EXPECT_THAT(front_of({}), ElementsAre());
}

TradeSettings settings_of(const std::string& scene, const std::vector<std::string>& overrides = {}) {
    const Folder folder;
    Folder::write(scene);
    return study::trade_settings({"scene.toml", overrides});
}

TEST(MeasureColumns, OfAggregatesCountParticlesAndBonds) {
    const Folder folder;
    Folder::write(good_scene + "[[measure]]\nname = \"clot\"\nkind = \"aggregate\"\npart = \"leaflets\"\n");
    const Scene scene = read_scene("scene.toml");
    for (const char* column : {"clot_particles", "clot_largest", "clot_bonds_made", "clot_bonds_broken"})
        EXPECT_TRUE(study::counts_particles(scene, column)) << column;
    for (const char* column : {"clot_mass", "clot_pieces", "flux_in", "tip_gap"})
        EXPECT_FALSE(study::counts_particles(scene, column)) << column;
}

TEST(TradeSettings, AreFourSpacingsWithEachLevelAndTwoRepeatsCheapestFirst) {
    const TradeSettings all = settings_of(good_scene);  // 0.1 mm
    EXPECT_THAT(all.keys, ElementsAre("particles.spacing", "quality", "numerics.step_factor"));
    ASSERT_THAT(all.settings, SizeIs(14));
    EXPECT_TRUE(std::ranges::is_sorted(all.settings, {}, &TradeSetting::cost));
    EXPECT_THAT(all.overrides(all.settings.front()), ElementsAre("particles.spacing=\"0.2 mm\"", "quality=\"draft\""));
    EXPECT_THAT(all.overrides(all.settings.back()),
                ElementsAre("particles.spacing=\"0.07071 mm\"", "quality=\"fine\""));
    EXPECT_NEAR(all.settings.front().cost, (1 + 1 / 0.3) / (1 + 1 / 0.1) / 8, 1e-12) << "in 2-D: particles times steps";
    std::vector<std::vector<std::string>> repeats;
    for (const TradeSetting& each : all.settings)
        if (each.role == TradeRole::repeat) repeats.push_back(all.overrides(each));
    EXPECT_THAT(
        repeats,
        ElementsAre(
            ElementsAre("particles.spacing=\"0.0995 mm\"", "quality=\"standard\"", "numerics.step_factor=0.485"),
            ElementsAre("particles.spacing=\"0.1005 mm\"", "quality=\"standard\"", "numerics.step_factor=0.47")));
}

std::set<std::string> levels_of(const TradeSettings& all) {
    std::set<std::string> levels;
    for (const TradeSetting& each : all.settings) levels.insert(each.level.text);
    return levels;
}

TEST(TradeSettings, LeaveOutLevelsThatMakeTheSameRun) {
    // The plain scheme's fine level sets the same as its standard one where all that it sets is given.
    const TradeSettings all = settings_of(good_scene, {"numerics.mach_number=0.1", "part.wall.layers=3"});
    EXPECT_THAT(levels_of(all), ElementsAre("standard"));
    EXPECT_THAT(all.settings, SizeIs(6));
}

TEST(TradeSettings, OfASceneThatGivesItsSpeedOfSoundHaveLowerOnes) {
    const std::string scene = good_scene;
    const TradeSettings all = settings_of(scene, {"numerics.sound_speed=\"8 m/s\"", "flow.largest_speed=\"0.5 m/s\""});
    EXPECT_THAT(all.keys, ElementsAre("particles.spacing", "numerics.sound_speed", "numerics.step_factor"));
    EXPECT_THAT(levels_of(all), ElementsAre("sound speed 4 m/s", "sound speed 8 m/s")) << "at 2 m/s: Mach 0.25";
    EXPECT_THAT(all.settings, SizeIs(10));
    EXPECT_THAT(all.overrides(all.settings.back()),
                ElementsAre("particles.spacing=\"0.07071 mm\"", "numerics.sound_speed=\"8 m/s\""));
    for (const TradeSetting& each : all.settings) {
        EXPECT_EQ(each.level.rank, each.level.text == "sound speed 4 m/s" ? 4 : 8);
        if (each.spacing_text == "0.1 mm") {
            EXPECT_DOUBLE_EQ(each.cost, each.level.rank / 8);
        }
    }
}

TEST(TradeSettings, OfASceneThatWritesDownAnAutomaticSpeedOfSoundAreByQuality) {
    const TradeSettings all = settings_of(good_scene, {"numerics.sound_speed=\"auto\""});
    EXPECT_THAT(all.keys, ElementsAre("particles.spacing", "quality", "numerics.step_factor"));
    EXPECT_EQ(levels_of(all), levels_of(settings_of(good_scene)));
}

TEST(TradeIdentity, IsOfWhatTheSettingsDoNotSet) {
    const Folder folder;
    Folder::write(good_scene);
    Folder::write("", "vein_valve.geo");
    const auto with = [](const std::vector<std::string>& overrides) {
        return study::trade_identity({"scene.toml", overrides});
    };
    const std::string own = with({}), of_sound = with({"numerics.sound_speed=\"8 m/s\""});
    EXPECT_EQ(with({"particles.spacing=\"0.3 mm\"", "quality=fine", "run.duration=\"1 s\""}), own);
    EXPECT_EQ(with({"numerics.sound_speed=\"4 m/s\""}), of_sound);
    EXPECT_EQ(with({"numerics.sound_speed=\"auto\""}), own);
    EXPECT_NE(of_sound, own) << "their levels are others";
    EXPECT_NE(with({"numerics.step_factor=0.3"}), own);
    EXPECT_NE(with({"part.wall.layers=5"}), own);
}

TEST(TradeIdentity, OfShippedTradesIsThatOfTheirScenes) {
    std::size_t found = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(DMP_SOURCE_DIR "/cases")) {
        if (entry.path().filename() != "trade.json") continue;
        const auto trade = nlohmann::json::parse(read_file(entry.path()));
        EXPECT_EQ(trade["identity"], study::trade_identity({entry.path().parent_path().string(), {}}))
            << entry.path() << ": make it anew, as the case's README says";
        ++found;
    }
    EXPECT_GT(found, 0U);
}

TEST(TradeSettings, MakeAStudyOfTheirRunsInTheirOrder) {
    const Folder folder;
    Folder::write(good_scene);
    const study::TradeScene scene{"scene.toml", {"run.duration=\"0.5 s\""}};
    const TradeSettings all = study::trade_settings(scene);
    std::filesystem::create_directories("out/trade");
    const Study read = study::parse_study(study::trade_study(scene, all, "out/trade"), "out/trade/study.toml");
    const study::Points points(read);
    ASSERT_EQ(points.size(), all.settings.size());
    for (std::size_t k = 0; k < points.size(); ++k) {
        std::vector<std::string> values;
        for (const auto& value : points.values_at(k)) values.push_back(value.toml);
        std::vector<std::string> expected = all.settings[k].values;
        expected.emplace_back("\"0.5 s\"");
        EXPECT_EQ(values, expected);
    }
}

/// Runs whose one measure is 1 + factor h^order at all times, of these spacings.
struct Ladder {
    Ladder(const std::vector<double>& spacings, double factor, double order) {
        for (const double h : spacings) add(h, 1 + factor * std::pow(h, order), TradeRole::candidate);
    }
    void add(double spacing, double value, TradeRole role) {
        settings.settings.push_back({spacing, "", {"standard", 1}, role, 1, {}});
        runs.push_back({runs.size(), 1, {TimeSeries{{0, 1}, {value, value}}}});
    }
    [[nodiscard]] study::TradeErrors errors() const {
        return trade_errors(settings, runs, std::vector<TradeColumn>(runs.front().measures.size()));
    }

    TradeSettings settings;
    std::vector<TradeRun> runs;
};

TEST(TradeErrors, AreThoseFromTheLimitWhereTheRunsConverge) {
    for (const double order : {0.7, 1.0, 2.0, 3.0}) {
        const double factor = 0.1;
        const Ladder ladder({0.5, 1, 0.25, 0.7}, factor, order);
        const auto errors = ladder.errors();
        EXPECT_EQ(errors.reference, 2U);
        const double reference = ladder.runs[2].measures[0].value[0];
        EXPECT_NEAR(errors.columns[0].order, order, 1e-9);
        EXPECT_NEAR(errors.columns[0].reference, factor * std::pow(0.25, order) / reference, 1e-9);
        for (std::size_t r = 0; r < 4; ++r)
            EXPECT_NEAR(errors.runs[r].error, factor * std::pow(ladder.settings.settings[r].spacing, order) / reference,
                        1e-9);
    }
}

TEST(TradeErrors, OfTheReferenceAreTheDistanceOfTwiceTheSpacingWhereRunsDoNotConverge) {
    Ladder ladder({}, 0, 1);
    for (const auto& [spacing, value] : {std::pair{1.0, 1.02}, {0.7, 0.9}, {0.5, 1.05}, {0.35, 1.0}})
        ladder.add(spacing, value, TradeRole::candidate);
    const auto errors = ladder.errors();
    EXPECT_TRUE(std::isnan(errors.columns[0].order));
    EXPECT_EQ(errors.columns[0].why_not, "it does not fall with an order of 0.5 to 4");
    EXPECT_NEAR(errors.columns[0].reference, 0.1, 1e-12);
    EXPECT_NEAR(errors.runs[2].error, 0.15, 1e-12);
    EXPECT_NEAR(errors.runs[3].error, 0.1, 1e-12) << "of the reference: its own";
}

TEST(TradeErrors, AreNotLessThanTheScatterOfRepeats) {
    Ladder ladder({1, 0.7, 0.5, 0.35}, 0.001, 1);
    ladder.add(0.502, 1.03, TradeRole::repeat);
    ladder.add(0.498, 0.99, TradeRole::repeat);
    const auto errors = ladder.errors();
    EXPECT_EQ(errors.reference, 3U);
    EXPECT_NEAR(errors.columns[0].scatter, 0.0295 / 1.0005, 1e-3);
    for (std::size_t r = 0; r < 4; ++r) EXPECT_DOUBLE_EQ(errors.runs[r].error, errors.columns[0].scatter);
}

TEST(TradeErrors, OfTheReferenceAreThoseOfFirstOrderByTheRunThatThereIs) {
    const Ladder ladder({1, 1.4}, 0.1, 1);  // which the budget has cut
    EXPECT_NEAR(ladder.errors().columns[0].reference, 0.1 / 1.1, 1e-12);
    EXPECT_EQ(ladder.errors().columns[0].why_not, "there are fewer than four spacings");
    const Ladder slow({1, 1.4, 2, 2.8}, 0.1, 0.3);
    EXPECT_GT(slow.errors().columns[0].reference, 0.55 * 0.1 / 1.1) << "of order 0.5: 0.56 of that of order 0.3";
}

TEST(TradeErrors, HoldThatOfTheReferencesLevel) {
    Ladder ladder({1, 1.4, 2}, 0.1, 1);
    for (auto& each : ladder.settings.settings) each.level.rank = 0;
    ladder.add(1.4, 1.2, TradeRole::candidate);  // of quality standard
    const auto errors = ladder.errors();
    EXPECT_EQ(errors.reference, 0U);
    EXPECT_NEAR(errors.columns[0].reference, 0.1 / 1.1 + (1.2 - 1.14) / 1.2, 1e-9);
}

TEST(TradeErrors, AgainstAGivenReferenceAreThoseFromTheLimit) {
    const double factor = 0.1;
    Ladder ladder({0.5, 1, 0.25, 0.7}, factor, 2);
    const double finest = 1 + factor * std::pow(0.125, 2);
    ladder.add(0.125, finest, TradeRole::reference);
    const auto errors = ladder.errors();
    EXPECT_EQ(errors.reference, 4U);
    EXPECT_NEAR(errors.columns[0].order, 2, 1e-9);
    EXPECT_NEAR(errors.columns[0].reference, factor * std::pow(0.125, 2) / finest, 1e-9);
    for (std::size_t r = 0; r < 4; ++r)
        EXPECT_NEAR(errors.runs[r].error, factor * std::pow(ladder.settings.settings[r].spacing, 2) / finest, 1e-9);
}

TEST(TradeErrors, OfAGivenReferenceHaveTheConvergenceOfTheFinestRunsLevel) {
    Ladder ladder({0.5, 1, 0.25, 0.7}, 0.1, 1);
    ladder.add(0.125, 1.0125, TradeRole::reference);
    ladder.settings.settings.back().level.rank = 2;  // which none of the others has
    EXPECT_NEAR(ladder.errors().columns[0].order, 1, 1e-9);
}

TEST(TradeErrors, AgainstAGivenReferenceThatIsCoarserAreSaidAllTheSame) {
    Ladder ladder({0.5, 1, 0.25, 0.7}, 0.1, 1);
    ladder.add(2, 1.2, TradeRole::reference);
    const auto errors = ladder.errors();
    EXPECT_EQ(errors.columns[0].why_not, "no other spacing has been run at its level");
    EXPECT_NEAR(errors.columns[0].reference, (1.2 - 1.025) / 1.2, 1e-9) << "of the finest run";
}

TEST(TradeErrors, AgainstWhatIsExactAreTheDistances) {
    Ladder ladder({0.5, 1, 0.25, 0.7}, 0.1, 2);
    for (std::size_t r = 0; r < 4; ++r) ladder.runs[r].measures.push_back(ladder.runs[r].measures[0]);
    const TimeSeries one{{0, 1}, {1, 1}};
    const auto errors = trade_errors(ladder.settings, ladder.runs, {{0, one}, {1, {}}});
    EXPECT_TRUE(errors.columns[0].is_exact);
    EXPECT_FALSE(errors.columns[1].is_exact);
    EXPECT_EQ(errors.columns[0].reference, 0);
    EXPECT_NEAR(errors.columns[0].order, 2, 1e-9);
    for (std::size_t r = 0; r < 4; ++r)
        EXPECT_NEAR(errors.runs[r].distance[0].largest(), 0.1 * std::pow(ladder.settings.settings[r].spacing, 2), 1e-9);
}

TEST(TradeErrors, AreNotKnownOfARunWithoutValues) {
    Ladder ladder({1, 0.7, 0.5, 0.35}, 0.1, 1);
    ladder.add(0.502, 1.05, TradeRole::repeat);
    ladder.runs[0].measures[0].value = {nan, nan};
    const auto errors = ladder.errors();
    EXPECT_TRUE(std::isnan(errors.runs[0].error));
    EXPECT_EQ(errors.runs[0].column, 0U);
    EXPECT_FALSE(std::isnan(errors.runs[1].error));
}

TEST(TradeErrors, OfAVectorsComponentAreTakenOfTheVectorsSize) {
    Ladder ladder({1, 0.7, 0.5, 0.35}, 0.1, 1);
    for (std::size_t r = 0; r < 4; ++r)
        ladder.runs[r].measures.push_back({{0, 1}, {1e-12, static_cast<double>(r) * 1e-12}});
    const auto together = trade_errors(ladder.settings, ladder.runs, {{7, {}}, {7, {}}});
    EXPECT_LT(together.runs[0].distance[1].largest(), 1e-11);
    EXPECT_EQ(together.runs[0].column, 0U);
    EXPECT_GT(trade_errors(ladder.settings, ladder.runs, {{0, {}}, {1, {}}}).runs[0].distance[1].largest(), 0.5);
}

TEST(TradeErrors, DoNotCountWhatScattersMoreThanHalfItsSize) {
    Ladder ladder({1, 0.7, 0.5, 0.35}, 0.1, 1);
    ladder.add(0.502, 1.05, TradeRole::repeat);
    for (std::size_t r = 0; r < 5; ++r) ladder.runs[r].measures.push_back({{0, 1}, {1, r == 4 ? -1.0 : 1.0}});
    const auto errors = trade_errors(ladder.settings, ladder.runs, {{0, {}}, {1, {}}});
    EXPECT_TRUE(errors.columns[0].counts());
    EXPECT_FALSE(errors.columns[1].counts());
    EXPECT_EQ(errors.runs[0].column, 0U);
}

TEST(TradeErrors, AreOfTheWorstMeasureThatHasANumber) {
    Ladder ladder({1, 0.7, 0.5, 0.35}, 0.1, 1);
    for (std::size_t r = 0; r < 4; ++r) {
        const double h = ladder.settings.settings[r].spacing;
        ladder.runs[r].measures.push_back({{0, 1}, {nan, nan}});
        ladder.runs[r].measures.push_back({{0, 1}, {0, 5 + 2 * h}});
    }
    const auto errors = trade_errors(ladder.settings, ladder.runs, {{0, {}}, {1, {}}, {2, {}}});
    EXPECT_EQ(errors.runs[0].column, 2U);
    EXPECT_NEAR(errors.runs[0].error, 2 / 5.7, 1e-9);
    EXPECT_FALSE(errors.columns[1].counts());
    EXPECT_EQ(errors.columns[1].why_not, "zero, or without values, in the reference");
}

}  // namespace
}  // namespace dmp::tests::study_trade_tests
