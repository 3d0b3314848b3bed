// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>

#include "report/run_files.hpp"

namespace dmp::report {

/// Points of a plot at most, and of all plots of a page together.
inline constexpr std::size_t most_points = 2000, most_points_of_page = 150'000;

/// Points of each of so many plots at most.
[[nodiscard]] std::size_t points_of_each(std::size_t plots);

/// JSON that page.js draws: {"measures": [{"name", "unit", "time": [s], "value": [], "reference": []}]}, missing values
/// null, seven digits; no "<" in it, so that it can stand in a <script>. `references`: what some columns should be, at
/// the same times; the others have no "reference".
[[nodiscard]] std::string plot_data(const MeasureSeries& measures, const MeasureSeries& references = {});

/// The section of the measures: plots, with what is known of what they should be, and the table of their extremes from
/// summary.json.
[[nodiscard]] std::string measures_section(const RunFiles& run);

}  // namespace dmp::report
