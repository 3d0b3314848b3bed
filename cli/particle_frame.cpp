// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/particle_frame.hpp"

#include <array>
#include <functional>
#include <vector>

#include "cli/uses.hpp"
#include "solver/output/wall_surfaces.hpp"

namespace dmp::cli {

namespace {

constexpr std::array kinds{PartKind::fluid, PartKind::elastic, PartKind::rigid, PartKind::spheres};
constexpr std::array group_names{"fluid", "solid", "walls", "spheres"};

using Indices = std::vector<std::size_t>;

FrameField scalar(const char* name, const char* unit, const Indices& members,
                  const std::function<double(std::size_t)>& value) {
    FrameField field{name, unit, 1, {}};
    field.values.reserve(members.size());
    for (const std::size_t i : members) field.values.push_back(static_cast<float>(value(i)));
    return field;
}

FrameField vector(const char* name, const char* unit, const Indices& members, const std::vector<Vec>& values) {
    FrameField field{name, unit, 3, {}};
    field.values.reserve(3 * members.size());
    for (const std::size_t i : members) {
        for (int axis = 0; axis < 3; ++axis) field.values.push_back(static_cast<float>(values[i][axis]));
    }
    return field;
}

void add_bonds(FrameGroup& group, const ParticleSet& particles, const Indices& members) {
    std::vector<std::int32_t> position(particles.size(), -1);
    for (std::size_t k = 0; k < members.size(); ++k) position[members[k]] = static_cast<std::int32_t>(k);
    FrameField length{"rest_length", "m", 1, {}};
    FrameField stiffness{"stiffness", "N/m", 1, {}};
    for (const Bond& bond : particles.bonds) {
        const std::int32_t a = position[static_cast<std::size_t>(bond.a)];
        const std::int32_t b = position[static_cast<std::size_t>(bond.b)];
        if (a < 0 || b < 0) continue;  // the other end is in another group's picture
        group.bond_ends.insert(group.bond_ends.end(), {a, b});
        length.values.push_back(static_cast<float>(bond.rest_length));
        stiffness.values.push_back(static_cast<float>(bond.stiffness));
    }
    group.bond_fields = {std::move(length), std::move(stiffness)};
}

FrameGroup group_of(const ParticleSet& particles, PartKind kind, const char* name) {
    Indices members;
    for (std::size_t i = 0; i < particles.size(); ++i) {
        if (particles.kind(i) == kind) members.push_back(i);
    }
    FrameGroup group;
    group.name = name;
    group.position = vector("position", "m", members, particles.position).values;
    for (const std::size_t i : members) {
        group.id.push_back(static_cast<std::int64_t>(i));
        group.part.push_back(particles.part[i]);
    }
    group.fields.push_back(scalar("volume", "m^3", members, [&](std::size_t i) { return particles.volume[i]; }));
    group.fields.push_back(scalar("mass", "kg", members, [&](std::size_t i) { return particles.mass[i]; }));
    if (kind == PartKind::elastic) {
        group.fields.push_back(scalar("body", "1", members, [&](std::size_t i) { return particles.body[i]; }));
        group.fields.push_back(scalar("fixed", "1", members, [&](std::size_t i) { return particles.fixed[i]; }));
        group.fields.push_back(scalar("seated", "1", members, [&](std::size_t i) { return particles.seated[i]; }));
        add_bonds(group, particles, members);
    }
    if (kind == PartKind::spheres) {
        group.fields.push_back(scalar("radius", "m", members, [&](std::size_t i) { return particles.radius[i]; }));
        group.fields.push_back(vector("velocity", "m/s", members, particles.velocity));
        group.fields.push_back(vector("angular_velocity", "rad/s", members, particles.angular_velocity));
        group.fields.push_back(scalar("fixed", "1", members, [&](std::size_t i) { return particles.fixed[i]; }));
    }
    if (kind == PartKind::rigid || kind == PartKind::elastic) {
        group.fields.push_back(vector("wall_normal", "1", members, particles.wall_normal));
        group.fields.push_back(
            scalar("wall_distance", "m", members, [&](std::size_t i) { return particles.wall_distance[i]; }));
    }
    if (kind == PartKind::elastic) {
        group.fields.push_back(
            scalar("opposite_distance", "m", members, [&](std::size_t i) { return particles.surface(i).opposite; }));
    }
    return group;
}

}  // namespace

Frame particle_frame(const ParticleSet& particles) {
    Frame frame;
    frame.spacing = particles.spacing;
    for (const auto& part : particles.parts) frame.parts.push_back(part.name);
    for (std::size_t k = 0; k < kinds.size(); ++k) {
        if (particles.count(kinds.at(k)) > 0)
            frame.groups.push_back(group_of(particles, kinds.at(k), group_names.at(k)));
    }
    FrameGroup walls = wall_surfaces(
        "walls", particles, particles.box, [](int) { return true; }, [](int) { return Vec(Vec::Zero()); });
    if (walls.size() > 0) frame.groups.push_back(std::move(walls));
    return frame;
}

}  // namespace dmp::cli
