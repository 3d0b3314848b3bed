// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/cell_grid.hpp"

#include <algorithm>
#include <numeric>
#include <random>

#include <gtest/gtest.h>

#include "tests/modules.hpp"

namespace dmp::tests::cell_grid_tests {
namespace {

std::array<double, 3> point_of(const Coordinates& points, int dimension, std::size_t i) {
    std::array<double, 3> point{};
    for (int axis = 0; axis < dimension; ++axis) point[axis] = points[axis][i];
    return point;
}

double distance_squared(const std::array<double, 3>& a, const std::array<double, 3>& b) {
    double sum = 0;
    for (int axis = 0; axis < 3; ++axis) sum += (a[axis] - b[axis]) * (a[axis] - b[axis]);
    return sum;
}

/// Indices the grid finds within the radius; each may be visited once only.
std::vector<int> found_by(const CellGrid& grid, const Coordinates& points, int dimension,
                          const std::array<double, 3>& centre, double radius) {
    std::vector<int> found;
    std::vector<int> visits(points[0].size(), 0);
    grid.for_each_near(centre, radius, [&](int k) {
        EXPECT_EQ(++visits[k], 1);
        if (distance_squared(centre, point_of(points, dimension, k)) <= radius * radius) found.push_back(k);
    });
    std::sort(found.begin(), found.end());
    return found;
}

void expect_the_same_as_all_pairs(const Coordinates& points, int dimension, double cell, double radius) {
    const std::size_t count = points[0].size();
    const CellGrid grid(points, count, dimension, cell);
    std::vector<int> order = grid.order();
    std::sort(order.begin(), order.end());
    std::vector<int> all(count);
    std::iota(all.begin(), all.end(), 0);
    ASSERT_EQ(order, all);
    std::size_t pairs = 0;
    for (std::size_t i = 0; i < count; ++i) {
        const auto centre = point_of(points, dimension, i);
        std::vector<int> expected;
        for (std::size_t j = 0; j < count; ++j)
            if (distance_squared(centre, point_of(points, dimension, j)) <= radius * radius)
                expected.push_back(static_cast<int>(j));
        ASSERT_EQ(found_by(grid, points, dimension, centre, radius), expected) << i;
        pairs += expected.size() - 1;
    }
    EXPECT_GT(pairs, 100U);  // a test without neighbours would show nothing
}

Coordinates random_points(int dimension, std::size_t count, unsigned seed) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> coordinate(-1, 2);
    Coordinates points;
    for (std::size_t i = 0; i < count; ++i)
        for (int axis = 0; axis < dimension; ++axis) points[axis].push_back(coordinate(random));
    return points;
}

Coordinates clustered_points(int dimension, std::size_t count, unsigned seed) {
    std::mt19937_64 random(seed);
    std::normal_distribution<double> offset(0, 0.01);
    Coordinates points;
    for (std::size_t i = 0; i < count; ++i)
        for (int axis = 0; axis < dimension; ++axis)
            points[axis].push_back(static_cast<double>(i % 4) * (axis + 1) + offset(random));
    return points;
}

TEST(CellGrid, FindsWhatAllPairsFind) {
    for (const int dimension : {2, 3}) {
        const auto random = random_points(dimension, 600, 1);
        for (const double radius : {0.2, 0.5, 5.0}) {
            expect_the_same_as_all_pairs(random, dimension, radius, radius);
            expect_the_same_as_all_pairs(random, dimension, 0.5 * radius, radius);
        }
        expect_the_same_as_all_pairs(clustered_points(dimension, 600, 2), dimension, 0.02, 0.02);
    }
}

TEST(CellGrid, FindsPointsOnCellBordersAndExactlyAtTheRadius) {
    Coordinates lattice;
    for (int i = 0; i < 20; ++i)
        for (int j = 0; j < 20; ++j) {
            lattice[0].push_back(0.1 * i);
            lattice[1].push_back(0.1 * j);
        }
    for (const double radius : {0.1, 0.2, 0.3}) expect_the_same_as_all_pairs(lattice, 2, radius, radius);
}

TEST(CellGrid, AStrayFarPointCostsNoMemory) {
    for (const int dimension : {2, 3}) {
        auto points = clustered_points(dimension, 400, 3);
        for (int axis = 0; axis < dimension; ++axis) points[axis].push_back(1e6 * (1 - 2 * (axis % 2)));
        expect_the_same_as_all_pairs(points, dimension, 0.02, 0.02);  // 1e16 cells or more if it were taken at its word
    }
}

TEST(CellGrid, LooksIntoBoxesAndBeyondItsOwnEdges) {
    const auto points = random_points(2, 500, 4);
    const CellGrid grid(points, 500, 2, 0.1);
    const auto inside = [&](const std::array<double, 3>& low, const std::array<double, 3>& high) {
        int visited = 0, expected = 0;
        const auto in_box = [&](int k) {
            return points[0][k] >= low[0] && points[0][k] <= high[0] && points[1][k] >= low[1] &&
                   points[1][k] <= high[1];
        };
        grid.for_each_near(low, high, [&](int k) { visited += in_box(k) ? 1 : 0; });
        for (int k = 0; k < 500; ++k) expected += in_box(k) ? 1 : 0;
        EXPECT_EQ(visited, expected);
        return visited;
    };
    EXPECT_EQ(inside({-9, -9, 0}, {9, 9, 0}), 500);
    EXPECT_GT(inside({0.03, 0.5, 0}, {1.1, 0.77, 0}), 10);
    EXPECT_GT(inside({-50, -0.5, 0}, {-0.5, 50, 0}), 20);
    EXPECT_EQ(inside({5, 5, 0}, {6, 6, 0}), 0);
    EXPECT_EQ(inside({-6, -6, 0}, {-5, -5, 0}), 0);
}

TEST(CellGrid, TakesTheFirstPointsOnly) {
    const auto points = random_points(2, 100, 5);
    const CellGrid grid(points, 40, 2, 0.5);
    EXPECT_EQ(grid.order().size(), 40U);
    grid.for_each_near({0.5, 0.5, 0}, 10.0, [](int k) { EXPECT_LT(k, 40); });
}

TEST(CellGrid, NoPointsOnePointAndEqualPoints) {
    const auto visited = [](const CellGrid& grid) {
        int count = 0;
        grid.for_each_near({0, 0, 0}, 1.0, [&](int) { ++count; });
        return count;
    };
    EXPECT_EQ(visited(CellGrid()), 0);
    EXPECT_EQ(visited(CellGrid({}, 0, 2, 0.1)), 0);
    EXPECT_EQ(visited(CellGrid({{{0.3}, {0.4}, {}}}, 1, 2, 0.1)), 1);
    EXPECT_EQ(visited(CellGrid({{{0.3, 0.3, 0.3}, {0.4, 0.4, 0.4}, {0, 0, 0}}}, 3, 3, 0.1)), 3);
}

}  // namespace
}  // namespace dmp::tests::cell_grid_tests
