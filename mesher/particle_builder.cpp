// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "mesher/particle_builder.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <sstream>

#include <omp.h>

#include "mesher/relax.hpp"
#include "mesher/sample_fluids.hpp"

namespace dmp::mesher {

namespace {

/// A wall particle this near to a body's node would stand in its place [spacings]: half a spacing. A node that moves is
/// also kept out of reach of the wall's repulsion. With as much room around nodes that do not move, such as a leaflet's
/// root, fluid finds a hole between them and the wall.
constexpr double place_of_a_node = 0.5 + 1e-6, clearance_of_moving_node = 0.75;

bool is_beyond_a_plane(const ParticleSet& set, const Vec& point) {
    for (int axis = 0; axis < set.dimension; ++axis)
        if (set.mirrored_back(point[axis], axis) != point[axis]) return true;
    return false;
}

}  // namespace

Box fluid_box(const Geometry& geometry, const Scene& scene) {
    Box box;
    box.low.setConstant(std::numeric_limits<double>::infinity());
    box.high.setConstant(-std::numeric_limits<double>::infinity());
    for (const Part* part : scene.parts_of(PartKind::fluid))
        for (const Polyline& loop : geometry.region(part->name)->loops)
            for (const Vec& point : loop.points) {
                box.low = box.low.cwiseMin(point);
                box.high = box.high.cwiseMax(point);
            }
    for (const Part* part : scene.parts_of(PartKind::elastic))
        if (const Region* region = geometry.region(part->name))
            for (const Polyline& loop : region->loops)
                for (const Vec& point : loop.points) widen_for_body(box, point, scene);
    if (scene.parts_of(PartKind::fluid).empty()) box = geometry.box;
    return box;
}

/// By axis, low and high.
std::array<std::array<bool, 2>, 3> mirrored_sides(const Scene& scene) {
    std::array<std::array<bool, 2>, 3> mirrored{};
    for (const BoxSide side : *scene.flow.symmetry)
        mirrored.at(static_cast<std::size_t>(axis_of(side))).at(is_high(side) ? 1 : 0) = true;
    return mirrored;
}

void widen_for_body(Box& box, const Vec& point, const Scene& scene) {
    const double spacing = scene.particles.spacing;
    const auto mirrored = mirrored_sides(scene);
    const auto spacings = [&](double length) { return spacing * std::ceil(std::max(0.0, length) / spacing - 1e-6); };
    for (int axis = 0; axis < scene.dimension; ++axis) {
        if (*scene.flow.periodic[axis]) continue;
        if (!mirrored[axis][0]) box.low[axis] -= spacings(box.low[axis] - point[axis]);
        if (!mirrored[axis][1]) box.high[axis] += spacings(point[axis] - box.high[axis]);
    }
}

ParticleBuilder::ParticleBuilder(const Geometry& geometry, const Scene& scene)
    : geometry_(geometry),
      scene_(scene),
      spacing_(scene.particles.spacing),
      lattice_(fluid_box(geometry, scene), {scene.flow.periodic[0], scene.flow.periodic[1], scene.flow.periodic[2]},
               spacing_, scene.particles.arrangement,
               {mirrored_sides(scene)[0][1], mirrored_sides(scene)[1][1], false}) {
    ParticleSet& set = result_.particles;
    set.dimension = scene.dimension;
    set.spacing = spacing_;
    set.box = fluid_box(geometry, scene);
    for (int axis = 0; axis < 3; ++axis) set.periodic[axis] = scene.flow.periodic[axis];
    set.mirrored = mirrored_sides(scene);
    for (const Part* part : scene.parts_of(PartKind::fluid))
        fluids_.push_back({part, InsideTest(*geometry.region(part->name))});
    claim_solids();
    for (const Part* part : scene.parts_of(PartKind::rigid)) {
        const double thickness = (part->layers + spare_layers(scene)) * spacing_;
        walls_.push_back({part, thickness, NearestCurve(*geometry.curve_set(part->name), 1.001 * thickness)});
    }
}

int ParticleBuilder::add_part(const Part& part, PartKind kind) {
    result_.particles.parts.push_back({part.name, kind});
    return static_cast<int>(result_.particles.parts.size()) - 1;
}

int ParticleBuilder::add_particle(int part, const NewParticle& particle) {
    ParticleSet& set = result_.particles;
    set.position.push_back(particle.position);
    set.volume.push_back(particle.volume);
    set.mass.push_back(particle.mass);
    set.part.push_back(part);
    set.body.push_back(particle.body);
    set.fixed.push_back(particle.fixed ? 1 : 0);
    set.seated.push_back(0);
    set.wall_normal.push_back(particle.wall_normal);
    set.wall_distance.push_back(particle.wall_distance);
    return static_cast<int>(set.size()) - 1;
}

const Part* ParticleBuilder::fluid_at(const Vec& point) const {
    const Part* on_edge = nullptr;
    for (const Fluid& fluid : fluids_) {
        const Side side = fluid.region.side_of(point);
        if (side == Side::inside) return fluid.part;
        if (side == Side::outside) continue;
        if (on_edge != nullptr) return on_edge;
        on_edge = fluid.part;
    }
    if (on_edge == nullptr || std::ranges::none_of(solids_, [&](const SpringSolid& solid) {
            return solid.region.side_of(point) == Side::on_edge;
        }))
        return nullptr;
    return on_edge;
}

/// A wall that ends at a plane of symmetry goes on as its own image.
void ParticleBuilder::nearest_from_images(const Vec& point, WallPoint& best) const {
    const ParticleSet& set = result_.particles;
    for (int axis = 0; axis < set.dimension; ++axis)
        for (const int side : {0, 1}) {
            if (!set.mirrored[axis][side]) continue;
            const double twice_plane = 2 * (side == 0 ? set.box.low : set.box.high)[axis];
            Vec image = point;
            image[axis] = twice_plane - image[axis];
            for (std::size_t w = 0; w < walls_.size(); ++w) {
                auto found = walls_[w].curve.nearest(image);
                if (!found || !walls_[w].holds(found->distance)) continue;
                if (best.wall >= 0 && best.surface.distance <= found->distance) continue;
                found->point[axis] = twice_plane - found->point[axis];
                best = {static_cast<int>(w), *found};
            }
        }
}

ParticleBuilder::WallPoint ParticleBuilder::wall_at(const Vec& point) const {
    WallPoint best;
    const auto nearest_from = [&](const Vec& shift) {
        for (std::size_t w = 0; w < walls_.size(); ++w) {
            const auto found = walls_[w].curve.nearest(point + shift);
            if (!found || !walls_[w].holds(found->distance)) continue;
            if (best.wall >= 0 && best.surface.distance <= found->distance) continue;
            best = {static_cast<int>(w), {found->point - shift, found->distance}};
        }
    };
    nearest_from(Vec::Zero());
    nearest_from_images(point, best);
    const ParticleSet& set = result_.particles;
    for (int axis = 0; axis < set.dimension; ++axis) {
        if (!set.periodic[axis]) continue;
        Vec shift = Vec::Zero();
        for (const double period : {set.box.extent()[axis], -set.box.extent()[axis]}) {
            shift[axis] = period;
            nearest_from(shift);
        }
    }
    return best;
}

Vec ParticleBuilder::normal_on_surface(const Vec& point) const {
    Vec sum = Vec::Zero();
    for (int k = 0; k < 64; ++k) {
        const double angle = 2 * std::numbers::pi * (k + 0.5) / 64;
        const Vec direction(std::cos(angle), std::sin(angle), 0);
        if (fluid_at(point + 0.1 * spacing_ * direction) != nullptr) sum += direction;
    }
    return sum.norm() > 0 ? Vec(sum.normalized()) : Vec(Vec::Zero());
}

void ParticleBuilder::add_fluid(const Part& part) {
    const Region& region = *geometry_.region(part.name);
    const int number = add_part(part, PartKind::fluid);
    const double volume = lattice_.cell_area();
    const bool is_filled = fills_beside_bodies();
    std::size_t count = 0, left_out = 0, by_bodies = 0;
    for (const Vec& point : lattice_.points(0)) {
        ++candidates_;
        if (fluid_at(point) != &part) continue;
        if (!clear_of_bodies(point)) {
            ++left_out;
            by_bodies += is_filled && !is_in_a_thin_strip(point) ? 1 : 0;
            continue;
        }
        add_particle(number, {point, volume, volume * part.density, -1, false, Vec::Zero(), 0});
        ++count;
    }
    double filled = static_cast<double>(count) * volume;
    double of_strips = 0;
    if (is_filled) {
        const Filled beside = fill_beside_bodies(part, number);
        count += beside.particles;
        filled += beside.area;
        of_strips = beside.of_strips;
    }
    if (count == 0)
        throw InputError(scene_.particles.spacing.location,
                         "no particle of '" + part.name.value + "' fits into its region at this spacing",
                         "refine particles.spacing, or check geometry.unit");
    MeshReport::PartLine line;
    line.name = part.name;
    line.kind = to_string(PartKind::fluid);
    line.particles = count;
    line.target = region.area() - static_cast<double>(left_out - by_bodies) * volume - of_strips;
    line.reached = filled;
    line.unit = "m^2";
    result_.report.parts.push_back(line);
    if (left_out > 0)
        result_.report.notes.push_back(part.name.value + ": " + std::to_string(left_out) +
                                       " lattice points left out where bodies stand");
}

void ParticleBuilder::add_walls(const Part& part) {
    const CurveSet& curve = *geometry_.curve_set(part.name);
    const int number = add_part(part, PartKind::rigid);
    const double volume = lattice_.cell_area();
    double density = 0;  // a wall never moves: its mass only has to be there
    for (const Fluid& fluid : fluids_) density = std::max(density, fluid.part->density.value);
    std::size_t count = 0;
    const auto own = static_cast<int>(std::ranges::find(walls_, &part, &Wall::part) - walls_.begin());
    for (const Vec& point : lattice_.points((part.layers + 1 + spare_layers(scene_)) * spacing_)) {
        ++candidates_;
        if (fluid_at(point) != nullptr || is_in_a_solid(point) || is_beyond_a_plane(result_.particles, point)) continue;
        const auto [owner, surface] = wall_at(point);
        if (owner != own || nodes_.any_near(point, place_of_a_node * spacing_)) continue;
        if (nodes_.any_near(point, clearance_of_moving_node * spacing_,
                            [](const auto& node) { return !node.anchored; }))
            continue;
        const Vec to_surface = surface.point - point;
        const Vec normal = surface.distance > 1e-6 * spacing_ ? Vec(to_surface.normalized()) : normal_on_surface(point);
        add_particle(number, {point, volume, volume * density, -1, true, normal, surface.distance});
        ++count;
    }
    if (count == 0) {
        for (const Polyline& piece : curve.pieces)
            for (std::size_t k = 0; k + 1 < piece.points.size(); ++k) {
                const Vec middle = 0.5 * (piece.points[k] + piece.points[k + 1]);
                const int owner = wall_at(middle).wall;
                if (owner < 0 || owner == own) continue;
                throw InputError(part.name.location,
                                 "no particle of the wall '" + part.name.value + "' is left: its curve near " +
                                     position_text(middle, 2) + " is one of the wall '" +
                                     walls_[static_cast<std::size_t>(owner)].part->name.value + "', too",
                                 "name each curve in one physical group only, or leave one of the walls out");
            }
        throw InputError(
            part.name.location,
            "no particle of the wall '" + part.name.value + "' fits behind its curve: there is fluid on both sides",
            "draw the wall as the edge of a hole in the fluid, or refine particles.spacing");
    }
    MeshReport::PartLine line;
    line.name = part.name;
    line.kind = to_string(PartKind::rigid);
    line.particles = count;
    line.target = curve.length();
    line.reached = static_cast<double>(count) / part.layers * spacing_;
    line.unit = "m";
    result_.report.parts.push_back(line);
}

void ParticleBuilder::sample() {
    const auto part_at = [&](const Vec& position) {
        const Part* fluid = fluid_at(position);
        if (fluid == nullptr || !clear_of_bodies(position)) return -1;
        return result_.particles.part_named(fluid->name);
    };
    result_.report.notes.push_back(sample_fluids(result_.particles, lattice_.cell_area(),
                                                 static_cast<std::uint64_t>(*scene_.particles.seed), part_at,
                                                 omp_get_max_threads()));
}

void ParticleBuilder::fit() {
    FitBounds bounds;
    for (const Wall& wall : walls_) bounds.walls.push_back({wall.part, false});
    bounds.nearest_wall = [this](const Vec& position) {
        const auto [wall, surface] = wall_at(position);
        return NearestWall{wall, surface.point, surface.distance};
    };
    bounds.into_fluid = [this](const Vec& position, const NearestWall&) { return normal_on_surface(position); };
    bounds.cell_volume = lattice_.cell_area();
    std::vector<const CurveSet*> curves;
    for (const Wall& wall : walls_) curves.push_back(geometry_.curve_set(wall.part->name));
    bounds.features = corner_positions(
        curves, [this](const Vec& point) { return fluid_at(point) != nullptr; }, spacing_);
    fit_particles(result_, geometry_, scene_, bounds);
}

bool ParticleBuilder::holds(std::size_t i, const Vec& point) const {
    const Part* fluid = fluid_at(point);
    return fluid != nullptr && *fluid->name == result_.particles.parts[result_.particles.part[i]].name;
}

bool ParticleBuilder::is_in_a_solid(const Vec& point) const {
    return std::ranges::any_of(solids_,
                               [&](const SpringSolid& solid) { return solid.region.side_of(point) == Side::inside; });
}

bool ParticleBuilder::is_in_a_strip(const Vec& point) const {
    const double beside = fills_beside_bodies() ? 0.5 * (1 - 1e-6) * spacing_ : 0;
    return std::ranges::any_of(strips_, [&](const Strip& strip) {
        return strip.curve.nearest(point).distance < strip.half + (strip.is_thick ? beside : 0);
    });
}

bool ParticleBuilder::is_in_a_thin_strip(const Vec& point) const {
    return std::ranges::any_of(strips_, [&](const Strip& strip) {
        return !strip.is_thick && strip.curve.nearest(point).distance < strip.half;
    });
}

bool ParticleBuilder::is_in_an_outline(const Vec& point) const {
    return std::ranges::any_of(strips_, [&](const Strip& strip) {
        return strip.is_thick && strip.curve.nearest(point).distance < strip.half;
    });
}

bool ParticleBuilder::clear_of_bodies(const Vec& point) const {
    if (is_in_a_strip(point)) return false;
    return !nodes_.any_near(point, keep_from_nodes * spacing_, [](const auto& node) { return node.of_a_solid; });
}

MeshResult ParticleBuilder::finish() {
    ParticleSet& set = result_.particles;
    for (int axis = 0; axis < 2; ++axis) {
        if (set.periodic[axis] || set.mirrored[axis][1]) {
            const double step = lattice_.step()[axis];
            const double wanted = Lattice::wanted_step(spacing_, scene_.particles.arrangement)[axis];
            if (std::abs(step / wanted - 1) > 1e-9) {
                std::ostringstream note;
                note << "lattice stretched along "
                     << "xyz"[axis] << " by " << 100 * (step / wanted - 1) << " % so that a whole number of cells "
                     << (set.periodic[axis] ? "makes one period" : "reaches the plane of symmetry");
                result_.report.notes.push_back(note.str());
            }
        }
        if (set.periodic[axis]) continue;
        for (const Vec& point : set.position) {
            if (!set.mirrored[axis][0]) set.box.low[axis] = std::min(set.box.low[axis], point[axis]);
            if (!set.mirrored[axis][1]) set.box.high[axis] = std::max(set.box.high[axis], point[axis]);
        }
    }
    return std::move(result_);
}

}  // namespace dmp::mesher
