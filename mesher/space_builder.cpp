// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "mesher/space_builder.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "geometry/surface_crossings.hpp"
#include "geometry/winding_number.hpp"
#include "mesher/particle_builder.hpp"

namespace dmp {

namespace {

constexpr std::int16_t nobody = -1;
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
        walls_.push_back({part, surface, solid != nullptr, thickness, NearestTriangle(*surface, 1.001 * thickness)});
    }
    for (std::size_t fluid = 0; fluid < fluids_.size(); ++fluid) {
        const TriangleSurface& surface = geometry.solid(fluids_[fluid]->name)->surface;
        claim(surface, static_cast<std::int16_t>(fluid));
        fluid_edges_.emplace_back(surface, spacing_);
    }
}

/// Gives the lattice points inside a solid, that nobody has yet, to `owner`. Inside is where more surfaces were entered
/// than left; of a surface that runs through a point, the side that follows counts.
void SpaceBuilder::claim(const TriangleSurface& solid, std::int16_t owner) {
    if (solid.has_holes) {
        claim_by_vote(solid, owner);
        return;
    }
    const auto& rows = lattice_->rows();
    const SurfaceCrossings crossings(solid, rows);
    const int points = lattice_->points();
    const double step = lattice_->step()[0];
    std::size_t line_start = 0;
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
                    if (here == nobody) here = owner;
                }
            }
        }
}

/// The same for a surface with holes, through which lines would get out.
void SpaceBuilder::claim_by_vote(const TriangleSurface& solid, std::int16_t owner) {
    const WindingNumber winding(solid);
    std::size_t index = 0;
    for (std::size_t row = 0; row < lattice_->rows().size(); ++row)
        for (int line = 0; line < lattice_->rows()[row].lines; ++line)
            for (int point = 0; point < lattice_->points(); ++point, ++index)
                if (owner_[index] == nobody && winding.inside(lattice_->at(row, line, point))) owner_[index] = owner;
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
    line.target = geometry_.solid(part.name)->volume();
    line.reached = static_cast<double>(count) * lattice_->cell_volume();
    line.unit = "m^3";
    result_.report.parts.push_back(line);
}

SpaceBuilder::WallPoint SpaceBuilder::wall_at(const Vec& point, std::int16_t owner) const {
    WallPoint best;
    const auto look_from = [&](const Vec& shift) {
        for (std::size_t w = 0; w < walls_.size(); ++w) {
            // A body's own particles stand in it, those of other walls outside all bodies.
            if (walls_[w].is_solid ? owner != owner_of_wall(w) : owner != nobody) continue;
            auto found = walls_[w].nearest.nearest(point + shift);
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

void SpaceBuilder::add_walls(const Part& part) {
    ParticleSet& set = result_.particles;
    const auto number = static_cast<int>(set.parts.size());
    set.parts.push_back({part.name, ParticleKind::rigid});
    double density = 0;  // a wall never moves: its mass only has to be there
    for (const Part* fluid : fluids_) density = std::max(density, fluid->density.value);
    std::size_t count = 0;
    for_each_point([&](std::int16_t owner, const auto& place) {
        if (owner >= 0) return;
        const Vec point = place();
        if (is_beyond_a_plane(point)) return;
        const auto [wall, surface] = wall_at(point, owner);
        if (wall < 0 || walls_[static_cast<std::size_t>(wall)].part != &part) return;
        add_particle(point, number, density);
        set.fixed.back() = 1;
        const Vec to_surface = surface.point - point;
        if (surface.distance > 1e-6 * spacing_) {
            set.wall_normal.back() = to_surface.normalized();
        } else {
            const Vec across = normal_of(*walls_[static_cast<std::size_t>(wall)].surface, surface.triangle);
            set.wall_normal.back() = owner_near(point + spacing_ * across) >= 0 ? across : Vec(-across);
        }
        set.wall_distance.back() = surface.distance;
        ++count;
    });
    if (count == 0)
        throw InputError(
            part.name.place,
            "no particle of the wall '" + part.name.value + "' fits behind its surface: there is fluid on both sides",
            "draw the wall as the edge of a hole in the fluid, or refine particles.spacing");
    const auto wall = std::ranges::find(walls_, &part, &Wall::part);
    MeshReport::PartLine line;
    line.name = part.name;
    line.kind = word(PartKind::rigid);
    line.particles = count;
    line.target = wall->surface->area();
    line.reached = static_cast<double>(count) * lattice_->cell_volume() / wall->thickness;
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
        const auto found = wall.nearest.nearest(point);
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
