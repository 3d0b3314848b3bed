// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/spheres/sphere_group.hpp"

namespace dmp::solver {

ParticleGroup sphere_group(const ParticleSet& set, const PositionQuantum& quantum, const Ranks& ranks) {
    const auto rank = static_cast<std::size_t>(ranks.rank()), size = static_cast<std::size_t>(ranks.size());
    const std::size_t begin = set.size() * rank / size, end = set.size() * (rank + 1) / size;
    ParticleGroup group(PartKind::spheres, 3);
    group.declare({Field::position, Field::velocity, Field::angular_velocity, Field::mass, Field::radius,
                   Field::contact_force, Field::contact_torque});
    group.resize(end - begin, 0);
    for (std::size_t i = begin; i < end; ++i) {
        const std::size_t k = i - begin;
        group.tags()[k] = {static_cast<std::int64_t>(i), -1, static_cast<std::uint16_t>(set.part[i])};
        group.data(Field::mass)[k] = set.mass[i];
        group.data(Field::radius)[k] = set.radius[i];
        for (int axis = 0; axis < 3; ++axis) {
            const bool fixed = set.fixed[i] != 0;
            group.data(Field::position, axis)[k] = quantum.round(set.position[i][axis]);
            // -0 becomes 0, as in the first step that adds something to it: some spheres are added nothing for long.
            group.data(Field::velocity, axis)[k] = fixed ? 0 : set.velocity[i][axis] + 0.0;
            group.data(Field::angular_velocity, axis)[k] = fixed ? 0 : set.angular_velocity[i][axis] + 0.0;
        }
    }
    return group;
}

}  // namespace dmp::solver
