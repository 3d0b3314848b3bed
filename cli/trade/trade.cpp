// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <numeric>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "base/nearest_name.hpp"
#include "cli/commands.hpp"
#include "cli/exit_codes.hpp"
#include "cli/machine.hpp"
#include "cli/output_folder.hpp"
#include "cli/prepare.hpp"
#include "cli/scene_name.hpp"
#include "cli/stop_signals.hpp"
#include "cli/sweep/sweep_dry_run.hpp"
#include "cli/sweep/sweep_folder.hpp"
#include "cli/sweep/sweep_page.hpp"
#include "cli/sweep/sweep_rows.hpp"
#include "cli/sweep/sweep_runs.hpp"
#include "cli/terminal.hpp"
#include "cli/text.hpp"
#include "cli/trade/known_trade.hpp"
#include "cli/trade/trade_budget.hpp"
#include "cli/trade/trade_outcome.hpp"
#include "cli/uses.hpp"
#include "scene/read_scene.hpp"
#include "scene/toml_node.hpp"
#include "study/read_study.hpp"

namespace dmp::cli {

namespace {

namespace fs = std::filesystem;

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

/// A trade as it was asked for.
struct Trade {
    study::TradeScene scene;
    Scene read;           ///< with what is set in all runs
    double duration = 0;  ///< of the scene without --until [s]
    std::optional<double> budget;
    std::vector<double> tolerances;
    study::TradeSettings settings;
};

void check_measures(const Trade& trade, const std::vector<std::string>& asked) {
    std::vector<std::string> names;
    for (const Measure& measure : trade.read.measures) names.push_back(*measure.name);
    for (const std::string& name : asked)
        if (std::ranges::find(names, name) == names.end())
            throw InputError({"--measures", 0, 0}, "the scene has no measure '" + name + "'",
                             "Its measures are " + quoted_list(names) + ".");
}

Trade trade_of(const TradeCommand& command) {
    Trade trade;
    trade.scene = {command.scene, command.overrides};
    trade.tolerances = tolerances_of(command);
    if (!command.budget.empty()) trade.budget = time_of(command.budget, "--budget");
    const Scene scene = read_scene(command.scene, command.overrides);
    trade.duration = *scene.run.duration;
    if (scene.measures.empty())
        throw InputError({scene.file, 0, 0}, "the scene measures nothing by which its runs could be compared",
                         "Add what matters to you (docs/scene/measure.md), at least:\n  [[measure]]\n"
                         "  name = \"kinetic_energy\"\n  kind = \"kinetic_energy\"");
    if (!command.until.empty())
        trade.scene.overrides.push_back(
            fmt::format("run.duration=\"{} s\"", exact_text(time_of(command.until, "--until"))));
    trade.read = read_scene(command.scene, trade.scene.overrides);
    check_measures(trade, command.measures);
    trade.settings = study::trade_settings(trade.scene);
    if (trade.settings.settings.size() < 2)
        throw InputError({scene.file, 0, 0},
                         "there is nothing to trade: its quality levels are the same, and it has no spacing",
                         "Vary a key of it with 'dmp sweep' (docs/studies.md).");
    return trade;
}

/// Throws where the budget has ended before two settings could be compared.
void need_enough_budget(const TradeOutcome& outcome, const TradeBudget& budget, const Trade& trade,
                        const TypedCommand& typed) {
    if (outcome.is_known()) return;
    std::string would = "not even one run has ended within it";
    std::vector<std::size_t> cheapest(std::min<std::size_t>(3, trade.settings.settings.size()));
    std::iota(cheapest.begin(), cheapest.end(), 0UL);
    if (const auto time = budget.expected(cheapest))
        would = fmt::format("the {} cheapest runs take about {} of one processor's time", cheapest.size(),
                            duration_text(*time));
    throw InputError({"--budget", 0, 0},
                     fmt::format("{} is too little to compare settings: {}", duration_text(*trade.budget), would),
                     "Give more, or a shorter run with --until, and go on:\n  " + typed.with("--resume"));
}

std::string left_text(const Trade& trade, const SweepCounts& counts, const TradeBudget& budget,
                      const TradeOutcome& outcome, const TypedCommand& typed) {
    std::vector<std::size_t> left;
    for (std::size_t index = 0; index < outcome.settings.settings.size(); ++index)
        if (outcome.failures[index].empty() &&
            std::ranges::find(outcome.runs, index, &study::TradeRun::setting) == outcome.runs.end())
            left.push_back(index);
    const auto time = budget.expected(left);
    return fmt::format("\n{} not done within {}{}. With a larger --budget, go on:\n  {}\n",
                       count_text(counts.left(), "run"), duration_text(*trade.budget),
                       time ? "; they would take about " + duration_text(*time) + " of one processor" : "",
                       typed.with("--resume"));
}

/// Tells and writes what is known when no more is run now. Returns the exit code.
int close(const TradeCommand& command, const Trade& trade, const SweepRows& rows, const TradeBudget& budget,
          const StopSignals& signals) {
    const fs::path& folder = rows.folder().path();
    TradeOutcome outcome = trade_outcome(folder, trade.read, trade.settings, rows.points(), command.measures);
    outcome.scene_path = command.scene;
    outcome.identity = study::trade_identity(trade.scene);
    outcome.common = command.overrides;
    outcome.until = *trade.read.run.duration;
    outcome.duration = trade.duration;
    const std::string page = write_sweep_page(folder, rows.study(), rows.points());
    if (outcome.is_known()) {
        write_trade(folder, outcome);
        print(trade_text(outcome, trade.tolerances, command.typed.program()));
    }
    Listing list;
    if (!page.empty()) list.add("look", page);
    if (outcome.is_known()) list.add((folder / trade_file_name).string(), "all errors and costs, for programs");
    list.add((folder / "runs").string(), "a folder for each run");
    print(Style(Stream::output).strong("Results") + "\n" + list.text());
    if (signals.flag()) {
        print(fmt::format("\nStopped before its end, by {}. Go on with the same command and --resume.\n  {}\n",
                          signals.name(), command.typed.with("--resume")));
        return signals.exit_code();
    }
    const SweepCounts& counts = rows.counts();
    if (counts.left() > 0) {
        need_enough_budget(outcome, budget, trade, command.typed);
        print(left_text(trade, counts, budget, outcome, command.typed));
    }
    if (!outcome.is_known())
        throw InputError({folder.string(), 0, 0}, "fewer than two settings have come to their end",
                         "results.csv there says why.");
    return exit_done;
}

std::string settings_text(const study::TradeSettings& settings) {
    std::vector<std::vector<std::string>> rows{{"spacing", "quality", "cost", ""}};
    for (const study::TradeSetting& each : settings.settings)
        rows.push_back({each.spacing_text.empty() ? "-" : each.spacing_text, to_string(each.quality),
                        fmt::format("{:.2g}", each.cost), each.is_repeat ? "repeat, for the scatter" : ""});
    return table_text(rows);
}

}  // namespace

int execute(const TradeCommand& command) {
    refuse_several_ranks();
    const Trade trade = trade_of(command);
    const fs::path out = output_folder(command.out, scene_name(trade.read) + "_trade");
    const study::Study study =
        study::parse_study(study::trade_study(trade.scene, trade.settings, out), (out / study_copy_name).string());
    const study::Points points(study);
    std::vector<std::size_t> all(points.size());
    std::iota(all.begin(), all.end(), 0UL);
    SweepSettings settings;
    settings.program = command.typed.program();
    settings.threads = std::max(1, *trade.read.run.threads);
    settings.jobs = runs_at_a_time(command.jobs, settings.threads);
    settings.left_out = study.left_out;
    print(Style(Stream::output).strong(scene_name(trade.read)) + ": " + count_text(all.size(), "setting") + " of " +
          study.scene.file + "\n");
    if (command.dry_run) {
        print(settings_text(trade.settings));
        flush_output();
        print(Style(Stream::output).strong("Dry run") + "\n" +
              cost_text(study, points, {0}, settings.jobs, settings.threads, settings.left_out) +
              "Nothing was written.\n");
        return exit_done;
    }
    const SweepFolder folder(out, {study, points.size(), command.resume, command.overwrite}, command.typed);
    print(folder.note() + fmt::format("Writing to {}, {} at a time on {} each\n\n", folder.path().string(),
                                      settings.jobs, count_text(static_cast<std::size_t>(settings.threads), "thread")));
    flush_output();
    begin_sweep_page(folder.path(), study, points, command.typed);
    const StopSignals signals;
    SweepRows rows(study, points, folder, all);
    const TradeBudget budget(trade.budget, trade.settings, points, folder.path(), settings.jobs, settings.threads);
    settings.may_start = [&](std::size_t index) { return budget.may_start(index); };
    settings.stop_at = budget.end();
    SweepRuns(rows, settings).run(signals);
    return close(command, trade, rows, budget, signals);
}

}  // namespace dmp::cli
