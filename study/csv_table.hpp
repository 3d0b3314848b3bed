// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "base/errors.hpp"
#include "scene/units.hpp"
#include "study/uses.hpp"

namespace dmp::study {

/// A CSV file of numbers, with a heading "NAME [UNIT],NAME [UNIT],...". Empty lines are left out.
class CsvTable {
  public:
    struct Column {
        std::string name, unit;
        std::size_t index = 0;
        Dimension dimension;
    };
    struct Row {
        std::vector<std::string> cells;
        SourceLocation location;
    };

    /// `asked_by`: the key that names the file, for messages; `place`: where it does; `relative_to`: "the scene";
    /// `wanted`: the heading that it should have. Throws InputError where there is no such file, it has no heading or
    /// nothing below it, or a line has not as many values as the heading has columns.
    CsvTable(const std::string& file, const std::string& asked_by, const SourceLocation& location,
             const std::string& relative_to, const std::string& wanted);

    /// `what` it is, for messages. Throws InputError where there is none, or its unit is not known.
    [[nodiscard]] Column column(const std::string& name, const std::string& what) const;
    /// Throws InputError where the column's unit is of another quantity.
    void need_dimension(const Column& column, const Dimension& wanted) const;
    [[nodiscard]] const std::vector<Row>& rows() const { return rows_; }
    /// In SI units. Throws InputError where the cell is no finite number.
    [[nodiscard]] static double number(const Row& row, const Column& column);

  private:
    std::vector<std::string> headings_;
    SourceLocation heading_;
    std::vector<Row> rows_;
};

/// Of a unit as tables have it: none for "" and "1". Throws InputError for an unknown unit.
[[nodiscard]] Dimension dimension_of(const std::string& unit);

}  // namespace dmp::study
