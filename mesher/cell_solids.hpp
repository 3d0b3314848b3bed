// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "mesher/mesh.hpp"
#include "mesher/solid_cells.hpp"
#include "mesher/uses.hpp"
#include "scene/scene.hpp"

namespace dmp::mesher {

/// The boxes of a lattice with this step that begins at the low corner of the set's box, or at another corner of it.
[[nodiscard]] BoxLattice boxes_of(const ParticleSpace& space, const Vec& step);
[[nodiscard]] BoxLattice boxes_of(const ParticleSpace& space, const Vec& step, const Vec& origin);

/// Nodes on a plane of symmetry stay in it.
void hold_on_planes(const ParticleSpace& space, SolidCells& cells);

/// How far from its anchor a node may be and be clamped [spacings].
constexpr double farthest_clamped = 1.2;

/// Whether a node is clamped: at most half a spacing before or behind the anchor's nearest face, so that it is of the
/// nearest row of nodes (of both where the face is half-way between them), and not beside its edge; but a node of cells
/// that the surface cuts, and of no other, is outside the solid, and may be a spacing beside. `normal`: of that face,
/// of unit length; `spacing`: the lattice's largest step [m].
[[nodiscard]] bool is_clamped(const Vec& from_anchor, const Vec& normal, double spacing, bool is_of_cut_cells);
/// By node.
[[nodiscard]] std::vector<bool> nodes_of_cut_cells(const SolidCells& cells, int dimension);
/// Clamps the nodes of the cell that is nearest to a point, if it is next to it: one node alone would be a pivot.
void clamp_cell_at(const Vec& point, int dimension, double spacing, SolidCells& cells);

/// Throws InputError for a part of which the cells have too little. `drawn`: its volume [m^3], in 2-D [m^2].
void check_filled(const Part& part, const SolidCells& cells, double drawn);

/// Adds cells to a set whose particles from `first` on are theirs, in their order.
void add_cells_of(const SolidCells& cells, std::size_t first, ParticleSet& set);

/// Whether all corners of a cell are clamped, and whether any is.
[[nodiscard]] bool is_held(const SolidCells& cells, std::size_t cell, int dimension);
[[nodiscard]] bool is_partly_held(const SolidCells& cells, std::size_t cell, int dimension);

/// What the report says of them; it warns where their volume is not the drawn one within 2 %.
void report_cells(const Part& part, const SolidCells& cells, double drawn, MeshReport::SpringLine& line,
                  MeshReport& report);

}  // namespace dmp::mesher
