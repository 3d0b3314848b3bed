// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "study/time_series.hpp"

#include <cmath>

namespace dmp::study {

void TimeSeries::add(double at_time, double its_value) {
    time.push_back(at_time);
    value.push_back(its_value);
}

TimeSeries finite_rows(const TimeSeries& series) {
    TimeSeries kept;
    for (std::size_t i = 0; i < series.time.size(); ++i)
        if (std::isfinite(series.value[i])) kept.add(series.time[i], series.value[i]);
    return kept;
}

double value_between(const TimeSeries& series, std::size_t i, double time) {
    const double part = (time - series.time[i]) / (series.time[i + 1] - series.time[i]);
    return (1 - part) * series.value[i] + part * series.value[i + 1];
}

double integral(const TimeSeries& series) {
    double sum = 0;
    for (std::size_t i = 0; i + 1 < series.time.size(); ++i)
        sum += (series.value[i] + series.value[i + 1]) / 2 * (series.time[i + 1] - series.time[i]);
    return sum;
}

}  // namespace dmp::study
