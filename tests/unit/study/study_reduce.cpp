// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Reductions against closed forms, on rows that are not evenly spaced.
#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "study/reduce.hpp"
#include "tests/modules.hpp"

namespace dmp::tests::study_reduce_tests {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double missing = std::numeric_limits<double>::quiet_NaN();

/// Rows at times that lie ever farther apart, from 0 to `end`.
TimeSeries sampled(double (*function)(double), std::size_t count, double end) {
    TimeSeries series;
    for (std::size_t i = 0; i < count; ++i) {
        const double part = static_cast<double>(i) / static_cast<double>(count - 1);
        series.time.push_back(end * part * (1 + part) / 2);
        series.value.push_back(function(series.time.back()));
    }
    return series;
}

double line(double t) { return 3 - 2 * t; }
double wave(double t) { return 0.7 + 1.3 * std::cos(2 * pi * t / 0.4 - 0.9); }

double of(const TimeSeries& series, Reduction reduction, Window window = {}, ReductionOptions options = {}) {
    return reduced(series, reduction, window, options);
}

TEST(Reduce, AStraightLineIsExact) {
    const TimeSeries series = sampled(line, 7, 2);
    EXPECT_NEAR(of(series, Reduction::mean), 1, 1e-14);
    EXPECT_NEAR(of(series, Reduction::integral), 2, 1e-14);
    EXPECT_NEAR(of(series, Reduction::positive_integral), 2.25, 1e-14) << "it crosses 0 between two rows, at 1.5";
    EXPECT_NEAR(of(series, Reduction::negative_integral), -0.25, 1e-14);
    EXPECT_NEAR(of(series, Reduction::positive_integral, {1.6, 1.9}), 0, 1e-14);
    EXPECT_EQ(of(series, Reduction::maximum), 3);
    EXPECT_EQ(of(series, Reduction::minimum), -1);
    EXPECT_EQ(of(series, Reduction::last), -1);
    EXPECT_NEAR(of(series, Reduction::slope), -2, 1e-13);
    EXPECT_NEAR(of(series, Reduction::first_crossing, {}, {.level = 0.5}), 1.25, 1e-14);
}

TEST(Reduce, AWindowMayLieBetweenRows) {
    const TimeSeries series = sampled(line, 7, 2);
    const Window window{0.3, 0.9};
    EXPECT_NEAR(of(series, Reduction::mean, window), line(0.6), 1e-14);
    EXPECT_NEAR(of(series, Reduction::integral, window), 0.6 * line(0.6), 1e-14);
    EXPECT_NEAR(of(series, Reduction::maximum, window), line(0.3), 1e-14);
    EXPECT_NEAR(of(series, Reduction::minimum, window), line(0.9), 1e-14);
    EXPECT_NEAR(of(series, Reduction::last, window), line(0.9), 1e-14);
    EXPECT_NEAR(of(series, Reduction::slope, window), -2, 1e-13);
    EXPECT_NEAR(of(series, Reduction::mean, {1.9, 1.95}), line(1.925), 1e-14) << "no row is in it";
    EXPECT_TRUE(std::isnan(of(series, Reduction::mean, {3, 4})));
    EXPECT_NEAR(of(series, Reduction::mean, {1, 4}), line(1.5), 1e-14) << "as much as there is";
}

TEST(Reduce, AWaveHasItsAmplitudeAndPhase) {
    const TimeSeries series = sampled(wave, 40, 1);
    const ReductionOptions options{.period = 0.4};
    EXPECT_NEAR(of(series, Reduction::amplitude, {}, options), 1.3, 1e-12);
    EXPECT_NEAR(of(series, Reduction::phase, {}, options), 0.9, 1e-12);
    EXPECT_NEAR(of(series, Reduction::amplitude, {0.31, 0.83}, options), 1.3, 1e-12);
    EXPECT_NEAR(of(series, Reduction::phase, {0.31, 0.83}, options), 0.9, 1e-12);
    TimeSeries constant = series;
    for (double& value : constant.value) value = 5;
    EXPECT_NEAR(of(constant, Reduction::amplitude, {}, options), 0, 1e-12);
}

TEST(Reduce, TheTrapezoidalRuleIsOfSecondOrder) {
    const auto error = [](std::size_t rows) {
        return std::abs(of(sampled([](double t) { return std::exp(t); }, rows, 1), Reduction::integral) -
                        (std::exp(1.0) - 1));
    };
    EXPECT_NEAR(error(41) / error(81), 4, 0.02);
}

TEST(Reduce, RowsWithoutAValueAreLeftOut) {
    TimeSeries series = sampled(line, 9, 2);
    series.value[0] = series.value[3] = missing;
    series.value[8] = std::numeric_limits<double>::infinity();
    EXPECT_EQ(of(series, Reduction::maximum), series.value[1]);
    EXPECT_EQ(of(series, Reduction::last), series.value[7]);
    EXPECT_NEAR(of(series, Reduction::slope), -2, 1e-13);
    EXPECT_NEAR(of(series, Reduction::mean), line((series.time[1] + series.time[7]) / 2), 1e-14);
    for (double& value : series.value) value = missing;
    for (const Reduction each : {Reduction::mean, Reduction::maximum, Reduction::minimum, Reduction::last,
                                 Reduction::integral, Reduction::slope, Reduction::first_crossing, Reduction::amplitude,
                                 Reduction::phase, Reduction::positive_integral, Reduction::negative_integral})
        EXPECT_TRUE(std::isnan(of(series, each))) << to_string(each);
}

TEST(Reduce, WhatRowsDoNotDetermineIsNoNumber) {
    const TimeSeries one{{0.5}, {2}}, two{{0, 0.1}, {1, 2}};
    EXPECT_EQ(of(one, Reduction::mean), 2);
    EXPECT_EQ(of(one, Reduction::integral), 0);
    EXPECT_TRUE(std::isnan(of(one, Reduction::slope)));
    EXPECT_TRUE(std::isnan(of(two, Reduction::amplitude, {}, {.period = 0.4})));
    EXPECT_TRUE(std::isnan(of(two, Reduction::first_crossing, {}, {.level = 3})));
    EXPECT_EQ(of(two, Reduction::first_crossing, {}, {.level = 2}), 0.1);
    EXPECT_EQ(of(two, Reduction::first_crossing, {}, {.level = 1}), 0);
}

TEST(Reduce, UnitsFollowTheReduction) {
    EXPECT_EQ(unit_of(Reduction::mean, "m^3/s"), "m^3/s");
    EXPECT_EQ(unit_of(Reduction::integral, "m^3/s"), "m^3");
    EXPECT_EQ(unit_of(Reduction::negative_integral, "m^3/s"), "m^3");
    EXPECT_EQ(unit_of(Reduction::integral, "1/s"), "1");
    EXPECT_EQ(unit_of(Reduction::slope, "m"), "m/s");
    EXPECT_EQ(unit_of(Reduction::slope, "1"), "s^-1");
    EXPECT_EQ(unit_of(Reduction::first_crossing, "m"), "s");
    EXPECT_EQ(unit_of(Reduction::phase, "m"), "rad");
}

}  // namespace
}  // namespace dmp::tests::study_reduce_tests
