// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "mesher/mesh.hpp"
#include "mesher/solid_cells.hpp"
#include "mesher/uses.hpp"
#include "scene/scene.hpp"

namespace dmp::mesher {

/// How far from its anchor a node may be and be clamped [spacings].
constexpr double farthest_clamped = 1.2;

/// Whether a node is clamped: at most half a spacing before or behind the anchor's nearest face, so that it is of the
/// nearest row of nodes (of both where the face is half-way between them), and at most a spacing beside its edge, as
/// nodes of cells that the surface cuts are outside the solid. `normal`: of that face, of unit length.
[[nodiscard]] bool is_clamped(const Vec& from_anchor, const Vec& normal, double spacing);

/// Throws InputError for a part of which the cells have too little. `drawn`: its volume [m^3], in 2-D [m^2].
void check_filled(const Part& part, const SolidCells& cells, double drawn);

/// Adds cells to a set whose particles from `first` on are theirs, in their order.
void add_cells_of(const SolidCells& cells, std::size_t first, ParticleSet& set);

/// Whether all corners of a cell are clamped, and whether any is.
[[nodiscard]] bool is_held(const SolidCells& cells, std::size_t cell, int dimension);
[[nodiscard]] bool is_partly_held(const SolidCells& cells, std::size_t cell, int dimension);

/// What the report says of them. `bodies` before them.
void report_cells(const Part& part, const SolidCells& cells, double drawn, double whole_cell,
                  MeshReport::SpringLine& line, std::vector<std::string>& notes);

}  // namespace dmp::mesher
