// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "report/plots.hpp"
#include "tests/modules.hpp"

namespace dmp::tests::report_plots_tests {
namespace {

using testing::HasSubstr;
using testing::Not;

const double missing = std::numeric_limits<double>::quiet_NaN();

TEST(PlotData, HasNamesUnitsTimesAndValues) {
    const auto json =
        nlohmann::json::parse(plot_data({{"flux", "gap"}, {"m^3/s", "m"}, {0, 0.5}, {{1.0 / 3, missing}, {-2e-9, 4}}}));
    EXPECT_EQ(json["measures"][0]["name"], "flux");
    EXPECT_EQ(json["measures"][0]["unit"], "m^3/s");
    EXPECT_EQ(json["measures"][0]["time"], (nlohmann::json{0.0, 0.5}));
    EXPECT_EQ(json["measures"][0]["value"], (nlohmann::json{0.3333333, -2e-9}));
    EXPECT_EQ(json["measures"][1]["value"], (nlohmann::json{nullptr, 4.0}));
}

TEST(PlotData, HasReferencesAtTheTimesOfTheirMeasures) {
    const MeasureSeries measures{{"flow", "gap"}, {"m/s", "m"}, {0, 0.5, 1}, {{1, 2}, {3, 4}, {5, 6}}};
    const MeasureSeries references{{"gap"}, {"m"}, {0, 0.25, 1}, {{missing}, {7}, {1.0 / 3}}};
    const auto json = nlohmann::json::parse(plot_data(measures, references))["measures"];
    EXPECT_FALSE(json[0].contains("reference"));
    EXPECT_EQ(json[1]["reference"], (nlohmann::json{nullptr, nullptr, 0.3333333})) << "none at 0.5 s";
}

TEST(PlotData, ReferencesOfThinnedMeasuresAreAtThePointsThatAreLeft) {
    MeasureSeries measures{{"a"}, {"m"}, {}, {}}, references = measures;
    for (int i = 0; i < 10'000; ++i) {
        measures.time.push_back(i);
        measures.rows.push_back({i % 7 - 3.0});
        references.time.push_back(i);
        references.rows.push_back({2.0 * i});
    }
    const auto json = nlohmann::json::parse(plot_data(measures, references))["measures"][0];
    ASSERT_EQ(json["reference"].size(), json["time"].size());
    EXPECT_LE(json["time"].size(), most_points);
    for (std::size_t k = 0; k < json["time"].size(); ++k)
        EXPECT_EQ(json["reference"][k].get<double>(), 2 * json["time"][k].get<double>());
}

TEST(PlotData, CannotEndItsScript) {
    const std::string text = plot_data({{"</script><script>alert(1)</script>"}, {"<m>"}, {0}, {{1}}});
    EXPECT_THAT(text, Not(HasSubstr("<")));
    EXPECT_EQ(nlohmann::json::parse(text)["measures"][0]["name"], "</script><script>alert(1)</script>");
}

TEST(PlotData, AMillionRowsMakeNoLargePage) {
    RunFiles run;
    run.summary = JsonValue::Json::object();
    run.measures.emplace();
    run.measures->names = {"a", "b"};
    run.measures->units = {"m", "1"};
    for (int i = 0; i < 1'000'000; ++i) {
        run.measures->time.push_back(i * 1e-6);
        run.measures->rows.push_back({i % 1000 / 7.0, 1.0 / (1 + i)});
    }
    EXPECT_LT(plot_data(*run.measures).size(), 150'000U);
    EXPECT_THAT(measures_section(run), HasSubstr("at most 2000 of the 1000000 rows"));
}

TEST(PlotData, ManyMeasuresShareThePointsOfAPage) {
    EXPECT_EQ(points_of_each(0), most_points);
    EXPECT_EQ(points_of_each(75), 2000U);
    EXPECT_EQ(points_of_each(300), 500U);
}

TEST(MeasuresSection, NamesEachPlotWithItsUnitAndSaysWhatNeedsJavaScript) {
    RunFiles run;
    run.measures = MeasureSeries{{"tip <gap>"}, {"m"}, {0}, {{1}}};
    run.summary = {{"measures", {{"tip <gap>", {{"unit", "m"}, {"min", 1.0}, {"max", 2.5}, {"missing", 0}}}}}};
    const std::string text = measures_section(run);
    EXPECT_THAT(text, HasSubstr("<figcaption>tip &lt;gap&gt; [m]</figcaption>"));
    EXPECT_THAT(text, HasSubstr("<noscript><p class=\"note\">The plots need JavaScript"));
    EXPECT_THAT(text, HasSubstr("<th scope=\"row\">tip &lt;gap&gt; [m]</th><td class=\"number\">1</td><td "
                                "class=\"number\">2.5</td><td class=\"number\">not known</td>"));
    EXPECT_THAT(text, Not(HasSubstr("at most")));
}

TEST(MeasuresSection, SaysWhatTheReferenceIs) {
    RunFiles run;
    run.summary = JsonValue::Json::object();
    run.measures = MeasureSeries{{"flow", "gap"}, {"m/s", "m"}, {0}, {{1, 2}}};
    run.references = MeasureSeries{{"flow"}, {"m/s"}, {0}, {{1}}};
    EXPECT_THAT(measures_section(run), HasSubstr("<figcaption>flow [m/s] <span class=\"note\">dashed: "
                                                 "reference</span></figcaption>"));
    run.summary = {{"references", {{{"column", "flow"}, {"source", "A <1997>"}, {"error", 0.00428}}}}};
    const std::string text = measures_section(run);
    EXPECT_THAT(text, HasSubstr("dashed: reference (A &lt;1997&gt;); 0.43 % from it</span>"));
    EXPECT_THAT(text, HasSubstr("<figcaption>gap [m]</figcaption>"));
}

}  // namespace
}  // namespace dmp::tests::report_plots_tests
