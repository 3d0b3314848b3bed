// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "mesher/space_builder.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>
#include <utility>

#include "base/length_text.hpp"
#include "geometry/surface_crossings.hpp"
#include "geometry/winding_number.hpp"
#include "mesher/names.hpp"
#include "mesher/particle_builder.hpp"
#include "mesher/uses.hpp"

namespace dmp::mesher {

namespace {

SpaceLattice lattice_around(const ParticleSet& set, const Scene& scene) {
    int layers = 0;
    for (const Part* part : scene.parts_of(PartKind::rigid)) layers = std::max(layers, *part->layers);
    std::array<bool, 3> fitted{};
    for (std::size_t axis = 0; axis < 3; ++axis) fitted.at(axis) = set.mirrored.at(axis)[1];
    return {set.box,
            set.periodic,
            set.spacing,
            scene.particles.arrangement,
            (layers + 1 + spare_layers(scene)) * set.spacing,
            fitted};
}

/// Whether a volume is to consist of cells however thin it is: something is given that shells do not have.
bool asks_for_cells(const Scene& scene, const Part& part) {
    const bool tears = std::ranges::any_of(
        scene.breaking, [&](const Breaking& rule) { return *rule.part == *part.name && rule.stress_above.given(); });
    return scene.is_of_cells(part) &&
           (part.model.given() || part.elastic_law.given() || part.damping_ratio.given() || tears);
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
    for (const Part* part : scene.parts_of(PartKind::elastic))
        if (const Solid* solid = geometry.solid(part->name))
            for (const Vec& corner : solid->surface.corners) widen_for_body(box, corner, scene);
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
        const double thickness = (part->layers + spare_layers(scene)) * spacing_;
        if (solid != nullptr) claim(*surface, owner_of_wall(walls_.size()));
        walls_.push_back({part, surface, solid != nullptr, thickness});
    }
    for (const Part* part : scene.parts_of(PartKind::elastic))
        if (const Solid* solid = geometry.solid(part->name);
            solid != nullptr &&
            (part->bonds_within.given() || asks_for_cells(scene, *part) || !take_as_sheet(*part, *solid)))
            claim_elastic(*part, *solid);
    for (std::size_t fluid = 0; fluid < fluids_.size(); ++fluid) {
        const TriangleSurface& surface = geometry.solid(fluids_[fluid]->name)->surface;
        taken_.push_back(claim(surface, static_cast<std::int16_t>(fluid)));
    }
    for (const std::size_t index : in_no_cell_)
        if (owner_[index] == nobody) owner_[index] = in_a_shell;
    for (const Part* part : scene.parts_of(PartKind::elastic))
        if (geometry.solid(part->name) == nullptr) clear_for_shell(geometry.surface_set(part->name)->surface);
    for (const ThinSolid& thin : thin_solids_) clear_for_shell(thin.middle);
}

Vec SpaceBuilder::normal_of(const TriangleSurface& surface, int triangle) {
    const auto& [a, b, c] = surface.triangles[static_cast<std::size_t>(triangle)];
    const auto corner = [&](int k) -> const Vec& { return surface.corners[static_cast<std::size_t>(k)]; };
    return (corner(b) - corner(a)).cross(corner(c) - corner(a)).normalized();
}

void SpaceBuilder::sort_triangles() {
    for (Wall& wall : walls_) wall.nearest = NearestTriangle(*wall.surface, 1.001 * wall.thickness);
    if (!shells_.empty()) clear_wedges();
    for (const Part* part : scene_.parts_of(PartKind::elastic))
        if (const Solid* solid = geometry_.solid(part->name)) spring_faces_.emplace_back(solid->surface, spacing_);
    if (fluids_.size() < 2) return;
    for (const Part* fluid : fluids_) fluid_edges_.emplace_back(geometry_.solid(fluid->name)->surface, spacing_);
}

/// Gives the lattice points inside a solid, that nobody has yet, to `owner`. Inside is where more surfaces were entered
/// than left; of a surface that runs through a point, the side that follows counts.
std::size_t SpaceBuilder::claim(const TriangleSurface& solid, std::int16_t owner) {
    if (solid.has_holes) return claim_by_vote(solid, owner);
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

/// The same for a surface with holes, through which lines would get out.
std::size_t SpaceBuilder::claim_by_vote(const TriangleSurface& solid, std::int16_t owner) {
    const WindingNumber winding(solid);
    std::size_t index = 0, taken = 0;
    for (std::size_t row = 0; row < lattice_->rows().size(); ++row)
        for (int line = 0; line < lattice_->rows()[row].lines; ++line)
            for (int point = 0; point < lattice_->points(); ++point, ++index) {
                if (!winding.inside(lattice_->at(row, line, point))) continue;
                if (owner_[index] == nobody)
                    owner_[index] = owner;
                else
                    ++taken;
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
std::int16_t SpaceBuilder::owner_near(const Vec& position) const {
    const auto& rows = lattice_->rows();
    const auto nearest = [](double distance, double step, long count) {
        return std::clamp(std::lround(distance / step), 0L, count - 1);
    };
    const long row = nearest(position.z() - rows.front().z, lattice_->step()[2], static_cast<long>(rows.size()));
    const LineRow& lines = rows[static_cast<std::size_t>(row)];
    const long line = nearest(position.y() - lines.first_y, lines.step_y, lines.lines);
    const double first = lattice_->first_x(static_cast<std::size_t>(row), static_cast<int>(line));
    const long point = nearest(position.x() - first, lattice_->step()[0], lattice_->points());
    return owner_[static_cast<std::size_t>((row * lines.lines + line) * lattice_->points() + point)];
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
    set.parts.push_back({part.name, PartKind::fluid});
    const auto fluid = static_cast<std::int16_t>(std::ranges::find(fluids_, &part) - fluids_.begin());
    make_room(static_cast<std::size_t>(std::ranges::count(owner_, fluid)));
    std::size_t count = 0;
    for_each_point([&](std::int16_t owner, const auto& position) {
        if (owner != fluid || is_beyond_a_plane(position())) return;
        add_particle(position(), number, part.density);
        ++count;
    });
    if (count == 0)
        throw InputError(scene_.particles.spacing.location,
                         "no particle of '" + part.name.value + "' fits into its solid at this spacing",
                         "refine particles.spacing, or check geometry.unit");
    const Added beside = fills_beside_cells() ? fill_beside_cells(part, number) : Added{};
    MeshReport::PartLine line;
    line.name = part.name;
    line.kind = to_string(PartKind::fluid);
    line.particles = count + beside.particles;
    const std::size_t taken = taken_[static_cast<std::size_t>(fluid)];
    line.target = geometry_.solid(part.name)->volume() -
                  static_cast<double>(taken - beside.left_points) * lattice_->cell_volume();
    line.reached = static_cast<double>(count) * lattice_->cell_volume() + beside.volume;
    line.unit = "m^3";
    result_.report.parts.push_back(line);
    if (taken > 0)
        result_.report.notes.push_back(part.name.value + ": " + std::to_string(taken) +
                                       " lattice points left to what has the room before it");
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
    const auto is_at = [&](const NearestTriangle& surface) {
        const auto found = surface.nearest(point);
        return found && found->distance < tolerance;
    };
    for (const Wall& wall : walls_)
        if (is_at(wall.nearest)) return true;
    for (std::size_t other = 0; other < fluids_.size(); ++other)
        if (fluids_[other] != &fluid && is_at(fluid_edges_[other])) return true;
    return std::ranges::any_of(spring_faces_, is_at);
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
        for (const Part* sheet : scene_.parts_of(PartKind::elastic))
            if (const SurfaceSet* set = geometry_.surface_set(sheet->name))
                if (NearestTriangle(set->surface, 2e-3 * spacing_).nearest(where))
                    throw sheet_as_border(*fluid, *sheet, where, 3);
        std::ostringstream problem;
        problem << "the boundary of '" << fluid->name.value << "' is open over " << 1e6 * open << " mm^2, near "
                << position_text(where) << ": no rigid part and no periodic side closes it";
        throw InputError(fluid->name.location, problem.str(),
                         "name this surface in the geometry as part of a rigid part, or make the axis periodic "
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

}  // namespace dmp::mesher
