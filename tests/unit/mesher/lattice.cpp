// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "mesher/lattice.hpp"

#include <cmath>
#include <limits>
#include <set>

#include <gtest/gtest.h>

#include "tests/modules.hpp"

namespace dmp::tests::lattice_tests {
namespace {

constexpr std::array<bool, 3> open{}, along_x{true, false, false}, along_both{true, true, false};

/// Smallest distance of any two points, across the periodic sides as well.
double smallest_distance(const std::vector<Vec>& points, const Box& box, const std::array<bool, 3>& periodic) {
    double smallest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < points.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
            Vec apart = points[i] - points[j];
            for (int axis = 0; axis < 2; ++axis)
                if (periodic[axis]) apart[axis] -= box.extent()[axis] * std::round(apart[axis] / box.extent()[axis]);
            smallest = std::min(smallest, apart.norm());
        }
    return smallest;
}

TEST(SquareLattice, StartsHalfACellInsideRowAfterRow) {
    const Box box{Vec(1, -2, 0), Vec(1.5, -1.25, 0)};
    const Lattice lattice(box, open, 0.25, Arrangement::square);
    const std::vector<Vec> expected{{1.125, -1.875, 0}, {1.375, -1.875, 0}, {1.125, -1.625, 0},
                                    {1.375, -1.625, 0}, {1.125, -1.375, 0}, {1.375, -1.375, 0}};
    EXPECT_EQ(lattice.points(0), expected);
    EXPECT_EQ(lattice.cell_area(), 0.0625);
}

TEST(SquareLattice, MarginWidensOpenAxesOnly) {
    const Box box{Vec(0, 0, 0), Vec(1, 0.5, 0)};
    EXPECT_EQ(Lattice(box, open, 0.125, Arrangement::square).points(0.25).size(), (8U + 4) * (4 + 4));
    const auto points = Lattice(box, along_x, 0.125, Arrangement::square).points(0.25);
    EXPECT_EQ(points.size(), 8U * (4 + 4));
    for (const Vec& point : points) {
        EXPECT_GT(point[0], 0);
        EXPECT_LT(point[0], 1);
        EXPECT_GT(point[1], -0.25);
        EXPECT_LT(point[1], 0.75);
    }
    EXPECT_EQ(Lattice(box, along_both, 0.125, Arrangement::square).points(0.25).size(), 8U * 4);
}

TEST(SquareLattice, SnapsToThePeriod) {
    const Box box{Vec(-0.5, 0, 0), Vec(0.5, 1, 0)};
    const Lattice lattice(box, along_x, 0.15, Arrangement::square);  // 6.67 cells: 7
    EXPECT_DOUBLE_EQ(lattice.step()[0], 1.0 / 7);
    EXPECT_EQ(lattice.step()[1], 0.15);
    EXPECT_DOUBLE_EQ(lattice.cell_area(), 0.15 / 7);
    const auto points = lattice.points(0);
    EXPECT_NEAR(smallest_distance(points, box, along_x), 1.0 / 7, 1e-14);
    EXPECT_EQ(points.size(), 7U * 7);  // the last row lies in the box, if not half a cell inside
    EXPECT_EQ(Lattice(box, along_both, 0.15, Arrangement::square).points(0).size(), 49U);
    EXPECT_EQ(Lattice(box, along_x, 5.0, Arrangement::square).step()[0], 1);  // never fewer than one cell
}

TEST(HexagonalLattice, StandsForTheSquareOfTheSpacing) {
    const double spacing = 0.1;
    const Box box{Vec(0, 0, 0), Vec(2, 2, 0)};
    const Lattice lattice(box, open, spacing, Arrangement::hexagonal);
    EXPECT_DOUBLE_EQ(lattice.cell_area(), spacing * spacing);
    EXPECT_DOUBLE_EQ(lattice.step()[1] / lattice.step()[0], std::sqrt(0.75));
    const auto points = lattice.points(0);
    const double nearest = 1.0745699318 * spacing;  // sqrt(2 / sqrt 3)
    EXPECT_NEAR(smallest_distance(points, box, open), nearest, 1e-10);
    // A point inside has six neighbours at that distance.
    for (const Vec& centre : points) {
        if ((centre - Vec(1, 1, 0)).norm() > 0.8) continue;
        int neighbours = 0;
        for (const Vec& point : points) {
            const double r = (point - centre).norm();
            neighbours += r > 0 && r < 1.01 * nearest ? 1 : 0;
        }
        ASSERT_EQ(neighbours, 6);
    }
}

TEST(HexagonalLattice, KeepsTheStaggerAcrossPeriodsAndMargins) {
    const Box box{Vec(0, 0, 0), Vec(1, 1.3, 0)};
    const Lattice lattice(box, along_both, 0.1, Arrangement::hexagonal);
    const double columns = 1 / lattice.step()[0], rows = 1.3 / lattice.step()[1];
    EXPECT_NEAR(columns, 9, 1e-12);
    EXPECT_NEAR(rows, 14, 1e-12);  // even
    const auto points = lattice.points(0.3);
    EXPECT_EQ(points.size(), 126U);
    EXPECT_NEAR(static_cast<double>(points.size()) * lattice.cell_area(), 1.3, 1e-12);
    EXPECT_GT(smallest_distance(points, box, along_both), 1.04 * 0.1);
    // Rows below the box are staggered like those in it.
    EXPECT_GT(smallest_distance(Lattice(box, open, 0.1, Arrangement::hexagonal).points(0.35), box, open), 1.07 * 0.1);
}

}  // namespace
}  // namespace dmp::tests::lattice_tests
