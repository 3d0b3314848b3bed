// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Of the ParticleBuilder: solids of cells.
#include <algorithm>
#include <limits>

#include "mesher/cell_solids.hpp"
#include "mesher/particle_builder.hpp"
#include "mesher/region_on_boxes.hpp"

namespace dmp::mesher {

namespace {

/// The same as is_clamped for the nearest segment of a curve; of two that meet there the one that it is farther off.
bool is_clamped_by(const CurveSet& anchor, const Vec& node, double spacing, bool is_of_cut_cells) {
    double nearest = std::numeric_limits<double>::infinity();
    bool clamped = false;
    for (const Polyline& piece : anchor.pieces)
        for (std::size_t n = 0; n + (piece.closed ? 0 : 1) < piece.points.size(); ++n) {
            const Vec &a = piece.points[n], &b = piece.points[(n + 1) % piece.points.size()];
            const Vec along = (b - a).normalized();
            const Vec point = a + std::clamp((node - a).dot(along), 0.0, (b - a).norm()) * along;
            const double distance = (node - point).norm();
            if (distance > nearest + 1e-9 * spacing) continue;
            const bool by_this = is_clamped(node - point, Vec(-along[1], along[0], 0), spacing, is_of_cut_cells);
            clamped = distance < nearest - 1e-9 * spacing ? by_this : clamped && by_this;
            nearest = std::min(nearest, distance);
        }
    return clamped;
}

}  // namespace

void ParticleBuilder::claim_cells(SpringSolid& solid, const Region& region) {
    const Part& part = *solid.part;
    const BoxLattice boxes = boxes_of(result_.particles, lattice_step());
    SolidCells cells = RegionOnBoxes(region, boxes).cells();
    check_filled(part, cells, region.area());
    hold_on_planes(result_.particles, cells);
    clamp_cells(part, cells);
    for (std::size_t n = 0; n < cells.cells.size(); ++n) {
        solid.points.push_back(cells.fillings[n].centroid);
        solid.anchored.push_back(is_partly_held(cells, n, 2));
    }
    solid.cells = std::move(cells);
}

void ParticleBuilder::clamp_cells(const Part& part, SolidCells& cells) const {
    if (part.anchor->empty()) return;
    if (const auto points = geometry_.points.find(part.anchor); points != geometry_.points.end()) {
        for (const Vec& anchor : points->second) clamp_cell_at(anchor, 2, spacing_, cells);
    } else {
        const CurveSet& anchor = *geometry_.curve_set(part.anchor);
        const double step = lattice_step().maxCoeff();
        const NearestCurve held_by(anchor, farthest_clamped * step);
        const std::vector<bool> of_cut = nodes_of_cut_cells(cells, 2);
        for (std::size_t n = 0; n < cells.nodes.size(); ++n)
            if (CellNode& node = cells.nodes[n]; held_by.nearest(node.position))
                node.fixed = is_clamped_by(anchor, node.position, step, of_cut[n]);
    }
    if (std::ranges::none_of(cells.nodes, &CellNode::fixed))
        throw InputError(part.anchor.location,
                         "no node of '" + part.name.value + "' is next to '" + part.anchor.value + "'",
                         "draw the part so that it touches what it is anchored to");
}

void ParticleBuilder::add_cells(const SpringSolid& solid, int part_number, MeshReport::SpringLine& line) {
    const SolidCells& cells = *solid.cells;
    const std::size_t first = result_.particles.size();
    for (std::size_t n = 0; n < cells.cells.size(); ++n) {
        const Filling& filling = cells.fillings[n];
        add_particle(part_number, {filling.centroid, filling.volume, filling.volume * solid.part->density,
                                   bodies_ + cells.piece[n], is_held(cells, n, 2), Vec::Zero(), 0});
    }
    add_cells_of(cells, first, result_.particles);
    bodies_ += cells.pieces;
    report_cells(*solid.part, cells, geometry_.region(solid.part->name)->area(), lattice_.cell_area(), line,
                 result_.report);
}

}  // namespace dmp::mesher
