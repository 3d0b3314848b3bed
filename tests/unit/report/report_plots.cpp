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

}  // namespace
}  // namespace dmp::tests::report_plots_tests
