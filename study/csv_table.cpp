// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "study/csv_table.hpp"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "base/csv.hpp"
#include "base/nearest_name.hpp"
#include "base/safe_file.hpp"
#include "base/text_lines.hpp"
#include "scene/value_types.hpp"

namespace dmp::study {

namespace {

/// Around it.
std::string without_spaces(const std::string& text) {
    const auto first = text.find_first_not_of(" \t"), last = text.find_last_not_of(" \t");
    return first == std::string::npos ? "" : text.substr(first, last - first + 1);
}

}  // namespace

CsvTable::CsvTable(const std::string& file, const std::string& asked_by, const SourceLocation& location,
                   const std::string& relative_to, const std::string& wanted)
    : heading_{file, 1, 1} {
    if (!std::filesystem::is_regular_file(file))
        throw InputError(location, asked_by + ": there is no file '" + file + "'",
                         "give a CSV file relative to the folder of " + relative_to);
    const std::vector<std::string> lines = text_lines(read_file(file));
    if (lines.empty())
        throw InputError(heading_, "the table is empty", "write a heading '" + wanted + "' and a line for each point");
    for (const std::string& cell : csv_cells(lines.front())) headings_.push_back(without_spaces(cell));
    for (std::size_t i = 1; i < lines.size(); ++i) {
        if (lines[i].empty()) continue;
        Row row{csv_cells(lines[i]), {file, static_cast<int>(i) + 1, 1}};
        if (row.cells.size() != headings_.size())
            throw InputError(
                row.location,
                "found " + std::to_string(row.cells.size()) + " values, expected " + std::to_string(headings_.size()),
                "give each line a value for each column of the heading");
        rows_.push_back(std::move(row));
    }
    if (rows_.empty())
        throw InputError(heading_, "the table has a heading only", "write a line for each point below it");
}

CsvTable::Column CsvTable::column(const std::string& name, const std::string& what) const {
    std::vector<std::string> names;
    for (const std::string& heading : headings_) names.push_back(name_and_unit(heading).first);
    const auto found = std::ranges::find(names, name);
    if (found == names.end())
        throw InputError(heading_, "the table has no column '" + name + "', " + what,
                         "its columns are " + quoted_list(names) + ": write the heading as '" + name + " [UNIT]'");
    const auto index = static_cast<std::size_t>(found - names.begin());
    Column column{name, name_and_unit(headings_[index]).second, index, {}};
    if (column.unit == "1") column.unit.clear();
    if (!column.unit.empty()) column.dimension = parse_quantity({"1 " + column.unit, heading_, {}}).dimension;
    return column;
}

void CsvTable::need_dimension(const Column& column, const Dimension& wanted) const {
    if (column.dimension == wanted) return;
    const std::string unit = wanted.si_unit();
    throw InputError(heading_,
                     "'" + column.name + "' is " + column.dimension.name_with_article() + " here, expected " +
                         wanted.name_with_article(),
                     unit.empty() ? "write plain numbers, without a unit"
                                  : "give it in " + unit + ", or another unit of the same quantity");
}

double CsvTable::number(const Row& row, const Column& column) {
    const std::string& cell = row.cells[column.index];
    const std::string text = column.unit.empty() ? cell : cell + " " + column.unit;
    return parse_quantity({text, row.location, {}}).si;
}

Dimension dimension_of(const std::string& unit) {
    return unit.empty() || unit == "1" ? Dimension{} : parse_quantity({"1 " + unit, {}, {}}).dimension;
}

}  // namespace dmp::study
