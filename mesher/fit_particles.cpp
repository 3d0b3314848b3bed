// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "mesher/fit_particles.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <sstream>

#include <omp.h>

#include "mesher/cad_surface.hpp"
#include "mesher/fit_to_surfaces.hpp"
#include "mesher/keep_particles.hpp"
#include "mesher/searchable_particles.hpp"
#include "mesher/uses.hpp"
#include "models/sph/kernels.hpp"

namespace dmp::mesher {

namespace {

/// A particle nearer than this stands on the surface: the surface, not the particle's place, tells its side [spacings].
constexpr double on_surface = 1e-6;
/// The surface is looked for this far [spacings].
constexpr double relative_reach = 2;
/// A particle no further away than this is brought to its place at a corner or an edge [spacings].
constexpr double fetched_from = 1.5;
/// Places nearer to another than this are left out, as at ends of edges shorter than it [spacings].
constexpr double pins_apart = 0.7;
/// So much room there must be at a place's deep point: edges of what is thinner than twice that are not kept
/// [spacings].
constexpr double room = 1.9;
/// Nearer to a plane of symmetry its own image is in the way [spacings].
constexpr double clear_of_planes = 0.4;
/// How far from walls such a place may be: a second wall is near, or it is the far side of an acute edge. Fluid about
/// the edge of a body lies around it, half a spacing from the edge as from its faces [spacings].
constexpr double shallowest_pin = 0.45, deepest_pin = 1, deepest_fluid_pin = 0.55;

/// Answers which surface a particle may not cross.
class Surfaces {
  public:
    Surfaces(const ParticleSet& set, const Geometry& geometry, const Scene& scene, const FitBounds& bounds)
        : set_(set), bounds_(bounds), borders_(set.parts.size()) {
        const auto fitted = fitted_parts(scene);
        if (fitted.size() < 2) return;
        for (std::size_t part = 0; part < set.parts.size(); ++part)
            for (const Part* each : fitted)
                if (*each->name == set.parts[part].name)
                    borders_[part].emplace(geometry, scene, set, *each, relative_reach * set.spacing);
    }

    [[nodiscard]] std::optional<SurfaceHold> hold_of(std::size_t i, const Vec& position) const {
        const auto found = bounds_.nearest_wall(position);
        const bool at_wall = found.wall >= 0 && found.distance <= relative_reach * set_.spacing;
        // Where a fluid ends at another one, which counts where no wall is nearer.
        const auto& border = borders_[static_cast<std::size_t>(set_.part[i])];
        const auto other = border ? border->nearest(position) : std::nullopt;
        if (other && (!at_wall || other->distance < found.distance)) {
            if (other->distance <= on_surface * set_.spacing) return into_part(*border, other->point);
            return SurfaceHold{other->point, (position - other->point).normalized()};
        }
        if (!at_wall) return std::nullopt;
        if (found.distance > on_surface * set_.spacing)
            return SurfaceHold{found.point, (position - found.point).normalized()};
        if (set_.kind(i) == PartKind::elastic) return border ? into_part(*border, found.point) : std::nullopt;
        const Vec into_fluid = bounds_.into_fluid(position, found);
        return SurfaceHold{found.point, set_.kind(i) == PartKind::fluid ? into_fluid : Vec(-into_fluid)};
    }

  private:
    static std::optional<SurfaceHold> into_part(const CadSurface& border, const Vec& point) {
        const auto out = border.way_out(point);
        return out ? std::optional(SurfaceHold{point, -*out}) : std::nullopt;
    }

    const ParticleSet& set_;
    const FitBounds& bounds_;
    std::vector<std::optional<CadSurface>> borders_;  ///< by part; of what is fitted, where there is more than one
};

/// By particle: 1 stays where it is. What stands still behind the layers asked for fills the kernels of the last one.
std::vector<std::uint8_t> held_particles(const ParticleSet& set, const Scene& scene, const FitBounds& bounds) {
    std::vector<std::uint8_t> held(set.size(), 0);
    std::vector<std::uint8_t> is_fitted(set.parts.size(), 0);
    for (const Part* part : fitted_parts(scene))
        if (const int number = set.part_named(*part->name); number >= 0)
            is_fitted[static_cast<std::size_t>(number)] = 1;
    std::vector<double> held_behind(set.parts.size(), 0);  // by part
    for (const FitBounds::Wall& wall : bounds.walls)
        if (const int part = set.part_named(wall.part->name); part >= 0)
            held_behind[static_cast<std::size_t>(part)] = (wall.part->layers + 0.5) * set.spacing;
    for (std::size_t i = 0; i < set.size(); ++i)
        if (set.kind(i) == PartKind::elastic)
            held[i] = is_fitted[static_cast<std::size_t>(set.part[i])] == 0 ? 1 : 0;
        else if (set.kind(i) == PartKind::rigid)
            held[i] = set.wall_distance[i] > held_behind[static_cast<std::size_t>(set.part[i])] ? 1 : 0;
    return held;
}

/// Brings to each place at a corner or an edge the nearest particle that is free, to be held there. Returns how many.
std::size_t pin_features(ParticleSet& set, const FitBounds& bounds, std::vector<std::uint8_t>& held) {
    std::size_t pinned = 0;
    if (bounds.features.empty()) return pinned;
    const SearchableParticles search(set, (fetched_from + pins_apart) * set.spacing, set.spacing);
    std::vector<Vec> moved(set.size(), Vec::Constant(HUGE_VAL));  // of what is pinned
    for (const FeaturePosition& feature : bounds.features) {
        Vec position = feature.point;
        bool in_box = true;
        for (int axis = 0; axis < set.dimension; ++axis) {
            for (const double aside : {-1.0, 1.0}) {
                const double x = position[axis] + aside * clear_of_planes * set.spacing;
                in_box = in_box && set.mirrored_back(x, axis) == x;
            }
            if (set.periodic[axis]) position[axis] = wrapped(position[axis], set.box.low[axis], set.box.high[axis]);
        }
        const double depth = bounds.nearest_wall(position).distance / set.spacing;
        if (!in_box || depth < shallowest_pin || depth > (feature.in_fluid ? deepest_fluid_pin : deepest_pin)) continue;
        const auto beyond = bounds.nearest_wall(feature.deep);
        if (beyond.wall >= 0 && beyond.distance < room * set.spacing) continue;
        double best = square(fetched_from * set.spacing);
        std::size_t nearest = set.size();
        Vec from;
        bool taken = false;
        search.for_each_near(position, (fetched_from + pins_apart) * set.spacing,
                             [&](std::size_t j, double square_of_distance, const Vec& at) {
                                 if (moved[j].x() < HUGE_VAL) {
                                     taken = taken || (at + moved[j] - position).norm() < pins_apart * set.spacing;
                                     return;
                                 }
                                 if (held[j] != 0 || set.kind(j) == PartKind::elastic || square_of_distance >= best)
                                     return;
                                 if ((set.kind(j) == PartKind::fluid) != feature.in_fluid) return;
                                 best = square_of_distance;
                                 nearest = j;
                                 from = at;
                             });
        if (taken || nearest == set.size()) continue;
        moved[nearest] = position - from;
        set.position[nearest] = position;
        held[nearest] = 1;
        ++pinned;
    }
    return pinned;
}

/// Of walls, keeps the layers asked for, by where their particles are now.
void trim_walls(ParticleSet& set, const FitBounds& bounds) {
    std::vector<std::uint8_t> keep(set.size(), 1);
    for (std::size_t i = 0; i < set.size(); ++i) {
        if (set.kind(i) != PartKind::rigid) continue;
        const auto found = bounds.nearest_wall(set.position[i]);
        const FitBounds::Wall& wall = bounds.walls[static_cast<std::size_t>(std::max(0, found.wall))];
        keep[i] = found.wall >= 0 && found.distance < wall.part->layers * set.spacing ? 1 : 0;
        if (keep[i] == 0 || found.distance < on_surface * set.spacing) continue;
        set.wall_distance[i] = found.distance;
        set.wall_normal[i] = (found.point - set.position[i]).normalized();
    }
    keep_particles(set, keep);
}

/// Counts anew, and shares out the volume of fluids that no body takes any of.
void update_lines(MeshResult& result, const FitBounds& bounds) {
    ParticleSet& set = result.particles;
    const bool no_bodies =
        std::ranges::none_of(bounds.walls, &FitBounds::Wall::is_body) && set.count(PartKind::elastic) == 0;
    for (MeshReport::PartLine& line : result.report.parts) {
        const int part = set.part_named(line.name);
        line.particles = static_cast<std::size_t>(std::ranges::count(set.part, part));
        const auto wall =
            std::ranges::find_if(bounds.walls, [&](const auto& each) { return *each.part->name == line.name; });
        if (wall != bounds.walls.end())
            line.reached =
                static_cast<double>(line.particles) * bounds.cell_volume / (wall->part->layers * set.spacing);
        else if (no_bodies)
            share_volume(set, part, line);
    }
}

}  // namespace

void fit_particles(MeshResult& result, const Geometry& geometry, const Scene& scene, const FitBounds& bounds) {
    ParticleSet& set = result.particles;
    const Surfaces surfaces(set, geometry, scene, bounds);
    std::vector<std::uint8_t> held = held_particles(set, scene, bounds);
    const std::size_t pinned = pin_features(set, bounds, held);
    const Fit fit = fit_to_surfaces(
        set, scene.numerics.support * set.spacing, held,
        [&](std::size_t i, const Vec& position) { return surfaces.hold_of(i, position); }, omp_get_max_threads());
    trim_walls(set, bounds);
    update_lines(result, bounds);
    std::ostringstream note;
    note << "relaxed in " << fit.iterations << " iterations, the last moves " << fit.last_move
         << " spacings and kernel sums spread by " << 100 * fit.spread
         << " %; the layer at the surfaces is half a spacing from them within " << fit.surface_error
         << " spacings (root mean square), " << fit.largest_surface_error << " at most";
    if (pinned > 0) note << "; " << pinned << " particles are pinned at corners and edges";
    result.report.notes.push_back(note.str());
}

}  // namespace dmp::mesher
