// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/trade/trade_request.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "base/errors.hpp"
#include "base/nearest_name.hpp"
#include "base/number_text.hpp"
#include "cli/text.hpp"
#include "cli/trade/known_trade.hpp"
#include "scene/quantity.hpp"
#include "scene/read_scene.hpp"
#include "scene/toml_node.hpp"
#include "study/exact_values.hpp"

namespace dmp::cli {

namespace {

/// A time that is not 0.
double time_of(const std::string& text, const char* option) {
    const SourceLocation location{option, 0, 0};
    const double time = read_quantity(text, "s", location);
    if (!(time > 0)) throw InputError(location, "'" + text + "' is no time above 0", "Give one such as \"20 min\".");
    return time;
}

std::vector<double> tolerances_of(const TradeCommand& command) {
    if (command.tolerances.empty()) return {0.01, 0.05, 0.1};
    std::vector<double> all;
    for (const std::string& text : command.tolerances) all.push_back(tolerance_of(text));
    std::ranges::sort(all);
    return all;
}

void add_conserved_measures(TradeRequest& trade, const Scene& scene) {
    trade.added.emplace_back("kinetic_energy");
    if (scene.species.size() == 1) trade.added.emplace_back("amount");
    for (const std::string& kind : trade.added)
        trade.scene.overrides.push_back("measure." + kind + ".kind=" + toml_quoted(kind));
}

void check_measures(const Scene& scene, const std::vector<std::string>& asked) {
    std::vector<std::string> names;
    for (const Measure& measure : scene.measures) names.push_back(*measure.name);
    for (const std::string& name : asked)
        if (std::ranges::find(names, name) == names.end())
            throw InputError({"--measures", 0, 0}, "the scene has no measure '" + name + "'",
                             "Its measures are " + quoted_list(names) + ".");
}

void need_two_rows(const Scene& scene, const std::string& until) {
    const double every = *scene.output.measure_every > 0 ? *scene.output.measure_every : *scene.output.every / 4;
    if (*scene.run.duration >= 2 * every) return;
    throw InputError({until.empty() ? scene.file : "--until", 0, 0},
                     fmt::format("runs to {} have fewer than two rows of measures, which are written every {}",
                                 duration_text(*scene.run.duration), duration_text(every)),
                     "Run longer, or set output.measure_every.");
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
    if (scene.measures.empty()) add_conserved_measures(trade, scene);
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
