// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/sweep/compared_columns.hpp"

#include <algorithm>

#include "study/measure_columns.hpp"

namespace dmp::cli {

std::vector<std::string> common_columns(const std::vector<MeasureSeries>& tables, const Scene& scene,
                                        const std::vector<std::string>& measures) {
    std::vector<std::string> columns;
    for (const std::string& name : tables.front().names) {
        const auto is_of = [&](const std::string& measure) { return study::is_column_of(scene, measure, name); };
        const bool asked = measures.empty() || std::ranges::any_of(measures, is_of);
        const auto has_it = [&](const MeasureSeries& table) {
            return std::ranges::find(table.names, name) != table.names.end();
        };
        if (asked && std::ranges::all_of(tables, has_it) && !study::counts_particles(scene, name))
            columns.push_back(name);
    }
    return columns;
}

study::TimeSeries column_of(const MeasureSeries& table, const std::string& name) {
    const auto at = static_cast<std::size_t>(std::ranges::find(table.names, name) - table.names.begin());
    study::TimeSeries series;
    for (std::size_t i = 0; i < table.rows.size(); ++i) series.add(table.time[i], table.rows[i][at]);
    return series;
}

}  // namespace dmp::cli
