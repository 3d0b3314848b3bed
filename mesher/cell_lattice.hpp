// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "base/vec.hpp"
#include "mesher/uses.hpp"
#include "particles/particle_set.hpp"

namespace dmp::mesher {

/// Nodes in 3-D and the springs between them, numbered as the nodes are.
struct SpringLattice {
    std::vector<Vec> nodes;     ///< [m]
    std::vector<double> share;  ///< volume [m^3] or, of shells and in 2-D, area [m^2] that each node stands for
    std::vector<Bond> bonds;
    std::vector<Hinge> hinges;
    std::vector<Dihedral> dihedrals;
};

/// Spring constants of a cubic lattice of spacing a, or of a square one in 2-D, 1 m deep: bonds along the edges
/// of its cells (k_1) and along both diagonals of their faces (k_2), hinges at the four corners of those faces (k_a).
/// Energies without 1/2. From the energy of a uniform strain, exact for any (docs/elastic.md), with d dimensions and b
/// = a in 3-D, 1 m in 2-D:
///   c_11 = 2 (k_1 + (d - 1) k_2) / b,   c_12 = 2 k_2 / b,   c_44 = 2 k_2 / b + 8 k_a / (a^2 b)
/// which is isotropic where c_11 - c_12 = 2 c_44. In 2-D that is a material held in its depth (plane strain).
/// Springs on the surface have the share of the cells that are there.
struct CellConstants {
    int dimension = 3;
    double spacing = 0;             ///< a [m]
    double edge_stiffness = 0;      ///< k_1 [N/m]
    double diagonal_stiffness = 0;  ///< k_2 [N/m]
    double hinge_stiffness = 0;     ///< k_a [J]

    [[nodiscard]] double depth() const { return dimension == 3 ? spacing : 1; }  ///< b [m]
    [[nodiscard]] double c11() const { return 2 * (edge_stiffness + (dimension - 1) * diagonal_stiffness) / depth(); }
    [[nodiscard]] double c12() const { return 2 * diagonal_stiffness / depth(); }                             ///< [Pa]
    [[nodiscard]] double c44() const { return c12() + 8 * hinge_stiffness / (spacing * spacing * depth()); }  ///< [Pa]
    /// Along an edge; in any direction where the lattice is isotropic.
    [[nodiscard]] double youngs_modulus() const { return c11() - 2 * c12() * poisson_ratio(); }  ///< [Pa]
    [[nodiscard]] double poisson_ratio() const { return c12() / (c11() + c12()); }
    [[nodiscard]] double shear_modulus() const { return c44(); }  ///< [Pa]
};

/// The isotropic lattice of this E [Pa] and Poisson ratio, which may be 0 to 1/4. At 1/4 it needs no hinges. Throws
/// InputError for other ratios: bonds alone give 1/4 and hinges lower it.
CellConstants cell_constants(double youngs_modulus, double poisson_ratio, double spacing, int dimension = 3);

/// Along each axis how many points of a grid with this step make a period of the box; 0: it is not periodic.
std::array<long, 3> points_in_period(const ParticleSpace& space, const Vec& step);

/// The lattice on points of a cubic or square grid along the axes: the springs of each cell whose corners are all
/// there, also on the other side of a period (points_in_period), which must be three points or longer. `step`: of the
/// grid along each axis [m], for one that was stretched a little; rest lengths and shares follow it. Shares are volumes
/// [m^3], in 2-D areas [m^2]. Throws InputError when a point is not on the grid that the first one begins, two are one,
/// or a point belongs to no cell.
SpringLattice cell_lattice(const std::vector<Vec>& points, const CellConstants& constants, const Vec& step,
                           const std::array<long, 3>& period = {});
inline SpringLattice cell_lattice(const std::vector<Vec>& points, const CellConstants& constants) {
    return cell_lattice(points, constants, Vec::Constant(constants.spacing));
}

/// For points of such a grid, whether each is a corner of a cell whose corners are all there. Throws as above.
std::vector<bool> in_whole_cells(const std::vector<Vec>& points, const Vec& step, int dimension = 3,
                                 const std::array<long, 3>& period = {});

}  // namespace dmp::mesher
