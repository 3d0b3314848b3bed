// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// limits.json, its picture, and the section of the page.
#include <limits>
#include <string>
#include <tuple>
#include <vector>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "base/safe_file.hpp"
#include "report/limits_facts.hpp"
#include "report/limits_picture.hpp"
#include "report/limits_section.hpp"
#include "report/log_axis.hpp"
#include "report/study_facts.hpp"
#include "report/write_report.hpp"
#include "tests/modules.hpp"
#include "tests/unit/temporary_files.hpp"
#include "tests/unit/thrown.hpp"

namespace dmp::tests::report_limits_tests {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

constexpr double no_value = std::numeric_limits<double>::quiet_NaN();

std::size_t count_of(const std::string& text, const std::string& part) {
    std::size_t count = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size())) ++count;
    return count;
}

LimitsFacts::Dial dial(const std::string& name, bool is_up, LimitWay way) {
    LimitsFacts::Dial made;
    made.name = name;
    made.what = "what it is";
    made.is_up = is_up;
    made.own = 2;
    made.unit = "m/s";
    made.clean = is_up ? 4 : 1;
    made.clean_run = "0004_00000000";
    if (way != LimitWay::none_found) made.bad = is_up ? 5 : 0.5;
    made.way = way;
    made.distance = no_value;
    return made;
}

LimitsFacts valve() {
    LimitsFacts limits;
    limits.scene = "cases/valve";
    limits.name = "valve";
    limits.version = "1";
    limits.set_in_all = {"run.threads=1"};
    limits.simulated = 0.02;
    limits.duration = 4;
    limits.tolerance = 0.05;
    limits.own_run = "0001_00000000";
    limits.columns = {{"flux", 0.01, 0.05, true}, {"gap", no_value, 0.05, false}};
    limits.dials = {dial("numerics.sound_speed", false, LimitWay::departs), dial("a", true, LimitWay::breaks),
                    dial("a", false, LimitWay::none_found), dial("b", true, LimitWay::refused)};
    limits.dials[0].distance = 0.12;
    limits.dials[0].column = "flux";
    limits.dials[1].stated = 4.5;
    limits.dials[1].stated_by = "a formula";
    limits.dials[1].cause = "the fluid is <faster> than its sound";
    limits.dials[1].likely_causes = "the step";
    limits.dials[1].keys = {"a", "c"};
    limits.dials[1].set = {"a=\"4 m/s\""};
    limits.notes = {"The repeat <breaks>."};
    return limits;
}

class FolderOfLimits : public testing::Test {
  protected:
    [[nodiscard]] LimitsFacts read_back(const LimitsFacts& limits) const {
        write_limits_facts(folder_.path(), limits);
        return read_limits_facts(folder_.path() / limits_file_name);
    }
    [[nodiscard]] nlohmann::json json() const {
        return nlohmann::json::parse(read_file(folder_.path() / limits_file_name));
    }
    [[nodiscard]] std::string error_with(const nlohmann::json& json) const {
        write_file(folder_.path() / limits_file_name, json.dump());
        return text_thrown<InputError>([&] { write_limits_picture(folder_.path()); });
    }
    TemporaryFolder folder_;
};

TEST_F(FolderOfLimits, ReadsWhatItHasWritten) {
    const LimitsFacts limits = valve(), again = read_back(limits);
    EXPECT_EQ(limits_picture(again), limits_picture(limits));
    EXPECT_EQ(limits_section(again), limits_section(limits));
    EXPECT_THAT(again.notes, ElementsAre("The repeat <breaks>."));
    EXPECT_THAT(again.set_in_all, ElementsAre("run.threads=1"));
    EXPECT_THAT(again.dials[1].keys, ElementsAre("a", "c"));
    EXPECT_THAT(again.dials[1].set, ElementsAre("a=\"4 m/s\""));
    EXPECT_EQ(again.dials[1].cause, limits.dials[1].cause);
    EXPECT_EQ(again.tolerance, 0.05);
    EXPECT_EQ(json()["dials"][1]["margin"], 2.0) << "on the safe side: last clean over own";
    EXPECT_EQ(json()["dials"][1]["stated_margin"], 2.25);
    EXPECT_EQ(json()["dials"][0]["margin"], 2.0) << "downwards: own over clean";
    EXPECT_EQ(json()["dials"][2]["margin"], 2.0) << "at least";
    EXPECT_TRUE(json()["dials"][2]["first_bad"].is_null());
    EXPECT_TRUE(json()["measures"][1]["scatter"].is_null());
    EXPECT_EQ(json()["dials"][0]["distance"], 0.12);
    EXPECT_FALSE(json()["dials"][1].contains("distance"));
}

TEST_F(FolderOfLimits, HasNoMarginBeforeTheEndOfADialAndNoBadValueAtABound) {
    LimitsFacts limits = valve();
    limits.dials[1].way = LimitWay::not_measured;
    limits.dials[3].bad.reset();
    limits.dials[3].clean = limits.dials[3].bound = 5;
    const LimitsFacts again = read_back(limits);
    EXPECT_EQ(json()["dials"][1]["first_bad"], 5) << "as far as it is known";
    EXPECT_TRUE(json()["dials"][1]["margin"].is_null());
    EXPECT_TRUE(json()["dials"][3]["first_bad"].is_null());
    EXPECT_EQ(json()["dials"][3]["bound"], 5);
    EXPECT_EQ(json()["dials"][3]["margin"], 2.5);
    EXPECT_THAT(limits_section(again), HasSubstr("<td>5 m/s</td><td>-</td><td>2.5</td><td>refused beyond 5 m/s</td>"));
}

TEST_F(FolderOfLimits, SaysWhatIsWrongWithADamagedFile) {
    write_limits_facts(folder_.path(), valve());
    const nlohmann::json whole = json();
    for (const auto& [key, value, said] :
         {std::tuple("own", nlohmann::json(nullptr), "'dials[1].own' is not there"),
          std::tuple("own", nlohmann::json(-1), "'dials[1].own' is not above 0"),
          std::tuple("first_bad", nlohmann::json("5"), "'dials[1].first_bad' is not a number"),
          std::tuple("ends", nlohmann::json("well"), "'dials[1].ends' is not one of the ways")}) {
        nlohmann::json damaged = whole;
        damaged["dials"][1][key] = value;
        EXPECT_THAT(error_with(damaged), AllOf(HasSubstr("limits.json"), HasSubstr(said))) << said;
    }
    nlohmann::json without = whole;
    without.erase("dials");
    EXPECT_THAT(error_with(without), HasSubstr("'dials' is not there"));
}

TEST(PictureOfLimits, HasARowForEachValueAndAMarkForEachSide) {
    const std::string svg = limits_picture(valve());
    EXPECT_EQ(count_of(svg, "<g class=\"dial\">"), 4U);
    EXPECT_EQ(count_of(svg, ">a</text>"), 1U) << "up and down in one row";
    EXPECT_EQ(count_of(svg, "class=\"stated\""), 1U);
    EXPECT_EQ(count_of(svg, "class=\"own\""), 1U);
    for (const char* part : {">valve</text>", ">where its models end, by runs of 0.02 s</text>", ">breaks</text>",
                             ">measures depart</text>", ">0.5</text>", ">1</text>", ">2</text>",
                             "<title>numerics.sound_speed down: departs: 12 % in flux; own 2 m/s, stated -, last clean "
                             "1 m/s, first bad 0.5 m/s</title>"})
        EXPECT_THAT(svg, HasSubstr(part));
    EXPECT_THAT(svg, Not(HasSubstr("Not measured")));
    EXPECT_THAT(svg, AllOf(Not(HasSubstr("nan")), Not(HasSubstr("inf"))));
}

TEST(PictureOfLimits, NothingInItIsMarkup) {
    LimitsFacts limits = valve();
    limits.name = limits.dials[0].name = limits.dials[0].column = limits.dials[0].cause = "<script>alert('x')</script>";
    EXPECT_THAT(limits_picture(limits), Not(HasSubstr("<script")));
    EXPECT_THAT(limits_section(limits), Not(HasSubstr("<script")));
}

TEST(PictureOfLimits, OfNothingMeasuredHasAxes) {
    LimitsFacts limits = valve();
    for (LimitsFacts::Dial& each : limits.dials) {
        each.way = LimitWay::not_measured;
        each.clean = each.bad = each.stated = {};
    }
    EXPECT_THAT(limits_picture(limits),
                AllOf(HasSubstr("Not measured to the end: 4."), HasSubstr(">1</text>"), Not(HasSubstr("nan"))));
    limits.dials.clear();
    EXPECT_THAT(limits_picture(limits), AllOf(HasSubstr("</svg>"), Not(HasSubstr("nan"))));
}

TEST(SectionOfLimits, HasTheTableOfTheDialsAndOfTheMeasures) {
    const std::string html = limits_section(valve());
    EXPECT_THAT(html, AllOf(HasSubstr("<section id=\"limits\""), HasSubstr("<svg ")));
    EXPECT_THAT(html,
                HasSubstr("<th scope=\"row\">a</th><td>up</td><td>2 m/s</td><td>4.5 m/s, 2.25 times</td><td>4 m/s</td>"
                          "<td>5 m/s</td><td>2</td><td>breaks</td><td>what it is; stated: a formula; the step</td>"));
    EXPECT_THAT(html, HasSubstr("<h3>Measures</h3>\n<p>The repeat &lt;breaks&gt;.</p>"));
    EXPECT_THAT(html, HasSubstr("<td>departs: 12 % in flux</td>"));
    EXPECT_THAT(html, HasSubstr("<th scope=\"row\">flux</th><td>1 %</td><td>5 %</td>"));
    EXPECT_THAT(html, HasSubstr("<th scope=\"row\">gap</th><td>not known</td><td>not counted"));
}

TEST_F(FolderOfLimits, SayOnThePageHowManyAreMeasured) {
    StudyFacts facts;
    facts.runs = 100;
    write_study_facts(folder_.path(), facts);
    const auto page_with = [&](const LimitsFacts& limits) {
        write_limits_facts(folder_.path(), limits);
        write_study_report(folder_.path());
        return read_file(folder_.path() / report_file_name);
    };
    LimitsFacts limits = valve();
    EXPECT_THAT(page_with(limits), AllOf(HasSubstr("Complete: 4 limits measured, by 0 runs"),
                                         HasSubstr("<h2 id=\"limits-heading\">Limits</h2>")));
    limits.dials[2].way = LimitWay::not_measured;
    EXPECT_THAT(page_with(limits), HasSubstr("Not complete: 3 of 4 limits measured, by 0 runs"));
    limits.dials[2].way = LimitWay::no_measure;
    EXPECT_THAT(page_with(limits), HasSubstr("Complete: 3 limits measured, by 0 runs"));
}

TEST(LogAxis, HasPlainNumbers) {
    std::vector<std::string> texts;
    for (const LogTick& tick : LogAxis({0.5, 20}, 0, 600).numbers(30)) texts.push_back(tick.text);
    EXPECT_THAT(texts, ElementsAre("0.5", "1", "2", "5", "10", "20"));
}

}  // namespace
}  // namespace dmp::tests::report_limits_tests
