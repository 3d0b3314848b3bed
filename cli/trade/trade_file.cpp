// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// trade.json, for programs, and its picture.
#include <algorithm>
#include <cmath>
#include <map>

#include <nlohmann/json.hpp>

#include "base/safe_file.hpp"
#include "cli/trade/trade_outcome.hpp"
#include "cli/version.hpp"
#include "report/trade_picture.hpp"

namespace dmp::cli {

namespace {

using Json = nlohmann::ordered_json;

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json of_column(const TradeOutcome& outcome, std::size_t c) {
    const study::ColumnTrust& trust = outcome.errors.columns[c];
    return {{"name", outcome.columns[c]},       {"unit", outcome.units[c]},
            {"scatter", number(trust.scatter)}, {"error_of_reference", number(trust.reference)},
            {"order", number(trust.order)},     {"why_no_order", trust.why_not}};
}

Json of_setting(const TradeOutcome& outcome, std::size_t index) {
    const study::TradeSetting& setting = outcome.settings.settings[index];
    Json json{{"run", outcome.names[index]},
              {"set", outcome.settings.overrides(setting)},
              {"spacing_m", setting.spacing},
              {"level", setting.level.text},
              {"is_repeat", setting.role == study::TradeRole::repeat},
              {"is_reference_given", setting.role == study::TradeRole::reference},
              {"failure", outcome.failures[index]}};
    const auto run = std::ranges::find(outcome.runs, index, &study::TradeRun::setting);
    if (run == outcome.runs.end()) return json;
    const study::RunError& error = outcome.errors.runs[static_cast<std::size_t>(run - outcome.runs.begin())];
    json["processor_s"] = number(run->cost);
    json["error"] = number(error.error);
    if (std::isfinite(error.error)) json["error_is_of"] = outcome.columns[error.column];
    for (std::size_t c = 0; c < outcome.columns.size(); ++c) {
        const study::SeriesError& distance = error.distance[c];
        json["distance"][outcome.columns[c]] = {{"whole", number(distance.whole)},
                                                {"end", number(distance.end)},
                                                {"peak", number(distance.peak)},
                                                {"integral", number(distance.integral)}};
    }
    return json;
}

/// Of all settings, the least accurate one first.
std::vector<std::string> levels_of(const study::TradeSettings& settings) {
    std::map<double, std::string> levels;
    for (const study::TradeSetting& setting : settings.settings) levels[setting.level.rank] = setting.level.text;
    std::vector<std::string> texts;
    for (const auto& [rank, level] : levels) texts.push_back(level);
    return texts;
}

}  // namespace

void write_trade(const std::filesystem::path& folder, const TradeOutcome& outcome) {
    Json json;
    json["scene"] = outcome.scene_path;
    json["name"] = outcome.scene_name;
    json["identity"] = outcome.identity;
    json["version"] = build_facts().version;
    json["set_in_all"] = outcome.common;
    json["simulated_s"] = outcome.until;
    json["duration_s"] = outcome.duration;
    json["levels"] = levels_of(outcome.settings);
    json["reference"] = outcome.names[outcome.runs[outcome.errors.reference].setting];
    for (const char* list : {"measures", "settings", "front"}) json[list] = Json::array();
    for (std::size_t c = 0; c < outcome.columns.size(); ++c) json["measures"].push_back(of_column(outcome, c));
    for (std::size_t index = 0; index < outcome.settings.settings.size(); ++index)
        json["settings"].push_back(of_setting(outcome, index));
    for (const std::size_t r : outcome.front()) json["front"].push_back(outcome.names[outcome.runs[r].setting]);
    write_file(folder / trade_file_name, json.dump(2) + "\n");
    write_trade_picture(folder);
}

}  // namespace dmp::cli
