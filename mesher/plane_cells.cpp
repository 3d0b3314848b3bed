// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Of the ParticleBuilder: solids of cells.
#include <algorithm>
#include <cmath>
#include <limits>
#include <list>
#include <set>

#include "base/length_text.hpp"
#include "mesher/cell_solids.hpp"
#include "mesher/own_lattice.hpp"
#include "mesher/particle_builder.hpp"
#include "mesher/places_with_room.hpp"
#include "mesher/region_on_boxes.hpp"
#include "mesher/relax.hpp"
#include "mesher/slits.hpp"
#include "mesher/turned_lattice.hpp"

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

/// Of a liquid particle that is added from walls' surfaces [spacings].
constexpr double added_from_wall = 0.5;
/// Places along each side of a box that are tried.
constexpr int places_of_a_side = 8;

using BoxIndex = std::array<int, 3>;

/// Adds what another area fills of each cell's box.
void fill_up(const RegionOnBoxes& with, const BoxLattice& boxes, SolidCells& cells) {
    for (std::size_t n = 0; n < cells.cells.size(); ++n) {
        SolidCell& cell = cells.cells[n];
        Filling& filling = cells.fillings[n];
        const Vec middle = filling.centroid - cell.centroid;
        const Filling more = with.filling(box_at(boxes, middle));
        if (!(more.volume > 0)) continue;
        filling.add(more);
        cells.behind_anchor += more.volume;
        cell.centroid = filling.centroid - middle;
        cell.moment = filling.moment;
    }
}

}  // namespace

std::vector<Vec> ParticleBuilder::places_beside_bodies(const Part& part, const std::vector<Vec>& corners) const {
    std::vector<Vec> places;
    for (const Vec& corner : corners)
        for (int n = 0; n < places_of_a_side * places_of_a_side; ++n) {
            const Vec within(n % places_of_a_side + 0.5, n / places_of_a_side + 0.5, 0);
            const Vec place = corner + within.cwiseProduct(lattice_step()) / places_of_a_side;
            if (fluid_at(place) != &part || is_in_a_solid(place) || is_in_an_outline(place)) continue;
            if (nodes_.any_near(place, keep_from_cells * spacing_)) continue;
            const auto [wall, surface] = wall_at(place);
            if (wall < 0 || surface.distance >= added_from_wall * spacing_) places.push_back(place);
        }
    return places;
}

bool ParticleBuilder::fills_beside_bodies() const {
    return (!solids_.empty() || std::ranges::any_of(strips_, &Strip::is_thick)) &&
           *scene_.particles.arrangement == Arrangement::square && *scene_.particles.fill == FillKind::lattice &&
           std::ranges::all_of(solids_, [](const SpringSolid& solid) { return solid.cells.has_value(); });
}

ParticleBuilder::Filled ParticleBuilder::fill_beside_bodies(const Part& part, int number) {
    ParticleSet& set = result_.particles;
    const BoxLattice boxes = boxes_of(set, lattice_step());
    const RegionOnBoxes liquid(*geometry_.region(part.name), boxes);
    std::list<RegionOnBoxes> strips;
    double thickest = 0;
    for (const Strip& strip : strips_)
        if (strip.is_thick) {
            strips.emplace_back(strip.outline, boxes);
            thickest = std::max(thickest, strip.half);
        }
    std::set<BoxIndex> taken, looked_at;
    std::size_t count = 0;
    for (std::size_t i = 0; i < set.size(); ++i)
        if (set.part[i] == number) {
            taken.insert(box_at(boxes, set.position[i]));
            ++count;
        }
    double missing = 0, of_strips = 0;  // [boxes]
    std::vector<Vec> corners;
    const auto look_at = [&](const BoxIndex& box, const RegionOnBoxes& drawn) {
        if (!looked_at.insert(box).second) return;
        const double with_strips = liquid.filling(box).volume / boxes.volume();
        double share = with_strips;
        for (const RegionOnBoxes& strip : strips) share -= strip.filling(box).volume / boxes.volume();
        share = std::max(0.0, share);
        of_strips += with_strips - share;
        if (share > 0) corners.push_back(boxes.corner(box));
        const bool is_left_out = !taken.contains(box) && fluid_at(boxes.middle(box)) == &part;
        if (is_left_out || drawn.filling(box).volume > 0) missing += share - (taken.contains(box) ? 1 : 0);
    };
    for (const SpringSolid& solid : solids_) {
        const RegionOnBoxes drawn(*geometry_.region(solid.part->name), boxes);
        for (const SolidCell& cell : solid.cells->cells) {
            const BoxIndex at = box_at(boxes, solid.cells->fillings[cell.particle].centroid);
            for (int k = 0; k < 9; ++k) look_at(boxes.in_period({at[0] + k % 3 - 1, at[1] + k / 3 - 1, 0}), drawn);
        }
        // A cell of a lattice of its own may reach farther, together with what it has taken up.
        const auto [first, last] = drawn.boxes();
        for (int y = first[1]; y < last[1]; ++y)
            for (int x = first[0]; x < last[0]; ++x)
                if (const BoxIndex box{x, y, 0}; !looked_at.contains(box) && drawn.filling(box).volume > 0)
                    look_at(box, drawn);
    }
    for (const RegionOnBoxes& strip : strips) {
        const auto [first, last] = strip.boxes();
        const auto about = static_cast<int>(std::ceil(thickest / spacing_)) + 1;
        for (int y = first[1] - about; y < last[1] + about; ++y)
            for (int x = first[0] - about; x < last[0] + about; ++x)
                if (const BoxIndex box{x, y, 0}; strip.filling(box).volume > 0 || is_in_a_strip(boxes.middle(box)))
                    look_at(boxes.in_period(box), strip);
    }
    const auto added = static_cast<std::size_t>(std::max(0L, std::lround(missing)));
    PlacesWithRoom room(set, boxes, places_beside_bodies(part, corners));
    for (const Vec& point : set.position) room.take(point);
    const double volume = lattice_.cell_area();
    std::size_t done = 0;
    for (; done < added; ++done) {
        const auto place = room.widest();
        if (!place) break;
        add_particle(number, {*place, volume, volume * part.density, -1, false, Vec::Zero(), 0});
        room.take(*place);
    }
    const double each = (static_cast<double>(count) + missing) / static_cast<double>(count + done);
    for (std::size_t i = 0; i < set.size(); ++i)
        if (set.part[i] == number) {
            set.volume[i] *= each;
            set.mass[i] *= each;
        }
    return {done, missing * volume, of_strips * volume};
}

void ParticleBuilder::claim_cells(SpringSolid& solid, const Region& region) {
    const Part& part = *solid.part;
    const CurveSet* anchor = part.anchor->empty() ? nullptr : geometry_.curve_set(part.anchor);
    const auto [turn, boxes, text] = lattice_in_plane(result_.particles, lattice_step(), region, anchor);
    const Region along = turn.of(region);
    SolidCells cells = RegionOnBoxes(along, boxes).cells();
    if (const auto slit = closed_slit(along, boxes, cells))
        result_.report.warnings.push_back(
            part.name.value + ": a cell near " + position_text(turn.back(*slit), 2) +
            " closes a slit that is drawn there, as it has the solid on both sides of it; "
            "take a particles.spacing of less than the slit's width");
    if (anchor != nullptr) {
        const Region behind = behind_anchor(along, turn.of(*anchor), spacing_);
        fill_up(RegionOnBoxes(behind, boxes), boxes, cells);
    }
    for (CellNode& node : cells.nodes) node.position = turn.back(node.position);
    for (Filling& filling : cells.fillings) filling.centroid = turn.back(filling.centroid);
    if (!text.empty())
        result_.report.notes.push_back(part.name.value + ": its cells have a lattice of their own, " + text);
    check_filled(part, cells, region.area());
    refuse_overlap(solid, cells);
    hold_on_planes(result_.particles, cells);
    clamp_cells(part, cells);
    for (std::size_t n = 0; n < cells.cells.size(); ++n) {
        solid.points.push_back(cells.fillings[n].centroid);
        solid.anchored.push_back(is_partly_held(cells, n, 2));
    }
    solid.cells = std::move(cells);
}

/// Two solids in one place: what is there would be there twice.
void ParticleBuilder::refuse_overlap(const SpringSolid& solid, const SolidCells& cells) const {
    constexpr double depth = 0.25;  // that solids drawn side by side may be in each other [spacings]
    for (const SpringSolid& other : solids_) {
        if (&other == &solid) continue;
        for (const Filling& filling : cells.fillings) {
            const auto is_in = [&](double x, double y) {
                const Vec point = filling.centroid + depth * spacing_ * Vec(x, y, 0);
                return other.region.side_of(point) == Side::inside;
            };
            if (!is_in(1, 0) || !is_in(-1, 0) || !is_in(0, 1) || !is_in(0, -1)) continue;
            throw InputError(solid.part->name.location,
                             "'" + solid.part->name.value + "' is drawn into '" + other.part->name.value +
                                 "', an elastic solid, too, near " + position_text(filling.centroid, 2),
                             "draw them beside each other, or as one part");
        }
    }
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
    report_cells(*solid.part, cells, geometry_.region(solid.part->name)->area(), line, result_.report);
}

}  // namespace dmp::mesher
