// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "study/reference_points.hpp"

#include <algorithm>
#include <filesystem>

#include "base/csv.hpp"
#include "base/nearest_name.hpp"
#include "base/safe_file.hpp"
#include "base/text_lines.hpp"
#include "scene/value_types.hpp"
#include "study/measure_columns.hpp"
#include "study/reduce.hpp"
#include "study/varied_value.hpp"

namespace dmp::study {

namespace {

namespace fs = std::filesystem;

/// A column of the file.
struct Column {
    std::string name, unit;
    std::size_t index = 0;
    Dimension dimension;
};

Column column_called(const std::string& name, const std::string& what, const std::vector<std::string>& headings,
                     const SourceLocation& location) {
    std::vector<std::string> names;
    for (const std::string& heading : headings) names.push_back(name_and_unit(heading).first);
    const auto found = std::ranges::find(names, name);
    if (found == names.end())
        throw InputError(location, "the table has no column '" + name + "', " + what,
                         "its columns are " + quoted_list(names) + ": write the heading as '" + name + " [UNIT]'");
    const auto index = static_cast<std::size_t>(found - names.begin());
    Column column{name, name_and_unit(headings[index]).second, index, {}};
    if (!column.unit.empty()) column.dimension = parse_quantity({"1 " + column.unit, location, {}}).dimension;
    return column;
}

void need_dimension(const Column& column, const Dimension& wanted, const SourceLocation& location) {
    if (column.dimension == wanted) return;
    const std::string unit = wanted.si_unit();
    throw InputError(location,
                     "'" + column.name + "' is " + column.dimension.name_with_article() + " here, expected " +
                         wanted.name_with_article(),
                     unit.empty() ? "write plain numbers, without a unit"
                                  : "give it in " + unit + ", or another unit of the same quantity");
}

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

double number_in(const std::string& cell, const Column& column, bool logarithmic, const SourceLocation& location) {
    const std::string text = column.unit.empty() ? cell : cell + " " + column.unit;
    const double number = parse_quantity({text, location, {}}).si;
    if (logarithmic && !(number > 0))
        throw InputError(location, "'" + column.name + "': " + cell + " has no place on a logarithmic axis",
                         "remove the line, or the axis from the plot's 'log'");
    return number;
}

}  // namespace

Dimension dimension_of(const std::string& unit) {
    return unit.empty() || unit == "1" ? Dimension{} : parse_quantity({"1 " + unit, {}, {}}).dimension;
}

ReferencePoints read_reference(const TomlNode& node, const Plot& plot, const Study& study) {
    ReferencePoints points;
    points.file = {text_not_empty().read(node, "plot.reference"), node.location};
    const std::string file = (fs::path(study.file).parent_path() / *points.file).string();
    if (!fs::is_regular_file(file))
        throw InputError(node.location, "plot.reference: there is no file '" + file + "'",
                         "give a CSV file relative to the folder of the study");
    const std::vector<std::string> lines = text_lines(read_file(file));
    SourceLocation location{file, 1, 1};
    if (lines.empty())
        throw InputError(
            location, "the table is empty",
            "write a heading '" + plot.key + " [UNIT]," + plot.result + " [UNIT]' and a line for each point");
    const std::vector<std::string> headings = csv_cells(lines.front());
    const Column x = column_called(plot.key, "the plot's key", headings, location);
    const Column y = column_called(plot.result, "the plot's result", headings, location);
    const std::vector<VariedKey> keys = study.keys();
    const std::string unit = std::ranges::find(keys, plot.key, [](const VariedKey& key) { return *key.key; })->unit;
    need_dimension(x, dimension_of(unit), location);
    if (const auto wanted = dimension_of_result(plot.result, study)) need_dimension(y, *wanted, location);
    points.y_dimension = y.dimension;
    for (std::size_t i = 1; i < lines.size(); ++i) {
        if (lines[i].empty()) continue;
        location.line = static_cast<int>(i) + 1;
        const std::vector<std::string> cells = csv_cells(lines[i]);
        if (cells.size() != headings.size())
            throw InputError(
                location,
                "found " + std::to_string(cells.size()) + " values, expected " + std::to_string(headings.size()),
                "give each line a value for each column of the heading");
        points.x.push_back(number_in_unit(number_in(cells[x.index], x, plot.log_x, location), unit));
        points.y.push_back(number_in(cells[y.index], y, plot.log_y, location));
    }
    if (points.x.empty())
        throw InputError(location, "the table has a heading only", "write a line for each point below it");
    return points;
}

}  // namespace dmp::study
