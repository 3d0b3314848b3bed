// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace dmp {

/// A cell according to RFC 4180: in quotes if it contains a comma, a quote or a line break.
[[nodiscard]] std::string csv_cell(const std::string& text);

/// The cells of a line, without their quotes. A cell may not hold a line break.
[[nodiscard]] std::vector<std::string> csv_cells(std::string_view line);

/// The shortest text that reads back as the same double; "nan" for a missing value, whatever its sign bit.
[[nodiscard]] std::string csv_number(double value);

/// The heading of a column: "inlet_flux [m^3/s]"; without brackets where there is no unit.
[[nodiscard]] std::string csv_heading(const std::string& name, const std::string& unit);
/// The inverse: name and unit, "" where there is none.
[[nodiscard]] std::pair<std::string, std::string> name_and_unit(const std::string& heading);

}  // namespace dmp
