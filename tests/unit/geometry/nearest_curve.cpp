// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/nearest_curve.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <stdexcept>

#include <gtest/gtest.h>

#include "tests/modules.hpp"

namespace dmp::tests::nearest_curve_tests {
namespace {

CurveSet wave(int segments) {
    Polyline line;
    for (int i = 0; i <= segments; ++i) {
        const double x = 10.0 * i / segments;
        line.points.emplace_back(x, std::sin(x), 0);
    }
    return {.name = "wave", .pieces = {line}};
}

TEST(CurveSet, NearestOfASegmentAgainstItsClosedForm) {
    const CurveSet set{.name = "line", .pieces = {{.points = {{1, 1, 0}, {5, 1, 0}}}}};
    const Projection above = set.nearest({3, 4, 0});
    EXPECT_EQ(above.point, Vec(3, 1, 0));
    EXPECT_EQ(above.distance, 3);
    const Projection beyond = set.nearest({8, 5, 0});
    EXPECT_EQ(beyond.point, Vec(5, 1, 0));
    EXPECT_EQ(beyond.distance, 5);
    EXPECT_EQ(set.nearest({2, 1, 0}).distance, 0);
}

TEST(CurveSet, NearestCountsTheClosingSegment) {
    Polyline triangle{.points = {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}}, .closed = true};
    EXPECT_NEAR((CurveSet{.name = "", .pieces = {triangle}}.nearest({1, 3, 0}).point - Vec(2, 2, 0)).norm(), 0, 1e-15);
    triangle.closed = false;
    EXPECT_EQ((CurveSet{.name = "", .pieces = {triangle}}.nearest({1, 3, 0}).point), Vec(1, 0, 0));
}

TEST(CurveSet, NearestOfNothingIsInfinitelyFar) {
    EXPECT_EQ(CurveSet{}.nearest({0, 0, 0}).distance, std::numeric_limits<double>::infinity());
    EXPECT_FALSE(NearestCurve(CurveSet{}, 1).nearest({0, 0, 0}));
}

TEST(NearestCurve, SameBitsAsBruteForceWithinTheLimit) {
    CurveSet set = wave(200);
    set.pieces.push_back({.points = {{0, -3, 0}, {10, 3, 0}}});  // long and oblique
    set.pieces.push_back({.points = {{2, 2, 0}, {3, 2, 0}, {3, 3, 0}}, .closed = true});
    set.pieces.push_back({.points = {{8, -2, 0}}});
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> x(-2, 12);
    std::uniform_real_distribution<double> y(-5, 5);
    for (const double limit : {0.001, 0.05, 0.7, 30.0}) {
        const NearestCurve indexed(set, limit);
        int found = 0;
        for (int i = 0; i < 5000; ++i) {
            const Vec point(x(random), y(random), 0);
            const Projection plain = set.nearest(point);
            const auto quick = indexed.nearest(point);
            ASSERT_EQ(quick.has_value(), plain.distance <= limit) << point.transpose() << " limit " << limit;
            if (!quick) continue;
            ++found;
            ASSERT_EQ(quick->distance, plain.distance);
            ASSERT_EQ(quick->point, plain.point);
        }
        EXPECT_GT(found, 0);
    }
}

TEST(NearestCurve, ADistanceOfExactlyTheLimitCounts) {
    const CurveSet set{.name = "line", .pieces = {{.points = {{0, 0, 0}, {1, 0, 0}}}}};
    const NearestCurve indexed(set, 0.1);
    EXPECT_TRUE(indexed.nearest({0.5, 0.1, 0}));
    EXPECT_TRUE(indexed.nearest({1.1, 0, 0}) || (Vec(1.1, 0, 0) - Vec(1, 0, 0)).norm() > 0.1);
    EXPECT_FALSE(indexed.nearest({0.5, std::nextafter(0.1, 1), 0}));
    EXPECT_FALSE(indexed.nearest({std::nan(""), 0, 0}));
}

TEST(NearestCurve, RefusesALimitThatIsNotPositive) {
    EXPECT_THROW(NearestCurve(wave(3), 0), std::invalid_argument);
    EXPECT_THROW(NearestCurve(wave(3), std::nan("")), std::invalid_argument);
}

TEST(NearestCurve, ComparesAPointWithFewSegments) {
    const NearestCurve indexed(wave(1000), 0.1);
    std::size_t found = 0, compared = 0;
    constexpr std::size_t points = 100000;
    for (std::size_t i = 0; i < points; ++i) {
        const Vec point(1e-4 * static_cast<double>(i), std::cos(0.37 * static_cast<double>(i)), 0);
        found += indexed.nearest(point) ? 1U : 0U;
        compared += indexed.candidates(point);
    }
    EXPECT_GT(found, 1000U);
    EXPECT_LT(compared / points, 50U) << "of 1000";
}

}  // namespace
}  // namespace dmp::tests::nearest_curve_tests
