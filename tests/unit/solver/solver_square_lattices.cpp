// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
//
// Square lattices in 2-D, as solids 1 m deep that are held in their depth, against static solves.
#include <cmath>

#include <gtest/gtest.h>

#include "tests/modules.hpp"
#include "tests/unit/solver/lattice_solids.hpp"

namespace dmp::tests::solver_square_lattices_tests {
namespace {

using namespace lattice_solids;

using PlaneLoads = SpringNetwork<2>::Vectors;

ParticleSet plane_set_of(const SpringLattice& lattice) {
    ParticleSet set = set_of_nodes(2, lattice.nodes, lattice.share);
    set.bonds = lattice.bonds;
    set.hinges = lattice.hinges;
    return set;
}

std::vector<Vec> displacements_in_plane(const ParticleSet& set, const PlaneLoads& load) {
    const auto at = statics(SpringNetwork<2>(set, part_with(0), 0), set, load);
    std::vector<Vec> moved;
    for (std::size_t n = 0; n < at.size(); ++n) moved.emplace_back(Vec(at[n][0], at[n][1], 0) - set.position[n]);
    return moved;
}

/// Nodal forces of a stress [Pa] that may vary with place, on the sides of a block: each node's share of its side.
template <class Stress>
PlaneLoads tractions(const std::vector<Vec>& points, double spacing, const Stress& stress) {
    Vec high = Vec::Zero();
    for (const Vec& point : points) high = high.cwiseMax(point);
    const auto is_on = [&](double x, double side) { return std::abs(x - side) < 0.1 * spacing; };
    PlaneLoads load(points.size(), Vector<double, 2>{});
    for (std::size_t n = 0; n < points.size(); ++n)
        for (int axis = 0; axis < 2; ++axis) {
            const double along = points[n][1 - axis];
            const double share = is_on(along, 0) || is_on(along, high[1 - axis]) ? 0.5 : 1;
            for (const double side : {0.0, high[axis]}) {
                if (!is_on(points[n][axis], side)) continue;
                const Eigen::Matrix2d here = stress(points[n]);
                for (int k = 0; k < 2; ++k) load[n][k] += (side > 0 ? 1 : -1) * here(k, axis) * share * spacing;
            }
        }
    return load;
}

Eigen::VectorXd linear_in_plane(const Vec& x) { return Eigen::Vector3d(1, x[0], x[1]); }

class Square : public ::testing::TestWithParam<double> {};

TEST_P(Square, is_the_material_held_in_its_depth) {
    const double modulus = 3e5, nu = GetParam(), spacing = 1e-3, strain = 1e-6;
    const CellConstants constants = cell_constants(modulus, nu, spacing, 2);
    EXPECT_NEAR(constants.youngs_modulus() / modulus, 1, 1e-14);
    EXPECT_NEAR(constants.poisson_ratio(), nu, 1e-15);
    EXPECT_NEAR(constants.shear_modulus() / (modulus / (2 * (1 + nu))), 1, 1e-14);
    EXPECT_NEAR((constants.c11() - constants.c12()) / (2 * constants.c44()), 1, 1e-13);

    const auto points = block(7, 5, 0, spacing);
    const ParticleSet set = plane_set_of(cell_lattice(points, constants));
    const auto strains = [&](const Eigen::Matrix2d& stress) {
        const auto moved = displacements_in_plane(set, tractions(points, spacing, [&](const Vec&) { return stress; }));
        const auto u = fit(points, moved, 0, linear_in_plane), v = fit(points, moved, 1, linear_in_plane);
        return Eigen::Vector3d(u[1], v[2], u[2] + v[1]);
    };
    Eigen::Matrix2d pull = Eigen::Matrix2d::Zero(), shear = pull;
    pull(0, 0) = modulus * strain;
    const Eigen::Vector3d pulled = strains(pull);
    EXPECT_NEAR(pulled[0] / strain, 1 - nu * nu, 2e-3);
    EXPECT_NEAR(pulled[1] / strain, -nu * (1 + nu), 2e-3);
    shear(0, 1) = shear(1, 0) = constants.shear_modulus() * strain;
    EXPECT_NEAR(strains(shear)[2] / strain, 1, 2e-3);
    // Along the diagonal too: the lattice is isotropic.
    const Eigen::Vector3d slanted = strains(Eigen::Matrix2d::Constant(modulus * strain / 2));
    EXPECT_NEAR((slanted[0] + slanted[1] + slanted[2]) / 2 / strain, 1 - nu * nu, 2e-3);
}

INSTANTIATE_TEST_SUITE_P(PoissonRatios, Square, ::testing::Values(0.0, 0.1, 0.25));

TEST(SquareLattice, of_bonds_alone_has_edges_twice_as_stiff_as_diagonals) {
    const CellConstants constants = cell_constants(1, 0.25, 0.01, 2);
    EXPECT_DOUBLE_EQ(constants.edge_stiffness, 0.4);
    EXPECT_DOUBLE_EQ(constants.diagonal_stiffness, 0.2);
    const SpringLattice lattice = cell_lattice(block(2, 1, 0, 0.01), constants);
    ASSERT_EQ(lattice.bonds.size(), 7U + 4U);
    EXPECT_TRUE(lattice.hinges.empty());
    double inner = 0, outer = 0;
    for (const Bond& bond : lattice.bonds) {
        if (bond.a == 1 && bond.b == 4) inner = bond.stiffness;
        if (bond.a == 0 && bond.b == 3) outer = bond.stiffness;
    }
    EXPECT_DOUBLE_EQ(inner, 0.4);  // two cells' shares
    EXPECT_DOUBLE_EQ(outer, 0.2);
    EXPECT_DOUBLE_EQ(lattice.share[1], 0.5e-4);
    EXPECT_EQ(cell_lattice(block(2, 1, 0, 0.01), cell_constants(1, 0.1, 0.01, 2)).hinges.size(), 8U);
}

TEST(SquareLattice, bends_as_a_plate) {
    // E / (1 - nu^2) in place of E; n cells thick it is stiffer, as strain that varies over a cell is not exact.
    const double nu = 0.25, strain = 1e-5;
    for (const int cells : {2, 4, 8}) {
        const double spacing = 1.0 / cells;
        const auto points = block(6 * cells, cells, 0, spacing);
        const ParticleSet set = plane_set_of(cell_lattice(points, cell_constants(1, nu, spacing, 2)));
        const auto load = tractions(points, spacing, [&](const Vec& x) {
            Eigen::Matrix2d stress = Eigen::Matrix2d::Zero();
            stress(0, 0) = -strain * (x[1] - 0.5);
            return stress;
        });
        double moment = 0;
        for (std::size_t n = 0; n < points.size(); ++n)
            if (points[n][0] > 5.99) moment -= load[n][0] * (points[n][1] - 0.5);
        const auto moved = displacements_in_plane(set, load);
        std::vector<Vec> axis_points, axis_moved;
        for (std::size_t n = 0; n < points.size(); ++n)
            if (std::abs(points[n][1] - 0.5) < 0.01 && std::abs(points[n][0] - 3) < 2.1) {
                axis_points.push_back(points[n]);
                axis_moved.push_back(moved[n]);
            }
        const double curvature = fit(axis_points, axis_moved, 1, [](const Vec& x) {
            return Eigen::VectorXd(Eigen::Vector3d(1, x[0], x[0] * x[0] / 2));
        })[2];
        const double excess = moment / (curvature / 12 / (1 - nu * nu)) - 1;
        EXPECT_NEAR(excess * cells * cells, 1.25, 0.01) << cells << " cells thick";
    }
}

}  // namespace
}  // namespace dmp::tests::solver_square_lattices_tests
