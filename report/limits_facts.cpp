// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "report/limits_facts.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/number_text.hpp"
#include "base/safe_file.hpp"
#include "base/unlisted_value.hpp"
#include "report/json_value.hpp"
#include "report/trade_facts.hpp"

namespace dmp::report {

namespace {

using Json = JsonValue::Json;

std::optional<double> ratio(const std::optional<double>& value, const LimitsFacts::Dial& dial) {
    if (!value || !(*value > 0) || !(dial.own > 0)) return {};
    return dial.is_up ? *value / dial.own : dial.own / *value;
}

Json number(const std::optional<double>& value) {
    return value && std::isfinite(*value) ? Json(*value) : Json(nullptr);
}

Json json_of(const LimitsFacts::Dial& dial) {
    Json json{{"dial", dial.name},
              {"keys", dial.keys},
              {"what", dial.what},
              {"side", dial.is_up ? "up" : "down"},
              {"is_physical", dial.is_physical},
              {"unit", dial.unit},
              {"own", dial.own},
              {"stated", number(dial.stated)},
              {"stated_by", dial.stated_by},
              {"last_clean", number(dial.clean)},
              {"last_clean_run", dial.clean_run},
              {"first_bad", number(dial.bad)},
              {"first_bad_run", dial.bad_run},
              {"bound", number(dial.bound)},
              {"ends", to_string(dial.way)},
              {"cause", dial.cause},
              {"likely_causes", dial.likely_causes},
              {"margin", number(dial.margin())},
              {"stated_margin", number(dial.stated_margin())}};
    if (dial.way == LimitWay::departs) {
        json["distance"] = number(dial.distance);
        json["column"] = dial.column;
    }
    json["set"] = dial.set;
    return json;
}

/// Above 0; none where it is missing or null.
std::optional<double> value_of(const JsonValue& json) {
    const double value = json.number();
    if (std::isnan(value)) return {};
    if (!(value > 0) || !std::isfinite(value)) json.fail("above 0");
    return value;
}

LimitWay way_of(const JsonValue& json) {
    const auto& names = enum_names<LimitWay>;
    const auto found = std::ranges::find(names, json.text());
    if (found == names.end()) json.fail("one of the ways in which a dial ends");
    return static_cast<LimitWay>(found - names.begin());
}

LimitsFacts::Dial dial_of(const JsonValue& json) {
    LimitsFacts::Dial dial;
    dial.name = json["dial"].text();
    dial.keys = json["keys"].texts();
    dial.what = json["what"].text();
    dial.is_up = json["side"].text() != "down";
    dial.is_physical = json["is_physical"].truth();
    dial.unit = json["unit"].text();
    const auto own = value_of(json["own"]);
    if (!own) json["own"].fail("there");
    dial.own = *own;
    dial.stated = value_of(json["stated"]);
    dial.stated_by = json["stated_by"].text();
    dial.clean = value_of(json["last_clean"]);
    dial.clean_run = json["last_clean_run"].text();
    dial.bad = value_of(json["first_bad"]);
    dial.bad_run = json["first_bad_run"].text();
    dial.bound = value_of(json["bound"]);
    dial.way = way_of(json["ends"]);
    dial.cause = json["cause"].text();
    dial.likely_causes = json["likely_causes"].text();
    dial.distance = json["distance"].number();
    dial.column = json["column"].text();
    dial.set = json["set"].texts();
    return dial;
}

}  // namespace

std::optional<double> LimitsFacts::Dial::margin() const {
    const bool has_end = way != LimitWay::not_measured && way != LimitWay::no_measure;
    return has_end ? ratio(clean, *this) : std::nullopt;
}

std::optional<double> LimitsFacts::Dial::stated_margin() const { return ratio(stated, *this); }

std::string limit_value_text(const std::optional<double>& value, const std::string& unit) {
    if (!value) return "-";
    return dmp::number_text(*value, 4) + (unit.empty() ? "" : " " + unit);
}

std::string limit_way_text(const LimitsFacts::Dial& dial) {
    switch (dial.way) {
        case LimitWay::not_measured:
            return "not measured";
        case LimitWay::none_found:
            return "none found";
        case LimitWay::departs:
            if (!std::isfinite(dial.distance)) return "departs: no values of " + dial.column;
            return "departs: " + error_text(dial.distance) + " in " + dial.column;
        case LimitWay::breaks:
            return "breaks";
        case LimitWay::refused:
            return dial.bound ? "refused beyond " + limit_value_text(dial.bound, dial.unit) : "refused";
        case LimitWay::no_measure:
            return "no measure counts";
    }
    unlisted_value(dial.way);
}

std::string margin_text(const std::optional<double>& margin) { return margin ? dmp::number_text(*margin, 3) : "-"; }

std::string stated_text(const std::string& stated, const std::optional<double>& margin) {
    return margin ? stated + ", " + margin_text(margin) + " times" : stated;
}

void write_limits_facts(const std::filesystem::path& folder, const LimitsFacts& limits) {
    Json json{{"scene", limits.scene},
              {"name", limits.name},
              {"version", limits.version},
              {"set_in_all", limits.set_in_all},
              {"simulated_s", limits.simulated},
              {"duration_s", limits.duration},
              {"tolerance", limits.tolerance},
              {"own_run", limits.own_run},
              {"notes", limits.notes}};
    for (const char* list : {"measures", "dials"}) json[list] = Json::array();
    for (const LimitsFacts::Column& column : limits.columns)
        json["measures"].push_back({{"name", column.name},
                                    {"scatter", number(column.scatter)},
                                    {"allowed", number(column.allowed)},
                                    {"counts", column.counts}});
    for (const LimitsFacts::Dial& dial : limits.dials) json["dials"].push_back(json_of(dial));
    write_file(folder / limits_file_name, json.dump(2) + "\n");
}

LimitsFacts read_limits_facts(const std::filesystem::path& file) {
    const Json document = read_json_object(file);
    const JsonValue json(&document, file);
    LimitsFacts limits;
    limits.scene = json["scene"].text();
    limits.name = json["name"].text();
    if (limits.name.empty()) limits.name = limits.scene;
    limits.version = json["version"].text();
    limits.set_in_all = json["set_in_all"].texts();
    limits.simulated = json["simulated_s"].number();
    limits.duration = json["duration_s"].number();
    limits.tolerance = json["tolerance"].number();
    limits.own_run = json["own_run"].text();
    limits.notes = json["notes"].texts();
    for (const JsonValue& column : json["measures"].elements())
        limits.columns.push_back(
            {column["name"].text(), column["scatter"].number(), column["allowed"].number(), column["counts"].truth()});
    if (!json["dials"].is_there()) json["dials"].fail("there");
    for (const JsonValue& dial : json["dials"].elements()) limits.dials.push_back(dial_of(dial));
    return limits;
}

}  // namespace dmp::report
