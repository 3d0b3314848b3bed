// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
//
// Lattices of springs as solid bodies under loads.
#pragma once

#include <Eigen/Dense>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "mesher/cell_lattice.hpp"
#include "tests/modules.hpp"
#include "tests/unit/solver/statics.hpp"

namespace dmp::tests::lattice_solids {

using V3 = Vector<double, 3>;
using Body = SpringNetwork<3>;
using Loads = Body::Vectors;
inline constexpr double pi = std::numbers::pi;

inline ParticleSet set_of(const SpringLattice& lattice) {
    ParticleSet set = set_of_nodes(3, lattice.nodes, lattice.share);
    set.bonds = lattice.bonds;
    set.hinges = lattice.hinges;
    set.dihedrals = lattice.dihedrals;
    return set;
}

/// Displacements of the nodes under the loads, which are in balance unless nodes are held.
inline std::vector<Vec> displacements(const ParticleSet& set, const Loads& load) {
    const Body body(set, part_with(0), 0);
    const auto at = statics(body, set, load);
    std::vector<Vec> moved;
    for (std::size_t n = 0; n < at.size(); ++n) moved.emplace_back(Vec(at[n][0], at[n][1], at[n][2]) - set.position[n]);
    return moved;
}

/// The displacement's best fit u = sum c_k f_k(x) along one axis: the coefficients c.
inline Eigen::VectorXd fit(const std::vector<Vec>& position, const std::vector<Vec>& moved, int axis,
                           const std::function<Eigen::VectorXd(const Vec&)>& shapes) {
    const Eigen::Index rows = static_cast<Eigen::Index>(position.size()), columns = shapes(position[0]).size();
    Eigen::MatrixXd matrix(rows, columns);
    Eigen::VectorXd right(rows);
    for (Eigen::Index n = 0; n < rows; ++n) {
        matrix.row(n) = shapes(position[static_cast<std::size_t>(n)]).transpose();
        right[n] = moved[static_cast<std::size_t>(n)][axis];
    }
    return matrix.colPivHouseholderQr().solve(right);
}
inline Eigen::VectorXd linear(const Vec& x) { return Eigen::Vector4d(1, x[0], x[1], x[2]); }
inline Eigen::VectorXd quadratic(const Vec& x) {
    return (Eigen::VectorXd(6) << 1, x[0], x[1], x[0] * x[0] / 2, x[1] * x[1] / 2, x[0] * x[1]).finished();
}

inline std::vector<Vec> block(int nx, int ny, int nz, double spacing) {
    std::vector<Vec> points;
    for (int k = 0; k <= nz; ++k)
        for (int j = 0; j <= ny; ++j)
            for (int i = 0; i <= nx; ++i) points.emplace_back(i * spacing, j * spacing, k * spacing);
    return points;
}

}  // namespace dmp::tests::lattice_solids
