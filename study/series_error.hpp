// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "study/time_series.hpp"
#include "study/uses.hpp"

namespace dmp::study {

/// How large a series is, over its time.
struct SeriesSize {
    double root_mean_square = 0;
    double peak = 0;      ///< largest |value|
    double integral = 0;  ///< of |value|

    /// The larger of both, part by part: of columns that make one vector.
    [[nodiscard]] SeriesSize with(const SeriesSize& other) const;
};

/// 0 where it has less than two rows with a value.
[[nodiscard]] SeriesSize size_of(const TimeSeries& series);

/// How far a measure of one run is from the same measure of a reference, over the time that both have. All are parts of
/// a size, so that measures in any unit compare; a measure that ends near zero is not divided by its end.
struct SeriesError {
    double whole = 0;     ///< root mean square over time of the difference, over that of the size
    double end = 0;       ///< |difference at the end| over the peak
    double peak = 0;      ///< |difference of the largest |values|| over the peak
    double integral = 0;  ///< |difference of the integrals over time| over the integral of the size

    [[nodiscard]] double largest() const;
};

/// Of the straight lines between the rows; rows without a value are left out. All parts are NaN where there are less
/// than two rows of each, where the series lacks more than 5 % of the reference's time, and where the size is zero.
/// `size`: that of the reference, or of the vector that it is a component of.
[[nodiscard]] SeriesError error_of(const TimeSeries& series, const TimeSeries& reference, const SeriesSize& size);
[[nodiscard]] SeriesError error_of(const TimeSeries& series, const TimeSeries& reference);

}  // namespace dmp::study
