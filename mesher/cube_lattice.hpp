// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "base/vec.hpp"
#include "particles/particle_set.hpp"

namespace dmp {

/// Nodes in space and the springs between them, numbered as the nodes are.
struct SpringLattice {
    std::vector<Vec> nodes;     ///< [m]
    std::vector<double> share;  ///< volume [m^3] or, of shells, area [m^2] that each node stands for
    std::vector<Bond> bonds;
    std::vector<Hinge> hinges;
    std::vector<Dihedral> dihedrals;
};

/// Spring constants of a cubic lattice of spacing a: bonds along its edges (k_1) and along both diagonals of its faces
/// (k_2), hinges at the four corners of its faces (k_a). Energies without 1/2. From the energy of a uniform strain,
/// exact for any (docs/springs.md):
///   c_11 = 2 (k_1 + 2 k_2) / a,   c_12 = 2 k_2 / a,   c_44 = 2 k_2 / a + 8 k_a / a^3
/// which is isotropic where c_11 - c_12 = 2 c_44. Springs on the surface have the share of the cells that are there.
struct CubeConstants {
    double spacing = 0;             ///< a [m]
    double edge_stiffness = 0;      ///< k_1 [N/m]
    double diagonal_stiffness = 0;  ///< k_2 [N/m]
    double hinge_stiffness = 0;     ///< k_a [J]

    [[nodiscard]] double c11() const { return 2 * (edge_stiffness + 2 * diagonal_stiffness) / spacing; }      ///< [Pa]
    [[nodiscard]] double c12() const { return 2 * diagonal_stiffness / spacing; }                             ///< [Pa]
    [[nodiscard]] double c44() const { return c12() + 8 * hinge_stiffness / (spacing * spacing * spacing); }  ///< [Pa]
    /// Along an edge; in any direction where the lattice is isotropic.
    [[nodiscard]] double youngs_modulus() const { return c11() - 2 * c12() * poisson_ratio(); }  ///< [Pa]
    [[nodiscard]] double poisson_ratio() const { return c12() / (c11() + c12()); }
    [[nodiscard]] double shear_modulus() const { return c44(); }  ///< [Pa]
};

/// The isotropic lattice of this E [Pa] and Poisson ratio, which may be 0 to 1/4. At 1/4 it needs no hinges, and k_1 =
/// k_2 = E a / 5. Throws InputError for other ratios: bonds alone give 1/4 and hinges lower it.
CubeConstants cube_constants(double youngs_modulus, double poisson_ratio, double spacing);

/// The lattice on points of a cubic grid along the axes: the springs of each cell whose eight corners are there.
/// `step`: of the grid along each axis [m], for one that was stretched a little; rest lengths and shares follow it.
/// Throws InputError when a point is not on the grid that the first one begins, two are one, or a point belongs to no
/// cell.
SpringLattice cube_lattice(const std::vector<Vec>& points, const CubeConstants& constants, const Vec& step);
inline SpringLattice cube_lattice(const std::vector<Vec>& points, const CubeConstants& constants) {
    return cube_lattice(points, constants, Vec::Constant(constants.spacing));
}

/// For points of such a grid, whether each is a corner of a cell whose eight corners are there. Throws as above.
std::vector<bool> in_whole_cells(const std::vector<Vec>& points, const Vec& step);

}  // namespace dmp
