// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "mesher/cell_solids.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <span>
#include <sstream>

#include "base/errors.hpp"
#include "base/number_text.hpp"
#include "models/elastic/corner_masses.hpp"

namespace dmp::mesher {

namespace {

/// Of the drawn volume: with more in boxes that have no cell beside them, the part is not what was drawn.
constexpr double most_lost = 0.1;

std::span<const int> corners(const SolidCells& cells, std::size_t cell, int dimension) {
    return std::span(cells.cells[cell].node).first(std::size_t{1} << dimension);
}

/// The largest moment of inertia of a free piece over that of what it has of the solid (corner_masses).
double largest_inertia(const SolidCells& cells, int dimension) {
    double largest = 1;
    for (int piece = 0; piece < cells.pieces; ++piece) {
        std::vector<CellMass> masses;
        std::vector<Vec> places;
        std::map<int, int> number;
        bool held = false;
        for (std::size_t n = 0; n < cells.cells.size(); ++n) {
            if (cells.piece[n] != piece) continue;
            const SolidCell& cell = cells.cells[n];
            CellMass& mass = masses.emplace_back();
            mass = {cell.node, cell.size, cell.centroid, cell.moment, cells.fillings[n].volume};
            for (int k = 0; k < 1 << dimension; ++k) {
                const CellNode& node = cells.nodes[cell.node[k]];
                const auto [known, is_new] = number.try_emplace(cell.node[k], static_cast<int>(places.size()));
                if (is_new) places.push_back(node.position);
                mass.node[k] = known->second;
                held = held || node.fixed;
            }
        }
        if (!held) largest = std::max(largest, corner_masses(dimension, masses, places).inertia);
    }
    return largest;
}

}  // namespace

BoxLattice boxes_of(const ParticleSpace& space, const Vec& step) { return boxes_of(space, step, space.box.low); }

BoxLattice boxes_of(const ParticleSpace& space, const Vec& step, const Vec& origin) {
    BoxLattice boxes{space.dimension, origin, step};
    for (int axis = 0; axis < space.dimension; ++axis) {
        if (!space.periodic[axis]) continue;
        boxes.period[axis] = static_cast<int>(std::lround(space.box.extent()[axis] / step[axis]));
        boxes.origin[axis] = space.box.low[axis];
        boxes.first[axis] = 0;
        boxes.last[axis] = boxes.period[axis];
    }
    for (int axis = 0; axis < space.dimension; ++axis) {
        const auto number = [&](const Vec& corner) {
            return static_cast<int>(std::lround((corner[axis] - boxes.origin[axis]) / step[axis]));
        };
        if (space.mirrored[axis][0]) boxes.first[axis] = number(space.box.low);
        if (space.mirrored[axis][1]) boxes.last[axis] = number(space.box.high);
    }
    return boxes;
}

void hold_on_planes(const ParticleSpace& space, SolidCells& cells) {
    constexpr double on_it = 1e-6, reaches = 0.1;  // [spacings]
    for (std::size_t n = 0; n < cells.cells.size(); ++n)
        for (int axis = 0; axis < space.dimension; ++axis)
            for (const int side : {0, 1}) {
                if (!space.mirrored[axis][side]) continue;
                const double plane = (side == 0 ? space.box.low : space.box.high)[axis];
                // Half the thickness of a slab with this second moment.
                const double half = std::sqrt(3 * cells.fillings[n].moment[axis]);
                if (std::abs(cells.fillings[n].centroid[axis] - plane) > half + reaches * space.spacing) continue;
                for (const int number : corners(cells, n, space.dimension)) {
                    CellNode& node = cells.nodes[number];
                    if (std::abs(node.position[axis] - plane) < on_it * space.spacing) node.on_plane[axis] = true;
                }
            }
}

bool is_clamped(const Vec& from_anchor, const Vec& normal, double spacing, bool is_of_cut_cells) {
    constexpr double a_little = 1e-6;
    const double off = from_anchor.dot(normal), beside = (from_anchor - off * normal).norm();
    return std::abs(off) <= (0.5 + a_little) * spacing && beside <= ((is_of_cut_cells ? 1 : 0) + a_little) * spacing;
}

std::vector<bool> nodes_of_cut_cells(const SolidCells& cells, int dimension) {
    std::vector<bool> of_cut(cells.nodes.size(), true);
    for (std::size_t n = 0; n < cells.cells.size(); ++n)
        if (cells.fillings[n].volume >= (1 - 1e-6) * cells.cells[n].size.head(dimension).prod())
            for (const int node : corners(cells, n, dimension)) of_cut[static_cast<std::size_t>(node)] = false;
    return of_cut;
}

void clamp_cell_at(const Vec& point, int dimension, double spacing, SolidCells& cells) {
    const auto distance = [&](const Filling& filling) { return (filling.centroid - point).norm(); };
    const auto nearest = std::ranges::min_element(cells.fillings, {}, distance);
    if (distance(*nearest) > 1.5 * spacing) return;
    for (const int node : corners(cells, static_cast<std::size_t>(nearest - cells.fillings.begin()), dimension))
        cells.nodes[node].fixed = true;
}

void check_filled(const Part& part, const SolidCells& cells, double drawn) {
    if (!cells.cells.empty() && cells.lost_volume <= most_lost * drawn) return;
    std::ostringstream problem;
    problem << "'" << part.name.value << "' is too thin for cells: " << cells.lost
            << " boxes of the lattice have too little of it for a cell and no cell beside them";
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

void report_cells(const Part& part, const SolidCells& cells, double drawn, MeshReport::SpringLine& line,
                  MeshReport& report) {
    line.bodies = cells.pieces;
    line.anchored = static_cast<std::size_t>(std::ranges::count(cells.nodes, true, &CellNode::fixed));
    const Vec& size = cells.cells.front().size;  // of its own lattice
    line.particle_mass = size[0] * size[1] * (size[2] > 0 ? size[2] : 1) * part.density;
    line.elements = {
        cells.cells.size(), cells.nodes.size(),          cells.cut, cells.volume(), drawn, part.youngs_modulus,
        part.poisson_ratio, to_string(*part.elastic_law)};
    const double share = (cells.volume() - cells.behind_anchor) / drawn;
    if (std::abs(share - 1) > 0.02) {
        std::ostringstream warning;
        warning.precision(3);
        warning << part.name.value << ": its cells have " << share
                << " of the drawn volume: some of it is beyond the sides of the scene or too thin"
                << (cells.cells.front().size[2] > 0 ? ", or its surfaces are seen too coarsely by seven lines a box"
                                                    : "")
                << "; a finer particles.spacing is nearer";
        report.warnings.push_back(warning.str());
    }
    if (const double inertia = largest_inertia(cells, size[2] > 0 ? 3 : 2); inertia > 1.01)
        report.warnings.push_back(part.name.value + ": as its mass is at the corners of its cells, it turns with " +
                                  number_text(inertia, 3) +
                                  " of its moment of inertia, for want of nodes inside it; take a smaller "
                                  "particles.spacing, so that it is two cells thick");
    if (cells.lost == 0) return;
    std::ostringstream note;
    note << part.name.value << ": " << cells.lost << " boxes of the lattice with little of it, in all "
         << 100 * cells.lost_volume / drawn << " % of its volume, have no cell beside them and are left out";
    report.notes.push_back(note.str());
}

}  // namespace dmp::mesher
