// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "geometry/geometry.hpp"
#include "geometry/inside_test.hpp"
#include "tests/modules.hpp"

namespace dmp::tests::region_tests {
namespace {

constexpr double pi = std::numbers::pi;

Polyline rectangle(double left, double low, double right, double high) {
    return {.points = {{left, low, 0}, {right, low, 0}, {right, high, 0}, {left, high, 0}}, .closed = true};
}

Polyline regular_polygon(int corners, double radius, const Vec& centre = Vec::Zero()) {
    Polyline polygon{.points = {}, .closed = true};
    for (int i = 0; i < corners; ++i) {
        const double angle = 2 * pi * i / corners;
        polygon.points.emplace_back(centre + radius * Vec(std::cos(angle), std::sin(angle), 0));
    }
    return polygon;
}

Region with_loops(std::vector<Polyline> loops) { return {.name = "region", .loops = std::move(loops)}; }

/// Both ways of asking must agree.
Side side(const Region& region, double x, double y) {
    const Vec point(x, y, 0);
    const Side plain = region.side_of(point);
    EXPECT_EQ(InsideTest(region).side_of(point), plain) << "at " << x << ", " << y;
    return plain;
}

TEST(Region, AreaOfAPolygonInAnyDirection) {
    auto polygon = regular_polygon(1000, 0.3, {2, -5, 0});
    const double expected = 0.5 * 1000 * 0.09 * std::sin(2 * pi / 1000);
    EXPECT_NEAR(with_loops({polygon}).area(), expected, 1e-13);
    std::ranges::reverse(polygon.points);
    EXPECT_NEAR(with_loops({polygon}).area(), expected, 1e-13);
}

TEST(Region, AreaWithHoleAndIslandWhateverTheOrder) {
    const auto outer = rectangle(0, 0, 10, 8);
    const auto hole = rectangle(1, 1, 5, 7);
    const auto island = rectangle(2, 2, 3, 3);
    EXPECT_NEAR(with_loops({outer, hole, island}).area(), 80 - 24 + 1, 1e-12);
    EXPECT_NEAR(with_loops({island, hole, outer}).area(), 80 - 24 + 1, 1e-12);
}

TEST(Region, AreaOfLoopsThatTouch) {
    EXPECT_NEAR(with_loops({rectangle(0, 0, 1, 1), rectangle(1, 1, 3, 2), rectangle(1, 0, 2, 1)}).area(), 4, 1e-14);
}

TEST(Region, AreaOfNothing) {
    EXPECT_EQ(with_loops({}).area(), 0);
    EXPECT_EQ(with_loops({rectangle(0, 1, 2, 1)}).area(), 0);
    EXPECT_EQ(with_loops({rectangle(1, 0, 1, 2)}).area(), 0);
}

TEST(Region, AreaDoesNotDependOnTheClosedFlag) {
    auto open = rectangle(0, 0, 2, 3);
    open.closed = false;
    EXPECT_DOUBLE_EQ(with_loops({open}).area(), 6);
    EXPECT_EQ(side(with_loops({open}), 0, 1), Side::on_edge);  // on the closing side
}

TEST(Region, SquareWithHoleAgainstItsClosedForm) {
    const Region region = with_loops({rectangle(0, 0, 4, 4), rectangle(1, 1, 3, 3)});
    const InsideTest test(region);
    for (int i = -2; i <= 18; ++i) {
        for (int j = -2; j <= 18; ++j) {
            const double x = 0.25 * i;
            const double y = 0.25 * j;
            // Distance from the centre in the maximum norm: exact in binary.
            const double r = std::max(std::abs(x - 2), std::abs(y - 2));
            const Side expected = r == 1 || r == 2 ? Side::on_edge : (r > 1 && r < 2 ? Side::inside : Side::outside);
            EXPECT_EQ(region.side_of({x, y, 0}), expected) << x << ", " << y;
            EXPECT_EQ(test.side_of({x, y, 0}), expected) << x << ", " << y;
        }
    }
}

TEST(Region, DiscAgainstItsClosedForm) {
    constexpr int corners = 720;
    const Region disc = with_loops({regular_polygon(corners, 1)});
    const InsideTest test(disc);
    const double incircle = std::cos(pi / corners);
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> coordinate(-1.1, 1.1);
    int inside = 0;
    for (int i = 0; i < 20000; ++i) {
        const Vec point(coordinate(random), coordinate(random), 0);
        const double r = point.norm();
        if (r > incircle && r < 1) continue;  // between polygon and circle
        EXPECT_EQ(test.side_of(point), r < 1 ? Side::inside : Side::outside) << point.transpose();
        inside += r < 1 ? 1 : 0;
    }
    EXPECT_GT(inside, 12000);
}

TEST(Region, EveryVertexIsOnTheEdge) {
    const Region disc = with_loops({regular_polygon(97, 0.7, {0.1, 0.2, 0}), regular_polygon(31, 0.2)});
    for (const auto& loop : disc.loops) {
        for (const auto& point : loop.points) EXPECT_EQ(side(disc, point.x(), point.y()), Side::on_edge);
    }
}

TEST(Region, OnAnEdgeMeansExactly) {
    // The middle of (0, 0) - (1, 3) is exact; the neighbouring doubles are not on the line, though 1e-16 away.
    const Region triangle = with_loops({{.points = {{0, 0, 0}, {1, 3, 0}, {-2, 3, 0}}, .closed = true}});
    EXPECT_EQ(side(triangle, 0.5, 1.5), Side::on_edge);
    EXPECT_EQ(side(triangle, std::nextafter(0.5, 0), 1.5), Side::inside);
    EXPECT_EQ(side(triangle, std::nextafter(0.5, 1), 1.5), Side::outside);
    // 0.1 and 0.3 are no doubles: three times the double next to 0.1 is not the double next to 0.3.
    EXPECT_EQ(side(triangle, 0.1, 0.3), Side::outside);
    EXPECT_EQ(side(triangle, 0.1, std::nextafter(0.3, 1)), Side::inside);
}

TEST(Region, RaysThroughVerticesCountOnce) {
    // A diamond, a spike up, a spike down and a step on the line y = 0, all right of the points asked for.
    const Region diamond = with_loops({{.points = {{0, 0, 0}, {2, -1, 0}, {4, 0, 0}, {2, 1, 0}}, .closed = true}});
    EXPECT_EQ(side(diamond, -1, 0), Side::outside);
    EXPECT_EQ(side(diamond, 0, 0), Side::on_edge);
    EXPECT_EQ(side(diamond, 1, 0), Side::inside);
    EXPECT_EQ(side(diamond, 4, 0), Side::on_edge);
    EXPECT_EQ(side(diamond, 5, 0), Side::outside);
    EXPECT_EQ(side(diamond, 0, 1), Side::outside);   // level with the top
    EXPECT_EQ(side(diamond, 0, -1), Side::outside);  // level with the bottom

    const Region spikes = with_loops({{.points = {{0, -2, 0},
                                                  {9, -2, 0},
                                                  {9, 2, 0},
                                                  {6, 2, 0},
                                                  {5, 0, 0},
                                                  {4, 2, 0},
                                                  {3, 2, 0},
                                                  {3, 0, 0},
                                                  {2, 0, 0},
                                                  {2, 2, 0},
                                                  {0, 2, 0}},
                                       .closed = true}});
    EXPECT_EQ(side(spikes, -1, 0), Side::outside);
    EXPECT_EQ(side(spikes, 1, 0), Side::inside);
    EXPECT_EQ(side(spikes, 2.5, 0), Side::on_edge);
    EXPECT_EQ(side(spikes, 4, 0), Side::inside);
    EXPECT_EQ(side(spikes, 2.5, 1), Side::outside);
    EXPECT_EQ(side(spikes, 5, 1), Side::outside);
    EXPECT_EQ(side(spikes, 8, 2), Side::on_edge);
    EXPECT_EQ(side(spikes, 5, 2), Side::outside);  // level with edges on both sides
}

TEST(Region, NothingIsInsideAnEmptyRegionAndNoNumberIsInsideAny) {
    EXPECT_EQ(side(with_loops({}), 0, 0), Side::outside);
    const Region square = with_loops({rectangle(0, 0, 1, 1)});
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(side(square, 0.5, nan), Side::outside);
    EXPECT_EQ(side(square, nan, 0.5), Side::outside);
    EXPECT_EQ(side(square, 0.5, std::numeric_limits<double>::infinity()), Side::outside);
}

TEST(InsideTest, ComparesAPointWithFewSegments) {
    const Region disc = with_loops({regular_polygon(1000, 1)});
    const InsideTest test(disc);
    std::size_t inside = 0, compared = 0;
    constexpr std::size_t points = 100000;
    for (std::size_t i = 0; i < points; ++i) {
        const Vec point(-1 + 2e-5 * static_cast<double>(i), std::sin(0.1 * static_cast<double>(i)), 0);
        inside += test.side_of(point) == Side::inside ? 1U : 0U;
        compared += test.candidates(point);
    }
    EXPECT_GT(inside, 30000U);
    EXPECT_LT(compared / points, 50U) << "of 1000";
}

}  // namespace
}  // namespace dmp::tests::region_tests
