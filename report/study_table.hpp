// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "report/study_files.hpp"

namespace dmp::report {

/// Cells of a page's table at most, of all its rows.
inline constexpr std::size_t most_table_cells = 250'000;

/// Indices of the rows that the page has: all, or as many as most_table_cells allows, evenly spaced.
[[nodiscard]] std::vector<std::size_t> rows_of_page(const StudyFiles& study);

/// What the scripts draw, for the element "page-data", without "<":
///   keys     name, unit, is_formula, and of each row its value as results.csv has it
///   results  name, unit, and of each row its number with seven digits, null where it has none
///   runs, failures, errors   names of runs; of those that failed, by row, exit code and index of the error
///   pages    whether each run has a page: "1" or "0"
///   plots    StudyFacts::Plot, with indices of result and keys (lines_by: -1 for one line)
///   is_scattered   no two runs differ in one key alone
[[nodiscard]] std::string study_data(const StudyFiles& study);

/// The section with the table of the runs, of which the first ones are there without scripts, too.
[[nodiscard]] std::string runs_section(const StudyFiles& study);

}  // namespace dmp::report
