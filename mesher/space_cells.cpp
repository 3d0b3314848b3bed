// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Of the SpaceBuilder: solids of cells.
#include <algorithm>
#include <sstream>

#include "mesher/cell_solids.hpp"
#include "mesher/own_lattice.hpp"
#include "mesher/solid_on_boxes.hpp"
#include "mesher/space_builder.hpp"

namespace dmp::mesher {

/// Takes the points of the scene's lattice in the box of a cell.
void SpaceBuilder::claim_box(const Vec& low, const Vec& size) {
    const Vec step = lattice_step(), first = lattice_->at(0, 0, 0);
    const std::array<long, 3> points{lattice_->points(), lattice_->rows()[0].lines,
                                     static_cast<long>(lattice_->rows().size())};
    std::array<long, 3> from{}, to{};
    for (int axis = 0; axis < 3; ++axis) {
        const auto at = static_cast<std::size_t>(axis);
        const double begin = (low[axis] - first[axis]) / step[axis], end = begin + size[axis] / step[axis];
        constexpr double a_little = 1e-6;
        // Outside of the lattice there is no fluid.
        from.at(at) = std::max(0L, std::lround(std::ceil(begin - a_little)));
        to.at(at) = std::min(points.at(at), std::lround(std::ceil(end - a_little)));
    }
    for (long k = from[2]; k < to[2]; ++k)
        for (long j = from[1]; j < to[1]; ++j)
            for (long i = from[0]; i < to[0]; ++i) {
                std::int16_t& here =
                    owner_.at(static_cast<std::size_t>((k * lattice_->rows()[0].lines + j) * lattice_->points() + i));
                if (here == nobody) here = in_a_shell;
            }
}

/// Takes the lattice points inside the solid, and those in boxes with a cell of it.
void SpaceBuilder::claim_cells(const Part& part, const Solid& solid) {
    if (*scene_.particles.arrangement != Arrangement::square)
        throw InputError(scene_.particles.arrangement.location,
                         "'" + part.name.value + "' is a solid of cells, which are built on the cubic lattice only",
                         "write particles.arrangement = \"square\", or model = \"springs\" and bonds_within");
    if (solid.surface.has_holes)
        throw InputError(
            part.name.location,
            "the surface of '" + part.name.value + "' has holes, so that what of a cell it fills is not known",
            "close it: geometry.repair, or dmp inspect, says where it is open");
    const Vec step = lattice_step();
    const BoxLattice of_scene = boxes_of(result_.particles, step, lattice_->at(0, 0, 0) - 0.5 * step);
    const BoxLattice boxes =
        own_lattice(result_.particles, of_scene, marks_of(solid.surface, anchor_of(part), spacing_));
    if (const std::string text = lattice_text(of_scene, boxes); !text.empty())
        result_.report.notes.push_back(part.name.value + ": its cells have a lattice of their own, " + text);
    SolidCells cells = SolidOnBoxes(solid.surface, boxes).cells();
    check_filled(part, cells, solid.volume());
    hold_on_planes(result_.particles, cells);
    const std::int16_t owner = owner_of_wall(walls_.size() + spring_solids_.size());
    claim(solid.surface, owner);
    for (const SolidCell& cell : cells.cells) claim_box(cells.nodes[cell.node[0]].position, cell.size);
    spring_solids_.push_back({&part, {}, std::move(cells)});
}

const TriangleSurface* SpaceBuilder::anchor_of(const Part& part) const {
    if (part.anchor->empty()) return nullptr;
    const Solid* solid = geometry_.solid(part.anchor);
    return solid != nullptr ? &solid->surface : &geometry_.surface_set(part.anchor)->surface;
}

void SpaceBuilder::clamp_cells(const Part& part, SolidCells& cells) const {
    if (part.anchor->empty()) return;
    const TriangleSurface& surface = *anchor_of(part);
    const double step = lattice_step().maxCoeff();
    const NearestTriangle anchor(surface, farthest_clamped * step);
    const std::vector<bool> of_cut = nodes_of_cut_cells(cells, 3);
    for (std::size_t n = 0; n < cells.nodes.size(); ++n)
        if (const auto found = anchor.nearest(cells.nodes[n].position))
            cells.nodes[n].fixed = is_clamped(cells.nodes[n].position - found->point,
                                              normal_of(surface, found->triangle), step, of_cut[n]);
    if (std::ranges::any_of(cells.nodes, &CellNode::fixed)) return;
    std::ostringstream problem;
    problem << "no node of '" << part.name.value << "' is within half a spacing of '" << part.anchor.value << "'";
    throw InputError(part.anchor.location, problem.str(), "draw the part so that it touches what it is anchored to");
}

void SpaceBuilder::add_cells(SpringSolid& solid, int part, MeshReport::SpringLine& line) {
    SolidCells& cells = *solid.cells;
    clamp_cells(*solid.part, cells);
    ParticleSet& set = result_.particles;
    const std::size_t first = set.size();
    for (std::size_t n = 0; n < cells.cells.size(); ++n) {
        const Filling& filling = cells.fillings[n];
        add_particle(filling.centroid, part, 0);
        set.volume.back() = filling.volume;
        set.mass.back() = filling.volume * solid.part->density;
        set.body.back() = bodies_ + cells.piece[n];
        set.fixed.back() = is_held(cells, n, 3) ? 1 : 0;
    }
    add_cells_of(cells, first, set);
    bodies_ += cells.pieces;
    report_cells(*solid.part, cells, geometry_.solid(solid.part->name)->volume(), line, result_.report);
}

}  // namespace dmp::mesher
