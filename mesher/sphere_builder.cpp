// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "mesher/sphere_builder.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <filesystem>
#include <numbers>

#include <fmt/format.h>

#include "base/random_number.hpp"
#include "geometry/triangle_surface.hpp"
#include "mesher/sphere_packing.hpp"
#include "mesher/sphere_table.hpp"
#include "mesher/uses.hpp"
#include "models/dem/contact_laws.hpp"

namespace dmp::mesher {

namespace {

double ball(double radius) { return 4.0 / 3 * std::numbers::pi * radius * radius * radius; }

Vec at_start(const std::array<Expression, 3>& formulas, const Vec& x) {
    return {formulas[0](0, x[0], x[1], x[2]), formulas[1](0, x[0], x[1], x[2]), formulas[2](0, x[0], x[1], x[2])};
}

/// (1 - nu^2) / E of a material.
double compliance(const Part& part) { return (1 - *part.poisson_ratio * *part.poisson_ratio) / *part.youngs_modulus; }

InputError no_room(const Part& part, int count, double radius) {
    const SourceLocation& position = part.count.given()      ? part.count.location
                                     : part.coverage.given() ? part.coverage.location
                                                             : part.volume_fraction.location;
    return {
        position,
        fmt::format("{} spheres of '{}' of radius {:.4g} m do not fit in without overlap", count, *part.name, radius),
        part.around.given() ? "ask for fewer, or a coverage of at most 0.8"
                            : "ask for fewer, or a volume_fraction of at most 0.5"};
}

}  // namespace

SphereBuilder::SphereBuilder(const Scene& scene) : scene_(scene) {
    ParticleSet& set = result_.particles;
    set.dimension = 3;
    for (std::size_t axis = 0; axis < 3; ++axis) set.periodic.at(axis) = scene.flow.periodic.at(axis);
}

int SphereBuilder::add_part(const Part& part, PartKind kind) {
    result_.particles.parts.push_back({part.name, kind});
    return static_cast<int>(result_.particles.parts.size()) - 1;
}

std::string SphereBuilder::path_of(const std::string& file) const {
    const std::filesystem::path path = file;
    return path.is_absolute() ? file : (std::filesystem::path(scene_.directory) / path).string();
}

std::uint64_t SphereBuilder::seed_of(int part) const {
    return mixed_bits(static_cast<std::uint64_t>(*scene_.particles.seed)) ^ static_cast<std::uint64_t>(part);
}

void SphereBuilder::add_plane(const Part& part) {
    const int number = add_part(part, PartKind::rigid);
    result_.particles.wall_planes.push_back({number, part.point, part.normal->normalized()});
    result_.report.walls.push_back({part.name, 0, 0});
}

void SphereBuilder::add_surface(const Part& part) {
    const TriangleSurface surface = read_stl(path_of(part.file), part.unit, part.file.location);
    const int number = add_part(part, PartKind::rigid);
    ParticleSet& set = result_.particles;
    const int first = static_cast<int>(set.wall_corners.size());
    set.wall_corners.insert(set.wall_corners.end(), surface.corners.begin(), surface.corners.end());
    for (const auto& [a, b, c] : surface.triangles)
        set.wall_triangles.push_back({number, first + a, first + b, first + c});
    result_.report.walls.push_back({part.name, surface.triangles.size(), surface.area()});
    if (surface.left_out > 0)
        result_.report.notes.push_back(
            fmt::format("{}: {} triangles without an area left out", *part.name, surface.left_out));
}

SphereBuilder::Spheres SphereBuilder::listed(const Part& part) const {
    Spheres spheres;
    if (part.centres.given()) {
        spheres.centre = part.centres;
    } else {
        SphereTable table = read_sphere_table(path_of(part.positions), part.positions.location);
        if (table.radius.empty() == part.radius->empty())
            throw InputError(
                part.radius->empty() ? part.positions.location : part.radius.location,
                "part '" + *part.name + "': radius is " +
                    (part.radius->empty() ? "neither in the scene nor in the table" : "in the scene and in the table"),
                part.radius->empty() ? "give radius, or the table a column radius [mm]" : "leave one of them out");
        spheres = {std::move(table.centre), std::move(table.radius), std::move(table.velocity), std::move(table.spin),
                   0};
    }
    const auto radius = [&](std::size_t i) { return part.radius->at(part.radius->size() == 1 ? 0 : i); };
    if (spheres.radius.empty())
        for (std::size_t i = 0; i < spheres.centre.size(); ++i) spheres.radius.push_back(radius(i));
    const auto refuse_twice = [&](bool in_table, const auto& value, const char* name) {
        if (in_table && value.given())
            throw InputError(value.location, "part '" + *part.name + "': " + name + " is in the scene and in the table",
                             "leave one of them out");
    };
    refuse_twice(!spheres.velocity.empty(), part.initial_velocity, "initial_velocity");
    refuse_twice(!spheres.spin.empty(), part.initial_spin, "initial_spin");
    return spheres;
}

double SphereBuilder::rest_overlap(const Part& inner, const Part& part, double inner_radius, double radius) const {
    const ContactPair* pair = scene_.contact_between(*inner.name, *part.name);
    if (pair == nullptr || !*pair->enabled) return 0;
    const double effective = inner_radius * radius / (inner_radius + radius);
    const double stiffness = *pair->normal_stiffness_factor * 4.0 / 3 / (compliance(inner) + compliance(part));
    return visit_adhesive_law(*pair->normal, *pair->adhesion, 0.0, [&]<class Law>() {
        const double work = pair->pull_off_force.given() ? Law::adhesion_energy(*pair->pull_off_force, effective)
                                                         : *pair->work_of_adhesion;
        return Law::rest_overlap(effective, stiffness, work);
    });
}

SphereBuilder::Spheres SphereBuilder::around(const Part& part) const {
    const ParticleSet& set = result_.particles;
    const Part& inner_part = *scene_.part_named(part.around);
    const int number = set.part_named(part.around);
    std::vector<std::size_t> inner;
    for (std::size_t i = 0; i < set.size(); ++i)
        if (set.part[i] == number) inner.push_back(i);
    if (inner.size() != 1)
        throw InputError(part.around.location,
                         fmt::format("part '{}': its spheres sit around one sphere, and '{}' has {}", *part.name,
                                     *part.around, inner.size()),
                         "name a part of one sphere");
    const std::size_t centre = inner.front();
    const double inner_radius = set.radius[centre], radius = part.radius->front();
    const int count = part.count.given() ? *part.count : count_for_coverage(part.coverage, inner_radius, radius);
    const double shell = inner_radius + radius - rest_overlap(inner_part, part, inner_radius, radius);
    const auto points =
        pack_around(set.position[centre], shell, radius, count, seed_of(static_cast<int>(set.parts.size())));
    if (!points || count == 0) throw no_room(part, count, radius);
    Spheres spheres;
    spheres.centre = *points;
    spheres.radius.assign(points->size(), radius);
    spheres.coverage = coverage_of(count, inner_radius, radius);
    const Vec& spin = set.angular_velocity[centre];
    for (const Vec& point : *points) {
        if (!part.initial_velocity.given())
            spheres.velocity.push_back(set.velocity[centre] + spin.cross(point - set.position[centre]));
        if (!part.initial_spin.given()) spheres.spin.push_back(spin);
    }
    return spheres;
}

SphereBuilder::Spheres SphereBuilder::filled(const Part& part) const {
    const ParticleSet& set = result_.particles;
    const double radius = part.radius->front();
    Room room{{part.fill_from, part.fill_to}, set.position, set.radius, set.wall_planes};
    const int count =
        part.count.given()
            ? *part.count
            : static_cast<int>(std::lround(*part.volume_fraction * room.box.extent().prod() / ball(radius)));
    const auto points = pack_room(room, radius, count, seed_of(static_cast<int>(set.parts.size())));
    if (!points || count == 0) throw no_room(part, count, radius);
    return {*points, std::vector<double>(points->size(), radius), {}, {}, 0};
}

void SphereBuilder::start(const Part& part, Spheres& spheres) const {
    const auto fill = [&](std::vector<Vec>& values, const std::array<Expression, 3>& formulas) {
        if (values.empty())
            for (const Vec& centre : spheres.centre) values.push_back(at_start(formulas, centre));
    };
    fill(spheres.velocity, *part.initial_velocity);
    fill(spheres.spin, *part.initial_spin);
}

void SphereBuilder::add_spheres(const Part& part) {
    Spheres spheres = part.around.given() ? around(part) : part.fill_from.given() ? filled(part) : listed(part);
    start(part, spheres);
    const int number = add_part(part, PartKind::spheres);
    ParticleSet& set = result_.particles;
    MeshReport::SpheresLine line;
    line.part = part.name;
    line.around = part.around;
    line.coverage = spheres.coverage;
    line.smallest = line.largest = spheres.radius.front();
    for (std::size_t i = 0; i < spheres.centre.size(); ++i) {
        const double volume = ball(spheres.radius[i]);
        set.position.push_back(spheres.centre[i]);
        set.volume.push_back(volume);
        set.mass.push_back(part.mass.given() ? *part.mass : volume * *part.density);
        set.part.push_back(number);
        set.body.push_back(-1);
        set.fixed.push_back(*part.fixed ? 1 : 0);
        set.seated.push_back(0);
        set.wall_normal.push_back(Vec::Zero());
        set.wall_distance.push_back(0);
        set.radius.push_back(spheres.radius[i]);
        set.velocity.push_back(spheres.velocity[i]);
        set.angular_velocity.push_back(spheres.spin[i]);
        line.smallest = std::min(line.smallest, spheres.radius[i]);
        line.largest = std::max(line.largest, spheres.radius[i]);
        line.mass += set.mass.back();
        ++line.spheres;
    }
    if (part.fill_from.given()) {
        const Vec size = *part.fill_to - *part.fill_from;
        line.volume_fraction = static_cast<double>(line.spheres) * ball(line.largest) / size.prod();
    }
    result_.report.spheres.push_back(line);
}

}  // namespace dmp::mesher
