// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/trade/trade_request.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "base/errors.hpp"
#include "base/nearest_name.hpp"
#include "cli/sweep/study_options.hpp"
#include "cli/text.hpp"
#include "scene/quantity.hpp"
#include "scene/read_scene.hpp"
#include "study/exact_values.hpp"

namespace dmp::cli {

namespace {

std::vector<double> tolerances_of(const TradeCommand& command) {
    if (command.tolerances.empty()) return {0.01, 0.05, 0.1};
    std::vector<double> all;
    for (const std::string& text : command.tolerances) all.push_back(tolerance_of(text));
    std::ranges::sort(all);
    return all;
}

void check_measures(const Scene& scene, const std::vector<std::string>& asked) {
    std::vector<std::string> names;
    for (const Measure& measure : scene.measures) names.push_back(*measure.name);
    for (const std::string& name : asked)
        if (std::ranges::find(names, name) == names.end())
            throw InputError({"--measures", 0, 0}, "the scene has no measure '" + name + "'",
                             "Its measures are " + quoted_list(names) + ".");
}

}  // namespace

TradeRequest trade_request(const TradeCommand& command) {
    TradeRequest trade;
    trade.scene = {command.scene, command.overrides};
    trade.identity = study::trade_identity(trade.scene);
    trade.tolerances = tolerances_of(command);
    if (!command.budget.empty()) trade.budget = time_of(command.budget, "--budget");
    const Scene scene = read_scene(command.scene, command.overrides);
    trade.duration = *scene.run.duration;
    trade.added = measures_to_add(scene);
    for (std::string& each : overrides_that_add(trade.added)) trade.scene.overrides.push_back(std::move(each));
    if (!command.until.empty())
        trade.scene.overrides.push_back(
            fmt::format("run.duration=\"{} s\"", exact_text(time_of(command.until, "--until"))));
    trade.read = read_scene(command.scene, trade.scene.overrides);
    check_measures(trade.read, command.measures);
    // A file of one that cannot be read is told before any run.
    for (const Reference& reference : trade.read.references) study::ExactValues(trade.read, reference);
    need_two_rows(trade.read, command.until);
    trade.comparison.measures = command.measures;
    if (!command.reference.empty()) trade.comparison.reference = given_reference(command.reference, trade.read);
    trade.settings = study::trade_settings(trade.scene);
    if (trade.settings.settings.size() < 2)
        throw InputError({scene.file, 0, 0},
                         "there is nothing to trade: its levels are the same, and it has no spacing",
                         "Vary a key of it with 'dmp sweep' (docs/studies.md).");
    return trade;
}

std::string settings_text(const study::TradeSettings& settings) {
    std::vector<std::vector<std::string>> rows{{"spacing", "level", "cost", ""}};
    for (const study::TradeSetting& each : settings.settings)
        rows.push_back({each.spacing_text.empty() ? "-" : each.spacing_text, each.level.text,
                        fmt::format("{:.2g}", each.cost),
                        each.role == study::TradeRole::repeat ? "repeat, for the scatter" : ""});
    return table_text(rows);
}

}  // namespace dmp::cli
