// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Of the SpaceBuilder: what bounds its particles, for those who move them.
#include "mesher/space_builder.hpp"
#include "mesher/vacancy.hpp"

namespace dmp {

FitBounds SpaceBuilder::bounds() const {
    FitBounds bounds;
    for (const Wall& wall : walls_) bounds.walls.push_back({wall.part, wall.is_solid});
    bounds.nearest_wall = [this](const Vec& place) {
        const auto [wall, face, surface] = surface_at(place);
        return NearestWall{face, surface.point, surface.distance, surface.triangle};
    };
    bounds.into_fluid = [this](const Vec& place, const NearestWall& there) {
        return into_fluid(place, there.wall, there.triangle);
    };
    bounds.cell_volume = lattice_->cell_volume();
    return bounds;
}

void SpaceBuilder::fit() {
    FitBounds bounded = bounds();
    const Vacancy vacancy(geometry_, scene_);
    std::vector<const TriangleSurface*> surfaces;
    for (const Wall& wall : walls_) surfaces.push_back(wall.surface);
    bounded.features = edge_places(
        surfaces, [&](const Vec& point) { return vacancy.fluid_at(point) >= 0; }, spacing_);
    fit_particles(result_, geometry_, scene_, bounded);
}

/// From a place on a wall's triangle.
Vec SpaceBuilder::into_fluid(const Vec& place, int face, int triangle) const {
    const Vec across = normal_of(walls_[static_cast<std::size_t>(face)].face(), triangle);
    return owner_near(place + spacing_ * across) >= 0 ? across : Vec(-across);
}

}  // namespace dmp
