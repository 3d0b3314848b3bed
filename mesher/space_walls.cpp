// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Of the SpaceBuilder: walls behind surfaces, and bodies in the fluid.
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "mesher/searchable_particles.hpp"
#include "mesher/space_builder.hpp"

namespace dmp::mesher {

namespace {

/// A wall particle nearer than this to a body's node would stand in its place. Less than in 2-D: one too many at
/// the root of a sheet keeps fluid out of the corner, one too few lets it be shifted between sheet and wall [spacings].
constexpr double body_clearance = 0.45;

}  // namespace

SpaceBuilder::WallPoint SpaceBuilder::wall_at(const Vec& point, std::int16_t owner, std::vector<Vec>& last) const {
    // A body's own particles stand in it, those of other walls outside all bodies.
    const auto counts = [&](std::size_t w) { return walls_[w].is_solid ? owner == owner_of_wall(w) : owner == nobody; };
    if (!has_hidden_faces_) return surface_at(point, counts, &last);
    // Whose it is does not depend on what fluid sees of the surface.
    int wall = -1;
    if (owner == nobody) wall = surface_at(point, counts, nullptr, true).wall;
    for (std::size_t w = 0; w < walls_.size() && owner != nobody; ++w)
        if (walls_[w].is_solid && owner == owner_of_wall(w)) wall = static_cast<int>(w);
    if (wall < 0) return {};
    WallPoint found = surface_at(
        point, [](std::size_t) { return true; }, &last);
    if (found.wall >= 0) found.wall = wall;
    return found;
}

/// Marks the lattice points of nobody within reach of the boxes about a wall's triangles; the others are never asked.
void SpaceBuilder::mark_band(const Wall& wall) {
    const auto& rows = lattice_->rows();
    const auto& step = lattice_->step();
    const double reach = 1.001 * wall.thickness;
    const auto first_index = [](double low, double first, double between, int count) {
        return static_cast<int>(std::clamp(std::ceil((low - first) / between), 0.0, static_cast<double>(count)));
    };
    const auto last_index = [](double high, double first, double between, int count) {
        return static_cast<int>(std::clamp(std::floor((high - first) / between), -1.0, count - 1.0));
    };
    const int points = lattice_->points(), lines = rows.front().lines, layers = static_cast<int>(rows.size());
    const auto beyond = [](double x, double low, double high) { return std::max({low - x, x - high, 0.0}); };
    const auto mark = [&](const Vec& low, const Vec& high) {
        const int last_row = last_index(high.z() + reach, rows.front().z, step[2], layers);
        for (int row = first_index(low.z() - reach, rows.front().z, step[2], layers); row <= last_row; ++row) {
            const LineRow& here = rows[static_cast<std::size_t>(row)];
            const double above = beyond(here.z, low.z(), high.z());
            const double reach_y = std::sqrt(std::max(0.0, reach * reach - above * above));
            const int last_line = last_index(high.y() + reach_y, here.first_y, here.step_y, lines);
            for (int line = first_index(low.y() - reach_y, here.first_y, here.step_y, lines); line <= last_line;
                 ++line) {
                const double aside = beyond(here.first_y + line * here.step_y, low.y(), high.y());
                const double reach_x = std::sqrt(std::max(0.0, reach_y * reach_y - aside * aside));
                const double first_x = lattice_->first_x(static_cast<std::size_t>(row), line);
                const int first = first_index(low.x() - reach_x, first_x, step[0], points);
                const int last = last_index(high.x() + reach_x, first_x, step[0], points);
                const std::size_t start =
                    (static_cast<std::size_t>(row) * static_cast<std::size_t>(lines) + static_cast<std::size_t>(line)) *
                    static_cast<std::size_t>(points);
                for (int k = first; k <= last; ++k) {
                    std::int16_t& owner = owner_[start + static_cast<std::size_t>(k)];
                    if (owner == nobody) owner = nobody_near_a_wall;
                }
            }
        }
    };
    const ParticleSet& set = result_.particles;
    for (const auto& triangle : wall.surface->triangles) {
        const auto corner = [&](std::size_t k) -> const Vec& {
            return wall.surface->corners[static_cast<std::size_t>(triangle.at(k))];
        };
        const Vec low = corner(0).cwiseMin(corner(1)).cwiseMin(corner(2));
        const Vec high = corner(0).cwiseMax(corner(1)).cwiseMax(corner(2));
        mark(low, high);
        for (int axis = 0; axis < 3; ++axis) {
            if (!set.periodic.at(static_cast<std::size_t>(axis))) continue;
            const Vec period = set.box.extent()[axis] * Vec::Unit(axis);
            if (low[axis] - reach < set.box.low[axis]) mark(low + period, high + period);
            if (high[axis] + reach > set.box.high[axis]) mark(low - period, high - period);
        }
    }
}

/// All walls' particles, row by row, so that threads may take rows and the order stays the same.
void SpaceBuilder::find_walls() {
    for (const Wall& wall : walls_)
        if (!wall.is_solid) mark_band(wall);
    const auto& rows = lattice_->rows();
    const auto points = static_cast<std::size_t>(lattice_->points());
    std::optional<SearchableParticles> bodies;
    if (bodies_ > 0) bodies.emplace(result_.particles, spacing_);
    const auto overlaps_a_body = [&](const Vec& point) {
        bool overlaps = false;
        if (bodies)
            bodies->for_each_near(point, body_clearance * spacing_, [&](std::size_t j, double, const Vec&) {
                overlaps = overlaps || result_.particles.kind(j) == PartKind::elastic;
            });
        return overlaps;
    };
    std::vector<std::vector<std::pair<int, WallParticle>>> found(rows.size());
#pragma omp parallel for schedule(dynamic)
    for (std::size_t row = 0; row < rows.size(); ++row) {
        std::vector<Vec> last(walls_.size(), Vec::Constant(std::numeric_limits<double>::infinity()));
        std::size_t index = row * static_cast<std::size_t>(rows[row].lines) * points;
        for (int line = 0; line < rows[row].lines; ++line)
            for (std::size_t k = 0; k < points; ++k, ++index) {
                const std::int16_t marked = owner_[index];
                if (marked >= 0 || marked == nobody) continue;
                const Vec point = lattice_->at(row, line, static_cast<int>(k));
                if (is_beyond_a_plane(point)) continue;
                const auto [wall, face, surface] = wall_at(point, marked == nobody_near_a_wall ? nobody : marked, last);
                if (wall >= 0 && !overlaps_a_body(point))
                    found[row].emplace_back(wall, wall_particle(point, face, surface));
            }
    }
    wall_particles_.resize(walls_.size());
    for (auto& in_row : found) {
        for (const auto& [wall, particle] : in_row) wall_particles_[static_cast<std::size_t>(wall)].push_back(particle);
        in_row = {};
    }
}

SpaceBuilder::WallParticle SpaceBuilder::wall_particle(const Vec& point, int face, const SurfacePoint& surface) const {
    const Vec to_surface = surface.point - point;
    if (surface.distance > 1e-6 * spacing_) return {point, to_surface.normalized(), surface.distance};
    return {point, into_fluid(point, face, surface.triangle), surface.distance};
}

void SpaceBuilder::add_walls(const Part& part) {
    if (wall_particles_.empty()) find_walls();
    ParticleSet& set = result_.particles;
    const auto number = static_cast<int>(set.parts.size());
    set.parts.push_back({part.name, PartKind::rigid});
    double density = 0;  // a wall never moves: its mass only has to be there
    for (const Part* fluid : fluids_) density = std::max(density, fluid->density.value);
    const auto wall = std::ranges::find(walls_, &part, &Wall::part);
    const auto particles = std::exchange(wall_particles_[static_cast<std::size_t>(wall - walls_.begin())], {});
    if (particles.empty() && wall->facing)
        result_.report.warnings.push_back(part.name.value +
                                          ": it has no particles, as fluid is nowhere within its layers");
    else if (particles.empty())
        throw InputError(
            part.name.location,
            "no particle of the wall '" + part.name.value + "' fits behind its surface: there is fluid on both sides",
            "draw the wall as the edge of a hole in the fluid, or refine particles.spacing");
    make_room(particles.size());
    for (const WallParticle& particle : particles) {
        add_particle(particle.position, number, density);
        set.fixed.back() = 1;
        set.wall_normal.back() = particle.normal;
        set.wall_distance.back() = particle.distance;
    }
    MeshReport::PartLine line;
    line.name = part.name;
    line.kind = to_string(PartKind::rigid);
    line.particles = particles.size();
    line.target = wall->surface->area();
    line.reached = static_cast<double>(particles.size()) * lattice_->cell_volume() / wall->thickness;
    line.unit = "m^2";
    result_.report.parts.push_back(line);
}

}  // namespace dmp::mesher
