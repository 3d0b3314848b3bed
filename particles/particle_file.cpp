// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/particle_file.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <stdexcept>
#include <string>

#include "base/sealed_file.hpp"
#include "particles/cells_in_file.hpp"

namespace dmp::particles {

namespace fs = std::filesystem;

namespace {

constexpr SealedKind particles_kind{"particle set", 1};
constexpr const auto& kind_names = enum_names<PartKind>;

// Vectors in a row are x, y, z, x, y, z, ...
static_assert(sizeof(Vec) == 3 * sizeof(double));
std::span<const double> flat(const std::vector<Vec>& vectors) {
    return vectors.empty() ? std::span<const double>() : std::span(vectors.front().data(), 3 * vectors.size());
}

bool finite(double value) { return std::isfinite(value); }

std::string of(const char* what, std::size_t number) { return std::string(what) + " " + std::to_string(number); }

/// What is wrong with the space and the parts, or "".
std::string problem_with_space(const ParticleSpace& space) {
    if (space.dimension != 2 && space.dimension != 3)
        return std::to_string(space.dimension) + " dimensions; there are scenes in 2 and 3";
    if (!finite(space.spacing) || space.spacing <= 0) return "the spacing is not more than 0";
    if (!space.box.low.allFinite() || !space.box.high.allFinite() || (space.box.extent().array() < 0).any())
        return "the box is none: its low corner is not below its high one";
    return "";
}

std::string problem_with_lengths(const ParticleSet& set) {
    const auto differs = [&](const char* name, std::size_t found) {
        return found == set.size() ? ""
                                   : std::string("there are positions of ") + std::to_string(set.size()) +
                                         " particles, and " + name + " of " + std::to_string(found);
    };
    for (const std::string& problem :
         {differs("volume", set.volume.size()), differs("mass", set.mass.size()), differs("part", set.part.size()),
          differs("body", set.body.size()), differs("fixed", set.fixed.size()), differs("seated", set.seated.size()),
          differs("wall_normal", set.wall_normal.size()), differs("wall_distance", set.wall_distance.size())})
        if (!problem.empty()) return problem;
    if (!set.opposite_distance.empty() && set.opposite_distance.size() != set.size())
        return differs("opposite_distance", set.opposite_distance.size());
    if (!set.has_spheres() && set.velocity.empty() && set.angular_velocity.empty()) return "";
    for (const std::string& problem : {differs("radius", set.radius.size()), differs("velocity", set.velocity.size()),
                                       differs("angular_velocity", set.angular_velocity.size())})
        if (!problem.empty()) return problem;
    return "";
}

std::string problem_with_sphere(const ParticleSet& set, std::size_t i) {
    if (set.kind(i) != PartKind::spheres) return "";
    if (!set.has_spheres() || !finite(set.radius[i]) || set.radius[i] <= 0) return "its radius is not more than 0";
    if (set.mass[i] <= 0) return "its mass is not more than 0";
    if (!set.velocity[i].allFinite() || !set.angular_velocity[i].allFinite())
        return "its velocity or angular_velocity is not finite";
    return "";
}

/// What is wrong with the walls for spheres, or "".
std::string problem_with_walls(const ParticleSpace& space) {
    const auto no_wall = [&](int part) {
        return part < 0 || static_cast<std::size_t>(part) >= space.parts.size() ||
               space.parts[static_cast<std::size_t>(part)].kind != PartKind::rigid;
    };
    for (std::size_t n = 0; n < space.wall_planes.size(); ++n) {
        const WallPlane& plane = space.wall_planes[n];
        if (no_wall(plane.part)) return of("wall plane", n) + ": its part is no rigid part";
        if (!plane.point.allFinite() || !(std::abs(plane.normal.norm() - 1) < 1e-12))
            return of("wall plane", n) + ": its point is not finite, or its normal is not one long";
    }
    for (std::size_t n = 0; n < space.contact_points.size(); ++n)
        if (!space.contact_points[n].allFinite()) return of("contact point", n) + " is not finite";
    for (std::size_t n = 0; n < space.contact_pieces.size(); ++n) {
        const ContactPiece& piece = space.contact_pieces[n];
        const auto is_no_point = [&](int point) {
            return point < 0 || static_cast<std::size_t>(point) >= space.contact_points.size();
        };
        if (piece.part < 0 || static_cast<std::size_t>(piece.part) >= space.parts.size())
            return of("contact piece", n) + ": its part is not there";
        const bool is_line = space.dimension == 2 && piece.c == ContactPiece::none;
        if (is_no_point(piece.a) || is_no_point(piece.b) || (!is_line && is_no_point(piece.c)))
            return of("contact piece", n) + " has a point that is not there";
        if (!finite(piece.thickness)) return of("contact piece", n) + ": its thickness is not finite";
    }
    for (std::size_t n = 0; n < space.wall_corners.size(); ++n)
        if (!space.wall_corners[n].allFinite()) return of("wall corner", n) + " is not finite";
    const auto outside = [&](int corner) {
        return corner < 0 || static_cast<std::size_t>(corner) >= space.wall_corners.size();
    };
    for (std::size_t n = 0; n < space.wall_triangles.size(); ++n) {
        const WallTriangle& triangle = space.wall_triangles[n];
        if (no_wall(triangle.part)) return of("wall triangle", n) + ": its part is no rigid part";
        if (outside(triangle.a) || outside(triangle.b) || outside(triangle.c))
            return of("wall triangle", n) + " has a corner that is not there";
    }
    return "";
}

std::string problem_with_particle(const ParticleSet& set, std::size_t i) {
    if (!set.position[i].allFinite()) return "its position is not finite";
    if (!finite(set.volume[i]) || !finite(set.mass[i])) return "its volume or mass is not finite";
    if (!set.wall_normal[i].allFinite() || !finite(set.wall_distance[i]))
        return "its wall_normal or wall_distance is not finite";
    if (!set.opposite_distance.empty() && !finite(set.opposite_distance[i]))
        return "its opposite_distance is not finite";
    if (set.part[i] < 0 || static_cast<std::size_t>(set.part[i]) >= set.parts.size())
        return "its part is number " + std::to_string(set.part[i]) + " of " + std::to_string(set.parts.size());
    if (set.body[i] < -1) return "its body is number " + std::to_string(set.body[i]);
    if (set.fixed[i] > 1 || set.seated[i] > 1) return "its fixed or seated is neither 0 nor 1";
    return problem_with_sphere(set, i);
}

/// What makes a set one that nobody can use, or "".
std::string problem_with(const ParticleSet& set) {
    std::string problem = problem_with_space(set);
    if (problem.empty()) problem = problem_with_walls(set);
    if (problem.empty()) problem = problem_with_lengths(set);
    if (!problem.empty()) return problem;
    for (std::size_t i = 0; i < set.size(); ++i) {
        problem = problem_with_particle(set, i);
        if (!problem.empty()) return of("particle", i) + ": " + problem;
    }
    const auto outside = [&](int end) { return end < 0 || static_cast<std::size_t>(end) >= set.size(); };
    for (std::size_t n = 0; n < set.bonds.size(); ++n) {
        const Bond& bond = set.bonds[n];
        if (outside(bond.a) || outside(bond.b)) return of("bond", n) + " ends at a particle that is not there";
        if (!finite(bond.rest_length) || !finite(bond.stiffness))
            return of("bond", n) + ": its rest_length or stiffness is not finite";
        if (bond.join < -1) return of("bond", n) + ": its join is number " + std::to_string(bond.join);
    }
    for (std::size_t n = 0; n < set.hinges.size(); ++n) {
        const Hinge& hinge = set.hinges[n];
        if (outside(hinge.a) || outside(hinge.centre) || outside(hinge.b))
            return of("hinge", n) + " joins a particle that is not there";
        if (!finite(hinge.rest_angle) || !finite(hinge.stiffness))
            return of("hinge", n) + ": its rest_angle or stiffness is not finite";
        if (set.dimension == 3 && !(hinge.rest_angle >= 0 && hinge.rest_angle <= std::numbers::pi))
            return of("hinge", n) + ": its rest_angle is not between 0 and pi, as angles in 3-D are";
    }
    if (set.dimension == 2 && !set.dihedrals.empty()) return "it has dihedrals, and there are none in 2-D";
    for (std::size_t n = 0; n < set.dihedrals.size(); ++n) {
        const Dihedral& dihedral = set.dihedrals[n];
        if (outside(dihedral.a) || outside(dihedral.b) || outside(dihedral.c) || outside(dihedral.d))
            return of("dihedral", n) + " joins a particle that is not there";
        if (!finite(dihedral.rest_angle) || !finite(dihedral.stiffness))
            return of("dihedral", n) + ": its rest_angle or stiffness is not finite";
    }
    return problem_with_cells(set);
}

/// One member of each bond, hinge or dihedral.
template <class T, class Item>
std::vector<T> column(const std::vector<Item>& items, T Item::*member) {
    std::vector<T> values(items.size());
    std::transform(items.begin(), items.end(), values.begin(), [member](const Item& item) { return item.*member; });
    return values;
}

void write_space(Hdf5Writer& to, const ParticleSpace& space) {
    to.write_number<std::int32_t>("dimension", space.dimension);
    to.write_number<double>("spacing", space.spacing);
    to.write_array<double>("box/low", std::span(space.box.low.data(), 3));
    to.write_array<double>("box/high", std::span(space.box.high.data(), 3));
    const std::array<std::uint8_t, 3> periodic{space.periodic[0], space.periodic[1], space.periodic[2]};
    to.write_array<std::uint8_t>("periodic", periodic);
    std::array<std::uint8_t, 6> mirrored{};
    for (std::size_t side = 0; side < mirrored.size(); ++side) mirrored[side] = space.mirrored[side / 2][side % 2];
    to.write_array<std::uint8_t>("mirrored", mirrored);
    std::vector<std::string> names, kinds;
    for (const auto& part : space.parts) {
        names.push_back(part.name);
        kinds.emplace_back(kind_names.at(static_cast<std::size_t>(part.kind)));
    }
    to.write_texts("parts/name", names);
    to.write_texts("parts/kind", kinds);
    for (const char* length : {"spacing", "box/low", "box/high"}) to.set_attribute(length, "unit", "m");
}

/// Walls for spheres, where there are any.
void write_walls(Hdf5Writer& to, const ParticleSpace& space) {
    if (!space.wall_planes.empty()) {
        std::vector<Vec> points, normals;
        for (const WallPlane& plane : space.wall_planes) {
            points.push_back(plane.point);
            normals.push_back(plane.normal);
        }
        to.write_array<std::int32_t>("wall_planes/part", column(space.wall_planes, &WallPlane::part));
        to.write_array<double>("wall_planes/point", flat(points));
        to.write_array<double>("wall_planes/normal", flat(normals));
        to.set_attribute("wall_planes/point", "unit", "m");
        to.set_attribute("wall_planes/normal", "unit", "1");
    }
    if (!space.contact_pieces.empty()) {
        to.write_array<double>("contact_pieces/points", flat(space.contact_points));
        to.write_array<std::int32_t>("contact_pieces/part", column(space.contact_pieces, &ContactPiece::part));
        to.write_array<std::int32_t>("contact_pieces/a", column(space.contact_pieces, &ContactPiece::a));
        to.write_array<std::int32_t>("contact_pieces/b", column(space.contact_pieces, &ContactPiece::b));
        to.write_array<std::int32_t>("contact_pieces/c", column(space.contact_pieces, &ContactPiece::c));
        to.write_array<double>("contact_pieces/thickness", column(space.contact_pieces, &ContactPiece::thickness));
        to.set_attribute("contact_pieces/points", "unit", "m");
        to.set_attribute("contact_pieces/thickness", "unit", "m");
    }
    if (space.wall_triangles.empty()) return;
    to.write_array<double>("wall_triangles/corners", flat(space.wall_corners));
    to.write_array<std::int32_t>("wall_triangles/part", column(space.wall_triangles, &WallTriangle::part));
    to.write_array<std::int32_t>("wall_triangles/a", column(space.wall_triangles, &WallTriangle::a));
    to.write_array<std::int32_t>("wall_triangles/b", column(space.wall_triangles, &WallTriangle::b));
    to.write_array<std::int32_t>("wall_triangles/c", column(space.wall_triangles, &WallTriangle::c));
    to.set_attribute("wall_triangles/corners", "unit", "m");
}

void write_arrays(Hdf5Writer& to, const ParticleSet& set) {
    to.write_array<double>("particles/position", flat(set.position));
    to.write_array<double>("particles/volume", set.volume);
    to.write_array<double>("particles/mass", set.mass);
    to.write_array<std::int32_t>("particles/part", set.part);
    to.write_array<std::int32_t>("particles/body", set.body);
    to.write_array<std::uint8_t>("particles/fixed", set.fixed);
    to.write_array<std::uint8_t>("particles/seated", set.seated);
    to.write_array<double>("particles/wall_normal", flat(set.wall_normal));
    to.write_array<double>("particles/wall_distance", set.wall_distance);
    to.set_attribute("particles/position", "unit", "m");
    to.set_attribute("particles/volume", "unit", "m^3");
    to.set_attribute("particles/mass", "unit", "kg");
    to.set_attribute("particles/wall_normal", "unit", "1");
    to.set_attribute("particles/wall_distance", "unit", "m");
    if (!set.opposite_distance.empty()) {
        to.write_array<double>("particles/opposite_distance", set.opposite_distance);
        to.set_attribute("particles/opposite_distance", "unit", "m");
    }
    if (!set.has_spheres()) return;
    to.write_array<double>("particles/radius", set.radius);
    to.write_array<double>("particles/velocity", flat(set.velocity));
    to.write_array<double>("particles/angular_velocity", flat(set.angular_velocity));
    to.set_attribute("particles/radius", "unit", "m");
    to.set_attribute("particles/velocity", "unit", "m/s");
    to.set_attribute("particles/angular_velocity", "unit", "rad/s");
}

void write_springs(Hdf5Writer& to, const ParticleSet& set) {
    to.write_array<std::int32_t>("bonds/a", column(set.bonds, &Bond::a));
    to.write_array<std::int32_t>("bonds/b", column(set.bonds, &Bond::b));
    to.write_array<double>("bonds/rest_length", column(set.bonds, &Bond::rest_length));
    to.write_array<double>("bonds/stiffness", column(set.bonds, &Bond::stiffness));
    if (std::ranges::any_of(set.bonds, [](const Bond& bond) { return bond.join >= 0; }))
        to.write_array<std::int32_t>("bonds/join", column(set.bonds, &Bond::join));
    to.write_array<std::int32_t>("hinges/a", column(set.hinges, &Hinge::a));
    to.write_array<std::int32_t>("hinges/centre", column(set.hinges, &Hinge::centre));
    to.write_array<std::int32_t>("hinges/b", column(set.hinges, &Hinge::b));
    to.write_array<double>("hinges/rest_angle", column(set.hinges, &Hinge::rest_angle));
    to.write_array<double>("hinges/stiffness", column(set.hinges, &Hinge::stiffness));
    to.set_attribute("bonds/rest_length", "unit", "m");
    to.set_attribute("bonds/stiffness", "unit", "N/m");
    to.set_attribute("hinges/rest_angle", "unit", "rad");
    to.set_attribute("hinges/stiffness", "unit", "J");
    if (set.dihedrals.empty()) return;
    to.write_array<std::int32_t>("dihedrals/a", column(set.dihedrals, &Dihedral::a));
    to.write_array<std::int32_t>("dihedrals/b", column(set.dihedrals, &Dihedral::b));
    to.write_array<std::int32_t>("dihedrals/c", column(set.dihedrals, &Dihedral::c));
    to.write_array<std::int32_t>("dihedrals/d", column(set.dihedrals, &Dihedral::d));
    to.write_array<double>("dihedrals/rest_angle", column(set.dihedrals, &Dihedral::rest_angle));
    to.write_array<double>("dihedrals/stiffness", column(set.dihedrals, &Dihedral::stiffness));
    to.set_attribute("dihedrals/rest_angle", "unit", "rad");
    to.set_attribute("dihedrals/stiffness", "unit", "J");
}

std::vector<Vec> read_vectors(const Hdf5Reader& from, const std::string& name) {
    const std::uint64_t length = from.length(name);
    if (length % 3 != 0) from.refuse(name + " has " + std::to_string(length) + " numbers, no three a vector");
    std::vector<Vec> vectors(length / 3);
    if (!vectors.empty()) from.read<double>(name, 0, std::span(vectors.front().data(), length));
    return vectors;
}

Vec read_vector(const Hdf5Reader& from, const std::string& name) {
    const std::vector<Vec> vectors = read_vectors(from, name);
    if (vectors.size() != 1) from.refuse(name + " is not one vector");
    return vectors.front();
}

void read_space(const Hdf5Reader& from, ParticleSpace& space) {
    space.dimension = from.number<std::int32_t>("dimension");
    space.spacing = from.number<double>("spacing");
    space.box.low = read_vector(from, "box/low");
    space.box.high = read_vector(from, "box/high");
    const auto periodic = from.array<std::uint8_t>("periodic");
    if (periodic.size() != 3 || std::ranges::any_of(periodic, [](int flag) { return flag > 1; }))
        from.refuse("periodic is not 0 or 1 for each of three axes");
    std::copy(periodic.begin(), periodic.end(), space.periodic.begin());
    if (from.has("mirrored")) {  // files of before there were planes of symmetry are without
        const auto mirrored = from.array<std::uint8_t>("mirrored");
        if (mirrored.size() != 6 || std::ranges::any_of(mirrored, [](int flag) { return flag > 1; }))
            from.refuse("mirrored is not 0 or 1 for each side of three axes");
        for (std::size_t side = 0; side < mirrored.size(); ++side)
            space.mirrored[side / 2][side % 2] = mirrored[side] == 1;
    }
    const auto names = from.texts("parts/name"), kinds = from.texts("parts/kind");
    if (names.size() != kinds.size())
        from.refuse(std::to_string(names.size()) + " parts have a name, and " + std::to_string(kinds.size()) +
                    " a kind");
    for (std::size_t n = 0; n < names.size(); ++n) {
        const auto* const kind = std::ranges::find(kind_names, kinds[n]);
        if (kind == kind_names.end())
            from.refuse("part '" + names[n] + "' is of the kind '" + kinds[n] + "', which is none");
        space.parts.push_back({names[n], static_cast<PartKind>(kind - kind_names.begin())});
    }
}

void read_arrays(const Hdf5Reader& from, ParticleSet& set) {
    set.position = read_vectors(from, "particles/position");
    set.volume = from.array<double>("particles/volume");
    set.mass = from.array<double>("particles/mass");
    set.part = from.array<std::int32_t>("particles/part");
    set.body = from.array<std::int32_t>("particles/body");
    set.fixed = from.array<std::uint8_t>("particles/fixed");
    set.seated = from.array<std::uint8_t>("particles/seated");
    set.wall_normal = read_vectors(from, "particles/wall_normal");
    set.wall_distance = from.array<double>("particles/wall_distance");
    if (from.has("particles/opposite_distance"))
        set.opposite_distance = from.array<double>("particles/opposite_distance");
    if (!from.has("particles/radius")) return;
    set.radius = from.array<double>("particles/radius");
    set.velocity = read_vectors(from, "particles/velocity");
    set.angular_velocity = read_vectors(from, "particles/angular_velocity");
}

/// One member of each bond or hinge, from its dataset; `items` has the right length already.
template <class T, class Item>
void read_column(const Hdf5Reader& from, const std::string& name, std::vector<Item>& items, T Item::*member) {
    const std::vector<T> values = from.array<T>(name);
    if (values.size() != items.size())
        from.refuse(name + " has " + std::to_string(values.size()) + " elements, not " + std::to_string(items.size()));
    for (std::size_t n = 0; n < values.size(); ++n) items[n].*member = values[n];
}

void read_walls(const Hdf5Reader& from, ParticleSpace& space) {
    if (from.has("wall_planes/part")) {
        const std::vector<Vec> points = read_vectors(from, "wall_planes/point");
        const std::vector<Vec> normals = read_vectors(from, "wall_planes/normal");
        space.wall_planes.resize(points.size());
        read_column(from, "wall_planes/part", space.wall_planes, &WallPlane::part);
        if (normals.size() != points.size()) from.refuse("wall_planes have not as many normals as points");
        for (std::size_t n = 0; n < points.size(); ++n) {
            space.wall_planes[n].point = points[n];
            space.wall_planes[n].normal = normals[n];
        }
    }
    if (from.has("contact_pieces/a")) {
        space.contact_points = read_vectors(from, "contact_pieces/points");
        space.contact_pieces.resize(from.length("contact_pieces/a"));
        read_column<std::int32_t>(from, "contact_pieces/part", space.contact_pieces, &ContactPiece::part);
        read_column<std::int32_t>(from, "contact_pieces/a", space.contact_pieces, &ContactPiece::a);
        read_column<std::int32_t>(from, "contact_pieces/b", space.contact_pieces, &ContactPiece::b);
        read_column<std::int32_t>(from, "contact_pieces/c", space.contact_pieces, &ContactPiece::c);
        read_column<double>(from, "contact_pieces/thickness", space.contact_pieces, &ContactPiece::thickness);
    }
    if (!from.has("wall_triangles/a")) return;
    space.wall_corners = read_vectors(from, "wall_triangles/corners");
    space.wall_triangles.resize(from.length("wall_triangles/a"));
    read_column(from, "wall_triangles/part", space.wall_triangles, &WallTriangle::part);
    read_column(from, "wall_triangles/a", space.wall_triangles, &WallTriangle::a);
    read_column(from, "wall_triangles/b", space.wall_triangles, &WallTriangle::b);
    read_column(from, "wall_triangles/c", space.wall_triangles, &WallTriangle::c);
}

void read_springs(const Hdf5Reader& from, ParticleSet& set) {
    set.bonds.resize(from.length("bonds/a"));
    read_column(from, "bonds/a", set.bonds, &Bond::a);
    read_column(from, "bonds/b", set.bonds, &Bond::b);
    read_column(from, "bonds/rest_length", set.bonds, &Bond::rest_length);
    read_column(from, "bonds/stiffness", set.bonds, &Bond::stiffness);
    if (from.has("bonds/join")) read_column(from, "bonds/join", set.bonds, &Bond::join);
    set.hinges.resize(from.length("hinges/a"));
    read_column(from, "hinges/a", set.hinges, &Hinge::a);
    read_column(from, "hinges/centre", set.hinges, &Hinge::centre);
    read_column(from, "hinges/b", set.hinges, &Hinge::b);
    read_column(from, "hinges/rest_angle", set.hinges, &Hinge::rest_angle);
    read_column(from, "hinges/stiffness", set.hinges, &Hinge::stiffness);
    if (!from.has("dihedrals/a")) return;
    set.dihedrals.resize(from.length("dihedrals/a"));
    read_column(from, "dihedrals/a", set.dihedrals, &Dihedral::a);
    read_column(from, "dihedrals/b", set.dihedrals, &Dihedral::b);
    read_column(from, "dihedrals/c", set.dihedrals, &Dihedral::c);
    read_column(from, "dihedrals/d", set.dihedrals, &Dihedral::d);
    read_column(from, "dihedrals/rest_angle", set.dihedrals, &Dihedral::rest_angle);
    read_column(from, "dihedrals/stiffness", set.dihedrals, &Dihedral::stiffness);
}

}  // namespace

void write_particles(const fs::path& file, const ParticleSet& particles, std::span<const std::string> made_from) {
    const std::string problem = problem_with(particles);
    if (!problem.empty()) throw std::invalid_argument("particles for '" + file.string() + "': " + problem);
    SealedWriter writer(file, particles_kind);
    write_space(writer.contents(), particles);
    write_walls(writer.contents(), particles);
    write_arrays(writer.contents(), particles);
    write_springs(writer.contents(), particles);
    write_cells(writer.contents(), particles);
    if (!made_from.empty()) writer.contents().write_texts("made_from", made_from);
    writer.finish();
}

StoredParticles read_particle_file(const fs::path& file) {
    const SealedReader reader(file, particles_kind);
    const Hdf5Reader& from = reader.contents();
    StoredParticles stored;
    read_space(from, stored.particles);
    read_walls(from, stored.particles);
    read_arrays(from, stored.particles);
    read_springs(from, stored.particles);
    read_cells(from, stored.particles);
    const std::string problem = problem_with(stored.particles);
    if (!problem.empty()) from.refuse(problem);
    if (from.has("made_from")) stored.made_from = from.texts("made_from");
    return stored;
}

ParticleSet read_particles(const fs::path& file) { return read_particle_file(file).particles; }

}  // namespace dmp::particles
