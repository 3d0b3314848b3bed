// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/forcing/body_force.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "particles/periodic_images.hpp"
#include "solver/store/sums_over.hpp"

namespace dmp::solver {

namespace {

/// Mass over volume of all liquid, as it starts [kg/m^3]; infinite without any.
double mean_density(const ParticleSet& set) {
    ExactSum mass, volume;
    for (std::size_t i = 0; i < set.size(); ++i)
        if (set.kind(i) == PartKind::fluid) {
            mass.add(set.mass[i]);
            volume.add(set.volume[i]);
        }
    return volume.value() > 0 ? mass.value() / volume.value() : std::numeric_limits<double>::infinity();
}

double least_density(const Scene& scene) {
    double least = std::numeric_limits<double>::infinity();
    for (const Part* part : scene.parts_of(PartKind::fluid)) least = std::min(least, part->density.value);
    return least;
}

double largest_volume(const ParticleSet& set) { return set.volume.empty() ? 0 : *std::ranges::max_element(set.volume); }

}  // namespace

BodyForce::BodyForce(const Scene& scene, const ParticleSet& set, const ParticleStore& particles)
    : acceleration_(scene.flow.acceleration),
      pressure_gradient_(scene.flow.pressure_gradient),
      depends_on_position_(std::ranges::any_of(acceleration_, &Expression::depends_on_position)),
      has_gradient_(!std::ranges::all_of(pressure_gradient_, &Expression::is_zero)),
      mean_density_(mean_density(set)),
      least_density_(least_density(scene)),
      rounded_(at_least_something(largest_volume(set))),
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

std::array<double, 3> BodyForce::force_density(double t) const {
    std::array<double, 3> force{};
    for (int axis = 0; axis < 3; ++axis)
        if (!pressure_gradient_[axis].is_zero()) force[axis] = -pressure_gradient_[axis](t);
    return force;
}

std::array<double, 3> BodyForce::in_walls(double t) const {
    std::array<double, 3> g = uniform(t);
    if (!has_gradient_) return g;
    const auto force = force_density(t);
    for (int axis = 0; axis < 3; ++axis) g[axis] += force[axis] / mean_density_;
    return g;
}

double BodyForce::largest(double t) const {
    const auto g = uniform(t), force = force_density(t);
    double largest = 0;
    for (int axis = 0; axis < 3; ++axis)
        largest = std::hypot(largest, std::abs(g[axis]) + std::abs(force[axis]) / least_density_);
    return largest;
}

double BodyForce::in_box(double x, int axis) const {
    return space_.periodic[axis] ? wrapped(x, space_.box.low[axis], space_.box.high[axis])
                                 : space_.mirrored_back(x, axis);
}

double BodyForce::at_particle(const ParticleGroup& group, std::size_t i, int axis, double t) const {
    std::array<double, 3> p{};
    for (int a = 0; a < group.dimension(); ++a) p[a] = in_box(group.data(Field::position, a)[i], a);
    const bool beyond = space_.is_mirrored(axis) && p[axis] != group.data(Field::position, axis)[i];
    return (beyond ? -1 : 1) * acceleration_[axis](t, p[0], p[1], p[2]);
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
            const double g = at_particle(fluid, i, axis, t);
            v[i] += dt * g;
            force.add(mass[i] * g);
        }
        ranks.sum(force);
        total[axis] = force.value();
    }
    return total;
}

BodyForce::Momentum BodyForce::add_weights(ParticleStore& particles, const SpringBodies& springs, const Ranks& ranks,
                                           double t) const {
    ParticleGroup& solids = particles.of(PartKind::elastic);
    const auto g = uniform(t);
    Momentum total{};
    for (int axis = 0; axis < particles.dimension(); ++axis) {
        if (acceleration_[axis].is_zero()) continue;
        const bool by_position = acceleration_[axis].depends_on_position();
        double* force = solids.data(Field::force, axis);
        ExactSum added;
        for (std::size_t i = 0; i < solids.owned(); ++i) {
            const double weight = springs.node_mass(i) * (by_position ? at_particle(solids, i, axis, t) : g[axis]);
            force[i] += weight;
            if (by_position) added.add(weight);
        }
        if (!by_position) continue;
        ranks.sum(added);
        total[axis] = added.value();
    }
    return total;
}

ExactSum BodyForce::add_pressure_forces(ParticleStore& particles, const std::array<double, 3>& pressure,
                                        int threads) const {
    ExactSum volumes;
    for (const PartKind kind : {PartKind::fluid, PartKind::elastic}) {
        ParticleGroup& group = particles.of(kind);
        const double* volume = group.data(Field::volume);
        const double* dry = group.has(Field::whole_pressure) ? group.data(Field::whole_pressure) : nullptr;
        std::array<double*, 3> force{};
        for (int axis = 0; axis < particles.dimension(); ++axis) force[axis] = group.data(Field::force, axis);
        volumes.add(sums_of_multiples<1>(group, threads, [&](std::ptrdiff_t i, auto& sum) {
            if (dry != nullptr && dry[i] != 0) return;
            const double rounded = rounded_(volume[i]);
            for (int axis = 0; axis < particles.dimension(); ++axis)
                if (pressure[axis] != 0) force[axis][i] += rounded * pressure[axis];
            sum[0] += rounded;
        })[0]);
    }
    return volumes;
}

}  // namespace dmp::solver
