// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "study/series_error.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>

namespace dmp::study {

namespace {

constexpr double least_common = 0.95;

/// On the straight line between the rows around `time`, which lies within the series.
double value_at(const TimeSeries& series, double time) {
    const auto after = std::ranges::upper_bound(series.time, time);
    if (after == series.time.begin()) return series.value.front();
    if (after == series.time.end()) return series.value.back();
    const auto i = static_cast<std::size_t>(std::distance(series.time.begin(), after));
    return value_between(series, i - 1, time);
}

/// Both series at the times of both, over the time that they have in common.
struct Pair {
    TimeSeries series, reference;
};

std::optional<Pair> common(const TimeSeries& series, const TimeSeries& reference) {
    if (series.time.size() < 2 || reference.time.size() < 2) return {};
    const double from = std::max(series.time.front(), reference.time.front());
    const double until = std::min(series.time.back(), reference.time.back());
    if (!(until - from >= least_common * (reference.time.back() - reference.time.front()))) return {};
    std::vector<double> times;
    std::ranges::merge(series.time, reference.time, std::back_inserter(times));
    Pair pair;
    for (const double time : times) {
        if (time < from || time > until) continue;
        pair.series.add(time, value_at(series, time));
        pair.reference.add(time, value_at(reference, time));
    }
    return pair;
}

/// Over time, exactly (Simpson's rule).
double integral_of_square(const TimeSeries& series) {
    double sum = 0;
    for (std::size_t i = 0; i + 1 < series.time.size(); ++i) {
        const double a = series.value[i], b = series.value[i + 1];
        sum += (a * a + a * b + b * b) / 3 * (series.time[i + 1] - series.time[i]);
    }
    return sum;
}

double largest_size(const std::vector<double>& value) {
    double largest = 0;
    for (const double each : value) largest = std::max(largest, std::abs(each));
    return largest;
}

TimeSeries sizes(TimeSeries series) {
    for (double& each : series.value) each = std::abs(each);
    return series;
}

}  // namespace

double SeriesError::largest() const {
    if (std::isnan(whole)) return no_number;
    return std::max({whole, end, peak, integral});
}

SeriesSize SeriesSize::with(const SeriesSize& other) const {
    return {std::max(root_mean_square, other.root_mean_square), std::max(peak, other.peak),
            std::max(integral, other.integral)};
}

SeriesSize size_of(const TimeSeries& series) {
    const TimeSeries rows = finite_rows(series);
    if (rows.time.size() < 2) return {};
    const double time = rows.time.back() - rows.time.front();
    return {std::sqrt(integral_of_square(rows) / time), largest_size(rows.value), integral(sizes(rows))};
}

SeriesError error_of(const TimeSeries& series, const TimeSeries& reference, const SeriesSize& size) {
    const auto pair = common(finite_rows(series), finite_rows(reference));
    if (!pair || size.peak == 0) return {no_number, no_number, no_number, no_number};
    TimeSeries difference = pair->series;
    std::ranges::transform(pair->series.value, pair->reference.value, difference.value.begin(), std::minus());
    return {size_of(difference).root_mean_square / size.root_mean_square, std::abs(difference.value.back()) / size.peak,
            std::abs(largest_size(pair->series.value) - largest_size(pair->reference.value)) / size.peak,
            std::abs(integral(difference)) / size.integral};
}

SeriesError error_of(const TimeSeries& series, const TimeSeries& reference) {
    const auto pair = common(finite_rows(series), finite_rows(reference));
    return error_of(series, reference, pair ? size_of(pair->reference) : SeriesSize{});
}

}  // namespace dmp::study
