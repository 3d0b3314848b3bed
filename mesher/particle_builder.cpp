// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "mesher/particle_builder.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <sstream>

#include <omp.h>

#include "mesher/sample_fluids.hpp"
#include "mesher/spring_lattice.hpp"

namespace dmp {

namespace {

/// A wall particle nearer than this to a body's node would stand in its place [spacings].
constexpr double wall_clearance = 0.75;
/// The end of a curve so near to another lies on it [spacings].
constexpr double touching = 0.1;

bool is_beyond_a_plane(const ParticleSet& set, const Vec& point) {
    for (int axis = 0; axis < set.dimension; ++axis)
        if (set.mirrored_back(point[axis], axis) != point[axis]) return true;
    return false;
}

/// Signed angle from arm a to arm b.
double angle_between(const Vec& a, const Vec& b) { return std::atan2(a[0] * b[1] - a[1] * b[0], a.dot(b)); }

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
    for (const Part* part : scene.parts_of(PartKind::rigid)) {
        const double thickness = (part->layers + spare_layers(scene)) * spacing_;
        walls_.push_back({part, thickness, NearestCurve(*geometry.curve_set(part->name), 1.001 * thickness)});
    }
}

int ParticleBuilder::add_part(const Part& part, ParticleKind kind) {
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

void ParticleBuilder::add_springs(const Part& part) {
    const int number = add_part(part, ParticleKind::springs);
    MeshReport::SpringLine line;
    line.part = part.name;
    line.axial_stiffness_asked = strip_stiffness(part).axial;
    for (const Polyline& piece : geometry_.curve_set(part.name)->pieces) add_ladder(part, number, piece, line);
    if (!part.anchor->empty() && line.anchored == 0) {
        const bool to_points = geometry_.points.contains(part.anchor);
        throw InputError(part.anchor.place,
                         to_points ? "no point of '" + part.anchor.value + "' lies on '" + part.name.value + "'"
                                   : "no end of '" + part.name.value + "' lies on '" + part.anchor.value + "'",
                         to_points ? "put the anchor points on the curve in the drawing"
                                   : "let the curve begin or end on it in the drawing");
    }
    if (std::abs(line.axial_stiffness / line.axial_stiffness_asked - 1) > 1e-9) {
        std::ostringstream note;
        const bool lowered = line.axial_stiffness < line.axial_stiffness_asked;
        note << part.name.value << ": EA " << (lowered ? "lowered" : "raised") << " from " << line.axial_stiffness_asked
             << " to " << line.axial_stiffness << " N, so that two rows " << spacing_ << " m apart can "
             << (lowered ? "bend as softly as EI asks" : "resist shear by cross bonds") << "; EI is held";
        result_.report.notes.push_back(note.str());
    }
    result_.report.springs.push_back(line);
}

void ParticleBuilder::add_ladder(const Part& part, int part_number, const Polyline& curve,
                                 MeshReport::SpringLine& line) {
    constexpr int fewest_columns = 5;
    if (curve.closed)
        throw InputError(part.name.place,
                         "'" + part.name.value + "' has a closed curve, and springs run along open ones only",
                         "leave a gap in the curve in the drawing");
    const Ladder ladder = ladder_along(curve, spacing_);
    if (ladder.columns() < fewest_columns) {
        std::ostringstream problem;
        problem << "a curve of '" << part.name.value << "' is " << curve.length() << " m long, " << ladder.columns()
                << " columns of particles; at least " << fewest_columns << " are needed to bend";
        throw InputError(part.name.place, problem.str(), "refine particles.spacing or draw a longer curve");
    }
    const LadderConstants constants = ladder_constants(part, ladder.along, spacing_);
    const int body = bodies_++;
    body_curves_.pieces.push_back(curve);
    ParticleSet& set = result_.particles;

    std::vector<Vec> middles;
    middles.reserve(ladder.nodes.size() / 2);
    for (std::size_t n = 0; n < ladder.nodes.size(); n += 2)
        middles.emplace_back(0.5 * (ladder.nodes[n] + ladder.nodes[n + 1]));
    const std::vector<bool> anchored = anchored_columns(part, curve, middles, ladder.along);

    const int first = static_cast<int>(set.size());
    const double mass = part.mass_per_length * ladder.along / 2;
    for (std::size_t n = 0; n < ladder.nodes.size(); ++n)
        add_particle(part_number,
                     {ladder.nodes[n], spacing_ * ladder.along, mass, body, anchored[n / 2], Vec::Zero(), 0});

    const auto bond = [&](int a, int b, double stiffness) {
        set.bonds.push_back({a, b, (set.position[a] - set.position[b]).norm(), stiffness});
        ++line.bonds;
    };
    const auto hinge = [&](int a, int centre, int b) {
        const double rest =
            angle_between(set.position[a] - set.position[centre], set.position[b] - set.position[centre]);
        set.hinges.push_back({a, centre, b, rest, constants.hinge_stiffness});
        ++line.hinges;
    };
    for (int c = 0; c < ladder.columns(); ++c) {
        const int left = first + 2 * c, right = left + 1;
        bond(left, right, constants.rung_stiffness());
        if (c + 1 == ladder.columns()) break;
        const int next_left = left + 2, next_right = right + 2;
        bond(left, next_left, constants.bond_stiffness);
        bond(right, next_right, constants.bond_stiffness);
        if (constants.cross_stiffness > 0) {
            bond(left, next_right, constants.cross_stiffness);
            bond(right, next_left, constants.cross_stiffness);
            continue;
        }
        hinge(next_left, left, right);
        hinge(left, right, next_right);
        hinge(right, next_right, next_left);
        hinge(next_right, next_left, left);
    }
    ++line.bodies;
    line.anchored += 2 * static_cast<std::size_t>(std::count(anchored.begin(), anchored.end(), true));
    line.bond_stiffness = constants.bond_stiffness;
    line.hinge_stiffness = constants.hinge_stiffness;
    line.cross_stiffness = constants.cross_stiffness;
    line.bending_stiffness = constants.bending_stiffness();
    line.axial_stiffness = constants.axial_stiffness();
    line.shear_stiffness = constants.shear_stiffness();
    line.particle_mass = mass;
}

std::vector<Vec> ParticleBuilder::anchors_of(const Part& part, const Polyline& curve) const {
    if (part.anchor->empty()) return {};
    const auto points = geometry_.points.find(part.anchor);
    if (points != geometry_.points.end()) return points->second;
    const NearestCurve held_by(*geometry_.curve_set(part.anchor), touching * spacing_);
    std::vector<Vec> ends;
    for (const Vec& end : {curve.points.front(), curve.points.back()})
        if (held_by.nearest(end)) ends.push_back(end);
    return ends;
}

std::vector<bool> ParticleBuilder::anchored_columns(const Part& part, const Polyline& curve,
                                                    const std::vector<Vec>& middles, double along) const {
    std::vector<bool> anchored(middles.size(), false);
    for (const Vec& anchor : anchors_of(part, curve)) {
        const auto distance = [&](const Vec& middle) { return (middle - anchor).norm(); };
        const auto nearest = std::min_element(middles.begin(), middles.end(),
                                              [&](const Vec& a, const Vec& b) { return distance(a) < distance(b); });
        if (distance(*nearest) < 0.51 * along) anchored[static_cast<std::size_t>(nearest - middles.begin())] = true;
    }
    return anchored;
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
    return nullptr;
}

/// A wall that ends at a plane of symmetry goes on as its own image.
void ParticleBuilder::look_from_images(const Vec& point, WallPoint& best) const {
    const ParticleSet& set = result_.particles;
    for (int axis = 0; axis < set.dimension; ++axis)
        for (const int side : {0, 1}) {
            if (!set.mirrored[axis][side]) continue;
            const double twice_plane = 2 * (side == 0 ? set.box.low : set.box.high)[axis];
            Vec image = point;
            image[axis] = twice_plane - image[axis];
            for (std::size_t w = 0; w < walls_.size(); ++w) {
                auto found = walls_[w].curve.nearest(image);
                if (!found || found->distance >= walls_[w].thickness) continue;
                if (best.wall >= 0 && best.surface.distance <= found->distance) continue;
                found->point[axis] = twice_plane - found->point[axis];
                best = {static_cast<int>(w), *found};
            }
        }
}

ParticleBuilder::WallPoint ParticleBuilder::wall_at(const Vec& point) const {
    WallPoint best;
    const auto look_from = [&](const Vec& shift) {
        for (std::size_t w = 0; w < walls_.size(); ++w) {
            const auto found = walls_[w].curve.nearest(point + shift);
            if (!found || found->distance >= walls_[w].thickness) continue;
            if (best.wall >= 0 && best.surface.distance <= found->distance) continue;
            best = {static_cast<int>(w), {found->point - shift, found->distance}};
        }
    };
    look_from(Vec::Zero());
    look_from_images(point, best);
    const ParticleSet& set = result_.particles;
    for (int axis = 0; axis < set.dimension; ++axis) {
        if (!set.periodic[axis]) continue;
        Vec shift = Vec::Zero();
        for (const double period : {set.box.extent()[axis], -set.box.extent()[axis]}) {
            shift[axis] = period;
            look_from(shift);
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

double ParticleBuilder::distance_to_spring_nodes(const Vec& point) const {
    const ParticleSet& set = result_.particles;
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < set.size(); ++i)
        if (set.kind(i) == ParticleKind::springs) nearest = std::min(nearest, (set.position[i] - point).norm());
    return nearest;
}

void ParticleBuilder::add_fluid(const Part& part) {
    const Region& region = *geometry_.region(part.name);
    const int number = add_part(part, ParticleKind::fluid);
    const double volume = lattice_.cell_area();
    std::size_t count = 0, left_out = 0;
    for (const Vec& point : lattice_.points(0)) {
        ++candidates_;
        if (fluid_at(point) != &part) continue;
        if (!clear_of_bodies(point)) {
            ++left_out;
            continue;
        }
        add_particle(number, {point, volume, volume * part.density, -1, false, Vec::Zero(), 0});
        ++count;
    }
    if (count == 0)
        throw InputError(scene_.particles.spacing.place,
                         "no particle of '" + part.name.value + "' fits into its region at this spacing",
                         "refine particles.spacing, or check geometry.unit");
    MeshReport::PartLine line;
    line.name = part.name;
    line.kind = word(PartKind::fluid);
    line.particles = count;
    line.target = region.area() - static_cast<double>(left_out) * volume;
    line.reached = static_cast<double>(count) * volume;
    line.unit = "m^2";
    result_.report.parts.push_back(line);
    if (left_out > 0)
        result_.report.notes.push_back(part.name.value + ": " + std::to_string(left_out) +
                                       " lattice points left out where bodies stand");
}

void ParticleBuilder::add_walls(const Part& part) {
    const CurveSet& curve = *geometry_.curve_set(part.name);
    const int number = add_part(part, ParticleKind::rigid);
    const double volume = lattice_.cell_area();
    double density = 0;  // a wall never moves: its mass only has to be there
    for (const Fluid& fluid : fluids_) density = std::max(density, fluid.part->density.value);
    std::size_t count = 0;
    const auto own = static_cast<int>(std::ranges::find(walls_, &part, &Wall::part) - walls_.begin());
    for (const Vec& point : lattice_.points((part.layers + 1 + spare_layers(scene_)) * spacing_)) {
        ++candidates_;
        if (fluid_at(point) != nullptr || is_beyond_a_plane(result_.particles, point)) continue;
        const auto [owner, surface] = wall_at(point);
        if (owner != own || distance_to_spring_nodes(point) < wall_clearance * spacing_) continue;
        const Vec to_surface = surface.point - point;
        const Vec normal = surface.distance > 1e-6 * spacing_ ? Vec(to_surface.normalized()) : normal_on_surface(point);
        add_particle(number, {point, volume, volume * density, -1, true, normal, surface.distance});
        ++count;
    }
    if (count == 0)
        throw InputError(
            part.name.place,
            "no particle of the wall '" + part.name.value + "' fits behind its curve: there is fluid on both sides",
            "draw the wall as the edge of a hole in the fluid, or refine particles.spacing");
    MeshReport::PartLine line;
    line.name = part.name;
    line.kind = word(PartKind::rigid);
    line.particles = count;
    line.target = curve.length();
    line.reached = static_cast<double>(count) / part.layers * spacing_;
    line.unit = "m";
    result_.report.parts.push_back(line);
}

void ParticleBuilder::sample() {
    const auto part_at = [&](const Vec& place) {
        const Part* fluid = fluid_at(place);
        if (fluid == nullptr || !clear_of_bodies(place)) return -1;
        return result_.particles.part_named(fluid->name);
    };
    result_.report.notes.push_back(sample_fluids(result_.particles, lattice_.cell_area(),
                                                 static_cast<std::uint64_t>(*scene_.particles.seed), part_at,
                                                 omp_get_max_threads()));
}

void ParticleBuilder::fit() {
    FitBounds bounds;
    for (const Wall& wall : walls_) bounds.walls.push_back({wall.part, false});
    bounds.nearest_wall = [this](const Vec& place) {
        const auto [wall, surface] = wall_at(place);
        return NearestWall{wall, surface.point, surface.distance};
    };
    bounds.into_fluid = [this](const Vec& place, const NearestWall&) { return normal_on_surface(place); };
    bounds.cell_volume = lattice_.cell_area();
    std::vector<const CurveSet*> curves;
    for (const Wall& wall : walls_) curves.push_back(geometry_.curve_set(wall.part->name));
    bounds.features = corner_places(
        curves, [this](const Vec& point) { return fluid_at(point) != nullptr; }, spacing_);
    fit_particles(result_, geometry_, scene_, bounds);
}

bool ParticleBuilder::holds(std::size_t i, const Vec& point) const {
    const Part* fluid = fluid_at(point);
    return fluid != nullptr && *fluid->name == result_.particles.parts[result_.particles.part[i]].name;
}

bool ParticleBuilder::clear_of_bodies(const Vec& point) const {
    return body_curves_.nearest(point).distance >= spacing_;
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

}  // namespace dmp
