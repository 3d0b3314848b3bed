// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <limits>
#include <random>
#include <set>
#include <tuple>

#include <gtest/gtest.h>

#include "particles/periodic_images.hpp"
#include "tests/modules.hpp"

namespace dmp::tests::periodic_tests {
namespace {

/// source and number of periods along x, y, z
using Copy = std::tuple<int, int, int, int>;

const Box box{Vec(-0.3, 1, -2), Vec(0.7, 3, 2)};

Coordinates points_in_box(std::size_t count, unsigned seed) {
    std::mt19937_64 random(seed);
    Coordinates points;
    for (int axis = 0; axis < 3; ++axis) {
        std::uniform_real_distribution<double> coordinate(box.low[axis], box.high[axis]);
        for (std::size_t i = 0; i < count; ++i) points[axis].push_back(coordinate(random));
    }
    return points;
}

std::multiset<Copy> made(const Coordinates& points, const std::array<bool, 3>& periodic, double reach) {
    std::multiset<Copy> ghosts;
    for (const PeriodicImage& image : periodic_images(points, points[0].size(), box, periodic, reach)) {
        std::array<int, 3> periods{};
        for (int axis = 0; axis < 3; ++axis) {
            const double ratio = image.shift[axis] / box.extent()[axis];
            periods[axis] = static_cast<int>(std::lround(ratio));
            EXPECT_NEAR(ratio, periods[axis], 1e-12);
        }
        ghosts.insert({image.source, periods[0], periods[1], periods[2]});
    }
    return ghosts;
}

/// Every shift of every point, kept where it lies within the reach of the box along the periodic axes.
std::multiset<Copy> expected(const Coordinates& points, const std::array<bool, 3>& periodic, double reach) {
    constexpr int most = 3;
    std::multiset<Copy> ghosts;
    for (std::size_t i = 0; i < points[0].size(); ++i)
        for (int x = -most; x <= most; ++x)
            for (int y = -most; y <= most; ++y)
                for (int z = -most; z <= most; ++z) {
                    const std::array<int, 3> periods{x, y, z};
                    bool keep = x != 0 || y != 0 || z != 0;
                    for (int axis = 0; axis < 3; ++axis) {
                        const double at = points[axis][i] + periods[axis] * box.extent()[axis];
                        keep = keep && (periods[axis] == 0 ||
                                        (periodic[axis] && at >= box.low[axis] - reach && at < box.high[axis] + reach));
                    }
                    if (keep) ghosts.insert({static_cast<int>(i), x, y, z});
                }
    return ghosts;
}

TEST(PeriodicImages, AreThoseOfBruteForce) {
    const auto points = points_in_box(300, 1);
    for (const auto& periodic : {std::array{true, false, false}, std::array{false, true, false},
                                 std::array{true, true, false}, std::array{true, true, true}})
        for (const double reach : {0.1, 0.45, 1.0, 2.3}) {  // up to more than two of the shortest periods
            const auto images = made(points, periodic, reach);
            EXPECT_EQ(images, expected(points, periodic, reach)) << reach;
            EXPECT_GT(images.size(), 10U);
        }
    EXPECT_TRUE(made(points, {false, false, false}, 1.0).empty());
}

TEST(PeriodicImages, OfACornerComeInThrees) {
    const Coordinates corner{{{-0.25, 0.2}, {2.95, 2.0}, {0, 0}}};
    EXPECT_EQ(made(corner, {true, true, false}, 0.1),
              (std::multiset<Copy>{{0, 1, 0, 0}, {0, 0, -1, 0}, {0, 1, -1, 0}}));
}

TEST(PeriodicImages, OfPointsOnTheSides) {
    // On the low side exactly: its image lies on the high side, at a distance of 0.
    const Coordinates side{{{box.low[0]}, {2}, {0}}};
    EXPECT_EQ(made(side, {true, false, false}, 0.1), (std::multiset<Copy>{{0, 1, 0, 0}}));
    EXPECT_TRUE(made(side, {true, false, false}, 0.0).empty());
}

TEST(PeriodicImages, TakeTheFirstPointsAndLeaveTheThirdAxisOfAPlaneEmpty) {
    auto points = points_in_box(50, 2);
    points[2].clear();
    for (const auto& image : periodic_images(points, 20, box, {true, true, false}, 0.3)) {
        EXPECT_LT(image.source, 20);
        EXPECT_EQ(image.shift[2], 0);
    }
}

TEST(PeriodicImages, OrderIsByAxisThenSource) {
    const auto points = points_in_box(100, 3);
    const auto images = periodic_images(points, 100, box, {true, false, false}, 0.3);
    ASSERT_GT(images.size(), 20U);
    for (std::size_t k = 1; k < images.size(); ++k) EXPECT_LE(images[k - 1].source, images[k].source);
}

TEST(Wrapped, MovesByWholePeriods) {
    EXPECT_EQ(wrapped(0.5, 0, 1), 0.5);
    EXPECT_EQ(wrapped(1.5, 0, 1), 0.5);
    EXPECT_EQ(wrapped(-0.25, 0, 1), 0.75);
    EXPECT_EQ(wrapped(-7.75, -2, 2), 0.25);
    EXPECT_EQ(wrapped(1e3, 0, 1), 0);
    EXPECT_NEAR(wrapped(123.4, -0.3, 0.7), 0.4, 1e-13);
}

TEST(Wrapped, TakesTheLowEdgeAndNotTheHighOne) {
    EXPECT_EQ(wrapped(0.0, 0, 1), 0);
    EXPECT_EQ(wrapped(1.0, 0, 1), 0);
    EXPECT_EQ(wrapped(-1e-30, 0, 1), 0);  // 1 - 1e-30 would be 1
    EXPECT_EQ(wrapped(0.046, -0.046, 0.046), -0.046);
}

TEST(Wrapped, StaysInTheBoxAndLeavesWhatIsInIt) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> bound(-1, 1);
    for (int trial = 0; trial < 2000; ++trial) {
        const double low = bound(random), high = low + std::abs(bound(random)) + 1e-3, period = high - low;
        for (const double edge : {low, high, low - period, high + period, low + 17 * period, high - 23 * period})
            for (const double x : {std::nextafter(edge, -infinity), edge, std::nextafter(edge, infinity)}) {
                const double moved = wrapped(x, low, high);
                ASSERT_GE(moved, low) << x;
                ASSERT_LT(moved, high) << x;
                if (x >= low && x < high) {
                    ASSERT_EQ(moved, x);
                }
                const double periods = (x - moved) / period;  // whole, but for rounding
                ASSERT_NEAR(periods, std::round(periods), 1e-9) << x;
            }
    }
}

TEST(Wrapped, DoesNotHideWhatIsNotANumber) {
    EXPECT_TRUE(std::isnan(wrapped(std::numeric_limits<double>::quiet_NaN(), 0, 1)));
}

}  // namespace
}  // namespace dmp::tests::periodic_tests
