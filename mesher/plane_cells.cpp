// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Of the ParticleBuilder: solids of cells.
#include <algorithm>
#include <sstream>

#include "mesher/particle_builder.hpp"
#include "mesher/region_on_boxes.hpp"

namespace dmp::mesher {

namespace {

/// A node so near to the anchor is clamped: the row of nodes nearest to it, both where it lies half-way [spacings].
constexpr double held_within = 0.5 + 1e-6;

}  // namespace

void ParticleBuilder::claim_cells(SpringSolid& solid, const Region& region) {
    const Part& part = *solid.part;
    const BoxLattice boxes{2, result_.particles.box.low, lattice_step()};
    SolidCells cells = RegionOnBoxes(region, boxes).cells();
    const double drawn = region.area();
    if (cells.cells.empty() || cells.lost_volume > 0.1 * drawn) {
        std::ostringstream problem;
        problem << "'" << part.name.value << "' is too thin for cells: " << cells.lost
                << " boxes of the lattice hold less "
                << "than a quarter of their area of it, and have no cell beside them";
        throw InputError(part.name.location, problem.str(),
                         "refine particles.spacing, or draw its middle line as a curve, with mass_per_length");
    }
    std::vector<Vec> nodes;
    for (const CellNode& node : cells.nodes) nodes.push_back(node.position);
    const std::vector<bool> clamped = clamped_nodes(part, nodes);
    for (std::size_t n = 0; n < nodes.size(); ++n) cells.nodes[n].fixed = clamped[n];
    for (std::size_t n = 0; n < cells.cells.size(); ++n) {
        const auto corners = std::span(cells.cells[n].node).first(4);
        solid.points.push_back(cells.fillings[n].centroid);
        solid.anchored.push_back(std::ranges::any_of(corners, [&](int node) { return cells.nodes[node].fixed; }));
    }
    solid.cells = std::move(cells);
}

std::vector<bool> ParticleBuilder::clamped_nodes(const Part& part, const std::vector<Vec>& nodes) const {
    std::vector<bool> clamped(nodes.size(), false);
    if (part.anchor->empty()) return clamped;
    const double reach = held_within * spacing_;
    if (const auto points = geometry_.points.find(part.anchor); points != geometry_.points.end()) {
        for (const Vec& anchor : points->second) {
            const auto distance = [&](const Vec& node) { return (node - anchor).norm(); };
            const auto nearest = std::ranges::min_element(nodes, {}, distance);
            if (distance(*nearest) < spacing_) clamped[static_cast<std::size_t>(nearest - nodes.begin())] = true;
        }
    } else {
        const NearestCurve held_by(*geometry_.curve_set(part.anchor), reach);
        for (std::size_t k = 0; k < nodes.size(); ++k) clamped[k] = held_by.nearest(nodes[k]).has_value();
    }
    if (std::ranges::find(clamped, true) == clamped.end())
        throw InputError(part.anchor.location,
                         "no node of '" + part.name.value + "' is next to '" + part.anchor.value + "'",
                         "draw the part so that it touches what it is anchored to");
    return clamped;
}

void ParticleBuilder::add_cells(const SpringSolid& solid, int part_number, MeshReport::SpringLine& line) {
    const Part& part = *solid.part;
    const SolidCells& cells = *solid.cells;
    ParticleSet& set = result_.particles;
    const auto first = static_cast<int>(set.size()), first_node = static_cast<int>(set.cell_nodes.size());
    for (std::size_t n = 0; n < cells.cells.size(); ++n) {
        const Filling& filling = cells.fillings[n];
        SolidCell cell = cells.cells[n];
        const auto corners = std::span(cell.node).first(4);
        const bool held = std::ranges::all_of(corners, [&](int node) { return cells.nodes[node].fixed; });
        add_particle(part_number, {filling.centroid, filling.volume, filling.volume * part.density,
                                   bodies_ + cells.piece[n], held, Vec::Zero(), 0});
        cell.particle += first;
        for (int& node : corners) node += first_node;
        set.cells.push_back(cell);
    }
    set.cell_nodes.insert(set.cell_nodes.end(), cells.nodes.begin(), cells.nodes.end());
    bodies_ += cells.pieces;
    line.bodies = cells.pieces;
    line.anchored = static_cast<std::size_t>(std::ranges::count(cells.nodes, true, &CellNode::fixed));
    line.particle_mass = lattice_.cell_area() * part.density;
    line.elements = {cells.cells.size(),
                     cells.nodes.size(),
                     cells.cut,
                     cells.volume(),
                     geometry_.region(part.name)->area(),
                     part.youngs_modulus,
                     part.poisson_ratio,
                     to_string(*part.elastic_law)};
    if (cells.lost > 0) {
        std::ostringstream note;
        note << part.name.value << ": " << cells.lost << " boxes of the lattice with little of it, in all "
             << cells.lost_volume << " m^2, have no cell beside them and are left out";
        result_.report.notes.push_back(note.str());
    }
}

}  // namespace dmp::mesher
