// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/spheres/sphere_output.hpp"

#include "particles/periodic_images.hpp"
#include "solver/output/frame_pieces.hpp"
#include "solver/output/wall_surfaces.hpp"
#include "solver/uses.hpp"

namespace dmp::solver {

Frame sphere_frame(const SphereStep& step, const ParticleSpace& space, double time, long step_count, bool with_walls,
                   bool in_pieces) {
    const Ranks& ranks = step.neighbours().ranks();
    Frame frame;
    frame.time = time;
    frame.step = step_count;
    frame.spacing = space.spacing > 0 ? space.spacing : 2 * step.setup().mean_radius;
    for (const auto& part : space.parts) frame.parts.push_back(part.name);

    FrameGroup group;
    group.name = "spheres";
    const auto of_spheres = [&](Field field) -> FrameField {
        return {std::string(info(field).name),
                std::string(info(field).unit),
                info(field).shape == FieldShape::vector ? 3 : 1,
                {}};
    };
    FrameField radius = of_spheres(Field::radius), velocity = of_spheres(Field::velocity),
               spin = of_spheres(Field::angular_velocity), force = of_spheres(Field::contact_force);
    for (std::size_t i = 0; i < step.rows().owned(); ++i) {
        const SphereMotion& sphere = step.rows().motion()[i];
        group.id.push_back(step.group().tags()[i].id);
        group.part.push_back(step.group().tags()[i].part);
        radius.values.push_back(static_cast<float>(sphere.radius()));
        for (int axis = 0; axis < 3; ++axis) {
            const double x = sphere.position.c[axis];
            group.position.push_back(static_cast<float>(space.periodic[static_cast<std::size_t>(axis)]
                                                            ? wrapped(x, space.box.low[axis], space.box.high[axis])
                                                            : x));
            velocity.values.push_back(static_cast<float>(sphere.velocity.c[axis]));
            spin.values.push_back(static_cast<float>(sphere.spin.c[axis]));
            force.values.push_back(static_cast<float>(step.rows().loads()[i].force.c[axis]));
        }
    }
    group.fields = {std::move(radius), std::move(velocity), std::move(spin), std::move(force)};
    if (in_pieces) {
        sort_by_id(group);
    } else {
        group.id = ranks.gather_to_first(group.id);
        group.part = ranks.gather_to_first(group.part);
        group.position = ranks.gather_to_first(group.position);
        for (FrameField& field : group.fields) field.values = ranks.gather_to_first(field.values);
        sort_by_id(group);
    }
    if (in_pieces || !group.id.empty()) frame.groups.push_back(std::move(group));
    const SphereWalls& walls = step.walls();
    const auto add_walls = [&](const char* name, bool moving) {
        FrameGroup surfaces = wall_surfaces(
            name, space, space.box, [&](int part) { return walls.moves(part) == moving; },
            [&](int part) { return walls.displacement(part); });
        if (surfaces.id.empty()) return;
        if (!ranks.is_first()) {
            surfaces = {};
            surfaces.name = name;
        }
        if (in_pieces || ranks.is_first()) frame.groups.push_back(std::move(surfaces));
    };
    if (with_walls) add_walls("walls", false);
    add_walls("moving_walls", true);
    return frame;
}

}  // namespace dmp::solver
