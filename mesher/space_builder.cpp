// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "mesher/space_builder.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <utility>

#include "geometry/surface_crossings.hpp"
#include "mesher/particle_builder.hpp"

namespace dmp {

namespace {

constexpr std::int16_t nobody = -1;
constexpr std::int16_t nobody_near_a_wall = std::numeric_limits<std::int16_t>::min();
constexpr std::int16_t owner_of_wall(std::size_t wall) {
    return static_cast<std::int16_t>(-2 - static_cast<int>(wall));
}

std::string point_text(const Vec& p) {
    std::ostringstream text;
    text << "(" << 1e3 * p[0] << ", " << 1e3 * p[1] << ", " << 1e3 * p[2] << ") mm";
    return text.str();
}

Vec normal_of(const TriangleSurface& surface, int triangle) {
    const auto& [a, b, c] = surface.triangles[static_cast<std::size_t>(triangle)];
    const auto corner = [&](int k) -> const Vec& { return surface.corners[static_cast<std::size_t>(k)]; };
    return (corner(b) - corner(a)).cross(corner(c) - corner(a)).normalized();
}

SpaceLattice lattice_around(const ParticleSet& set, const Scene& scene) {
    int layers = 0;
    for (const Part* part : scene.parts_of(PartKind::rigid)) layers = std::max(layers, *part->layers);
    std::array<bool, 3> fitted{};
    for (std::size_t axis = 0; axis < 3; ++axis) fitted.at(axis) = set.mirrored.at(axis)[1];
    return {set.box, set.periodic, set.spacing, scene.particles.arrangement, (layers + 1) * set.spacing, fitted};
}

}  // namespace

Box fluid_box_in_space(const Geometry& geometry, const Scene& scene) {
    Box box{.low = Vec::Constant(std::numeric_limits<double>::infinity()), .high = {}};
    box.high = -box.low;
    for (const Part* part : scene.parts_of(PartKind::fluid))
        for (const Vec& corner : geometry.solid(part->name)->surface.corners) {
            box.low = box.low.cwiseMin(corner);
            box.high = box.high.cwiseMax(corner);
        }
    return scene.parts_of(PartKind::fluid).empty() ? geometry.box : box;
}

SpaceBuilder::SpaceBuilder(const Geometry& geometry, const Scene& scene)
    : geometry_(geometry), scene_(scene), spacing_(scene.particles.spacing), fluids_(scene.parts_of(PartKind::fluid)) {
    ParticleSet& set = result_.particles;
    set.dimension = 3;
    set.spacing = spacing_;
    set.box = fluid_box_in_space(geometry, scene);
    for (std::size_t axis = 0; axis < 3; ++axis) set.periodic.at(axis) = *scene.flow.periodic.at(axis);
    set.mirrored = mirrored_sides(scene);
    lattice_.emplace(lattice_around(set, scene));
    owner_.assign(lattice_->rows().size() * static_cast<std::size_t>(lattice_->rows().front().lines) *
                      static_cast<std::size_t>(lattice_->points()),
                  nobody);
    for (const Part* part : scene.parts_of(PartKind::rigid)) {
        const Solid* solid = geometry.solid(part->name);
        const TriangleSurface* surface =
            solid != nullptr ? &solid->surface : &geometry.surface_set(part->name)->surface;
        const double thickness = part->layers * spacing_;
        if (solid != nullptr) claim(*surface, owner_of_wall(walls_.size()));
        walls_.push_back({part, surface, solid != nullptr, thickness, std::nullopt});
    }
    for (std::size_t fluid = 0; fluid < fluids_.size(); ++fluid) {
        const TriangleSurface& surface = geometry.solid(fluids_[fluid]->name)->surface;
        taken_.push_back(claim(surface, static_cast<std::int16_t>(fluid)));
    }
}

void SpaceBuilder::sort_triangles() {
    for (Wall& wall : walls_) wall.nearest.emplace(*wall.surface, 1.001 * wall.thickness);
    if (fluids_.size() < 2) return;
    for (const Part* fluid : fluids_) fluid_edges_.emplace_back(geometry_.solid(fluid->name)->surface, spacing_);
}

/// Gives the lattice points inside a solid, that nobody has yet, to `owner`. Inside is where more surfaces were entered
/// than left; of a surface that runs through a point, the side that follows counts.
std::size_t SpaceBuilder::claim(const TriangleSurface& solid, std::int16_t owner) {
    const auto& rows = lattice_->rows();
    const SurfaceCrossings crossings(solid, rows);
    const int points = lattice_->points();
    const double step = lattice_->step()[0];
    std::size_t line_start = 0, taken = 0;
    for (std::size_t row = 0; row < rows.size(); ++row)
        for (int line = 0; line < rows[row].lines; ++line, line_start += static_cast<std::size_t>(points)) {
            const double first = lattice_->first_x(row, line);
            const auto at_or_after = [&](double x) {
                return std::clamp(static_cast<int>(std::ceil((x - first) / step)), 0, points);
            };
            int depth = 0, entered = 0;
            for (const Crossing& crossing : crossings.of(row, line)) {
                const int before = depth;
                depth += crossing.direction;
                if (before <= 0 && depth > 0) entered = at_or_after(crossing.x);
                if (before <= 0 || depth > 0) continue;
                for (int k = entered; k < at_or_after(crossing.x); ++k) {
                    std::int16_t& here = owner_[line_start + static_cast<std::size_t>(k)];
                    if (here == nobody)
                        here = owner;
                    else
                        ++taken;
                }
            }
        }
    return taken;
}

bool SpaceBuilder::is_beyond_a_plane(const Vec& point) const {
    const ParticleSet& set = result_.particles;
    for (int axis = 0; axis < 3; ++axis)
        if (set.mirrored_back(point[axis], axis) != point[axis]) return true;
    return false;
}

/// Of the lattice point nearest to a place, about.
std::int16_t SpaceBuilder::owner_near(const Vec& place) const {
    const auto& rows = lattice_->rows();
    const auto nearest = [](double distance, double step, long count) {
        return std::clamp(std::lround(distance / step), 0L, count - 1);
    };
    const long row = nearest(place.z() - rows.front().z, lattice_->step()[2], static_cast<long>(rows.size()));
    const LineRow& lines = rows[static_cast<std::size_t>(row)];
    const long line = nearest(place.y() - lines.first_y, lines.step_y, lines.lines);
    const double first = lattice_->first_x(static_cast<std::size_t>(row), static_cast<int>(line));
    const long point = nearest(place.x() - first, lattice_->step()[0], lattice_->points());
    return owner_[static_cast<std::size_t>((row * lines.lines + line) * lattice_->points() + point)];
}

template <class Visit>
void SpaceBuilder::for_each_point(const Visit& visit) const {
    std::size_t index = 0;
    for (std::size_t row = 0; row < lattice_->rows().size(); ++row)
        for (int line = 0; line < lattice_->rows()[row].lines; ++line)
            for (int point = 0; point < lattice_->points(); ++point)
                visit(owner_[index++], [&] { return lattice_->at(row, line, point); });
}

/// For so many more particles: arrays that double by themselves take twice the memory.
void SpaceBuilder::make_room(std::size_t particles) {
    ParticleSet& set = result_.particles;
    const std::size_t size = set.size() + particles;
    set.position.reserve(size);
    set.volume.reserve(size);
    set.mass.reserve(size);
    set.part.reserve(size);
    set.body.reserve(size);
    set.fixed.reserve(size);
    set.seated.reserve(size);
    set.wall_normal.reserve(size);
    set.wall_distance.reserve(size);
}

void SpaceBuilder::add_particle(const Vec& position, int part, double density) {
    ParticleSet& set = result_.particles;
    set.position.push_back(position);
    set.volume.push_back(lattice_->cell_volume());
    set.mass.push_back(lattice_->cell_volume() * density);
    set.part.push_back(part);
    set.body.push_back(-1);
    set.fixed.push_back(0);
    set.seated.push_back(0);
    set.wall_normal.emplace_back(Vec::Zero());
    set.wall_distance.push_back(0);
}

void SpaceBuilder::add_fluid(const Part& part) {
    ParticleSet& set = result_.particles;
    const auto number = static_cast<int>(set.parts.size());
    set.parts.push_back({part.name, ParticleKind::fluid});
    const auto fluid = static_cast<std::int16_t>(std::ranges::find(fluids_, &part) - fluids_.begin());
    make_room(static_cast<std::size_t>(std::ranges::count(owner_, fluid)));
    std::size_t count = 0;
    for_each_point([&](std::int16_t owner, const auto& place) {
        if (owner != fluid || is_beyond_a_plane(place())) return;
        add_particle(place(), number, part.density);
        ++count;
    });
    if (count == 0)
        throw InputError(scene_.particles.spacing.place,
                         "no particle of '" + part.name.value + "' fits into its solid at this spacing",
                         "refine particles.spacing, or check geometry.unit");
    MeshReport::PartLine line;
    line.name = part.name;
    line.kind = word(PartKind::fluid);
    line.particles = count;
    const std::size_t taken = taken_[static_cast<std::size_t>(fluid)];
    line.target = geometry_.solid(part.name)->volume() - static_cast<double>(taken) * lattice_->cell_volume();
    line.reached = static_cast<double>(count) * lattice_->cell_volume();
    line.unit = "m^3";
    result_.report.parts.push_back(line);
    if (taken > 0)
        result_.report.notes.push_back(part.name.value + ": " + std::to_string(taken) +
                                       " lattice points left to what has the room before it");
}

SpaceBuilder::WallPoint SpaceBuilder::wall_at(const Vec& point, std::int16_t owner, std::vector<Vec>& last) const {
    WallPoint best;
    const auto look_from = [&](const Vec& shift) {
        for (std::size_t w = 0; w < walls_.size(); ++w) {
            // A body's own particles stand in it, those of other walls outside all bodies.
            if (walls_[w].is_solid ? owner != owner_of_wall(w) : owner != nobody) continue;
            auto found = walls_[w].nearest->nearest(point + shift, last[w]);
            if (found) last[w] = found->point;
            if (!found || found->distance >= walls_[w].thickness) continue;
            if (best.wall >= 0 && best.surface.distance <= found->distance) continue;
            found->point -= shift;
            best = {static_cast<int>(w), *found};
        }
    };
    look_from(Vec::Zero());
    const ParticleSet& set = result_.particles;
    for (int axis = 0; axis < 3; ++axis) {
        if (!set.periodic.at(static_cast<std::size_t>(axis))) continue;
        Vec shift = Vec::Zero();
        for (const double period : {set.box.extent()[axis], -set.box.extent()[axis]}) {
            shift[axis] = period;
            look_from(shift);
        }
    }
    return best;
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
    const std::size_t points = static_cast<std::size_t>(lattice_->points());
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
                const auto [wall, surface] = wall_at(point, marked == nobody_near_a_wall ? nobody : marked, last);
                if (wall >= 0) found[row].emplace_back(wall, wall_particle(point, wall, surface));
            }
    }
    wall_particles_.resize(walls_.size());
    for (auto& in_row : found) {
        for (const auto& [wall, particle] : in_row) wall_particles_[static_cast<std::size_t>(wall)].push_back(particle);
        in_row = {};
    }
}

SpaceBuilder::WallParticle SpaceBuilder::wall_particle(const Vec& point, int wall, const SurfacePoint& surface) const {
    const Vec to_surface = surface.point - point;
    if (surface.distance > 1e-6 * spacing_) return {point, to_surface.normalized(), surface.distance};
    const Vec across = normal_of(*walls_[static_cast<std::size_t>(wall)].surface, surface.triangle);
    return {point, owner_near(point + spacing_ * across) >= 0 ? across : Vec(-across), surface.distance};
}

void SpaceBuilder::add_walls(const Part& part) {
    if (wall_particles_.empty()) find_walls();
    ParticleSet& set = result_.particles;
    const auto number = static_cast<int>(set.parts.size());
    set.parts.push_back({part.name, ParticleKind::rigid});
    double density = 0;  // a wall never moves: its mass only has to be there
    for (const Part* fluid : fluids_) density = std::max(density, fluid->density.value);
    const auto wall = std::ranges::find(walls_, &part, &Wall::part);
    const auto particles = std::exchange(wall_particles_[static_cast<std::size_t>(wall - walls_.begin())], {});
    if (particles.empty())
        throw InputError(
            part.name.place,
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
    line.kind = word(PartKind::rigid);
    line.particles = particles.size();
    line.target = wall->surface->area();
    line.reached = static_cast<double>(particles.size()) * lattice_->cell_volume() / wall->thickness;
    line.unit = "m^2";
    result_.report.parts.push_back(line);
}

/// Whether something besides this fluid reaches the point on its surface.
bool SpaceBuilder::closes(const Vec& point, const Part& fluid) const {
    const double tolerance = 1e-3 * spacing_;
    const ParticleSet& set = result_.particles;
    for (int axis = 0; axis < 3; ++axis)
        for (const bool high : {false, true}) {
            const auto at = static_cast<std::size_t>(axis);
            if (!set.periodic.at(at) && !set.mirrored.at(at).at(high ? 1 : 0)) continue;
            if (std::abs(point[axis] - (high ? set.box.high : set.box.low)[axis]) < tolerance) return true;
        }
    for (const Wall& wall : walls_) {
        const auto found = wall.nearest->nearest(point);
        if (found && found->distance < tolerance) return true;
    }
    for (std::size_t other = 0; other < fluids_.size(); ++other)
        if (fluids_[other] != &fluid) {
            const auto found = fluid_edges_[other].nearest(point);
            if (found && found->distance < tolerance) return true;
        }
    return false;
}

void SpaceBuilder::check_boundary() const {
    for (const Part* fluid : fluids_) {
        const TriangleSurface& surface = geometry_.solid(fluid->name)->surface;
        double open = 0, largest = 0;
        Vec where = Vec::Zero();
        for (const auto& [a, b, c] : surface.triangles) {
            const auto corner = [&](int k) -> const Vec& { return surface.corners[static_cast<std::size_t>(k)]; };
            const Vec middle = (corner(a) + corner(b) + corner(c)) / 3;
            if (closes(middle, *fluid)) continue;
            const double area = 0.5 * (corner(b) - corner(a)).cross(corner(c) - corner(a)).norm();
            open += area;
            if (area > largest) where = middle;
            largest = std::max(largest, area);
        }
        if (open == 0) continue;
        std::ostringstream problem;
        problem << "the boundary of '" << fluid->name.value << "' is open over " << 1e6 * open << " mm^2, near "
                << point_text(where) << ": no rigid part and no periodic side closes it";
        throw InputError(fluid->name.place, problem.str(),
                         "name this surface in the drawing as part of a rigid part, or make the axis periodic "
                         "(flow.periodic), or the side a plane of symmetry (flow.symmetry)");
    }
}

MeshResult SpaceBuilder::finish() {
    ParticleSet& set = result_.particles;
    const auto wanted = SpaceLattice::wanted_step(spacing_, scene_.particles.arrangement);
    for (int axis = 0; axis < 3; ++axis) {
        const auto at = static_cast<std::size_t>(axis);
        const double stretch = lattice_->step().at(at) / wanted.at(at) - 1;
        if (std::abs(stretch) > 1e-9) {
            std::ostringstream note;
            note << "lattice stretched along "
                 << "xyz"[axis] << " by " << 100 * stretch << " % so that a whole number of cells "
                 << (set.periodic.at(at) ? "makes one period" : "reaches the plane of symmetry");
            result_.report.notes.push_back(note.str());
        }
        if (set.periodic.at(at)) continue;
        for (const Vec& point : set.position) {
            if (!set.mirrored.at(at)[0]) set.box.low[axis] = std::min(set.box.low[axis], point[axis]);
            if (!set.mirrored.at(at)[1]) set.box.high[axis] = std::max(set.box.high[axis], point[axis]);
        }
    }
    return std::move(result_);
}

}  // namespace dmp
