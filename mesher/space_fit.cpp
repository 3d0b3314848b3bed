// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Of the SpaceBuilder: what bounds its particles, for those who move them.
#include <algorithm>

#include <omp.h>

#include "mesher/sample_fluids.hpp"
#include "mesher/space_builder.hpp"
#include "mesher/vacancy.hpp"

namespace dmp::mesher {

FitBounds SpaceBuilder::bounds() const {
    FitBounds bounds;
    for (const Wall& wall : walls_) bounds.walls.push_back({wall.part, wall.is_solid});
    bounds.nearest_wall = [this](const Vec& position) {
        const auto [wall, face, surface] = surface_at(position);
        return NearestWall{face, surface.point, surface.distance, surface.triangle};
    };
    bounds.into_fluid = [this](const Vec& position, const NearestWall& there) {
        return into_fluid(position, there.wall, there.triangle);
    };
    bounds.cell_volume = lattice_->cell_volume();
    return bounds;
}

void SpaceBuilder::sample() {
    const Vacancy vacancy(geometry_, scene_);
    std::vector<int> part_of;  // by fluid
    for (const Part* fluid : fluids_) part_of.push_back(result_.particles.part_named(fluid->name));
    const auto part_at = [&](const Vec& position) {
        if (is_beyond_a_plane(position) || is_in_a_shell(position) || is_in_a_wedge(position)) return -1;
        const int fluid = vacancy.fluid_at(position);
        return fluid < 0 ? -1 : part_of[static_cast<std::size_t>(fluid)];
    };
    result_.report.notes.push_back(sample_fluids(result_.particles, lattice_->cell_volume(),
                                                 static_cast<std::uint64_t>(*scene_.particles.seed), part_at,
                                                 omp_get_max_threads()));
}

void SpaceBuilder::fit() {
    FitBounds bounded = bounds();
    const Vacancy vacancy(geometry_, scene_);
    std::vector<const TriangleSurface*> surfaces;
    for (const Wall& wall : walls_) surfaces.push_back(wall.surface);
    bounded.features = edge_positions(
        surfaces, [&](const Vec& point) { return vacancy.fluid_at(point) >= 0; }, spacing_);
    fit_particles(result_, geometry_, scene_, bounded);
}

/// From a place on a wall's triangle.
Vec SpaceBuilder::into_fluid(const Vec& position, int face, int triangle) const {
    const Vec across = normal_of(walls_[static_cast<std::size_t>(face)].face(), triangle);
    return owner_near(position + spacing_ * across) >= 0 ? across : Vec(-across);
}

}  // namespace dmp::mesher
