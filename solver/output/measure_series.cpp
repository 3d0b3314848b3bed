// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/output/measure_series.hpp"

#include <algorithm>
#include <limits>
#include <sstream>

#include "base/errors.hpp"

namespace dmp::solver {

namespace {

/// Names and units of the columns, a line each.
std::string columns_text(const MeasureSeries& series) {
    std::string text;
    for (std::size_t k = 0; k < series.names.size(); ++k) text += series.names[k] + " [" + series.units[k] + "]\n";
    return text;
}

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

}  // namespace

void archive_series(Archive& file, MeasureSeries& series) {
    const std::string now = columns_text(series);
    std::string then = now;
    file("measures/columns", then);
    std::vector<double> values;
    for (const auto& row : series.rows) values.insert(values.end(), row.begin(), row.end());
    file("measures/time", series.time);
    file("measures/values", values);
    if (!file.loading()) return;
    const std::vector<std::string> columns = lines_of(now), stored = lines_of(then);
    if (values.size() != stored.size() * series.time.size())
        throw InputError("the checkpoint's measures do not fit their columns", "start the run anew");
    series.rows.assign(series.time.size(),
                       std::vector<double>(columns.size(), std::numeric_limits<double>::quiet_NaN()));
    for (std::size_t column = 0; column < columns.size(); ++column) {
        const auto from = static_cast<std::size_t>(std::ranges::find(stored, columns[column]) - stored.begin());
        if (from == stored.size()) continue;  // nobody has measured it until now
        for (std::size_t row = 0; row < series.time.size(); ++row)
            series.rows[row][column] = values[row * stored.size() + from];
    }
}

}  // namespace dmp::solver
