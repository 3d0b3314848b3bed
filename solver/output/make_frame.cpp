// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/output/make_frame.hpp"

#include <cmath>
#include <unordered_map>

#include "particles/periodic_images.hpp"
#include "solver/output/frame_pieces.hpp"
#include "solver/output/velocity_gradient.hpp"

namespace dmp {

namespace {

/// A liquid's particle beyond a plane of symmetry stands for its image.
bool is_shown_mirrored(const ParticleGroup& particles, const ParticleSpace& space, int axis, std::size_t i) {
    if (particles.kind() != ParticleKind::fluid || axis >= space.dimension || !space.is_mirrored(axis)) return false;
    const double x = particles.data(Field::position, axis)[i];
    return space.mirrored_back(x, axis) != x;
}

/// Fields over this rank's particles of one kind, in the store's order.
FrameField stored_field(const ParticleGroup& particles, const ParticleSpace& space, Field field) {
    const FieldInfo& about = info(field);
    FrameField out{std::string(about.name), std::string(about.unit), about.is_vector ? 3 : 1, {}};
    for (std::size_t i = 0; i < particles.owned(); ++i)
        for (int axis = 0; axis < out.components; ++axis) {
            float value =
                axis == 0 || axis < particles.dimension() ? static_cast<float>(particles.data(field, axis)[i]) : 0.0F;
            if (out.components == 3 && is_shown_mirrored(particles, space, axis, i)) value = -value;
            out.values.push_back(value);
        }
    return out;
}

/// Those of the particles whose part is chosen.
template <class Chosen>
FrameGroup group_of(const std::string& name, const ParticleGroup& particles, const ParticleSpace& space,
                    const Chosen& chosen) {
    FrameGroup group;
    group.name = name;
    for (std::size_t i = 0; i < particles.owned(); ++i) {
        const ParticleTag& tag = particles.tags()[i];
        if (!chosen(tag.part)) continue;
        group.id.push_back(tag.id);
        group.part.push_back(tag.part);
        for (int axis = 0; axis < 3; ++axis) {
            double x = axis < space.dimension ? particles.data(Field::position, axis)[i] : 0;
            if (space.periodic[axis]) x = wrapped(x, space.box.low[axis], space.box.high[axis]);
            if (is_shown_mirrored(particles, space, axis, i)) x = space.mirrored_back(x, axis);
            group.position.push_back(static_cast<float>(x));
        }
    }
    return group;
}

FrameGroup group_of(const std::string& name, const ParticleGroup& particles, const ParticleSpace& space) {
    return group_of(name, particles, space, [](std::uint16_t) { return true; });
}

FrameField fluid_field(FluidField field, const ParticleStore& particles, const FluidStep& fluid) {
    switch (field) {
        case FluidField::velocity:
            return stored_field(particles.fluid(), particles.space(), Field::velocity);
        case FluidField::pressure:
            return stored_field(particles.fluid(), particles.space(), Field::pressure);
        case FluidField::density:
            return stored_field(particles.fluid(), particles.space(), Field::density);
        case FluidField::shear_stress:
            break;
    }
    FrameField out{"shear_stress", "Pa", 1, {}};
    for (const double stress : shear_stress(particles, fluid.neighbours().list(), fluid.sweeps()))
        out.values.push_back(static_cast<float>(stress));
    return out;
}

/// The particles of all ranks on the first one, in the order of their ids.
void collect(FrameGroup& group, const Ranks& ranks) {
    group.id = ranks.gather_to_first(group.id);
    group.part = ranks.gather_to_first(group.part);
    group.position = ranks.gather_to_first(group.position);
    for (FrameField& field : group.fields) field.values = ranks.gather_to_first(field.values);
    sort_by_id(group);
}

/// What spring bodies alone know; the group is complete and in the order of ids.
void add_springs(FrameGroup& group, const SpringBodies& springs) {
    std::unordered_map<std::int64_t, std::int32_t> index_of;
    for (std::size_t k = 0; k < group.id.size(); ++k) index_of[group.id[k]] = static_cast<std::int32_t>(k);
    FrameField displacement{"displacement", "m", 3, std::vector<float>(3 * group.id.size(), 0.0F)};
    FrameField strain{"strain", "1", 1, {}}, force{"force", "N", 1, {}};
    for (const SpringBody& body : springs.bodies()) {
        const auto& position = body.positions();
        for (std::size_t n = 0; n < body.ids().size(); ++n)
            for (int axis = 0; axis < 2; ++axis)
                displacement.values[3 * index_of.at(body.ids()[n]) + axis] =
                    static_cast<float>(position[n][axis] - body.positions_at_rest()[n][axis]);
        for (const Bond& bond : body.bonds()) {
            group.bond_ends.push_back(index_of.at(body.ids()[bond.a]));
            group.bond_ends.push_back(index_of.at(body.ids()[bond.b]));
            const auto ends = position[bond.a] - position[bond.b];
            const double stretch = std::sqrt(dot(ends, ends)) - bond.rest_length;
            strain.values.push_back(static_cast<float>(stretch / bond.rest_length));
            force.values.push_back(static_cast<float>(2 * bond.stiffness * stretch));
        }
    }
    group.fields.push_back(std::move(displacement));
    group.bond_fields = {std::move(strain), std::move(force)};
}

}  // namespace

Frame make_frame(const Scene& scene, const ParticleStore& particles, const FluidStep& fluid, double time, long step,
                 FrameOptions options) {
    Frame frame;
    frame.time = time;
    frame.step = step;
    frame.spacing = particles.space().spacing;
    for (const auto& part : particles.space().parts) frame.parts.push_back(part.name);

    const Ranks& ranks = fluid.neighbours().ranks();
    const auto add = [&](FrameGroup group, bool in_pieces) {
        if (in_pieces)
            sort_by_id(group);
        else
            collect(group, ranks);
        // All pieces name the same groups.
        if (in_pieces ? ranks.any(!group.id.empty()) : !group.id.empty()) frame.groups.push_back(std::move(group));
    };
    FrameGroup liquid = group_of("fluid", particles.fluid(), particles.space());
    for (const FluidField field : scene.output.fields) liquid.fields.push_back(fluid_field(field, particles, fluid));
    add(std::move(liquid), options.in_pieces);

    FrameGroup solid = group_of("solid", particles.of(ParticleKind::springs), particles.space());
    solid.fields.push_back(stored_field(particles.of(ParticleKind::springs), particles.space(), Field::velocity));
    add(std::move(solid), false);
    if (!frame.groups.empty() && frame.groups.back().name == "solid") add_springs(frame.groups.back(), fluid.springs());

    const ParticleGroup& rigid = particles.of(ParticleKind::rigid);
    const WallMotion& walls = fluid.walls();
    if (options.with_walls)
        add(group_of("walls", rigid, particles.space(), [&](std::uint16_t part) { return !walls.moves(part); }),
            options.in_pieces);
    if (walls.moves())
        add(group_of("moving_walls", rigid, particles.space(), [&](std::uint16_t part) { return walls.moves(part); }),
            options.in_pieces);
    return frame;
}

}  // namespace dmp
