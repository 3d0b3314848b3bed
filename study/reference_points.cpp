// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "study/reference_points.hpp"

#include <algorithm>
#include <filesystem>

#include "scene/value_types.hpp"
#include "study/csv_table.hpp"
#include "study/measure_columns.hpp"
#include "study/reduce.hpp"
#include "study/varied_value.hpp"

namespace dmp::study {

namespace {

/// Of the results, in SI units; none where only runs can tell.
std::optional<Dimension> dimension_of_result(const std::string& name, const Study& study) {
    for (const Result& result : study.results) {
        if (*result.name != name) continue;
        for (const Measure& measure : study.scene.measures) {
            if (*measure.name != *result.measure) continue;
            const std::string unit = unit_of(result.reduce, columns_of(*measure.kind).unit);
            if (*result.reduce == Reduction::first_crossing || !columns_of(*measure.kind).unit.empty())
                return dimension_of(unit);
        }
    }
    return {};
}

double number_in(const CsvTable::Row& row, const CsvTable::Column& column, bool logarithmic) {
    const double number = CsvTable::number(row, column);
    if (logarithmic && !(number > 0))
        throw InputError(row.location,
                         "'" + column.name + "': " + row.cells[column.index] + " has no place on a logarithmic axis",
                         "remove the line, or the axis from the plot's 'log'");
    return number;
}

}  // namespace

ReferencePoints read_reference(const TomlNode& node, const Plot& plot, const Study& study) {
    ReferencePoints points;
    points.file = {text_not_empty().read(node, "plot.reference"), node.location};
    const CsvTable table((std::filesystem::path(study.file).parent_path() / *points.file).string(), "plot.reference",
                         node.location, "the study", plot.key + " [UNIT]," + plot.result + " [UNIT]");
    const CsvTable::Column x = table.column(plot.key, "the plot's key");
    const CsvTable::Column y = table.column(plot.result, "the plot's result");
    const std::vector<VariedKey> keys = study.keys();
    const std::string unit = std::ranges::find(keys, plot.key, [](const VariedKey& key) { return *key.key; })->unit;
    table.need_dimension(x, dimension_of(unit));
    if (const auto wanted = dimension_of_result(plot.result, study)) table.need_dimension(y, *wanted);
    points.y_dimension = y.dimension;
    for (const CsvTable::Row& row : table.rows()) {
        points.x.push_back(number_in_unit(number_in(row, x, plot.log_x), unit));
        points.y.push_back(number_in(row, y, plot.log_y));
    }
    return points;
}

}  // namespace dmp::study
