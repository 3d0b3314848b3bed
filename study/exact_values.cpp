// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "study/exact_values.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <limits>

#include "scene/measure_columns.hpp"
#include "study/csv_table.hpp"
#include "study/measure_columns.hpp"

namespace dmp::study {

namespace {

/// Of a time: steps add up to it with rounding errors.
constexpr double same_time = 1e-9;

bool is_before(double time, double other) { return time < other - same_time * std::abs(other); }

std::string unit_of_column(const Scene& scene, const Reference& reference) {
    const std::string wanted = reference.column_name();
    for (const MeasureColumn& column : measure_columns(scene, measure_called(scene, reference.measure)))
        if (column.name == wanted) return column.unit;
    throw InputError(reference.measure.location, "there is no column '" + wanted + "'", "read the scene again");
}

TimeSeries read_rows(const Scene& scene, const Reference& reference) {
    const std::string name = reference.column_name();
    const CsvTable table((std::filesystem::path(scene.directory) / *reference.file).string(), "reference.file",
                         reference.file.location, "the scene", "time [s]," + name + " [UNIT]");
    const CsvTable::Column time = table.column("time", "for the times"), value = table.column(name, "of the measure");
    table.need_dimension(time, dimension_of("s"));
    table.need_dimension(value, dimension_of(unit_of_column(scene, reference)));
    TimeSeries rows;
    for (const CsvTable::Row& row : table.rows()) {
        const double at = CsvTable::number(row, time);
        if (!rows.time.empty() && !(at > rows.time.back()))
            throw InputError(row.location, "the time " + row.cells[time.index] + " does not come after the one before",
                             "sort the lines by time, and keep one of each");
        rows.add(at, CsvTable::number(row, value));
    }
    if (rows.time.size() < 2)
        throw InputError(table.rows().front().location, "the table has one line, and a curve needs two",
                         "add lines, or write a constant as a formula");
    return rows;
}

}  // namespace

const Reference* reference_of(const Scene& scene, const std::string& column) {
    const auto found =
        std::ranges::find(scene.references, column, [](const Reference& each) { return each.column_name(); });
    return found == scene.references.end() ? nullptr : &*found;
}

ExactValues::ExactValues(const Scene& scene, const Reference& reference)
    : from_(reference.from),
      until_(reference.until.given() ? *reference.until : std::numeric_limits<double>::infinity()),
      formula_(reference.formula) {
    if (reference.file.given()) rows_ = read_rows(scene, reference);
}

double ExactValues::at(double time) const {
    if (is_before(time, from_) || (std::isfinite(until_) && is_before(until_, time))) return no_number;
    if (rows_.time.empty()) return formula_(time);
    if (is_before(time, rows_.time.front()) || is_before(rows_.time.back(), time)) return no_number;
    const double inside = std::clamp(time, rows_.time.front(), rows_.time.back());
    const auto after = std::ranges::upper_bound(rows_.time, inside);
    const auto next = std::min<std::ptrdiff_t>(std::distance(rows_.time.begin(), after),
                                               static_cast<std::ptrdiff_t>(rows_.time.size()) - 1);
    return value_between(rows_, static_cast<std::size_t>(next - 1), inside);
}

TimeSeries exact_series(const Scene& scene, const Reference& reference, const std::vector<double>& times) {
    const ExactValues values(scene, reference);
    TimeSeries series;
    for (const double time : times) series.add(time, values.at(time));
    return series;
}

std::vector<SeriesError> errors_of(const std::vector<std::string>& columns, const std::vector<TimeSeries>& series,
                                   const std::vector<TimeSeries>& exact) {
    std::vector<SeriesError> errors;
    for (std::size_t c = 0; c < columns.size(); ++c) {
        SeriesSize size;
        for (std::size_t other = 0; other < columns.size(); ++other)
            if (vector_of(columns[other]) == vector_of(columns[c])) size = size.with(size_of(exact[other]));
        errors.push_back(error_of(series[c], exact[c], size));
    }
    return errors;
}

}  // namespace dmp::study
