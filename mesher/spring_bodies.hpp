// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "geometry/triangle_surface.hpp"
#include "mesher/cell_lattice.hpp"
#include "mesher/mesh.hpp"
#include "mesher/shell_lattice.hpp"
#include "mesher/uses.hpp"
#include "scene/scene.hpp"

namespace dmp::mesher {

/// A body of springs on cells or in layers, and what each of its nodes stands for.
struct SpringBody {
    SpringLattice lattice;
    std::vector<double> volume;  ///< in the SPH sums [m^3], in 2-D [m^2]
    std::vector<double> mass;    ///< [kg]
};

/// A solid of springs on those points of a cubic grid, or in the plane of a square one, that belong to whole cells.
/// Each node stands for a cell of the grid. The cells between the nodes fill less than the nodes stand for, by half a
/// spacing at the surface: their springs are that much stiffer, so that the body stretches as one that fills all of it;
/// bending stays softer.
struct SolidBody : SpringBody {
    CellConstants constants;
    double stiffened = 1;  ///< what the cells between the nodes fill, into what the nodes stand for [-]
};
/// `points` as in_whole_cells() leaves them; `step` of the grid [m]. Throws InputError for a Poisson ratio beyond 1/4.
SolidBody solid_body(const Part& part, const std::vector<Vec>& points, const Vec& step, const ParticleSpace& space);

/// A shell half a spacing to both sides of a sheet, which is meshed anew so that each pair of nodes has about spacing^2
/// of it. In the SPH sums nodes at its border stand for as much as those inside: the shell reaches half a spacing on.
/// Its membrane stiffness E h is lowered, if the part allows it, where two layers a spacing apart would alone bend with
/// more than half of D = E h^3 / (12 (1 - nu^2)); D is held.
struct ShellBody : SpringBody {
    ShellConstants constants;
    double membrane_stiffness_asked = 0;  ///< E h [N/m]
};
/// `sheet`: one connected piece, which goes on through a periodic side where its rims on both are alike. Throws
/// InputError for a sheet too small to bend, one that branches, or one whose membrane stiffness may not be lowered
/// though it must. `is_clamped`: whether the shell is held at a point of the sheet.
ShellBody shell_body(const Part& part, const TriangleSurface& sheet, const ParticleSpace& space,
                     const std::function<bool(const Vec&)>& is_clamped);

/// By node: the number of the connected piece that it belongs to, from `pieces` on by ascending first node; `pieces`
/// counts on.
std::vector<int> pieces_of(const SpringLattice& lattice, int& pieces);

/// Adds the lattice's springs to a set whose particles from `first` on are its nodes, and counts them.
void add_elastic_of(const SpringLattice& lattice, std::size_t first, ParticleSet& set, MeshReport::SpringLine& line);

/// Gives a solid of springs the mass of what is drawn, shared alike by its nodes, the particles from `first` on; in the
/// SPH sums they keep their volume. Not where `corners` of what is drawn are beyond a periodic side or a plane of
/// symmetry: there nodes have the mass of what they stand for. Says how far that is from the drawn one, and warns where
/// it is off by more than a tenth. `drawn`: its volume [m^3], in 2-D [m^2].
void share_drawn_mass(const Part& part, double drawn, const std::vector<Vec>& corners, std::size_t first,
                      ParticleSet& set, MeshReport::SpringLine& line, MeshReport& report);

/// Says where the nodes from `first` on reach a side of the box beyond which the scene goes on, and their springs do
/// not. A warning, with the place, where free nodes would be bonded to others across the side, or stand at a plane of
/// symmetry. `may_be_cells`: whether it is an area or a volume.
void note_open_ends(const ParticleSet& set, std::size_t first, const std::string& part, bool may_be_cells,
                    MeshReport& report);

}  // namespace dmp::mesher
