// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "study/reduce.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/unlisted_value.hpp"

namespace dmp::study {

namespace {

/// A row at a window's end counts as inside it: times are sums of steps.
constexpr double tolerance = 1e-9;

/// The rows in the window.
TimeSeries rows_in(const TimeSeries& series, const Window& window) {
    const double slack = tolerance * (series.time.empty() ? 0 : std::abs(series.time.back()));
    TimeSeries kept;
    for (std::size_t i = 0; i < series.time.size(); ++i)
        if (series.time[i] >= window.from - slack && series.time[i] <= window.until + slack)
            kept.add(series.time[i], series.value[i]);
    return kept;
}

/// The rows in the window, and the ends of the window where they lie between two rows.
TimeSeries lines_in(const TimeSeries& series, const Window& window) {
    const TimeSeries rows = rows_in(series, window);
    TimeSeries clipped;
    const auto add_end = [&](double end) {
        for (std::size_t i = 0; i + 1 < series.time.size(); ++i)
            if (series.time[i] < end && end < series.time[i + 1]) clipped.add(end, value_between(series, i, end));
    };
    if (rows.time.empty() || window.from < rows.time.front()) add_end(window.from);
    for (std::size_t i = 0; i < rows.time.size(); ++i) clipped.add(rows.time[i], rows.value[i]);
    if (rows.time.empty() || window.until > rows.time.back()) add_end(window.until);
    return clipped;
}

double mean(const TimeSeries& series) {
    const double length = series.time.back() - series.time.front();
    return length > 0 ? integral(series) / length : series.value.front();
}

/// Of what is above 0 of the straight lines.
double positive_integral(const TimeSeries& series) {
    double sum = 0;
    for (std::size_t i = 0; i + 1 < series.time.size(); ++i) {
        const double high = std::max(series.value[i], series.value[i + 1]);
        const double low = std::min(series.value[i], series.value[i + 1]);
        if (!(high > 0)) continue;
        const double share = low < 0 ? high / (high - low) : 1;  // of the time, in which the line is above 0
        sum += (series.time[i + 1] - series.time[i]) * share * (high + std::max(low, 0.0)) / 2;
    }
    return sum;
}

double first_crossing(const TimeSeries& series, double level) {
    for (std::size_t i = 0; i < series.time.size(); ++i) {
        const double above = series.value[i] - level;
        if (above == 0) return series.time[i];
        if (i + 1 == series.time.size()) break;
        const double next = series.value[i + 1] - level;
        if ((above < 0) == (next < 0) || next == 0) continue;
        return series.time[i] + (series.time[i + 1] - series.time[i]) * above / (above - next);
    }
    return no_number;
}

/// The time that each row stands for: half the times to its neighbours.
std::vector<double> weights(const TimeSeries& series) {
    std::vector<double> weight(series.time.size(), 0.0);
    for (std::size_t i = 0; i + 1 < weight.size(); ++i) {
        const double half = (series.time[i + 1] - series.time[i]) / 2;
        weight[i] += half;
        weight[i + 1] += half;
    }
    return weight;
}

/// Factors of the functions in the weighted fit with the least squares; NaN where the rows do not determine them.
template <int Count>
Eigen::Vector<double, Count> fitted(const TimeSeries& series, const auto& functions_at) {
    const std::vector<double> weight = weights(series);
    const auto rows = static_cast<Eigen::Index>(series.time.size());
    Eigen::Matrix<double, Eigen::Dynamic, Count> matrix(rows, Count);
    Eigen::VectorXd values(rows);
    for (Eigen::Index i = 0; i < rows; ++i) {
        const auto k = static_cast<std::size_t>(i);
        const double root = std::sqrt(weight[k]);
        matrix.row(i) = root * functions_at(series.time[k]).transpose();
        values[i] = root * series.value[k];
    }
    const auto solver = matrix.colPivHouseholderQr();
    if (rows < Count || solver.rank() < Count) return Eigen::Vector<double, Count>::Constant(no_number);
    return solver.solve(values);
}

double slope(const TimeSeries& series) {
    const double start = series.time.front(), length = series.time.back() - start;
    if (!(length > 0)) return no_number;
    const auto line = [&](double time) { return Eigen::Vector2d(1, (time - start) / length); };
    return fitted<2>(series, line)[1] / length;
}

/// m, a and b of m + a cos + b sin.
Eigen::Vector3d wave(const TimeSeries& series, double period) {
    return fitted<3>(series, [&](double time) {
        const double angle = 2 * std::numbers::pi * time / period;
        return Eigen::Vector3d(1, std::cos(angle), std::sin(angle));
    });
}

/// `unit` times (or, with -1, over) a second; as it stands where it is none that scenes know.
std::string per_time(const std::string& unit, bool times) {
    const Dimension second = parse_quantity({"1 s", {}, {}}).dimension;
    try {
        const Dimension own = parse_quantity({"1 " + unit, {}, {}}).dimension;
        const std::string joined = (times ? own * second : own / second).si_unit();
        return joined.empty() ? "1" : joined;
    } catch (const InputError&) {
        return unit + (times ? "*s" : "/s");
    }
}

}  // namespace

double reduced(const TimeSeries& series, Reduction reduction, const Window& window, const ReductionOptions& options) {
    const TimeSeries known = finite_rows(series);
    const TimeSeries lines = lines_in(known, window);
    if (lines.time.empty()) return no_number;
    const TimeSeries rows = rows_in(known, window);
    switch (reduction) {
        case Reduction::mean:
            return mean(lines);
        case Reduction::maximum:
            return *std::ranges::max_element(lines.value);
        case Reduction::minimum:
            return *std::ranges::min_element(lines.value);
        case Reduction::last:
            return lines.value.back();
        case Reduction::integral:
            return integral(lines);
        case Reduction::positive_integral:
            return positive_integral(lines);
        case Reduction::negative_integral:
            return integral(lines) - positive_integral(lines);
        case Reduction::first_crossing:
            return first_crossing(lines, options.level);
        case Reduction::slope:
            return rows.time.empty() ? no_number : slope(rows);
        case Reduction::amplitude: {
            const Eigen::Vector3d fit = wave(rows, options.period);
            return std::hypot(fit[1], fit[2]);
        }
        case Reduction::phase: {
            const Eigen::Vector3d fit = wave(rows, options.period);
            return std::atan2(fit[2], fit[1]);
        }
    }
    unlisted_value(reduction);
}

std::string unit_of(Reduction reduction, const std::string& unit) {
    switch (reduction) {
        case Reduction::mean:
        case Reduction::maximum:
        case Reduction::minimum:
        case Reduction::last:
        case Reduction::amplitude:
            return unit;
        case Reduction::integral:
        case Reduction::positive_integral:
        case Reduction::negative_integral:
            return per_time(unit, true);
        case Reduction::slope:
            return per_time(unit, false);
        case Reduction::first_crossing:
            return "s";
        case Reduction::phase:
            return "rad";
    }
    unlisted_value(reduction);
}

}  // namespace dmp::study
