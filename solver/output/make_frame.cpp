// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/output/make_frame.hpp"

#include <algorithm>
#include <string_view>

#include "particles/periodic_images.hpp"
#include "solver/output/fluid_fields.hpp"
#include "solver/output/frame_pieces.hpp"
#include "solver/output/solid_fields.hpp"
#include "solver/uses.hpp"

namespace dmp::solver {

namespace {

/// Fields over this rank's particles of one kind, in the store's order.
FrameField stored_field(const ParticleGroup& particles, Field field) {
    const FieldInfo& about = info(field);
    FrameField out{std::string(about.name), std::string(about.unit), about.shape == FieldShape::vector ? 3 : 1, {}};
    for (std::size_t i = 0; i < particles.owned(); ++i)
        for (int axis = 0; axis < out.components; ++axis)
            out.values.push_back(
                axis == 0 || axis < particles.dimension() ? static_cast<float>(particles.data(field, axis)[i]) : 0.0F);
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

FrameField frame_field(const FluidValues& values) {
    return {values.name, values.unit, values.components, {values.values.begin(), values.values.end()}};
}

/// The particles of all ranks on the first one, in the order of their ids.
void collect(FrameGroup& group, const Ranks& ranks) {
    group.id = ranks.gather_to_first(group.id);
    group.part = ranks.gather_to_first(group.part);
    group.position = ranks.gather_to_first(group.position);
    for (FrameField& field : group.fields) field.values = ranks.gather_to_first(field.values);
    sort_by_id(group);
}

/// Takes a field out of a group.
FrameField taken_out(FrameGroup& group, std::string_view name) {
    const auto found = std::ranges::find(group.fields, name, &FrameField::name);
    FrameField field = std::move(*found);
    group.fields.erase(found);
    return field;
}

}  // namespace

Frame make_frame(const Scene& scene, const ParticleStore& particles, const FluidStep& fluid,
                 const MeanDisplacement& mean_displacement, double time, long step, FrameOptions options) {
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
    FluidFields fields(scene, particles, fluid);
    for (const FluidField field : scene.output.fields)
        for (const FluidValues& values : fields.of(field)) liquid.fields.push_back(frame_field(values));
    add(std::move(liquid), options.in_pieces);

    const ParticleGroup& nodes = particles.of(PartKind::elastic);
    FrameGroup solid = group_of("solid", nodes, particles.space());
    if (scene.asks_for(SolidField::velocity)) solid.fields.push_back(stored_field(nodes, Field::velocity));
    solid.fields.push_back(stored_field(nodes, Field::volume));
    add(std::move(solid), false);
    if (!frame.groups.empty() && frame.groups.back().name == "solid") {
        FrameGroup& complete = frame.groups.back();
        const FrameField volume = taken_out(complete, info(Field::volume).name);
        add_solid_fields(complete, scene.output.solid_fields, volume.values, fluid.springs(), mean_displacement);
    }

    const ParticleGroup& rigid = particles.of(PartKind::rigid);
    const WallMotion& walls = fluid.walls();
    if (options.with_walls)
        add(group_of("walls", rigid, particles.space(), [&](std::uint16_t part) { return !walls.moves(part); }),
            options.in_pieces);
    if (walls.moves())
        add(group_of("moving_walls", rigid, particles.space(), [&](std::uint16_t part) { return walls.moves(part); }),
            options.in_pieces);
    return frame;
}

}  // namespace dmp::solver
