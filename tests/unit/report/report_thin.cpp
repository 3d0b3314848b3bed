// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "report/thin.hpp"
#include "tests/modules.hpp"

namespace dmp::tests::report_thin_tests {
namespace {

const double missing = std::numeric_limits<double>::quiet_NaN();

Curve sampled(std::size_t points, const auto& value) {
    Curve curve;
    for (std::size_t i = 0; i < points; ++i) {
        curve.time.push_back(static_cast<double>(i));
        curve.value.push_back(value(i));
    }
    return curve;
}

TEST(Thinned, ShortCurvesStayAsTheyAre) {
    const Curve curve = sampled(2000, [](std::size_t i) { return static_cast<double>(i % 7); });
    const Curve thin = thinned(curve, 2000);
    EXPECT_EQ(thin.time, curve.time);
    EXPECT_EQ(thin.value, curve.value);
}

TEST(Thinned, ASineKeepsItsExtremesInEveryPeriod) {
    // 100 periods of 10 000 points: each extreme of each period, 1 and -1, lies on a point.
    constexpr std::size_t period = 10'000;
    const Curve curve = sampled(100 * period, [](std::size_t i) {
        return std::sin(2 * std::numbers::pi * static_cast<double>(i % period) / period);
    });
    const Curve thin = thinned(curve, 2000);
    EXPECT_LE(thin.value.size(), 2000U);
    EXPECT_GE(thin.value.size(), 1300U);
    EXPECT_EQ(thin.time.front(), 0);
    EXPECT_EQ(thin.time.back(), 100.0 * period - 1);
    EXPECT_TRUE(std::ranges::is_sorted(thin.time));
    const auto count = [&](double extreme) {
        std::vector<bool> found(100);
        for (std::size_t k = 0; k < thin.value.size(); ++k)
            if (std::abs(thin.value[k] - extreme) < 1e-12)
                found[static_cast<std::size_t>(thin.time[k]) / period] = true;
        return std::ranges::count(found, true);
    };
    EXPECT_EQ(count(1), 100);
    EXPECT_EQ(count(-1), 100);
    for (std::size_t k = 0; k < thin.value.size(); ++k)
        EXPECT_EQ(thin.value[k], curve.value[static_cast<std::size_t>(thin.time[k])]) << "only points of the curve";
}

TEST(Thinned, APeakOfOnePointStays) {
    const Curve thin = thinned(sampled(1'000'000, [](std::size_t i) { return i == 654'321 ? 5.0 : 0.0; }), 2000);
    const auto peak = std::ranges::find(thin.value, 5.0);
    ASSERT_NE(peak, thin.value.end());
    EXPECT_EQ(thin.time[static_cast<std::size_t>(peak - thin.value.begin())], 654'321);
}

TEST(Thinned, GapsStay) {
    const Curve thin =
        thinned(sampled(100'000, [](std::size_t i) { return i == 5'000 || i > 90'000 ? missing : 1.0; }), 500);
    EXPECT_LE(thin.value.size(), 500U);
    EXPECT_NE(std::ranges::find(thin.time, 5'000), thin.time.end());
    for (std::size_t k = 0; k < thin.value.size(); ++k)
        EXPECT_EQ(std::isnan(thin.value[k]), thin.time[k] == 5'000 || thin.time[k] > 90'000) << thin.time[k];
}

TEST(Thinned, RefusesWhatCannotBe) {
    EXPECT_THROW(static_cast<void>(thinned({{0, 1}, {0}}, 100)), std::invalid_argument);
    EXPECT_THROW(static_cast<void>(thinned({}, 4)), std::invalid_argument);
}

}  // namespace
}  // namespace dmp::tests::report_thin_tests
