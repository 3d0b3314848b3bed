// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "mesher/sphere_table.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fstream>
#include <optional>
#include <string_view>

#include "base/nearest_name.hpp"
#include "mesher/uses.hpp"
#include "scene/quantity.hpp"

namespace dmp::mesher {

namespace {

constexpr std::array known{"x", "y", "z", "radius", "vx", "vy", "vz", "wx", "wy", "wz"};

/// What a column's unit is like.
const char* example_of(std::size_t column) { return column < 4 ? "1 mm" : column < 7 ? "1 m/s" : "1 rad/s"; }

/// One cell of a line, without the quotes and spaces around it.
struct Cell {
    std::string text;
    int column = 1;
};

Cell cell_of(const std::string& line, std::size_t begin, std::size_t end) {
    constexpr std::string_view spaces = " \t\r";
    const auto trim = [&] {
        while (begin < end && spaces.find(line[begin]) != std::string_view::npos) ++begin;
        while (end > begin && spaces.find(line[end - 1]) != std::string_view::npos) --end;
    };
    trim();
    if (end - begin >= 2 && line[begin] == '"' && line[end - 1] == '"') {
        ++begin;
        --end;
        trim();
    }
    return {line.substr(begin, end - begin), static_cast<int>(begin) + 1};
}

/// Cells between separators that stand in no quotes.
std::vector<Cell> cells_of(const std::string& line, char separator) {
    std::vector<Cell> cells;
    std::size_t begin = 0;
    bool quoted = false;
    for (std::size_t at = 0; at < line.size(); ++at) {
        if (line[at] == '"') quoted = !quoted;
        if (line[at] != separator || quoted) continue;
        cells.push_back(cell_of(line, begin, at));
        begin = at + 1;
    }
    cells.push_back(cell_of(line, begin, line.size()));
    return cells;
}

/// What separates the cells, by the table's heading: spreadsheets of countries that write 1,5 use semicolons.
char separator_in(const std::string& heading) { return heading.find(';') == std::string::npos ? ',' : ';'; }

/// A column of the table: which of the known ones, and its unit in SI.
struct Column {
    std::size_t known = 0;
    double unit = 1;
};

Column read_heading(const Cell& cell, const SourceLocation& at) {
    const std::size_t open = cell.text.find('[');
    std::string name = cell.text.substr(0, open);
    name.erase(name.find_last_not_of(" \t") + 1);
    const auto* const found = std::ranges::find(known, name);
    if (found == known.end()) {
        const std::vector<std::string> names(known.begin(), known.end());
        const std::string nearest = nearest_name(name, names);
        throw InputError(at, "unknown column '" + name + "'",
                         nearest.empty() ? "a table of spheres has the columns " + quoted_list(names)
                                         : "did you mean '" + nearest + "'?");
    }
    Column column;
    column.known = static_cast<std::size_t>(found - known.begin());
    const Expected expected(example_of(column.known));
    if (open == std::string::npos || cell.text.back() != ']')
        throw InputError(at, "column '" + name + "' has no unit",
                         "write it behind the name: " + name + " [" + expected.unit() + "]");
    const std::string unit = cell.text.substr(open + 1, cell.text.size() - open - 2);
    column.unit = expected.read({"1 " + unit, at, {}}, "column " + name);
    return column;
}

double read_number(const Cell& cell, const SourceLocation& at) {
    double value = 0;
    const char* const end = cell.text.data() + cell.text.size();
    const char* begin = cell.text.data();
    if (begin != end && *begin == '+') ++begin;
    const auto [stop, error] = std::from_chars(begin, end, value);
    if (error != std::errc() || stop != end || !std::isfinite(value))
        throw InputError(at, "found \"" + cell.text + "\", expected a number",
                         cell.text.find(',') == std::string::npos
                             ? "correct the table"
                             : "write 1.5, not 1,5: save the table with points in its numbers");
    return value;
}

/// By known column, the one of the table; none where it has none.
using Positions = std::array<std::optional<std::size_t>, known.size()>;

void need_together(const Positions& places, std::size_t first, const SourceLocation& at, bool must) {
    for (std::size_t k = first; k < first + 3; ++k)
        for (std::size_t other = first; other < first + 3; ++other)
            if (!places.at(k) && (must || places.at(other)))
                throw InputError(at, std::string("the table has no column '") + known.at(k) + "'",
                                 must ? "name the columns in its first line: x [mm], y [mm], z [mm]"
                                      : "give all three components, or none");
}

}  // namespace

SphereTable read_sphere_table(const std::string& file, const SourceLocation& location) {
    std::ifstream stream(file);
    if (!stream.is_open()) throw InputError(location, "'" + file + "' cannot be read", "check the file's name");
    SphereTable table;
    std::vector<Column> columns;
    Positions places{};
    std::string line;
    char separator = ',';
    for (int number = 1; std::getline(stream, line); ++number) {
        // The mark with which Windows' programs begin a text.
        if (number == 1 && line.starts_with("\xEF\xBB\xBF")) line.erase(0, 3);
        const std::size_t begin = line.find_first_not_of(" \t\r");
        if (begin == std::string::npos || line[begin] == '#') continue;
        if (columns.empty()) separator = separator_in(line);
        const std::vector<Cell> cells = cells_of(line, separator);
        const auto at = [&](const Cell& cell) { return SourceLocation{file, number, cell.column}; };
        if (columns.empty()) {
            for (const Cell& cell : cells) {
                columns.push_back(read_heading(cell, at(cell)));
                auto& taken = places.at(columns.back().known);
                if (taken)
                    throw InputError(at(cell),
                                     std::string("column '") + known.at(columns.back().known) + "' stands twice",
                                     "leave one of them out");
                taken = columns.size() - 1;
            }
            need_together(places, 0, SourceLocation{file, number, 1}, true);
            need_together(places, 4, SourceLocation{file, number, 1}, false);
            need_together(places, 7, SourceLocation{file, number, 1}, false);
            continue;
        }
        if (cells.size() != columns.size())
            throw InputError(SourceLocation{file, number, 1},
                             "found " + std::to_string(cells.size()) + " values in a table of " +
                                 std::to_string(columns.size()) + " columns",
                             "correct the table");
        std::vector<double> values;
        for (std::size_t k = 0; k < cells.size(); ++k)
            values.push_back(columns[k].unit * read_number(cells[k], at(cells[k])));
        const auto vector_at = [&](std::size_t first) {
            return Vec(values[*places.at(first)], values[*places.at(first + 1)], values[*places.at(first + 2)]);
        };
        table.centre.push_back(vector_at(0));
        if (places[3]) {
            table.radius.push_back(values[*places[3]]);
            if (table.radius.back() <= 0)
                throw InputError(at(cells[*places[3]]), "a sphere's radius is more than 0", "correct the table");
        }
        if (places[4]) table.velocity.push_back(vector_at(4));
        if (places[7]) table.spin.push_back(vector_at(7));
    }
    if (table.centre.empty()) throw InputError(location, "'" + file + "' lists no sphere", "give it rows");
    return table;
}

}  // namespace dmp::mesher
