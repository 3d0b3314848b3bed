// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "mesher/cell_lattice.hpp"

namespace dmp::mesher {

/// Spring constants of a shell: two layers of the same triangles, t apart, with bonds along the edges of each layer
/// (k_b), a rung from each node to its partner (k_r), both diagonals between the layers at each edge (k_c), and a
/// dihedral at each edge inside a layer (k_d). Energies without 1/2. Of equilateral triangles of edge a, with l^2 = a^2
/// + t^2 and A = sqrt(3)/2 a^2 the area of a node (docs/elastic.md):
///   p = 2 k_b a^2 + 2 k_c a^4 / l^2,   q = 4 k_c a^2 t^2 / l^2,   r = 6 k_c t^4 / l^2 + k_r t^2,
///   mu = 3 p / (4 A),   lambda = mu - 9 q^2 / (8 r A)   (membrane, thickness free) [N/m]
///   D = 3 sqrt(3)/4 k_b t^2 + 2 sqrt(3) k_d,   nu_b D = sqrt(3)/4 k_b t^2 - 2/sqrt(3) k_d   (bending) [N m]
///   S = 4 sqrt(3) k_c t^2 / l^2   (transverse shear) [N/m]
/// Membrane and layers' bending are exact inside any patch; a layer's dihedrals (Seung & Nelson 1988) are missing along
/// its border. Where that is clamped, hinges between the rungs of an edge and the edges to the point opposite to it
/// stand in for them (k_h): as much as the dihedrals resist in the row of triangles there, of height h, with edges l_1
/// and l_2,
///   k_h = sqrt(3) k_d a / (h SUM (h / l_i)^2) [J], 4/3 k_d for equilateral triangles
struct ShellConstants {
    double edge = 0;                ///< a [m]
    double distance = 0;            ///< t between the layers [m]
    double bond_stiffness = 0;      ///< k_b [N/m]
    double rung_stiffness = 0;      ///< k_r [N/m]
    double cross_stiffness = 0;     ///< k_c [N/m]
    double dihedral_stiffness = 0;  ///< k_d [J]

    [[nodiscard]] double membrane_stiffness() const;  ///< force on a strip's unit width over its strain, "E h" [N/m]
    [[nodiscard]] double membrane_poisson_ratio() const;
    /// D: moment on a unit width over curvature, where the other curvature is 0 [N m].
    [[nodiscard]] double bending_stiffness() const;
    [[nodiscard]] double bending_poisson_ratio() const;
    [[nodiscard]] double shear_stiffness() const;  ///< S: transverse force on a unit width over its angle [N/m]
};

/// The constants, with k_r = k_c = k_b, that give this membrane stiffness ("E h") and D. Throws InputError where the
/// layers alone already bend with more than D.
ShellConstants shell_constants(double membrane_stiffness, double bending_stiffness, double edge, double distance);

/// The shell half a distance to both sides of a surface of triangles: nodes 2 n and 2 n + 1 on the side of the normal
/// of point n and on the other. The constants are those of equilateral triangles of the mean area; others have them
/// scaled: bonds and diagonals with (areas beside the edge) / (its length)^2 (van Gelder 1998), dihedrals with the
/// inverse (Grinspun et al. 2003), rungs with the node's area. Edges on a border have half of it then, and membrane
/// strains that are uniform are exact for equilateral triangles only. Throws InputError for triangles without area, an
/// edge of more than two triangles or of two that are not oriented alike, and points of no triangle. In a `space` with
/// periods triangles may join points on both sides of one. `clamped`: by point; empty: none is.
SpringLattice shell_lattice(const std::vector<Vec>& points, const std::vector<std::array<int, 3>>& triangles,
                            const ShellConstants& constants, const ParticleSpace& space = {},
                            const std::vector<bool>& clamped = {});

}  // namespace dmp::mesher
