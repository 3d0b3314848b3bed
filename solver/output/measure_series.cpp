// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/output/measure_series.hpp"

#include "base/errors.hpp"

namespace dmp::solver {

void archive_series(Archive& file, MeasureSeries& series) {
    std::vector<double> values;
    for (const auto& row : series.rows) values.insert(values.end(), row.begin(), row.end());
    file("measures/time", series.time);
    file("measures/values", values);
    if (!file.loading()) return;
    const std::size_t columns = series.names.size();
    if (values.size() != columns * series.time.size())
        throw InputError("the checkpoint's measures are not those of the scene", "start the run anew");
    series.rows.clear();
    for (std::size_t row = 0; row < series.time.size(); ++row)
        series.rows.emplace_back(values.begin() + static_cast<std::ptrdiff_t>(row * columns),
                                 values.begin() + static_cast<std::ptrdiff_t>((row + 1) * columns));
}

}  // namespace dmp::solver
