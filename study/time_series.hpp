// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "study/uses.hpp"

namespace dmp::study {

/// A measure over time, as measures.csv has it. Between two rows it is the straight line.
struct TimeSeries {
    std::vector<double> time;   ///< [s], increasing
    std::vector<double> value;  ///< NaN where there was none

    void add(double at_time, double its_value);
};

/// Where a number cannot be had.
inline constexpr double no_number = std::numeric_limits<double>::quiet_NaN();

/// Without the rows that have no finite value.
[[nodiscard]] TimeSeries finite_rows(const TimeSeries& series);
/// On the line between the rows i and i + 1.
[[nodiscard]] double value_between(const TimeSeries& series, std::size_t i, double time);
/// Over time (trapezoidal rule).
[[nodiscard]] double integral(const TimeSeries& series);

}  // namespace dmp::study
