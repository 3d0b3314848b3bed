// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "mesher/cell_solids.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <sstream>

#include "base/errors.hpp"

namespace dmp::mesher {

namespace {

/// Of the drawn volume: with more in boxes that have no cell beside them, the part is not what was drawn.
constexpr double most_lost = 0.1;

std::span<const int> corners(const SolidCells& cells, std::size_t cell, int dimension) {
    return std::span(cells.cells[cell].node).first(std::size_t{1} << dimension);
}

}  // namespace

bool is_clamped(const Vec& from_anchor, const Vec& normal, double spacing) {
    constexpr double a_little = 1e-6;
    const double off = from_anchor.dot(normal), beside = (from_anchor - off * normal).norm();
    return std::abs(off) <= (0.5 + a_little) * spacing && beside <= (1 + a_little) * spacing;
}

void check_filled(const Part& part, const SolidCells& cells, double drawn) {
    if (!cells.cells.empty() && cells.lost_volume <= most_lost * drawn) return;
    std::ostringstream problem;
    problem << "'" << part.name.value << "' is too thin for cells: " << cells.lost
            << " boxes of the lattice are filled by less than a quarter and have no cell beside them";
    throw InputError(part.name.location, problem.str(),
                     "refine particles.spacing to half of its thickness, or draw its middle as a curve, with "
                     "mass_per_length, or in 3-D as a surface, with thickness");
}

bool is_held(const SolidCells& cells, std::size_t cell, int dimension) {
    return std::ranges::all_of(corners(cells, cell, dimension), [&](int node) { return cells.nodes[node].fixed; });
}
bool is_partly_held(const SolidCells& cells, std::size_t cell, int dimension) {
    return std::ranges::any_of(corners(cells, cell, dimension), [&](int node) { return cells.nodes[node].fixed; });
}

void add_cells_of(const SolidCells& cells, std::size_t first, ParticleSet& set) {
    const auto first_node = static_cast<int>(set.cell_nodes.size());
    for (SolidCell cell : cells.cells) {
        cell.particle += static_cast<int>(first);
        for (int& node : std::span(cell.node).first(std::size_t{1} << set.dimension)) node += first_node;
        set.cells.push_back(cell);
    }
    set.cell_nodes.insert(set.cell_nodes.end(), cells.nodes.begin(), cells.nodes.end());
}

void report_cells(const Part& part, const SolidCells& cells, double drawn, double whole_cell,
                  MeshReport::SpringLine& line, std::vector<std::string>& notes) {
    line.bodies = cells.pieces;
    line.anchored = static_cast<std::size_t>(std::ranges::count(cells.nodes, true, &CellNode::fixed));
    line.particle_mass = whole_cell * part.density;
    line.elements = {
        cells.cells.size(), cells.nodes.size(),          cells.cut, cells.volume(), drawn, part.youngs_modulus,
        part.poisson_ratio, to_string(*part.elastic_law)};
    if (cells.lost == 0) return;
    std::ostringstream note;
    note << part.name.value << ": " << cells.lost << " boxes of the lattice with little of it, in all "
         << 100 * cells.lost_volume / drawn << " % of its volume, have no cell beside them and are left out";
    notes.push_back(note.str());
}

}  // namespace dmp::mesher
