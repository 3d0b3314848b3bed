// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
//
// Lattices in 3-D, as solids: what their spring constants are said to give, against static solves.
#include <Eigen/Dense>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "base/errors.hpp"
#include "mesher/cell_lattice.hpp"
#include "mesher/spring_lattice.hpp"
#include "tests/modules.hpp"
#include "tests/unit/solver/lattice_solids.hpp"
#include "tests/unit/thrown.hpp"

namespace dmp::tests::solver_spring_lattices_tests {
namespace {

using namespace lattice_solids;

/// Nodal forces of a uniform stress in a block [Pa]: each face's traction, a quarter of each square at its corners.
Loads uniform_stress(const std::vector<Vec>& points, double spacing, const Eigen::Matrix3d& stress) {
    Vec high = Vec::Zero();
    for (const Vec& point : points) high = high.cwiseMax(point);
    Loads load(points.size(), V3{});
    for (std::size_t n = 0; n < points.size(); ++n)
        for (int axis = 0; axis < 3; ++axis) {
            const bool low_face =
                points[n][axis]<0.1 * spacing, high_face = points[n][axis]> high[axis] - 0.1 * spacing;
            if (!low_face && !high_face) continue;
            double area = spacing * spacing;
            for (int other = 0; other < 3; ++other)
                if (other != axis &&
                    (points[n][other] < 0.1 * spacing || points[n][other] > high[other] - 0.1 * spacing))
                    area /= 2;
            for (int k = 0; k < 3; ++k) load[n][k] += (high_face ? 1 : -1) * stress(k, axis) * area;
        }
    return load;
}

class Cube : public ::testing::TestWithParam<double> {};

TEST_P(Cube, has_the_modulus_the_poisson_ratio_and_the_shear_modulus_asked_for) {
    const double modulus = 3e5, nu = GetParam(), spacing = 1e-3, strain = 1e-6;
    const CellConstants constants = cell_constants(modulus, nu, spacing);
    EXPECT_NEAR(constants.youngs_modulus() / modulus, 1, 1e-14);
    EXPECT_NEAR(constants.poisson_ratio(), nu, 1e-15);
    EXPECT_NEAR(constants.shear_modulus() / (modulus / (2 * (1 + nu))), 1, 1e-14);
    EXPECT_NEAR((constants.c11() - constants.c12()) / (2 * constants.c44()), 1, 1e-13);  // isotropic

    const auto points = block(5, 4, 3, spacing);
    const ParticleSet set = set_of(cell_lattice(points, constants));
    Eigen::Matrix3d pull = Eigen::Matrix3d::Zero(), shear = pull;
    pull(0, 0) = modulus * strain;
    auto moved = displacements(set, uniform_stress(points, spacing, pull));
    EXPECT_NEAR(fit(points, moved, 0, linear)[1] / strain, 1, 2e-3);
    EXPECT_NEAR(fit(points, moved, 1, linear)[2] / strain, -nu, 2e-3);
    EXPECT_NEAR(fit(points, moved, 2, linear)[3] / strain, -nu, 2e-3);
    shear(0, 1) = shear(1, 0) = constants.shear_modulus() * strain;
    moved = displacements(set, uniform_stress(points, spacing, shear));
    EXPECT_NEAR((fit(points, moved, 0, linear)[2] + fit(points, moved, 1, linear)[1]) / strain, 1, 2e-3);
    // Along the diagonal of two axes too: the lattice is isotropic.
    Eigen::Matrix3d slanted = Eigen::Matrix3d::Zero();
    slanted.topLeftCorner<2, 2>().setConstant(modulus * strain / 2);
    moved = displacements(set, uniform_stress(points, spacing, slanted));
    const auto u = fit(points, moved, 0, linear), v = fit(points, moved, 1, linear);
    EXPECT_NEAR((u[1] + u[2] + v[1] + v[2]) / 2 / strain, 1, 2e-3);
}

INSTANTIATE_TEST_SUITE_P(PoissonRatios, Cube, ::testing::Values(0.0, 0.1, 0.25));

TEST(CubeLattice, of_bonds_alone_is_that_of_equal_bonds) {
    const CellConstants constants = cell_constants(1, 0.25, 1);
    EXPECT_DOUBLE_EQ(constants.edge_stiffness, 0.2);
    EXPECT_DOUBLE_EQ(constants.diagonal_stiffness, 0.2);
    EXPECT_EQ(constants.hinge_stiffness, 0);
    const SpringLattice lattice = cell_lattice(block(1, 1, 1, 1), constants);
    EXPECT_EQ(lattice.bonds.size(), 12U + 12U);
    EXPECT_TRUE(lattice.hinges.empty());
    EXPECT_EQ(cell_lattice(block(2, 1, 1, 1), cell_constants(1, 0.1, 1)).hinges.size(), 4U * 11U);
}

TEST(CubeLattice, bends_as_a_beam) {
    // The lattice is not exact under strain that varies over a cell: n cells thick it is stiffer by 0.9 / n^2.
    const double nu = 0.25;
    for (const int cells : {2, 4}) {
        const double spacing = 1.0 / cells, strain = 1e-5;
        const auto points = block(6 * cells, cells, cells, spacing);
        const CellConstants constants = cell_constants(1, nu, spacing);
        const ParticleSet set = set_of(cell_lattice(points, constants));
        Loads load(points.size(), V3{});
        for (const double end : {0.0, 6.0})  // axial stress that is linear over the section
            for (std::size_t n = 0; n < points.size(); ++n) {
                if (std::abs(points[n][0] - end) > 0.1 * spacing) continue;
                double area = spacing * spacing;
                for (const int axis : {1, 2})
                    if (std::abs(std::abs(points[n][axis] - 0.5) - 0.5) < 0.1 * spacing) area /= 2;
                load[n][0] = (end > 1 ? -1 : 1) * strain * (points[n][2] - 0.5) * area;
            }
        double moment = 0;
        for (std::size_t n = 0; n < points.size(); ++n)
            if (points[n][0] > 5.9) moment -= load[n][0] * (points[n][2] - 0.5);
        const auto moved = displacements(set, load);
        std::vector<Vec> axis_points, axis_moved;
        for (std::size_t n = 0; n < points.size(); ++n)
            if (std::abs(points[n][2] - 0.5) < 0.01 && std::abs(points[n][1] - 0.5) < 0.01 &&
                std::abs(points[n][0] - 3) < 2.1) {
                axis_points.push_back(points[n]);
                axis_moved.push_back(moved[n]);
            }
        const double curvature = fit(axis_points, axis_moved, 2, [](const Vec& x) {
            return Eigen::VectorXd(Eigen::Vector3d(1, x[0], x[0] * x[0] / 2));
        })[2];
        const double ratio = curvature * (1.0 / 12) / moment;
        EXPECT_NEAR(1 / ratio, 1 + 0.9 / (cells * cells), 0.01) << cells << " cells thick";
    }
}

struct LadderAsked {
    double axial, shear;  ///< 0: cross bonds alone
};

class PlaneLadder : public ::testing::TestWithParam<LadderAsked> {};

TEST_P(PlaneLadder, stretches_bends_and_shears_as_said) {
    for (const double along : {1.0, 0.8}) {
        const double across = 1, length = 64 * along;
        Part part = part_with(0);
        part.bending_stiffness = 3;
        part.axial_stiffness = GetParam().axial;
        part.shear_stiffness = GetParam().shear;
        part.cross_bonds = GetParam().shear == 0;
        part.lower_axial_stiffness = false;
        const LadderConstants constants = ladder_constants(part, along, across);
        std::vector<Vec> position;
        for (int column = 0; column <= 64; ++column)
            for (const double y : {0.5, -0.5}) position.emplace_back(column * along, y * across, 0);
        ParticleSet set = set_of_nodes(2, position, std::vector<double>(position.size(), 1));
        const auto bond = [&](int a, int b, double stiffness) {
            set.bonds.push_back({a, b, (position[a] - position[b]).norm(), stiffness});
        };
        for (int n = 0; n <= 128; n += 2) {
            bond(n, n + 1, constants.rung_stiffness);
            if (n == 128) break;
            for (const int row : {0, 1}) {
                bond(n + row, n + 2 + row, constants.bond_stiffness);
                bond(n + row, n + 3 - row, constants.cross_stiffness);
            }
            if (constants.hinge_stiffness == 0) continue;
            const std::array<int, 4> corners{n, n + 1, n + 3, n + 2};
            for (std::size_t k = 0; k < 4; ++k)
                set.hinges.push_back({corners[k], corners[(k + 1) % 4], corners[(k + 2) % 4], -std::numbers::pi / 2,
                                      constants.hinge_stiffness});
        }
        set.fixed[0] = set.fixed[1] = 1;
        const SpringNetwork<2> body(set, part_with(0), 0);
        const auto loaded = [&](double fx, double fy) {
            SpringNetwork<2>::Vectors load(set.size());
            for (const std::size_t n : {set.size() - 1, set.size() - 2}) load[n] = {{fx / 2, fy / 2}};
            return statics(body, set, load);
        };
        // Away from the ends, where the thickness is held or has half as many diagonals.
        const auto pulled = loaded(1e-6, 0);
        EXPECT_NEAR((pulled[108][0] - pulled[20][0] - 44 * along) / (1e-6 * 44 * along / part.axial_stiffness), 1,
                    1e-5);
        const auto bent = loaded(0, 1e-9);
        const double shear = part.shear_stiffness > 0 ? *part.shear_stiffness : constants.shear_stiffness();
        const double tip = 1e-9 * (std::pow(length, 3) / (3 * part.bending_stiffness) + length / shear);
        EXPECT_NEAR((bent.back()[1] + bent[bent.size() - 2][1]) / 2 / tip, 1, 2e-3);
    }
}

// Of 0.05, shear is 4 to 7 % of the tip's deflection.
INSTANTIATE_TEST_SUITE_P(All, PlaneLadder,
                         ::testing::Values(LadderAsked{16, 0}, LadderAsked{13, 4}, LadderAsked{12, 0.05}),
                         [](const auto& asked) {
                             return asked.param.shear == 0  ? "cross_bonds"
                                    : asked.param.shear > 1 ? "hinges_and_diagonals"
                                                            : "soft_in_shear";
                         });

TEST(CubeLattice, refuses_what_it_cannot_be) {
    EXPECT_EQ(text_thrown<InputError>([] { (void)cell_constants(1, 0.3, 1); }),
              "a lattice of cells cannot have a Poisson ratio of 0.3\n"
              "  give one from 0 to 1/4: bonds alone give 1/4, and hinges lower it");
    const CellConstants constants = cell_constants(1, 0.25, 1);
    auto points = block(1, 1, 1, 1);
    points.emplace_back(2, 0, 0);
    EXPECT_EQ(text_thrown<InputError>([&] { (void)cell_lattice(points, constants); }),
              "point 8 is the corner of no whole cell\n  leave it out, or give all corners of a cell");
    points.back() = Vec(1.5, 0, 0);
    EXPECT_EQ(text_thrown<InputError>([&] { (void)cell_lattice(points, constants); }),
              "point 8 at (1.5   0   0) m is not on the grid that point 0 begins\n"
              "  give points whose distances along each axis are whole numbers of spacings");
    points.back() = Vec(1, 0, 0);
    EXPECT_EQ(text_thrown<InputError>([&] { (void)cell_lattice(points, constants); }),
              "point 8 at (1 0 0) m is point 1 again\n  give it once");
}

}  // namespace
}  // namespace dmp::tests::solver_spring_lattices_tests
