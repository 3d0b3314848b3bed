// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/time/wall_motion.hpp"

#include <algorithm>

namespace dmp {

WallMotion::WallMotion(const Scene& scene, const ParticleSpace& space) {
    for (const Part* part : scene.parts_of(PartKind::rigid)) {
        const auto& velocity = part->surface_velocity.value;
        if (!Scene::any(velocity)) continue;
        const bool by_place = std::any_of(velocity.begin(), velocity.end(),
                                          [](const Expression& axis) { return axis.depends_on_place(); });
        for (std::size_t p = 0; p < space.parts.size(); ++p)
            if (space.parts[p].name == *part->name)
                surfaces_.push_back({static_cast<std::uint16_t>(p), velocity, by_place});
    }
}

bool WallMotion::show_surfaces(ParticleGroup& walls, double t) const {
    bool by_place = false;
    const auto tags = walls.tags();
    for (const Surface& surface : surfaces_) {
        by_place = by_place || surface.by_place;
        for (int axis = 0; axis < walls.dimension(); ++axis) {
            double* v = walls.data(Field::velocity, axis);
            const double everywhere = surface.by_place ? 0 : surface.velocity[axis](t);
            for (std::size_t i = 0; i < walls.total(); ++i) {
                if (tags[i].part != surface.part) continue;
                v[i] = everywhere;
                if (!surface.by_place || i >= walls.owned()) continue;
                std::array<double, 3> x{};
                for (int a = 0; a < walls.dimension(); ++a) x[a] = walls.data(Field::position, a)[i];
                v[i] = surface.velocity[axis](t, x[0], x[1], x[2]);
            }
        }
    }
    return by_place;
}

void WallMotion::show_motion(ParticleGroup& walls) const {
    if (surfaces_.empty()) return;
    for (int axis = 0; axis < walls.dimension(); ++axis)
        std::fill_n(walls.data(Field::velocity, axis), walls.total(), 0.0);
}

}  // namespace dmp
