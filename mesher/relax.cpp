// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "mesher/relax.hpp"

#include <algorithm>
#include <cmath>

#include "mesher/searchable_particles.hpp"
#include "mesher/uses.hpp"
#include "models/sph/kernels.hpp"

namespace dmp::mesher {

namespace {

/// Fluid particles within this distance of a body move [support radii].
constexpr double moving_zone = 2.0;
constexpr int iterations = 80;
/// Displacement per unit of R^2 SUM V grad W; half of what makes the descent oscillate on a lattice.
constexpr double descent = 0.1;

std::vector<std::size_t> fluid_near_bodies(const ParticleSet& set, double distance) {
    const SearchableParticles search(set, distance);
    std::vector<std::size_t> near;
    for (std::size_t i = 0; i < set.size(); ++i) {
        if (set.kind(i) != PartKind::fluid) continue;
        bool found = false;
        search.for_each_neighbour(
            i, [&](std::size_t j, const Vec&) { found = found || set.kind(j) == PartKind::elastic; });
        if (found) near.push_back(i);
    }
    return near;
}

template <int D>
void relax(ParticleSet& set, double support, const std::function<bool(std::size_t, const Vec&)>& may_stand) {
    const WendlandC2<D> kernel(support);
    const double inverse_at_spacing = 1 / kernel.value(set.spacing);
    const bool keeps_away = D == 3 || !set.cells.empty();
    const bool all_are_cells = set.cells.size() == set.count(PartKind::elastic);
    const double nearest_allowed = D == 3 && !all_are_cells ? keep_from_nodes : keep_from_cells;
    const std::vector<std::size_t> moving = fluid_near_bodies(set, moving_zone * support);
    std::vector<Vec> step(moving.size());
    for (int iteration = 0; iteration < iterations; ++iteration) {
        const SearchableParticles search(set, support);
        for (std::size_t k = 0; k < moving.size(); ++k) {
            Vec sum = Vec::Zero(), from_node = Vec::Zero();
            double nearest_node = support;
            search.for_each_neighbour(moving[k], [&](std::size_t j, const Vec& separation) {
                const double r = separation.norm();
                if (keeps_away && r < nearest_node && set.kind(j) == PartKind::elastic) {
                    nearest_node = r;
                    from_node = separation / r;
                }
                const double crowding = 1 + 0.2 * square(square(kernel.value(r) * inverse_at_spacing));
                sum += crowding * set.volume[j] * kernel.slope(r) * separation;
            });
            step[k] = -descent * support * support * sum;
            const double room = nearest_node - nearest_allowed * set.spacing;
            if (keeps_away && step[k].dot(from_node) < -room) step[k] -= (step[k].dot(from_node) + room) * from_node;
            const double length = step[k].norm(), longest = 0.1 * set.spacing;
            if (length > longest) step[k] *= longest / length;
        }
        for (std::size_t k = 0; k < moving.size(); ++k) {
            Vec moved = set.position[moving[k]] + step[k];
            for (int axis = 0; axis < set.dimension; ++axis)
                if (set.periodic[axis]) moved[axis] = wrapped(moved[axis], set.box.low[axis], set.box.high[axis]);
            if (may_stand(moving[k], moved)) set.position[moving[k]] = moved;
        }
    }
}

}  // namespace

void relax_around_bodies(ParticleSet& set, double support,
                         const std::function<bool(std::size_t, const Vec&)>& may_stand) {
    if (set.count(PartKind::elastic) == 0) return;
    set.dimension == 3 ? relax<3>(set, support, may_stand) : relax<2>(set, support, may_stand);
}

void mark_seated(ParticleSet& set, double contact_range) {
    if (set.count(PartKind::elastic) == 0 || contact_range <= 0) return;
    const SearchableParticles search(set, contact_range);
    for (std::size_t i = 0; i < set.size(); ++i) {
        if (set.kind(i) != PartKind::elastic) continue;
        search.for_each_neighbour(i, [&](std::size_t j, const Vec&) {
            if (set.kind(j) == PartKind::rigid) set.seated[i] = 1;
        });
    }
}

}  // namespace dmp::mesher
