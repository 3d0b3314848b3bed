// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/forcing/body_force.hpp"

#include <algorithm>

#include "particles/periodic_images.hpp"
#include "solver/parallel/exact_sum.hpp"

namespace dmp::solver {

BodyForce::BodyForce(const Scene& scene, const ParticleStore& particles)
    : acceleration_(scene.flow.acceleration),
      depends_on_position_(std::ranges::any_of(acceleration_, &Expression::depends_on_position)),
      space_(particles.space()) {}

std::array<double, 3> BodyForce::uniform(double t) const {
    std::array<double, 3> g{};
    for (int axis = 0; axis < 3; ++axis)
        g[axis] = acceleration_[axis].depends_on_position() ? 0 : acceleration_[axis](t);
    return g;
}

std::array<double, 3> BodyForce::hydrostatic(double t) const {
    std::array<double, 3> g = uniform(t);
    for (int axis = 0; axis < 3; ++axis)
        if (space_.periodic[axis]) g[axis] = 0;
    return g;
}

double BodyForce::in_box(double x, int axis) const {
    return space_.periodic[axis] ? wrapped(x, space_.box.low[axis], space_.box.high[axis])
                                 : space_.mirrored_back(x, axis);
}

BodyForce::Momentum BodyForce::kick_fluid(ParticleStore& particles, const Ranks& ranks, double t, double dt) const {
    ParticleGroup& fluid = particles.fluid();
    const double* mass = fluid.data(Field::mass);
    Momentum total{};
    for (int axis = 0; axis < particles.dimension(); ++axis) {
        if (!acceleration_[axis].depends_on_position()) continue;
        double* v = fluid.data(Field::velocity, axis);
        ExactSum force;
        for (std::size_t i = 0; i < fluid.owned(); ++i) {
            const double x = fluid.data(Field::position, axis)[i];
            std::array<double, 3> p{};
            for (int a = 0; a < particles.dimension(); ++a) p[a] = in_box(fluid.data(Field::position, a)[i], a);
            // Beyond a plane of symmetry the mirror image of the acceleration acts.
            const double sign = space_.is_mirrored(axis) && p[axis] != x ? -1 : 1;
            const double g = sign * acceleration_[axis](t, p[0], p[1], p[2]);
            v[i] += dt * g;
            force.add(mass[i] * g);
        }
        ranks.sum(force);
        total[axis] = force.value();
    }
    return total;
}

BodyForce::Momentum BodyForce::add_to_solidified(ParticleStore& particles, const Ranks& ranks, double t) const {
    ParticleGroup& solids = particles.of(PartKind::elastic);
    const double* mass = solids.data(Field::mass);
    const auto g = uniform(t);
    Momentum total{};
    for (int axis = 0; axis < particles.dimension(); ++axis) {
        if (acceleration_[axis].is_zero()) continue;
        const bool by_position = acceleration_[axis].depends_on_position();
        double* force = solids.data(Field::force, axis);
        ExactSum added;
        for (std::size_t i = 0; i < solids.owned(); ++i) {
            if (space_.parts[solids.tags()[i].part].kind != PartKind::fluid) continue;
            std::array<double, 3> p{};
            for (int a = 0; by_position && a < particles.dimension(); ++a)
                p[a] = in_box(solids.data(Field::position, a)[i], a);
            const double weight = mass[i] * (by_position ? acceleration_[axis](t, p[0], p[1], p[2]) : g[axis]);
            force[i] += weight;
            if (by_position) added.add(weight);
        }
        if (!by_position) continue;
        ranks.sum(added);
        total[axis] = added.value();
    }
    return total;
}

}  // namespace dmp::solver
