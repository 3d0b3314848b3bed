// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// What a trade has found: its picture, and its section of the study's page.
#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "base/errors.hpp"
#include "report/label_places.hpp"
#include "report/log_axis.hpp"
#include "report/study_facts.hpp"
#include "report/trade_picture.hpp"
#include "report/trade_section.hpp"
#include "report/write_report.hpp"
#include "tests/unit/report/run_folder.hpp"
#include "tests/unit/thrown.hpp"

namespace dmp::tests::report_trade_tests {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

constexpr double no_value = std::numeric_limits<double>::quiet_NaN();

std::size_t count_of(const std::string& text, const std::string& part) {
    std::size_t count = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size())) ++count;
    return count;
}

std::vector<std::string> texts_of(const std::vector<LogTick>& ticks) {
    std::vector<std::string> all;
    for (const LogTick& tick : ticks) all.push_back(tick.text);
    return all;
}

constexpr std::size_t draft = 0, standard = 1, fine = 2;
const std::vector<std::string> levels{"draft", "standard", "fine"};

TradeFacts::Setting setting(double spacing, std::size_t level, double cost, double error) {
    TradeFacts::Setting made;
    made.run = fmt::format("{}_{}", spacing, levels[level]);
    made.set = {fmt::format("particles.spacing=\"{} m\"", spacing), "quality=\"" + levels[level] + "\""};
    made.spacing = spacing;
    made.level = level;
    made.has_ended = true;
    made.cost = cost;
    made.error = error;
    made.error_is_of = "flux";
    return made;
}

/// Four settings, of which the third one is beaten by the second one, and a repeat.
TradeFacts valve() {
    TradeFacts trade;
    trade.scene = "cases/valve";
    trade.name = "valve";
    trade.simulated = 1.2;
    trade.duration = 4.8;
    trade.levels = levels;
    trade.settings = {setting(4e-4, draft, 7, 0.2), setting(2e-4, standard, 60, 0.06), setting(2e-4, fine, 90, 0.07),
                      setting(1.414e-4, fine, 300, 0.02), setting(1.99e-4, standard, 61, 0.061)};
    trade.settings[4].is_repeat = true;
    trade.measures = {{"flux", 0.015}};
    trade.front = {0, 1, 3};
    trade.reference = 3;
    return trade;
}

TEST(LogAxis, HasRoundTimesInTheUnitThatSuitsThem) {
    EXPECT_THAT(texts_of(LogAxis({7, 300}, 0, 600).times(50)),
                ElementsAre("10 s", "20 s", "30 s", "1 min", "2 min", "5 min"));
    EXPECT_THAT(texts_of(LogAxis({0.002, 0.2}, 0, 600).times(50)),
                ElementsAre("2 ms", "5 ms", "10 ms", "20 ms", "50 ms", "100 ms", "200 ms"));
    EXPECT_THAT(texts_of(LogAxis({1, 2e5}, 0, 600).times(50)),
                AllOf(Contains("10 s"), Contains("10 min"), Contains("1 h"), Contains("10 h"), Not(Contains("2 s"))));
    EXPECT_THAT(texts_of(LogAxis({100 * 86400.0}, 0, 600).times(50)), ElementsAre("50 d", "100 d", "200 d"));
}

TEST(LogAxis, HasPercents) {
    EXPECT_THAT(texts_of(LogAxis({0.01, 0.2}, 300, 0).percents(18)), ElementsAre("1 %", "2 %", "5 %", "10 %", "20 %"));
    EXPECT_THAT(texts_of(LogAxis({1e-6, 0.1}, 300, 0).percents(18)),
                ElementsAre("1e-4 %", "1e-3 %", "0.01 %", "0.1 %", "1 %", "10 %"))
        << "fewer where there is less room";
}

TEST(LogAxis, TicksKeepTheirDistanceWhateverTheRange) {
    constexpr double apart = 20;
    for (const double largest : {1.0, 1.001, 30.0, 1e4, 1e12, 1e150, 1e300})
        for (const double smallest : {1.0, 1e-3, 1e-200, 5e-324}) {
            const LogAxis axis({smallest, largest}, 40, 640);
            for (const auto& ticks : {axis.times(apart), axis.percents(apart)}) {
                EXPECT_GE(ticks.size(), 2U) << smallest << " to " << largest;
                for (std::size_t k = 0; k < ticks.size(); ++k) {
                    const double at = axis.at_log10(ticks[k].log10);
                    EXPECT_TRUE(at > 40 - 1e-3 && at < 640 + 1e-3) << ticks[k].text;
                    if (k == 0) continue;
                    EXPECT_GE(at - axis.at_log10(ticks[k - 1].log10), apart - 1e-6) << ticks[k].text;
                }
            }
        }
}

TEST(LogAxis, IsLogarithmicFromEndToEnd) {
    const LogAxis axis({1, 100}, 0, 200);
    EXPECT_NEAR(axis.at(10), 100, 1e-9) << "the middle";
    EXPECT_NEAR(axis.at(100) - axis.at(10), axis.at(10) - axis.at(1), 1e-9);
    EXPECT_GT(axis.at(1), 0);
    EXPECT_LT(axis.at(100), 200);
}

TEST(LabelPlaces, AreBesideTheirMarksAndOverlapNothing) {
    LabelObstacles obstacles{{}, {}, {0, 0, 600, 300}};
    // Pairs that are closer to each other than a label is wide, and a mark in a corner.
    for (const PicturePoint at : {PicturePoint{100, 100}, PicturePoint{115, 105}, PicturePoint{300, 200},
                                  PicturePoint{300, 215}, PicturePoint{593, 7}})
        obstacles.marks.push_back({at.x - 6, at.y - 6, at.x + 6, at.y + 6});
    const std::vector<PictureBox> places = label_places(obstacles, std::vector<double>(5, 50.0), 12);
    for (std::size_t k = 0; k < places.size(); ++k) {
        EXPECT_NEAR(shared_area(places[k], obstacles.frame), 50.0 * 12, 1e-6) << k;
        EXPECT_LT(std::hypot(places[k].centre().x - obstacles.marks[k].centre().x,
                             places[k].centre().y - obstacles.marks[k].centre().y),
                  45)
            << k;
        for (std::size_t other = 0; other < places.size(); ++other) {
            EXPECT_EQ(shared_area(places[k], obstacles.marks[other]), 0) << k << ", mark " << other;
            if (other == k) continue;
            EXPECT_EQ(shared_area(places[k], places[other]), 0) << k << ", label " << other;
        }
    }
}

TEST(PictureOfATrade, HasAMarkForEachSettingAndALineForTheBestOnes) {
    const std::string svg = trade_picture(valve());
    EXPECT_THAT(svg, testing::StartsWith("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"720\""));
    EXPECT_EQ(count_of(svg, "<g class=\"mark\">"), 4U) << "no repeat";
    EXPECT_EQ(count_of(svg, "class=\"label\""), 4U);
    EXPECT_EQ(count_of(svg, "class=\"tolerance\""), 3U);
    EXPECT_EQ(count_of(svg, "class=\"reference\""), 2U) << "in the plot and in the legend";
    const std::string front = svg.substr(svg.find("class=\"front\" points=\""));
    EXPECT_EQ(count_of(front.substr(0, front.find(" fill=")), ","), 3U) << "three corners";
    for (const char* part :
         {">valve</text>", ">error over processor time of 1.2 s simulated</text>", ">0.4 mm</text>", ">0.2 mm</text>",
          ">0.14 mm</text>", ">draft</text>", ">standard</text>", ">fine</text>", ">1 %</text>", ">5 %</text>",
          ">10 %</text>", ">1 min</text>", "<title>0.1414 mm, fine: 5.0 min, error 2 % of flux</title>"})
        EXPECT_THAT(svg, HasSubstr(part));
    EXPECT_THAT(svg, Not(HasSubstr("Not shown")));
}

TEST(PictureOfATrade, FillsTheMarksOfTheBestOnesOnly) {
    TradeFacts trade = valve();
    const auto hollow = [&] { return count_of(trade_picture(trade), "fill=\"#ffffff\" stroke=\"#009e73\""); };
    EXPECT_EQ(hollow(), 1U);
    trade.front = {0};
    EXPECT_EQ(hollow(), 2U);
}

TEST(PictureOfATrade, NeedsNothingElseAndNothingInItIsMarkup) {
    TradeFacts trade = valve();
    trade.name = "<script>alert('name')</script>\"&\a";
    trade.settings[0].error_is_of = "</title><script>alert('of')</script>";
    trade.settings.push_back(setting(1e-4, fine, no_value, 0.01));
    trade.settings.back().is_reference_given = true;
    trade.settings.back().run = "<script>alert('run')</script>";
    const std::string svg = trade_picture(trade);
    EXPECT_THAT(svg, AllOf(Not(HasSubstr("<script")), HasSubstr("&lt;script&gt;alert(&#39;name&#39;)"),
                           HasSubstr("&lt;/title&gt;&lt;script&gt;alert(&#39;of"),
                           HasSubstr("Compared with the run in &lt;script&gt;alert(&#39;run")));
    for (const char* from : {"href", "url(", "@import", "<style", "<foreignObject", "<image", "\a"})
        EXPECT_THAT(svg, Not(HasSubstr(from)));
    trade.name = std::string(500, 'n');
    EXPECT_THAT(trade_picture(trade), HasSubstr("nnn ...</text>"));
}

TEST(PictureOfATrade, CountsWhatHasNoPlace) {
    TradeFacts trade = valve();
    trade.settings[0].cost = no_value;
    trade.settings[1].error = no_value;
    trade.settings[2].cost = 0;
    trade.front = {3};
    std::string svg = trade_picture(trade);
    EXPECT_EQ(count_of(svg, "<g class=\"mark\">"), 1U);
    EXPECT_THAT(svg, HasSubstr("Not shown: 3 settings without a processor time or an error."));
    EXPECT_THAT(svg, Not(HasSubstr(">draft</text>"))) << "the legend has what is shown";
    trade.settings[3].has_ended = false;
    trade.settings[3].error = trade.settings[3].cost = no_value;
    svg = trade_picture(trade);
    EXPECT_EQ(count_of(svg, "<g class=\"mark\">"), 0U);
    EXPECT_THAT(svg, AllOf(HasSubstr("Not shown: 4 settings"), Not(HasSubstr("nan")), Not(HasSubstr("inf"))));
}

TEST(PictureOfATrade, AnErrorOf0IsAtTheLowerEdge) {
    TradeFacts trade = valve();
    trade.settings[3].error = 0;
    const std::string svg = trade_picture(trade);
    EXPECT_EQ(count_of(svg, "<g class=\"mark\">"), 4U);
    EXPECT_THAT(svg, AllOf(HasSubstr("At the lower edge: an error of 0."), HasSubstr("error 0 % of flux"),
                           Not(HasSubstr("nan")), Not(HasSubstr("inf"))));
    EXPECT_THAT(trade_picture(valve()), Not(HasSubstr("lower edge")));
}

TEST(PictureOfATrade, OfOnePointOrEqualOnesOrFarOnesHasAxes) {
    TradeFacts trade = valve();
    for (TradeFacts::Setting& each : trade.settings) each.cost = 60;
    EXPECT_THAT(trade_picture(trade), AllOf(HasSubstr(">1 min</text>"), Not(HasSubstr("nan"))));
    for (TradeFacts::Setting& each : trade.settings) each.error = 0.03;
    EXPECT_EQ(count_of(trade_picture(trade), "<g class=\"mark\">"), 4U);
    trade.settings.resize(1);
    trade.front = {0};
    trade.reference.reset();
    EXPECT_EQ(count_of(trade_picture(trade), "<g class=\"mark\">"), 1U);
    trade = valve();
    trade.settings[0].cost = 1e-300;
    trade.settings[1].cost = 1e300;
    trade.settings[2].error = 1e300;
    trade.settings[3].error = 1e-320;
    EXPECT_THAT(trade_picture(trade), AllOf(Not(HasSubstr("nan")), Not(HasSubstr("inf"))));
    EXPECT_LT(trade_picture(trade).size(), 100'000U);
}

TEST(PictureOfATrade, WithoutSpacingIsLabelledByLevel) {
    TradeFacts trade = valve();
    trade.settings.resize(3);
    trade.front = {0, 1};
    trade.reference.reset();
    trade.settings[1].spacing = trade.settings[2].spacing = trade.settings[0].spacing = 0;
    const std::string svg = trade_picture(trade);
    EXPECT_EQ(count_of(svg, ">draft</text>"), 2U) << "at the mark and in the legend";
    EXPECT_THAT(svg, AllOf(HasSubstr("<title>draft: 7 s, error 20 % of flux</title>"), Not(HasSubstr(" mm<"))));
}

TEST(PictureOfATrade, HasAllSpacingsInOneUnit) {
    TradeFacts trade = valve();
    for (TradeFacts::Setting& each : trade.settings) each.spacing /= 4;
    const std::string svg = trade_picture(trade), html = trade_section(trade);
    EXPECT_THAT(svg, AllOf(HasSubstr(">0.1 mm</text>"), HasSubstr(">0.05 mm</text>"), HasSubstr(">0.035 mm</text>"),
                           HasSubstr("<title>0.03535 mm, fine: ")));
    EXPECT_THAT(html, AllOf(HasSubstr("<th scope=\"row\">0.03535 mm</th>"), HasSubstr("For 5 %: 0.03535 mm, fine, ")));
}

TEST(PictureOfATrade, OfTooManySettingsHasNoLabels) {
    TradeFacts trade = valve();
    trade.settings.resize(20'000, trade.settings[1]);
    trade.settings[4].is_repeat = false;
    const std::string svg = trade_picture(trade);
    EXPECT_EQ(count_of(svg, "<g class=\"mark\">"), 20'000U);
    EXPECT_EQ(count_of(svg, "class=\"label\""), 0U);
    EXPECT_THAT(svg, HasSubstr("Too many settings to label them."));
}

TEST(SectionOfATrade, HasPictureTableAndCommands) {
    TradeFacts trade = valve();
    trade.set_in_all = {"run.threads=1"};
    TradeFacts::Setting& failed = trade.settings.emplace_back(setting(8e-4, draft, no_value, no_value));
    failed.has_ended = false;
    failed.failure = "particle 12 <flew> away";
    const std::string html = trade_section(trade);
    EXPECT_THAT(html, AllOf(HasSubstr("<section id=\"trade\""), HasSubstr("<svg "), HasSubstr("</svg>")));
    const auto row = [](const std::string& cells) { return "<tr><th scope=\"row\">" + cells + "</td></tr>"; };
    EXPECT_THAT(html, HasSubstr(row("0.4 mm</th><td>draft</td><td>7 s</td><td>20 %</td><td>flux</td><td>"
                                    "no other is cheaper and as good")));
    EXPECT_THAT(html, HasSubstr(row("0.2 mm</th><td>fine</td><td>90 s</td><td>7 %</td><td>flux</td><td>")));
    EXPECT_THAT(html, HasSubstr("<td>the reference; no other is cheaper and as good</td>"));
    EXPECT_THAT(html, HasSubstr("<td>repeat, for the scatter</td>"));
    EXPECT_THAT(html, HasSubstr("<td>failed</td><td></td><td></td><td>particle 12 &lt;flew&gt; away</td>"));
    EXPECT_THAT(html,
                HasSubstr("For 1 %: not reachable: the smallest error is 2 %, in flux, and repeats scatter by 1.5 %."));
    EXPECT_THAT(html,
                HasSubstr("For 5 %: 0.1414 mm, fine, with an error of 2 % up to 1.2 s of 4.8 s; the whole scene takes "
                          "about 20.0 min of one processor."));
    EXPECT_THAT(
        html, HasSubstr("For 10 %: 0.2 mm, standard, with an error of 6 % up to 1.2 s of 4.8 s; the whole scene takes "
                        "about 4.0 min"));
    EXPECT_THAT(html, HasSubstr("The runs end at 1.2 s of 4.8 s: what happens later was not measured"));
    EXPECT_THAT(html,
                HasSubstr("<code>dmp run cases/valve --set run.threads=1 --set &#39;particles.spacing=&quot;0.0002 "
                          "m&quot;&#39; --set &#39;quality=&quot;standard&quot;&#39;</code>"));
}

TEST(SectionOfATrade, WithoutErrorsSaysSo) {
    TradeFacts trade = valve();
    for (TradeFacts::Setting& each : trade.settings) each.error = no_value;
    trade.front.clear();
    EXPECT_EQ(count_of(trade_section(trade), "not reachable: no error is known."), 3U);
}

TEST(ErrorText, HasTwoDigits) {
    EXPECT_EQ(error_text(0.0321), "3.2 %");
    EXPECT_EQ(error_text(0.996), "100 %");
    EXPECT_EQ(error_text(1.5), "150 %");
    EXPECT_EQ(error_text(no_value), "not known");
}

/// The folder of a study with a trade.json.
class FolderOfATrade : public testing::Test {
  protected:
    FolderOfATrade() {
        StudyFacts facts;
        facts.runs = 2;
        write_study_facts(folder_.path(), facts);
        for (const auto& [run, level, cost, error] :
             {std::tuple("a", "draft", 10.0, 0.1), std::tuple("b", "fine", 20.0, 0.004)})
            json_["settings"].push_back({{"run", run},
                                         {"set", {std::string("quality=\"") + level + "\""}},
                                         {"spacing_m", 2e-4},
                                         {"level", level},
                                         {"is_repeat", false},
                                         {"failure", ""},
                                         {"processor_s", cost},
                                         {"error", error},
                                         {"error_is_of", "flux"}});
        json_["scene"] = "scene.toml";
        json_["simulated_s"] = json_["duration_s"] = 2.0;
        json_["reference"] = "b";
        json_["front"] = {"a", "b"};
        json_["levels"] = levels;
        write();
    }
    void write() const { write_file(folder_.path() / trade_file_name, json_.dump()); }
    [[nodiscard]] std::string page() const {
        write_study_report(folder_.path());
        return read_file(folder_.path() / report_file_name);
    }
    [[nodiscard]] std::string error() const {
        return text_thrown<InputError>([&] { write_trade_picture(folder_.path()); });
    }

    TemporaryFolder folder_;
    nlohmann::json json_;
};

TEST_F(FolderOfATrade, LeavesAPictureAndASectionAtTheTopOfThePage) {
    write_trade_picture(folder_.path());
    const std::string svg = read_file(folder_.path() / trade_picture_name);
    EXPECT_THAT(svg, HasSubstr(">scene.toml</text>")) << "without a name the scene's path";
    EXPECT_EQ(count_of(svg, "<g class=\"mark\">"), 2U);
    const std::string text = page();
    EXPECT_THAT(text,
                AllOf(HasSubstr(svg), HasSubstr("<a href=\"#trade\">Cost and error</a>"),
                      HasSubstr("For 1 %: 0.2 mm, fine, with an error of 0.4 %; the whole scene takes about 20 s")));
    EXPECT_LT(text.find("id=\"trade\""), text.find("id=\"what\""));
    std::filesystem::remove(folder_.path() / trade_file_name);
    EXPECT_THAT(page(), Not(HasSubstr("Cost and error")));
}

TEST_F(FolderOfATrade, MayLackWhatIsNotKnown) {
    for (auto& each : json_["settings"]) each["processor_s"] = each["error"] = nullptr;
    json_["front"] = nlohmann::json::array();
    json_.erase("simulated_s");
    write();
    EXPECT_THAT(page(), AllOf(HasSubstr("Not shown: 2 settings"), HasSubstr("<td>not known</td><td>not known</td>"),
                              HasSubstr(">error over processor time</text>")));
    for (auto& each : json_["settings"]) each.erase("error");
    write();
    EXPECT_THAT(page(), HasSubstr("<td>not run to its end</td>"));
}

TEST_F(FolderOfATrade, DamageIsNamedWithItsPlace) {
    const nlohmann::json whole = json_;
    const std::vector<std::tuple<std::string, nlohmann::json, std::string>> damaged{
        {"/settings", "many", "'settings' is not a list"},
        {"/settings/1/error", "small", "'settings[1].error' is not a number"},
        {"/settings/1/error", -0.1, "'settings[1].error' is not 0 or more"},
        {"/settings/0/processor_s", -1, "'settings[0].processor_s' is not 0 or more"},
        {"/settings/0/spacing_m", -1, "'settings[0].spacing_m' is not 0 or more"},
        {"/settings/0/level", "perfect", "'settings[0].level' is not one of its levels"},
        {"/front/0", "c", "'front[0]' is not the run of one of its settings"},
        {"/reference", "c", "'reference' is not the run of one of its settings"}};
    for (const auto& [place, value, said] : damaged) {
        json_ = whole;
        json_[nlohmann::json::json_pointer(place)] = value;
        write();
        EXPECT_THAT(error(), AllOf(HasSubstr("trade.json"), HasSubstr(said)));
        EXPECT_THROW(write_study_report(folder_.path()), InputError) << said;
    }
    json_ = whole;
    json_.erase("settings");
    write();
    EXPECT_THAT(error(), AllOf(HasSubstr("trade.json"), HasSubstr("'settings' is not there")));
    write_file(folder_.path() / trade_file_name, "{\n\"settings\": [");
    EXPECT_THAT(error(), AllOf(HasSubstr("trade.json:2"), HasSubstr("not valid JSON")));
}

}  // namespace
}  // namespace dmp::tests::report_trade_tests
