// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/trade/trade_outcome.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "base/errors.hpp"
#include "base/nearest_name.hpp"
#include "cli/output_folder.hpp"
#include "cli/sweep/sweep_folder.hpp"
#include "postproc/tables.hpp"
#include "study/front.hpp"
#include "study/measure_columns.hpp"

namespace dmp::cli {

namespace fs = std::filesystem;

namespace {

/// Columns that all tables have, in the order of the first one.
std::vector<std::string> common_columns(const std::vector<MeasureSeries>& tables, const Scene& scene,
                                        const std::vector<std::string>& measures) {
    std::vector<std::string> columns;
    for (const std::string& name : tables.front().names) {
        const auto is_of = [&](const std::string& measure) { return study::is_column_of(scene, measure, name); };
        const bool asked = measures.empty() || std::ranges::any_of(measures, is_of);
        const auto has_it = [&](const MeasureSeries& table) {
            return std::ranges::find(table.names, name) != table.names.end();
        };
        if (asked && std::ranges::all_of(tables, has_it)) columns.push_back(name);
    }
    return columns;
}

/// For each column a number of its vector: velocity_x, velocity_y and velocity_z are of one, all others of their own.
std::vector<std::size_t> vectors_of(const std::vector<std::string>& columns) {
    std::map<std::string, std::size_t> numbers;
    std::vector<std::size_t> all;
    for (const std::string& name : columns) {
        const bool is_component = name.ends_with("_x") || name.ends_with("_y") || name.ends_with("_z");
        const std::string vector = is_component ? name.substr(0, name.size() - 1) : name;
        all.push_back(numbers.emplace(vector, numbers.size()).first->second);
    }
    return all;
}

study::TimeSeries column(const MeasureSeries& table, const std::string& name) {
    const auto at = static_cast<std::size_t>(std::ranges::find(table.names, name) - table.names.begin());
    study::TimeSeries series;
    for (std::size_t i = 0; i < table.rows.size(); ++i) series.add(table.time[i], table.rows[i][at]);
    return series;
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

}  // namespace

std::vector<std::size_t> TradeOutcome::front() const {
    std::vector<study::CostAndError> tried;
    for (std::size_t r = 0; r < runs.size(); ++r)
        tried.push_back({runs[r].cost, setting(runs[r]).is_repeat ? study::no_number : errors.runs[r].error});
    return study::front_of(tried);
}

TradeOutcome trade_outcome(const fs::path& folder, const Scene& scene, const study::TradeSettings& settings,
                           const study::Points& points, const std::vector<std::string>& measures) {
    TradeOutcome outcome;
    outcome.settings = settings;
    const auto failures = earlier_failures(folder / sweep_results_name);
    const auto times = run_times(folder / sweep_timing_name);
    std::vector<MeasureSeries> tables;
    std::size_t comparable = 0;
    for (std::size_t index = 0; index < points.size(); ++index) {
        const std::string& name = outcome.names.emplace_back(points.at(index).name);
        const auto failure = failures.find(name);
        outcome.failures.push_back(failure == failures.end() ? "" : failure->second.error);
        const fs::path run = run_folder(folder, name);
        if (contents_of(run).kind != FolderContents::Kind::finished) continue;
        try {
            tables.push_back(postproc::read_measures_csv(run));
        } catch (const Error& error) {
            outcome.failures.back() = one_line(error);
            continue;
        }
        const auto time = times.find(name);
        outcome.runs.push_back({index, time == times.end() ? study::no_number : time->second.processor_s, {}});
        comparable += settings.settings[index].is_repeat ? 0 : 1;
    }
    if (comparable < 2) return outcome;
    outcome.columns = common_columns(tables, scene, measures);
    need_columns(outcome.columns, scene, measures, folder);
    for (const std::string& name : outcome.columns) {
        const auto& names = tables.front().names;
        outcome.units.push_back(
            tables.front().units[static_cast<std::size_t>(std::ranges::find(names, name) - names.begin())]);
        for (std::size_t r = 0; r < tables.size(); ++r) outcome.runs[r].measures.push_back(column(tables[r], name));
    }
    outcome.errors = study::trade_errors(settings, outcome.runs, vectors_of(outcome.columns));
    return outcome;
}

}  // namespace dmp::cli
