// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "report/trade_facts.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/errors.hpp"
#include "base/number_text.hpp"
#include "report/json_value.hpp"

namespace dmp::report {

namespace {

/// 0 or more; NaN where it is missing or null.
double number_from_0(const JsonValue& json) {
    const double value = json.number();
    if (value < 0) json.fail("0 or more");
    return value;
}

std::size_t level_of(const JsonValue& json, const std::vector<std::string>& levels) {
    const auto found = std::ranges::find(levels, json.text());
    if (found == levels.end()) json.fail("one of its levels");
    return static_cast<std::size_t>(found - levels.begin());
}

TradeFacts::Setting setting_of(const JsonValue& json, const std::vector<std::string>& levels) {
    TradeFacts::Setting setting;
    setting.run = json["run"].text();
    setting.set = json["set"].texts();
    setting.spacing = number_from_0(json["spacing_m"]);
    setting.level = level_of(json["level"], levels);
    setting.is_repeat = json["is_repeat"].truth();
    setting.is_reference_given = json["is_reference_given"].truth();
    setting.failure = json["failure"].text();
    setting.has_ended = json["error"].is_there();
    setting.cost = number_from_0(json["processor_s"]);
    setting.error = number_from_0(json["error"]);
    setting.error_is_of = json["error_is_of"].text();
    return setting;
}

std::size_t setting_named(const TradeFacts& facts, const JsonValue& name) {
    const auto found = std::ranges::find(facts.settings, name.text(), &TradeFacts::Setting::run);
    if (found == facts.settings.end()) name.fail("the run of one of its settings");
    return static_cast<std::size_t>(found - facts.settings.begin());
}

}  // namespace

bool TradeFacts::is_on_front(std::size_t setting) const { return std::ranges::find(front, setting) != front.end(); }

double TradeFacts::largest_spacing() const {
    double largest = 0;
    for (const Setting& each : settings) largest = std::max(largest, each.spacing);
    return largest;
}

std::optional<std::size_t> TradeFacts::cheapest_within(double error) const {
    const auto found = std::ranges::find_if(front, [&](std::size_t each) { return settings[each].error <= error; });
    if (found == front.end()) return {};
    return *found;
}

std::optional<std::size_t> TradeFacts::best() const {
    if (front.empty()) return {};
    return front.back();
}

TradeFacts read_trade_facts(const std::filesystem::path& file) {
    const JsonValue::Json document = read_json_object(file);
    const JsonValue json(&document, file);
    TradeFacts facts;
    facts.scene = json["scene"].text();
    facts.name = json["name"].text();
    if (facts.name.empty()) facts.name = facts.scene;
    facts.set_in_all = json["set_in_all"].texts();
    facts.simulated = number_from_0(json["simulated_s"]);
    facts.duration = number_from_0(json["duration_s"]);
    for (const JsonValue& measure : json["measures"].elements())
        facts.measures.push_back({measure["name"].text(), number_from_0(measure["scatter"])});
    facts.levels = json["levels"].texts();
    if (!json["settings"].is_there()) json["settings"].fail("there");
    for (const JsonValue& setting : json["settings"].elements())
        facts.settings.push_back(setting_of(setting, facts.levels));
    for (const JsonValue& name : json["front"].elements()) facts.front.push_back(setting_named(facts, name));
    if (json["reference"].is_there()) facts.reference = setting_named(facts, json["reference"]);
    return facts;
}

std::string two_digits(double value) {
    return value >= 99.5 && value < 1e5 ? fmt::format("{:.0f}", value) : fmt::format("{:.2g}", value);
}

std::string error_text(double error) { return std::isfinite(error) ? percentage_text(error) : "not known"; }

}  // namespace dmp::report
