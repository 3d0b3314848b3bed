// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/trade/trade_outcome.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "base/errors.hpp"
#include "base/nearest_name.hpp"
#include "cli/output_folder.hpp"
#include "cli/scene_name.hpp"
#include "cli/sweep/compared_columns.hpp"
#include "cli/sweep/sweep_folder.hpp"
#include "postproc/tables.hpp"
#include "report/trade_facts.hpp"
#include "study/exact_values.hpp"
#include "study/front.hpp"
#include "study/measure_columns.hpp"

namespace dmp::cli {

namespace fs = std::filesystem;

namespace {

/// velocity_x, velocity_y and velocity_z are of one vector, all others of their own. What the scene says that they
/// should be is taken at the times of the finest run.
std::vector<study::TradeColumn> trade_columns(const std::vector<std::string>& columns, const Scene& scene,
                                              const std::vector<double>& times) {
    std::map<std::string, std::size_t> numbers;
    std::vector<study::TradeColumn> all;
    for (const std::string& name : columns) {
        study::TradeColumn& column = all.emplace_back();
        column.vector = numbers.emplace(study::vector_of(name), numbers.size()).first->second;
        if (const Reference* reference = study::reference_of(scene, name))
            column.exact = study::exact_series(scene, *reference, times);
    }
    return all;
}

void need_columns(const std::vector<std::string>& columns, const Scene& scene, const std::vector<std::string>& measures,
                  const fs::path& folder) {
    for (const std::string& measure : measures)
        if (std::ranges::none_of(columns, [&](auto& name) { return study::is_column_of(scene, measure, name); }))
            throw InputError({folder.string(), 0, 0}, "the runs have no column of '" + measure + "' in common",
                             "Name other measures with --measures.");
    if (columns.empty())
        throw InputError({folder.string(), 0, 0}, "the runs have no column of measures in common",
                         "Name measures with --measures that all runs have.");
}

/// What trade.json says of runs that have failed: those that a small budget has not begun again. By the run's name.
std::map<std::string, std::string> failures_told(const fs::path& folder) {
    std::map<std::string, std::string> failures;
    if (!fs::is_regular_file(folder / report::trade_file_name)) return failures;
    try {
        for (const auto& setting : report::read_trade_facts(folder / report::trade_file_name).settings)
            failures[setting.run] = setting.failure;
    } catch (const Error&) {
        failures.clear();  // it is damaged, and written anew
    }
    return failures;
}

/// Processor time of a run's steps: making its particles counts for the first run of a spacing alone, and does not
/// grow with the time that is simulated. Without that, of its processes.
double cost_of(const fs::path& folder, const std::map<std::string, RunTime>& times, const std::string& name) {
    if (const auto end = postproc::read_run_end(folder); end && end->processor_s > 0) return end->processor_s;
    const auto time = times.find(name);
    return time == times.end() ? study::no_number : time->second.processor_s;
}

}  // namespace

fs::path default_trade_folder(const Scene& scene) { return output_folder("", scene_name(scene) + "_trade"); }

bool TradeOutcome::may_be_advised(const study::TradeSetting& setting) const {
    const bool is_shortened = until < duration * (1 - 1e-9);
    return setting.role == study::TradeRole::candidate &&
           (!is_shortened || setting.level.rank >= settings.own_level.rank);
}

std::vector<std::size_t> TradeOutcome::front() const {
    std::vector<study::CostAndError> tried;
    for (std::size_t r = 0; r < runs.size(); ++r)
        tried.push_back({runs[r].cost, may_be_advised(setting(runs[r])) ? errors.runs[r].error : study::no_number});
    return study::front_of(tried);
}

TradeOutcome trade_outcome(const fs::path& folder, const Scene& scene, const study::TradeSettings& settings,
                           const study::Points& points, const TradeComparison& comparison) {
    TradeOutcome outcome;
    outcome.settings = settings;
    const auto failures = earlier_failures(folder / sweep_results_name);
    auto told = failures_told(folder);
    const auto times = run_times(folder / sweep_timing_name);
    std::vector<MeasureSeries> tables;
    std::size_t comparable = 0;
    for (std::size_t index = 0; index < points.size(); ++index) {
        const std::string& name = outcome.names.emplace_back(points.at(index).name);
        const auto failure = failures.find(name);
        outcome.failures.push_back(failure == failures.end() ? told[name] : failure->second.error);
        const FolderContents contents = contents_of(run_folder(folder, name));
        outcome.begun.push_back(contents.kind == FolderContents::Kind::unfinished && contents.has_checkpoint);
        if (contents.kind != FolderContents::Kind::finished) continue;
        try {
            tables.push_back(postproc::read_measures_csv(run_folder(folder, name)));
        } catch (const Error& error) {
            outcome.failures.back() = one_line(error);
            continue;
        }
        outcome.failures.back().clear();  // at most, a number of the study's page could not be had
        outcome.runs.push_back({index, cost_of(run_folder(folder, name), times, name), {}});
        comparable += settings.settings[index].role == study::TradeRole::candidate ? 1 : 0;
    }
    if (comparable < 2) return outcome;
    if (comparison.reference) {
        outcome.runs.push_back({outcome.settings.settings.size(), study::no_number, {}});
        outcome.settings.settings.push_back(comparison.reference->setting);
        outcome.names.push_back(comparison.reference->folder.string());
        outcome.failures.emplace_back();
        outcome.begun.push_back(false);
        tables.push_back(comparison.reference->measures);
    }
    outcome.columns = common_columns(tables, scene, comparison.measures);
    need_columns(outcome.columns, scene, comparison.measures, folder);
    for (const std::string& name : outcome.columns) {
        const auto& names = tables.front().names;
        outcome.units.push_back(
            tables.front().units[static_cast<std::size_t>(std::ranges::find(names, name) - names.begin())]);
        for (std::size_t r = 0; r < tables.size(); ++r) outcome.runs[r].measures.push_back(column_of(tables[r], name));
    }
    outcome.errors =
        study::trade_errors(outcome.settings, outcome.runs, trade_columns(outcome.columns, scene, tables.back().time));
    return outcome;
}

}  // namespace dmp::cli
