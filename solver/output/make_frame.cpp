// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/output/make_frame.hpp"

#include <cmath>
#include <unordered_map>

#include "particles/periodic_images.hpp"
#include "solver/output/frame_pieces.hpp"
#include "solver/output/velocity_gradient.hpp"

namespace dmp {

namespace {

/// Fields over this rank's particles of one kind, in the store's order.
FrameField stored_field(const ParticleGroup& particles, Field field) {
    const FieldInfo& about = info(field);
    FrameField out{std::string(about.name), std::string(about.unit), about.is_vector ? 3 : 1, {}};
    for (std::size_t i = 0; i < particles.owned(); ++i)
        for (int axis = 0; axis < out.components; ++axis)
            out.values.push_back(
                axis == 0 || axis < particles.dimension() ? static_cast<float>(particles.data(field, axis)[i]) : 0.0F);
    return out;
}

FrameGroup group_of(const std::string& name, const ParticleGroup& particles, const ParticleSpace& space) {
    FrameGroup group;
    group.name = name;
    for (std::size_t i = 0; i < particles.owned(); ++i)
        for (int axis = 0; axis < 3; ++axis) {
            double x = axis < space.dimension ? particles.data(Field::position, axis)[i] : 0;
            if (space.periodic[axis]) x = wrapped(x, space.box.low[axis], space.box.high[axis]);
            group.position.push_back(static_cast<float>(x));
        }
    for (const ParticleTag& tag : particles.tags().first(particles.owned())) {
        group.id.push_back(tag.id);
        group.part.push_back(tag.part);
    }
    return group;
}

FrameField fluid_field(FluidField field, const ParticleStore& particles, const FluidStep& fluid) {
    switch (field) {
        case FluidField::velocity:
            return stored_field(particles.fluid(), Field::velocity);
        case FluidField::pressure:
            return stored_field(particles.fluid(), Field::pressure);
        case FluidField::density:
            return stored_field(particles.fluid(), Field::density);
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
    for (const auto& body : springs.bodies()) {
        for (std::size_t n = 0; n < body->nodes(); ++n) {
            const Vec way = body->place(n) - body->place_at_rest(n);
            for (int axis = 0; axis < 3; ++axis)
                displacement.values[3 * index_of.at(body->ids()[n]) + axis] = static_cast<float>(way[axis]);
        }
        for (const Bond& bond : body->bonds()) {
            group.bond_ends.push_back(index_of.at(body->ids()[bond.a]));
            group.bond_ends.push_back(index_of.at(body->ids()[bond.b]));
            const double stretch = (body->place(bond.a) - body->place(bond.b)).norm() - bond.rest_length;
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
    solid.fields.push_back(stored_field(particles.of(ParticleKind::springs), Field::velocity));
    add(std::move(solid), false);
    if (!frame.groups.empty() && frame.groups.back().name == "solid") add_springs(frame.groups.back(), fluid.springs());

    if (options.with_walls)
        add(group_of("walls", particles.of(ParticleKind::rigid), particles.space()), options.in_pieces);
    return frame;
}

}  // namespace dmp
