// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/sweep_table.hpp"

#include <algorithm>
#include <utility>

#include "base/csv.hpp"
#include "base/errors.hpp"
#include "base/nearest_name.hpp"
#include "cli/terminal.hpp"
#include "postproc/tables.hpp"
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
std::size_t column_of(const study::Result& result, const MeasureSeries& measures) {
    const auto found = std::ranges::find(measures.names, result.column_name());
    if (found != measures.names.end()) return static_cast<std::size_t>(found - measures.names.begin());
    const std::string start = *result.measure + "_";
    std::vector<std::string> columns;
    for (const std::string& name : measures.names)
        if (name.starts_with(start)) columns.push_back(name.substr(start.size()));
    const SourceLocation& where = result.column.given() ? result.column.location : result.measure.location;
    if (columns.empty())
        throw InputError(where, "measures.csv has no column '" + result.column_name() + "'",
                         "its columns are " + quoted_list(measures.names));
    throw InputError(
        where,
        "result '" + *result.name + "': the columns of measure '" + *result.measure + "' are " + quoted_list(columns),
        "write column = \"" + columns.front() + "\" or another of them");
}

SweepRow::Result result_of(const study::Result& result, const MeasureSeries& measures) {
    const std::size_t column = column_of(result, measures);
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

std::string one_line(const Error& error) {
    const std::string where = error.where().text();
    return (where.empty() ? "" : where + ": ") + error.problem();
}

}  // namespace

SweepRow finished_row(const study::Study& study, const study::Point& point, const fs::path& folder) {
    SweepRow row = row_of(point);
    if (study.results.empty()) return row;
    try {
        const MeasureSeries measures = read_measures_csv(folder);
        for (const study::Result& result : study.results) row.results.push_back(result_of(result, measures));
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
    for (std::size_t begin = 0; begin < output.size();) {
        const std::size_t end = std::min(output.find('\n', begin), output.size());
        const std::string line = output.substr(begin, end - begin);
        begin = end + 1;
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

std::string SweepTable::text() const {
    const std::vector<std::string> known_units = units();
    std::string text = "run";
    for (const study::VariedKey& key : study_.keys()) text += "," + csv_cell(csv_heading(*key.key, key.unit));
    for (std::size_t k = 0; k < known_units.size(); ++k)
        text += "," + csv_cell(csv_heading(*study_.results[k].name, known_units[k]));
    text += ",exit_code,error\n";
    for (const auto& row : rows_) {
        if (!row) continue;
        std::string error = row->error;
        text += row->run;
        for (const std::string& value : row->values) text += "," + csv_cell(value);
        for (std::size_t k = 0; k < known_units.size(); ++k) {
            text += ",";
            if (row->results.empty()) continue;
            const auto& [value, unit] = row->results[k];
            if (unit == known_units[k])
                text += csv_number(value);
            else
                error =
                    "result '" + *study_.results[k].name + "' is in " + unit + ", that of others in " + known_units[k];
        }
        text += "," + std::to_string(row->exit_code) + "," + csv_cell(error) + "\n";
    }
    return text;
}

}  // namespace dmp::cli
