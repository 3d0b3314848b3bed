// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <string>

#include "study/study.hpp"
#include "study/time_series.hpp"

namespace dmp::study {

/// The part of a run that a result is of [s].
struct Window {
    double from = -std::numeric_limits<double>::infinity();
    double until = std::numeric_limits<double>::infinity();
};

/// What a reduction needs besides the series.
struct ReductionOptions {
    double level = 0;   ///< first_crossing: in the measure's unit
    double period = 1;  ///< amplitude, phase [s]
};

/// One number of a series. Rows without a value (NaN, infinite) are left out; NaN where too little is left.
///
/// Of the straight lines between the rows, which need not be evenly spaced, from `from` to `until` or as much of this
/// as the series has:
///   mean            integral over time / time (trapezoidal rule); of a single row its value
///   integral        over time (trapezoidal rule), in the measure's unit times s
///   positive_integral, negative_integral   the same of what is above 0, and of what is below it, which is negative
///   maximum, minimum, last   the largest and smallest value, and that at the window's end
///   first_crossing  the time at which `level` is first reached from above or below [s]; NaN if it never is
/// Of the rows in the window, each weighted by the time that it stands for (half that between its neighbours):
///   slope           of the straight line that fits best (least squares), in the measure's unit per s
///   amplitude       sqrt(a^2 + b^2) of the fit m + a cos(2 pi t / T) + b sin(2 pi t / T), T the period (least squares)
///   phase           atan2(b, a), in (-pi, pi]: the fit is m + amplitude cos(2 pi t / T - phase), so it is largest at
///                   t = T phase / (2 pi) after the start of the run [rad]
double reduced(const TimeSeries& series, Reduction reduction, const Window& window, const ReductionOptions& options);

/// Unit of the result for a measure with this unit: "m^3" of the integral of "m^3/s", "s" of a crossing.
std::string unit_of(Reduction reduction, const std::string& unit);

}  // namespace dmp::study
