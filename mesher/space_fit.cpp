// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Of the SpaceBuilder: particles that follow the surfaces of the drawing.
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <sstream>

#include <omp.h>

#include "mesher/space_builder.hpp"

namespace dmp {

namespace {

/// A particle nearer than this stands on the surface: the triangle, not its place, tells its side [spacings].
constexpr double on_surface = 1e-6;
/// The surface is looked for this far [spacings].
constexpr double reach = 2;

template <class T>
void keep_flagged(std::vector<T>& values, const std::vector<std::uint8_t>& keep) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < values.size(); ++i)
        if (keep[i] != 0) values[kept++] = values[i];
    values.resize(kept);
}

}  // namespace

std::optional<SurfaceHold> SpaceBuilder::hold_of(std::size_t i, const Vec& place) const {
    const auto found = surface_at(place);
    if (found.wall < 0 || found.surface.distance > reach * spacing_) return std::nullopt;
    const Vec apart = place - found.surface.point;
    if (found.surface.distance > on_surface * spacing_) return SurfaceHold{found.surface.point, apart.normalized()};
    const Vec across = normal_of(walls_[static_cast<std::size_t>(found.face)].face(), found.surface.triangle);
    const bool is_fluid = result_.particles.kind(i) == ParticleKind::fluid;
    const bool fluid_across = owner_near(place + spacing_ * across) >= 0;
    return SurfaceHold{found.surface.point, fluid_across == is_fluid ? across : Vec(-across)};
}

void SpaceBuilder::fit() {
    ParticleSet& set = result_.particles;
    // What stands still behind the layers asked for fills the kernels of the last one.
    std::vector<std::uint8_t> held(set.size(), 0);
    std::vector<double> held_behind(set.parts.size(), 0);  // by part
    for (const Wall& wall : walls_)
        for (std::size_t part = 0; part < set.parts.size(); ++part)
            if (set.parts[part].name == *wall.part->name) held_behind[part] = (wall.part->layers + 0.5) * spacing_;
    for (std::size_t i = 0; i < set.size(); ++i)
        if (set.kind(i) == ParticleKind::springs)
            held[i] = 1;
        else if (set.kind(i) == ParticleKind::rigid)
            held[i] = set.wall_distance[i] > held_behind[static_cast<std::size_t>(set.part[i])] ? 1 : 0;
    const Fit fit = fit_to_surfaces(
        set, scene_.accuracy.support * spacing_, held,
        [&](std::size_t i, const Vec& place) { return hold_of(i, place); }, omp_get_max_threads());
    trim_walls();
    std::ostringstream note;
    note << "relaxed in " << fit.iterations << " iterations, the last moves " << fit.last_move
         << " spacings; the layer at the surfaces is half a spacing from them within " << fit.surface_error
         << " spacings (root mean square), " << fit.largest_surface_error << " at most";
    result_.report.notes.push_back(note.str());
}

/// Of walls, keeps the layers asked for, by where their particles are now. A fluid alone in its solid shares its volume
/// equally.
void SpaceBuilder::trim_walls() {
    ParticleSet& set = result_.particles;
    std::vector<std::uint8_t> keep(set.size(), 1);
    for (std::size_t i = 0; i < set.size(); ++i) {
        if (set.kind(i) != ParticleKind::rigid) continue;
        const auto found = surface_at(set.position[i]);
        const Wall& wall = walls_[static_cast<std::size_t>(std::max(0, found.wall))];
        const double kept = wall.part->layers * spacing_;
        keep[i] = found.wall >= 0 && found.surface.distance < kept ? 1 : 0;
        if (keep[i] == 0 || found.surface.distance < on_surface * spacing_) continue;
        set.wall_distance[i] = found.surface.distance;
        set.wall_normal[i] = (found.surface.point - set.position[i]).normalized();
    }
    const auto keep_all = [&](auto&... values) { (keep_flagged(values, keep), ...); };
    keep_all(set.position, set.volume, set.mass, set.part, set.body, set.fixed, set.seated, set.wall_normal,
             set.wall_distance);
    const bool bodies = std::ranges::any_of(walls_, &Wall::is_solid) || set.count(ParticleKind::springs) > 0;
    for (MeshReport::PartLine& line : result_.report.parts) {
        const auto part = static_cast<int>(std::ranges::find(set.parts, line.name, &ParticleSpace::PartInfo::name) -
                                           set.parts.begin());
        line.particles = static_cast<std::size_t>(std::ranges::count(set.part, part));
        const auto wall = std::ranges::find_if(walls_, [&](const Wall& w) { return *w.part->name == line.name; });
        if (wall != walls_.end()) {
            wall->thickness -= spare_layers(scene_) * spacing_;
            line.reached = static_cast<double>(line.particles) * lattice_->cell_volume() / wall->thickness;
        } else if (fluids_.size() == 1 && !bodies) {
            const double volume = line.target / static_cast<double>(line.particles);
            for (std::size_t i = 0; i < set.size(); ++i) {
                if (set.part[i] != part) continue;
                set.mass[i] *= volume / set.volume[i];
                set.volume[i] = volume;
            }
            line.reached = line.target;
        }
    }
}

}  // namespace dmp
