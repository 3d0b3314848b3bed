// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/sweep/sweep_table.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <csignal>
#include <cstring>
#include <utility>

#include <fmt/format.h>

#include "base/csv.hpp"
#include "base/errors.hpp"
#include "base/nearest_name.hpp"
#include "base/safe_file.hpp"
#include "base/text_lines.hpp"
#include "cli/terminal.hpp"
#include "cli/text.hpp"
#include "postproc/tables.hpp"
#include "study/measure_columns.hpp"
#include "study/read_result.hpp"
#include "study/reduce.hpp"

namespace dmp::cli {

namespace fs = std::filesystem;

namespace {

SweepRow row_of(const study::Point& point) {
    SweepRow row;
    row.run = point.name;
    for (const study::VariedValue& value : point.values) row.values.push_back(value.cell);
    return row;
}

/// The column of a result in measures.csv. Throws InputError where there is none.
std::size_t column_of(const study::Result& result, const Scene& scene, const MeasureSeries& measures) {
    const auto found = std::ranges::find_if(measures.names, [&](const std::string& name) {
        return name == result.column_name() && study::is_column_of(scene, *result.measure, name);
    });
    if (found != measures.names.end()) return static_cast<std::size_t>(found - measures.names.begin());
    const std::string start = *result.measure + "_";
    std::vector<std::string> columns;
    for (const std::string& name : measures.names)
        if (name.starts_with(start) && study::is_column_of(scene, *result.measure, name))
            columns.push_back(name.substr(start.size()));
    const SourceLocation& where = result.column.given() ? result.column.location : result.measure.location;
    if (columns.empty())
        throw InputError(where, "measures.csv has no column '" + result.column_name() + "'",
                         "its columns are " + quoted_list(measures.names));
    throw InputError(
        where,
        "result '" + *result.name + "': the columns of measure '" + *result.measure + "' are " + quoted_list(columns),
        "write column = \"" + columns.front() + "\" or another of them");
}

/// A window that a run has not reached the end of would give another result than that of the others.
void need_whole_window(const study::Result& result, double end) {
    const double slack = 1e-9 * std::abs(end);
    const auto seconds = [](double time) { return quantity_text(time, "s"); };
    const auto too_short = [&](const SourceLocation& where, const std::string& what) {
        return InputError(where, "result '" + *result.name + "': the run ended at " + seconds(end) + ", " + what,
                          "give a time that all runs reach, or a longer run.duration");
    };
    if (result.until.given() && *result.until > end + slack)
        throw too_short(result.until.location, "before " + seconds(*result.until));
    if (result.from.given() && *result.from > end + slack)
        throw too_short(result.from.location, "before " + seconds(*result.from));
    const double until = result.until.given() ? *result.until : end;
    if (result.period.given() && until - *result.from < *result.period - slack)
        throw too_short(result.period.location,
                        "and the window is shorter than the period of " + seconds(*result.period));
}

SweepRow::Result result_of(const study::Result& result, const Scene& scene, const MeasureSeries& measures, double end) {
    const std::size_t column = column_of(result, scene, measures);
    need_whole_window(result, end);
    study::TimeSeries series{measures.time, {}};
    for (const auto& row : measures.rows) series.value.push_back(row[column]);
    study::Window window;
    if (result.from.given()) window.from = result.from;
    if (result.until.given()) window.until = result.until;
    study::ReductionOptions options;
    if (result.period.given()) options.period = result.period;
    const std::string& unit = measures.units[column];
    if (result.level.given()) options.level = study::level_in(result, unit);
    return {study::reduced(series, result.reduce, window, options), study::unit_of(result.reduce, unit)};
}

}  // namespace

std::string killed_text(int signal) {
    const char* name = strsignal(signal);
    return fmt::format("it was ended by signal {} ({}){}", signal, name == nullptr ? "" : name,
                       signal == SIGKILL ? ", perhaps for lack of memory" : "");
}

std::string one_line(const Error& error) {
    const std::string where = error.where().text();
    return (where.empty() ? "" : where + ": ") + error.problem();
}

SweepRow finished_row(const study::Study& study, const study::Point& point, const fs::path& folder) {
    SweepRow row = row_of(point);
    if (study.results.empty()) return row;
    try {
        const MeasureSeries measures = read_measures_csv(folder);
        const auto run_end = read_run_end(folder);
        const double end = run_end ? run_end->simulated_s : measures.time.empty() ? 0 : measures.time.back();
        for (const study::Result& result : study.results)
            row.results.push_back(result_of(result, study.scene, measures, end));
    } catch (const Error& error) {
        row.results.clear();
        row.error = one_line(error);
    }
    return row;
}

SweepRow failed_row(const study::Point& point, int exit_code, const std::string& output) {
    SweepRow row = row_of(point);
    row.exit_code = exit_code;
    row.error = last_error(output);
    if (row.error.empty()) row.error = "it ended with code " + std::to_string(exit_code) + " and said nothing";
    return row;
}

std::string last_error(const std::string& output) {
    constexpr std::string_view mark = "error: ";
    std::string last, error;
    for (const std::string& line : text_lines(output)) {
        if (line.starts_with(mark)) error = line.substr(mark.size());
        if (line.find_first_not_of(" \t\r") != std::string::npos) last = line;
    }
    return printable(error.empty() ? last : error, false);
}

std::vector<std::string> SweepTable::units() const {
    std::vector<std::string> units(study_.results.size());
    for (const auto& row : rows_)
        for (std::size_t k = 0; row && k < row->results.size(); ++k)
            if (units[k].empty()) units[k] = row->results[k].unit;
    return units;
}

std::vector<std::optional<SweepRow>> SweepTable::rows() const {
    const std::vector<std::string> known_units = units();
    std::vector<std::optional<SweepRow>> settled = rows_;
    for (auto& row : settled) {
        if (!row) continue;
        for (std::size_t k = 0; k < row->results.size(); ++k) {
            const std::string& unit = row->results[k].unit;
            if (unit != known_units[k])
                row->error =
                    "result '" + *study_.results[k].name + "' is in " + unit + ", that of others in " + known_units[k];
        }
    }
    return settled;
}

std::string SweepTable::text() const {
    const std::vector<std::string> known_units = units();
    std::string text = "run";
    for (const study::VariedKey& key : study_.keys()) text += "," + csv_cell(csv_heading(*key.key, key.unit));
    for (std::size_t k = 0; k < known_units.size(); ++k)
        text += "," + csv_cell(csv_heading(*study_.results[k].name, known_units[k]));
    text += ",exit_code,error\n";
    for (const auto& row : rows()) {
        if (!row) continue;
        text += row->run;
        for (const std::string& value : row->values) text += "," + csv_cell(value);
        for (std::size_t k = 0; k < known_units.size(); ++k) {
            text += ",";
            if (row->results.empty()) continue;
            const auto& [value, unit] = row->results[k];
            if (unit == known_units[k]) text += csv_number(value);
        }
        text += "," + std::to_string(row->exit_code) + "," + csv_cell(row->error) + "\n";
    }
    return text;
}

std::map<std::string, RunTime> run_times(const fs::path& file) {
    std::map<std::string, RunTime> times;
    if (!fs::is_regular_file(file)) return times;
    for (const std::string& line : text_lines(read_file(file))) {
        const std::vector<std::string> cells = csv_cells(line);
        if (cells.size() < 3 || cells[0] == "run") continue;
        const auto number = [](const std::string& text) {
            double value = 0;
            std::from_chars(text.data(), text.data() + text.size(), value);
            return value;
        };
        RunTime& time = times[cells[0]];
        time.wall_s += number(cells[1]);
        time.processor_s += number(cells[2]);
    }
    return times;
}

std::map<std::string, EarlierFailure> earlier_failures(const fs::path& file) {
    std::map<std::string, EarlierFailure> failures;
    if (!fs::is_regular_file(file)) return failures;
    std::vector<std::string> lines = text_lines(read_file(file));
    if (!lines.empty()) lines.erase(lines.begin());
    for (const std::string& line : lines) {
        const std::vector<std::string> cells = csv_cells(line);
        if (cells.size() < 3) continue;  // damaged: the run is done again when it is asked for
        int code = 0;
        const std::string& text = cells[cells.size() - 2];
        std::from_chars(text.data(), text.data() + text.size(), code);
        if (code != 0) failures[cells.front()] = {code, cells.back()};
    }
    return failures;
}

}  // namespace dmp::cli
