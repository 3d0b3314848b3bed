// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/output/make_frame.hpp"

#include "solver/output/fluid_fields.hpp"
#include "solver/output/frame_groups.hpp"
#include "solver/output/frame_pieces.hpp"
#include "solver/uses.hpp"

namespace dmp::solver {

namespace {

FrameField frame_field(const FluidValues& values) {
    return {values.name, values.unit, values.components, {values.values.begin(), values.values.end()}};
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

    SolidGroup solid = solid_group(particles, fluid, scene.output.solid_fields, &mean_displacement);
    if (!solid.group.id.empty()) frame.groups.push_back(std::move(solid.group));

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
