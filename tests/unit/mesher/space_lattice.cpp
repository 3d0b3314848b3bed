// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "mesher/space_lattice.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include <gtest/gtest.h>

#include "tests/modules.hpp"

namespace dmp::tests::space_lattice_tests {
namespace {

std::vector<Vec> points_of(const SpaceLattice& lattice) {
    std::vector<Vec> points;
    for (std::size_t row = 0; row < lattice.rows().size(); ++row)
        for (int line = 0; line < lattice.rows()[row].lines; ++line)
            for (int point = 0; point < lattice.points(); ++point) points.push_back(lattice.at(row, line, point));
    return points;
}

struct Wanted {
    std::string name;
    Arrangement arrangement;
    double nearest;  ///< [spacings]
    int neighbours;  ///< at that distance
};
class Lattices : public testing::TestWithParam<Wanted> {};

/// Across the sides of a box that is periodic along all axes.
Vec separation(const Vec& a, const Vec& b, const Box& box) {
    Vec apart = a - b;
    for (int axis = 0; axis < 3; ++axis)
        apart[axis] -= box.extent()[axis] * std::round(apart[axis] / box.extent()[axis]);
    return apart;
}

TEST_P(Lattices, every_point_of_a_periodic_box_has_the_same_neighbours) {
    const double spacing = 0.25;
    const auto step = SpaceLattice::wanted_step(spacing, GetParam().arrangement);
    EXPECT_NEAR(step[0] * step[1] * step[2], std::pow(spacing, 3), 1e-15);
    // A whole number of cells, so that nothing is stretched.
    const Box box{Vec(1, -2, 3), Vec(1 + 6 * step[0], -2 + 6 * step[1], 3 + 6 * step[2])};
    const SpaceLattice lattice(box, {true, true, true}, spacing, GetParam().arrangement, 1);
    const auto points = points_of(lattice);
    ASSERT_EQ(points.size(), 216U);
    EXPECT_NEAR(216 * lattice.cell_volume(), box.extent().prod(), 1e-12);
    for (const Vec& a : points) {
        double nearest = std::numeric_limits<double>::infinity();
        for (const Vec& b : points)
            if (&a != &b) nearest = std::min(nearest, separation(a, b, box).norm());
        const auto as_near = std::ranges::count_if(
            points, [&](const Vec& b) { return &a != &b && separation(a, b, box).norm() < 1.0001 * nearest; });
        EXPECT_NEAR(nearest / spacing, GetParam().nearest, 1e-4);
        EXPECT_EQ(as_near, GetParam().neighbours);
    }
}

TEST_P(Lattices, a_margin_widens_open_axes_only) {
    const Box box{Vec(0, 0, 0), Vec(2, 2, 2)};
    const SpaceLattice narrow(box, {true, false, false}, 0.25, GetParam().arrangement, 0);
    const SpaceLattice wide(box, {true, false, false}, 0.25, GetParam().arrangement, 0.6);
    EXPECT_EQ(narrow.points(), wide.points());
    std::size_t inside = 0;
    for (const Vec& point : points_of(wide)) {
        EXPECT_TRUE(point.x() >= 0 && point.x() < 2);
        // The wide lattice goes on where the narrow one ends.
        const auto narrow_points = points_of(narrow);
        inside += std::ranges::any_of(narrow_points, [&](const Vec& p) { return (p - point).norm() < 1e-12; }) ? 1 : 0;
    }
    EXPECT_EQ(inside, points_of(narrow).size());
    EXPECT_LT(points_of(wide).front().z(), -0.4);
}

INSTANTIATE_TEST_SUITE_P(AllOf, Lattices,
                         testing::Values(Wanted{"cubic", Arrangement::square, 1, 6},
                                         Wanted{"fcc", Arrangement::fcc, 1.12246, 12},
                                         Wanted{"hcp", Arrangement::hexagonal, 1.12246, 12}),
                         [](const auto& tested) { return tested.param.name; });

TEST(SpaceLattice, is_stretched_to_a_period_and_to_a_plane_of_symmetry) {
    const Box box{Vec(0, 0, 0), Vec(1.1, 1.1, 1.1)};
    const SpaceLattice lattice(box, {true, false, false}, 0.25, Arrangement::square, 0, {false, true, false});
    EXPECT_NEAR(lattice.step()[0], 0.275, 1e-15);
    EXPECT_NEAR(lattice.step()[1], 0.275, 1e-15);
    EXPECT_EQ(lattice.step()[2], 0.25);
}

}  // namespace
}  // namespace dmp::tests::space_lattice_tests
