// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Of the SpaceBuilder: liquid beside solids of cells.
#include <algorithm>
#include <cmath>
#include <set>

#include "mesher/cell_solids.hpp"
#include "mesher/places_with_room.hpp"
#include "mesher/relax.hpp"
#include "mesher/space_builder.hpp"

namespace dmp::mesher {

namespace {

/// Places along each side of a box that are tried.
constexpr int places_of_a_side = 4;

}  // namespace

bool SpaceBuilder::fills_beside_cells() const {
    return !spring_solids_.empty() && shells_.empty() && *scene_.particles.arrangement == Arrangement::square &&
           *scene_.particles.fill == FillKind::lattice &&
           std::ranges::all_of(spring_solids_, [](const SpringSolid& solid) { return solid.cells.has_value(); });
}

/// A box of the scene's lattice that a solid cuts, or whose lattice point a cell has taken.
struct SpaceBuilder::CutBox {
    std::array<int, 3> box{};
    double solid = 0;    ///< share of the box that solids of cells fill
    bool taken = false;  ///< a particle of the liquid stands there
    bool left = false;   ///< the lattice point was drawn as liquid, and a cell has it
    double liquid = 0;   ///< share of the box
    double of_any = 0;   ///< of all liquids
    std::vector<Vec> places{};
};

std::vector<SpaceBuilder::CutBox> SpaceBuilder::boxes_cut_by_cells(const BoxLattice& boxes,
                                                                   const std::vector<SolidOnBoxes>& solids,
                                                                   int fluid) const {
    std::vector<CutBox> cut;
    std::set<std::array<int, 3>> known;
    const auto look_at = [&](const std::array<int, 3>& box) {
        const std::int16_t owner = owner_near(boxes.middle(box));
        double filled = 0;
        for (const SolidOnBoxes& solid : solids) filled += solid.filling(box).volume / boxes.volume();
        const bool is_of_cells = owner == in_a_shell || (owner <= owner_of_wall(walls_.size()) && owner > in_a_shell);
        if (filled < 1 - 1e-9 && (filled > 0 || is_of_cells) && known.insert(box).second)
            cut.push_back({.box = box, .solid = filled, .taken = owner == fluid});
    };
    for (const SolidOnBoxes& solid : solids) {
        const auto [first, last] = solid.boxes();
        for (int k = first[2] - 1; k <= last[2]; ++k)
            for (int j = first[1] - 1; j <= last[1]; ++j)
                for (int i = first[0] - 1; i <= last[0]; ++i) look_at(boxes.in_period({i, j, k}));
    }
    return cut;
}

/// Finds how much of the box is the liquid's, and the places where a particle of it may stand.
void SpaceBuilder::look_into(CutBox& cut, const BoxLattice& boxes, const Vacancy& vacancy, int fluid) const {
    constexpr int side = places_of_a_side, places = side * side * side;
    const Vec corner = boxes.corner(cut.box), middle = boxes.middle(cut.box);
    int of_this = 0, of_any = 0;
    for (int n = 0; n < places; ++n) {
        const Vec within(n % side + 0.5, n / side % side + 0.5, n / (side * side) + 0.5);
        const Vec place = corner + within.cwiseProduct(boxes.step) / side;
        const int found = vacancy.fluid_at(place);
        of_any += found >= 0 ? 1 : 0;
        if (found != fluid) continue;
        ++of_this;
        if (may_stand(place)) cut.places.push_back(place);
    }
    // Where a wall is near, only the places tell how much of the box it leaves.
    const auto wall = surface_at(middle);
    const bool by_a_wall = wall.wall >= 0 && wall.surface.distance < spacing_;
    if (of_any == 0 && !by_a_wall) {  // a sliver between the places is its neighbour's
        for (int n = 0; n < 27 && of_any == 0; ++n) {
            const std::array<int, 3> beside{cut.box[0] + n % 3 - 1, cut.box[1] + n / 3 % 3 - 1, cut.box[2] + n / 9 - 1};
            const std::int16_t owner = owner_near(boxes.middle(boxes.in_period(beside)));
            of_any = owner >= 0 ? 1 : 0;
            of_this = owner == fluid ? 1 : 0;
        }
    }
    if (of_any > 0) cut.of_any = by_a_wall ? of_any / static_cast<double>(places) : 1 - cut.solid;
    if (of_this > 0) cut.liquid = cut.of_any * of_this / of_any;
    cut.left = !cut.taken && vacancy.fluid_at(middle) == fluid;
}

SpaceBuilder::Added SpaceBuilder::fill_beside_cells(const Part& part, int number) {
    ParticleSet& set = result_.particles;
    const BoxLattice boxes = boxes_of(set, lattice_step(), lattice_->at(0, 0, 0) - 0.5 * lattice_step());
    const auto fluid = static_cast<int>(std::ranges::find(fluids_, &part) - fluids_.begin());
    std::vector<SolidOnBoxes> solids;
    // Boxes of the scene's lattice round a solid; its cells may be on a lattice of their own.
    double rounded = 0;  // [boxes]
    for (const SpringSolid& solid : spring_solids_) {
        solids.emplace_back(geometry_.solid(solid.part->name)->surface, boxes);
        rounded += (solids.back().volume() - solid.cells->volume()) / boxes.volume();
    }
    std::vector<CutBox> cut = boxes_cut_by_cells(boxes, solids, fluid);
    const Vacancy vacancy(geometry_, scene_);
    const auto count_of_boxes = static_cast<std::ptrdiff_t>(cut.size());
#pragma omp parallel for schedule(dynamic, 16)
    for (std::ptrdiff_t n = 0; n < count_of_boxes; ++n)
        look_into(cut[static_cast<std::size_t>(n)], boxes, vacancy, fluid);

    Added added;
    double missing = 0, liquid = 0, of_any = 0;  // [boxes]
    std::vector<Vec> places;
    for (const CutBox& here : cut) {
        liquid += here.liquid;
        of_any += here.of_any;
        missing += here.liquid - (here.taken ? 1 : 0);
        added.left_points += here.left ? 1 : 0;
        places.insert(places.end(), here.places.begin(), here.places.end());
    }
    if (of_any > 0) missing += rounded * liquid / of_any;
    PlacesWithRoom room(set, boxes, std::move(places));
    for (std::size_t i = 0; i < set.size(); ++i)
        room.take(set.position[i], set.kind(i) == PartKind::elastic ? keep_from_cells * spacing_ : 0);
    const auto wanted = static_cast<std::size_t>(std::max(0L, std::lround(missing)));
    for (; added.particles < wanted; ++added.particles) {
        const auto place = room.widest();
        if (!place) break;
        add_particle(*place, number, part.density);
        room.take(*place);
    }
    const auto count = static_cast<double>(std::ranges::count(set.part, number));
    const double each = (count - static_cast<double>(added.particles) + missing) / count;
    for (std::size_t i = 0; i < set.size(); ++i)
        if (set.part[i] == number) {
            set.volume[i] *= each;
            set.mass[i] *= each;
        }
    added.volume = missing * lattice_->cell_volume();
    return added;
}

}  // namespace dmp::mesher
