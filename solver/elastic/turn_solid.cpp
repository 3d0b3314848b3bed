// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/elastic/turn_solid.hpp"

#include <algorithm>
#include <cmath>

namespace dmp::solver {

namespace {

/// Distance of fluid particle i of a cluster to the nearest wall particle in its list, or `range` if that is smaller
/// [m].
double distance_to_walls(const ParticleStore& particles, const ClusterList& list, std::size_t cluster, std::int32_t i,
                         double range) {
    const ParticleGroup &fluid = particles.fluid(), &walls = particles.of(PartKind::rigid);
    double least = range * range;
    for (const std::int32_t j : list.neighbours(PartKind::fluid, cluster, PartKind::rigid)) {
        double square = 0;
        for (int axis = 0; axis < particles.dimension(); ++axis)
            square += std::pow(fluid.data(Field::position, axis)[i] - walls.data(Field::position, axis)[j], 2);
        least = std::min(least, square);
    }
    return std::sqrt(least);
}

}  // namespace

void solidify_particles(ParticleStore& particles, std::span<const std::int64_t> ids, double ahead,
                        const ClusterList& list) {
    ParticleGroup &fluid = particles.fluid(), &springs = particles.of(PartKind::elastic);
    const bool contact = springs.has(Field::wall_contact_range);
    std::vector<std::int32_t> turning, staying;
    std::vector<double> wall_range;
    const auto clusters = list.clusters(PartKind::fluid);
    for (std::size_t c = 0; c < clusters.size(); ++c)
        for (std::int32_t i = clusters[c].first; i < clusters[c].first + clusters[c].count; ++i) {
            if (!std::ranges::binary_search(ids, fluid.tags()[i].id)) {
                staying.push_back(i);
                continue;
            }
            turning.push_back(i);
            if (contact)
                wall_range.push_back(distance_to_walls(particles, list, c, i, fluid.data(Field::contact_range)[i]));
        }

    const std::size_t before = springs.owned();
    springs.resize(before + turning.size(), 0);
    for (std::size_t k = 0; k < turning.size(); ++k) springs.tags()[before + k] = fluid.tags()[turning[k]];
    for (const Field field : springs.declared())
        for (int axis = 0; axis < springs.axes(field); ++axis) {
            double* to = springs.data(field, axis) + before;
            const bool known = fluid.has(field) && axis < fluid.axes(field);
            for (std::size_t k = 0; k < turning.size(); ++k)
                to[k] = known ? fluid.data(field, axis)[turning[k]]
                              : (field == Field::wall_contact_range ? wall_range[k] : 0.0);
        }
    for (int axis = 0; axis < particles.dimension(); ++axis)
        for (std::size_t k = before; k < springs.owned(); ++k)
            springs.data(Field::position, axis)[k] +=
                particles.quantum().round(ahead * springs.data(Field::velocity, axis)[k]);
    fluid.reorder(staying);
}

}  // namespace dmp::solver
