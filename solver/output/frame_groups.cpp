// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/output/frame_groups.hpp"

#include <algorithm>
#include <optional>
#include <string_view>

#include "solver/output/fluid_fields.hpp"
#include "solver/output/frame_pieces.hpp"
#include "solver/output/solid_fields.hpp"
#include "solver/output/surface_traction.hpp"

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

/// Takes a field out of a group.
FrameField taken_out(FrameGroup& group, std::string_view name) {
    const auto found = std::ranges::find(group.fields, name, &FrameField::name);
    FrameField field = std::move(*found);
    group.fields.erase(found);
    return field;
}

}  // namespace

FrameGroup group_of(const std::string& name, const ParticleGroup& particles, const ParticleSpace& space,
                    const std::function<bool(int)>& chosen) {
    FrameGroup group;
    group.name = name;
    for (std::size_t i = 0; i < particles.owned(); ++i) {
        const ParticleTag& tag = particles.tags()[i];
        if (chosen && !chosen(tag.part)) continue;
        group.id.push_back(tag.id);
        group.part.push_back(tag.part);
        for (const double x : shown_place(particles, space, i)) group.position.push_back(static_cast<float>(x));
    }
    return group;
}

void collect(FrameGroup& group, const Ranks& ranks) {
    group.id = ranks.gather_to_first(group.id);
    group.part = ranks.gather_to_first(group.part);
    group.position = ranks.gather_to_first(group.position);
    for (FrameField& field : group.fields) field.values = ranks.gather_to_first(field.values);
    sort_by_id(group);
}

SolidGroup solid_group(const ParticleStore& particles, const FluidStep& step, const std::vector<SolidField>& fields,
                       const MeanDisplacement* mean_displacement) {
    const ParticleGroup& nodes = particles.of(PartKind::elastic);
    const auto asks_for = [&](SolidField field) { return std::ranges::find(fields, field) != fields.end(); };
    SolidGroup solid{group_of("solid", nodes, particles.space()), {}};
    FrameGroup& group = solid.group;
    if (asks_for(SolidField::velocity)) group.fields.push_back(stored_field(nodes, Field::velocity));
    group.fields.push_back(stored_field(nodes, Field::volume));
    collect(group, step.neighbours().ranks());
    std::optional<SurfaceTraction> traction;
    if (asks_for(SolidField::traction)) traction.emplace(particles, step.springs(), step.neighbours().ranks());
    solid.volume = taken_out(group, info(Field::volume).name).values;
    if (group.id.empty()) return solid;
    add_solid_fields(group, fields, solid.volume, {step.springs(), mean_displacement, traction ? &*traction : nullptr});
    return solid;
}

}  // namespace dmp::solver
