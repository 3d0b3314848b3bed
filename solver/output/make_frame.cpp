// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/output/make_frame.hpp"

#include <cmath>

#include "solver/output/velocity_gradient.hpp"

namespace dmp {

namespace {

FrameGroup group_of(const std::string& name, const ParticleSet& set, const ParticleStore& particles,
                    ParticleKind kind) {
    FrameGroup group;
    group.name = name;
    for (const int i : particles.ids(kind)) {
        for (int axis = 0; axis < 3; ++axis)
            group.position.push_back(
                axis < particles.dimension() ? static_cast<float>(particles.data(Field::position, axis)[i]) : 0.0F);
        group.id.push_back(i);
        group.part.push_back(set.part[i]);
    }
    return group;
}

FrameField stored_field(const ParticleStore& particles, ParticleKind kind, Field field) {
    const FieldInfo& about = info(field);
    FrameField out{std::string(about.name), std::string(about.unit), about.is_vector ? 3 : 1, {}};
    for (const int i : particles.ids(kind))
        for (int axis = 0; axis < out.components; ++axis)
            out.values.push_back(
                axis == 0 || axis < particles.dimension() ? static_cast<float>(particles.data(field, axis)[i]) : 0.0F);
    return out;
}

FrameField fluid_field(FluidField field, const ParticleStore& particles, const FluidStep& fluid) {
    switch (field) {
        case FluidField::velocity:
            return stored_field(particles, ParticleKind::fluid, Field::velocity);
        case FluidField::pressure:
            return stored_field(particles, ParticleKind::fluid, Field::pressure);
        case FluidField::density:
            return stored_field(particles, ParticleKind::fluid, Field::density);
        case FluidField::shear_stress:
            break;
    }
    FrameField out{"shear_stress", "Pa", 1, {}};
    for (const double stress : shear_stress(particles, fluid.list(), fluid.sweeps()))
        out.values.push_back(static_cast<float>(stress));
    return out;
}

void add_springs(FrameGroup& group, const ParticleSet& set, const ParticleStore& particles, const FluidStep& fluid) {
    std::vector<Vec> displacement(set.size(), Vec::Zero());
    for (const SpringBody& body : fluid.springs().bodies())
        for (std::size_t n = 0; n < body.ids().size(); ++n) {
            const int i = body.ids()[n];
            for (int axis = 0; axis < 2; ++axis)
                displacement[i][axis] = body.positions()[n][axis] - set.position[i][axis];
        }
    FrameField moved{"displacement", "m", 3, {}};
    std::vector<std::int32_t> index_in_group(set.size(), -1);
    const auto& ids = particles.ids(ParticleKind::springs);
    for (std::size_t k = 0; k < ids.size(); ++k) {
        index_in_group[ids[k]] = static_cast<std::int32_t>(k);
        for (int axis = 0; axis < 3; ++axis) moved.values.push_back(static_cast<float>(displacement[ids[k]][axis]));
    }
    group.fields.push_back(std::move(moved));

    FrameField strain{"strain", "1", 1, {}}, force{"force", "N", 1, {}};
    for (const Bond& bond : set.bonds) {
        group.bond_ends.push_back(index_in_group[bond.a]);
        group.bond_ends.push_back(index_in_group[bond.b]);
        const Vec ends = set.position[bond.a] + displacement[bond.a] - set.position[bond.b] - displacement[bond.b];
        const double stretch = ends.norm() - bond.rest_length;
        strain.values.push_back(static_cast<float>(stretch / bond.rest_length));
        force.values.push_back(static_cast<float>(2 * bond.stiffness * stretch));
    }
    group.bond_fields = {std::move(strain), std::move(force)};
}

}  // namespace

Frame make_frame(const Scene& scene, const ParticleSet& set, const ParticleStore& particles, const FluidStep& fluid,
                 double time, long step, bool with_walls) {
    Frame frame;
    frame.time = time;
    frame.step = step;
    frame.spacing = set.spacing;
    for (const auto& part : set.parts) frame.parts.push_back(part.name);

    if (!particles.ids(ParticleKind::fluid).empty()) {
        FrameGroup group = group_of("fluid", set, particles, ParticleKind::fluid);
        for (const FluidField field : scene.output.fields) group.fields.push_back(fluid_field(field, particles, fluid));
        frame.groups.push_back(std::move(group));
    }
    if (!particles.ids(ParticleKind::springs).empty()) {
        FrameGroup group = group_of("solid", set, particles, ParticleKind::springs);
        group.fields.push_back(stored_field(particles, ParticleKind::springs, Field::velocity));
        add_springs(group, set, particles, fluid);
        frame.groups.push_back(std::move(group));
    }
    if (with_walls && !particles.ids(ParticleKind::rigid).empty())
        frame.groups.push_back(group_of("walls", set, particles, ParticleKind::rigid));
    return frame;
}

}  // namespace dmp
