// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/domain/regions.hpp"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "tests/modules.hpp"

namespace dmp::tests::regions_tests {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

Box flat(double x_low, double x_high, double y_low, double y_high) {
    return {Vec(x_low, y_low, -infinity), Vec(x_high, y_high, infinity)};
}

const Box plane = flat(-infinity, infinity, -infinity, infinity);

TEST(Regions, AreTheFirstRanksAtFirst) {
    const Regions regions(plane, 3);
    EXPECT_EQ(regions.owner({-1e300, 5, 0}), 0);
    EXPECT_EQ(regions.box(0).low[0], -infinity);
    for (const int rank : {1, 2}) EXPECT_GT(regions.box(rank).low[0], regions.box(rank).high[0]) << "not empty";
}

TEST(Regions, GiveACutWithoutTiesToItsUpperSide) {
    // 0 | 1 below y = 2, 2 above
    const std::vector<Box> boxes{flat(-infinity, 1, -infinity, 2), flat(1, infinity, -infinity, 2),
                                 flat(-infinity, infinity, 2, infinity)};
    const auto regions = Regions::along(plane, boxes);
    ASSERT_TRUE(regions);
    EXPECT_EQ(regions->owner({0.999, 1.999, 0}), 0);
    EXPECT_EQ(regions->owner({1, 1.999, 0}), 1);
    EXPECT_EQ(regions->owner({1, 2, 0}), 2);
    EXPECT_EQ(regions->owner({-1e9, 2, 0}), 2);
    EXPECT_EQ(regions->owner({-1e9, -1e9, 0}), 0);
    EXPECT_EQ(regions->owner({1e9, -1e9, 0}), 1);
    for (int rank = 0; rank < 3; ++rank) {
        EXPECT_EQ(regions->box(rank).low, boxes[rank].low);
        EXPECT_EQ(regions->box(rank).high, boxes[rank].high);
    }
}

TEST(Regions, EndWithTheSpace) {
    const auto regions = Regions::along(
        flat(0, 4, -infinity, infinity),
        std::vector<Box>{flat(-infinity, 1, -infinity, infinity), flat(1, infinity, -infinity, infinity)});
    ASSERT_TRUE(regions);
    EXPECT_EQ(regions->box(0).low[0], 0);
    EXPECT_EQ(regions->box(0).high[0], 1);
    EXPECT_EQ(regions->box(1).high[0], 4);
}

/// Bisecting points that lie on one another makes boxes without extent.
TEST(Regions, MayHaveNoExtent) {
    const auto regions = Regions::along(
        plane, std::vector<Box>{flat(-infinity, 1, -infinity, infinity), flat(1, 1, -infinity, infinity),
                                flat(1, 1, -infinity, infinity), flat(1, infinity, -infinity, infinity)});
    ASSERT_TRUE(regions);
    EXPECT_EQ(regions->owner({0.999, 0, 0}), 0);
    EXPECT_EQ(regions->owner({1, 0, 0}), 3);
}

TEST(Regions, DivideTiesByTheOtherCoordinates) {
    // Ten points on the cut x = 1, one left of it and three right of it, weighing 2 each: seven a side.
    const std::vector<Box> boxes{flat(-infinity, 1, -infinity, infinity), flat(1, infinity, -infinity, infinity)};
    WeightedPoints points{2, {0, 0, 2, 0, 2, 0, 2, 0}, {2, 2, 2, 2}};
    for (int y = 9; y >= 0; --y) {
        points.coordinates.insert(points.coordinates.end(), {1, static_cast<double>(y)});
        points.weights.push_back(2);
    }
    auto regions = Regions::along(plane, boxes);
    regions->divide_ties(Ranks::alone(), points);
    for (int y = 0; y < 10; ++y) EXPECT_EQ(regions->owner({1, static_cast<double>(y), 0}), y < 6 ? 0 : 1) << y;
    EXPECT_EQ(regions->owner({std::nextafter(1.0, 0.0), 9, 0}), 0);
    EXPECT_EQ(regions->owner({std::nextafter(1.0, 2.0), -9, 0}), 1);
}

TEST(Regions, KeepTiesTogetherWhereThatBalances) {
    const std::vector<Box> boxes{flat(-infinity, 1, -infinity, infinity), flat(1, infinity, -infinity, infinity)};
    for (const double others : {0.0, 2.0}) {  // they need all of the tied ones on the other side
        WeightedPoints points{2, {others, 0, 1, 5, 1, 6}, {2, 1, 1}};
        auto regions = Regions::along(plane, boxes);
        regions->divide_ties(Ranks::alone(), points);
        for (const double y : {5.0, 6.0, 100.0}) EXPECT_EQ(regions->owner({1, y, 0}), others == 0 ? 1 : 0) << y;
    }
}

TEST(Regions, RefuseBoxesThatDoNotComeFromCuts) {
    // overlapping
    EXPECT_FALSE(Regions::along(
        plane, std::vector<Box>{flat(-infinity, 2, -infinity, infinity), flat(1, infinity, -infinity, infinity)}));
    // a pinwheel: no plane leaves all five whole
    EXPECT_FALSE(Regions::along(flat(0, 3, 0, 3), std::vector<Box>{flat(0, 2, 0, 1), flat(2, 3, 0, 2), flat(1, 3, 2, 3),
                                                                   flat(0, 1, 1, 3), flat(1, 2, 1, 2)}));
}

}  // namespace
}  // namespace dmp::tests::regions_tests
