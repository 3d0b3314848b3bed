// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/output/probe.hpp"

#include <algorithm>
#include <limits>

namespace dmp::solver {

namespace {

Vec vector_of(const ParticleGroup& group, Field field, std::size_t i) {
    Vec value = Vec::Zero();
    for (int axis = 0; axis < group.dimension(); ++axis) value[axis] = group.data(field, axis)[i];
    return value;
}

/// Whether the walls' velocity is that of their surface now. With the plain scheme it is that of their particles
/// between steps (WallMotion).
bool walls_show_their_surface(const PairSettings& settings) {
    return settings.corrected || !(settings.walls.moving || settings.walls.sliding);
}

}  // namespace

Probe::Probe(const Vec& point, FluidField field, const ParticleStore& particles, const FluidStep& step,
             const PairSettings& settings, const Ranks& ranks)
    : particles_(particles), step_(step), ranks_(ranks) {
    find_fluid(point, settings.support);
    if (field == FluidField::velocity && walls_show_their_surface(settings)) find_walls(point, settings.support);
    if (field == FluidField::velocity) find_bodies(point, settings.support);
    for (const Sample& sample : fluid_) fit_.add(sample.x, sample.weight);
    for (const SurfaceSample& sample : surfaces_) fit_.add(sample.x, sample.weight);
    fit_.finish(ranks, particles.space().spacing);
}

Vec Probe::from_point(const ParticleGroup& group, std::size_t i, const Vec& point) const {
    const ParticleSpace& space = particles_.space();
    Vec apart = Vec::Zero();
    for (int axis = 0; axis < group.dimension(); ++axis)  // fluid beyond a plane of symmetry is shown mirrored
        apart[axis] = space.mirrored_back(group.data(Field::position, axis)[i], axis) - point[axis];
    return nearest_image(apart, space);
}

void Probe::find_fluid(const Vec& point, double support) {
    const ParticleGroup& fluid = particles_.fluid();
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < fluid.owned(); ++i) {
        const Vec x = from_point(fluid, i, point);
        const double distance = x.norm();
        nearest = std::min(nearest, distance);
        const double weight = fluid.data(Field::volume)[i] * step_.sweeps().kernel_value(distance);
        if (distance < support && weight > 0) fluid_.push_back({i, x, weight});
    }
    nearest_ = ranks_.smallest(nearest);
}

void Probe::find_walls(const Vec& point, double support) {
    const ParticleGroup& walls = particles_.of(PartKind::rigid);
    for (std::size_t i = 0; i < walls.owned(); ++i) {
        const double depth = walls.data(Field::wall_distance)[i];
        if (depth > particles_.space().spacing) continue;
        if (walls.has(Field::wall_slip) && walls.data(Field::wall_slip)[i] > 0) continue;
        const Vec x = from_point(walls, i, point) + depth * vector_of(walls, Field::wall_normal, i);
        add_surface(x, walls.data(Field::volume)[i], vector_of(walls, Field::velocity, i), support);
    }
}

void Probe::find_bodies(const Vec& point, double support) {
    const ParticleGroup& bodies = particles_.of(PartKind::elastic);
    if (!bodies.has(Field::opposite_distance)) return;  // plain walls
    const int dimension = bodies.dimension();
    for (std::size_t i = 0; i < bodies.owned(); ++i) {
        const double depth = bodies.data(Field::wall_distance)[i];
        const Vec normal = vector_of(bodies, Field::wall_normal, i);
        const Vec x = from_point(bodies, i, point) + depth * normal;
        if (depth > particles_.space().spacing || normal.isZero() || x.dot(normal) > 0) continue;
        Vec velocity = vector_of(bodies, Field::velocity, i);
        for (int a = 0; a < dimension; ++a)
            for (int b = 0; b < dimension; ++b)
                velocity[a] += depth * bodies.data(Field::surface_gradient, a * dimension + b)[i] * normal[b];
        add_surface(x, bodies.data(Field::volume)[i], velocity, support);
    }
}

void Probe::add_surface(const Vec& x, double volume, const Vec& velocity, double support) {
    const double weight = volume * step_.sweeps().kernel_value(x.norm());
    if (x.norm() < support && weight > 0) surfaces_.push_back({x, weight, velocity});
}

std::vector<double> Probe::of(const FluidValues& array) const {
    const auto components = static_cast<std::size_t>(array.components);
    const std::vector<std::size_t> probed = probed_components(array.components, particles_.dimension());
    if (!is_in_fluid()) return std::vector<double>(probed.size(), std::numeric_limits<double>::quiet_NaN());
    std::vector<ExactSum> sums(probed.size());
    for (std::size_t c = 0; c < probed.size(); ++c) {
        for (const auto& [i, x, weight] : fluid_)
            sums[c].add(fit_.share(x, weight) * array.values[components * i + probed[c]]);
        for (const auto& [x, weight, velocity] : surfaces_)
            sums[c].add(fit_.share(x, weight) * velocity[static_cast<int>(probed[c])]);
    }
    ranks_.sum(sums);
    std::vector<double> values;
    for (const ExactSum& sum : sums) values.push_back(sum.value());
    return values;
}

}  // namespace dmp::solver
