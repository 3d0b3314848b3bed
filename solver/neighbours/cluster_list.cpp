// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/neighbours/cluster_list.hpp"

#include <algorithm>

#include "solver/neighbours/search_grid.hpp"

namespace dmp {

namespace {

/// The smallest box around a cluster.
struct Bounds {
    std::array<double, 3> low{}, high{};

    Bounds(const ParticleGroup& group, const Cluster& cluster) {
        for (int axis = 0; axis < group.dimension(); ++axis) {
            const double* x = group.data(Field::position, axis) + cluster.first;
            const auto [least, most] = std::minmax_element(x, x + cluster.count);
            low[axis] = *least;
            high[axis] = *most;
        }
    }
};

/// Kinds that clusters of `kind` may have to do with: walls do not act on walls.
bool may_meet(ParticleKind own, ParticleKind other) {
    return own != ParticleKind::rigid || other != ParticleKind::rigid;
}

}  // namespace

template <int D>
void ClusterList::drop_far(const ParticleGroup& group, const Cluster& cluster, const ParticleGroup& others,
                           double reach, List& list) {
    // Unused places repeat the first particle.
    std::array<std::array<double, cluster_size>, D> member{};
    std::array<const double*, D> x{};
    for (int axis = 0; axis < D; ++axis) {
        const double* own = group.data(Field::position, axis) + cluster.first;
        for (int k = 0; k < cluster_size; ++k) member[axis][k] = own[k < cluster.count ? k : 0];
        x[axis] = others.data(Field::position, axis);
    }
    std::size_t kept = list.first.back();
    for (std::size_t n = kept; n < list.neighbours.size(); ++n) {
        const std::int32_t j = list.neighbours[n];
        std::array<double, cluster_size> square{};
        for (int axis = 0; axis < D; ++axis)
            for (int k = 0; k < cluster_size; ++k) {
                const double d = member[axis][k] - x[axis][j];
                square[k] += d * d;
            }
        list.neighbours[kept] = j;
        kept += *std::min_element(square.begin(), square.end()) < reach * reach ? 1 : 0;
    }
    list.neighbours.resize(kept);
}

template <int D>
void ClusterList::find(const ParticleStore& particles, double reach, int threads) {
    std::vector<SearchGrid> grids;
    for (const ParticleKind kind : all_kinds) grids.emplace_back(particles.of(kind), 2 * particles.space().spacing);

    for (const ParticleKind own : all_kinds) {
        const ParticleGroup& group = particles.of(own);
        const auto& clusters = clusters_[static_cast<std::size_t>(own)];
        List& list = lists_[static_cast<std::size_t>(own)];
        // As many runs of clusters as threads, each listed on its own; the lists are then joined.
        std::vector<List> parts(static_cast<std::size_t>(threads));
        const auto run = [&](int t) {
            return clusters.size() * static_cast<std::size_t>(t) / static_cast<std::size_t>(threads);
        };
#pragma omp parallel for num_threads(threads) schedule(static, 1)
        for (int t = 0; t < threads; ++t) {
            List& part = parts[t];
            if (threads == 1) part.neighbours.swap(list.neighbours);  // memory that is there already
            part.neighbours.clear();
            for (std::size_t c = run(t); c < run(t + 1); ++c) {
                const Bounds bounds(group, clusters[c]);
                for (const ParticleKind other : all_kinds) {
                    part.first.push_back(part.neighbours.size());
                    if (!may_meet(own, other)) continue;
                    grids[static_cast<std::size_t>(other)].append_near<D>(bounds.low, bounds.high, reach,
                                                                          part.neighbours);
                    drop_far<D>(group, clusters[c], particles.of(other), reach, part);
                    if (own != ParticleKind::springs || other != own) continue;
                    const std::int32_t body = group.tags()[clusters[c].first].body;
                    const auto mine = [&](std::int32_t j) { return group.tags()[j].body == body; };
                    const auto begin = part.neighbours.begin() + static_cast<std::ptrdiff_t>(part.first.back());
                    part.neighbours.erase(std::remove_if(begin, part.neighbours.end(), mine), part.neighbours.end());
                }
            }
        }
        list.first.clear();
        if (threads == 1) {
            list = std::move(parts[0]);
        } else {
            list.neighbours.clear();
            for (const List& part : parts) {
                for (const std::size_t first : part.first) list.first.push_back(first + list.neighbours.size());
                list.neighbours.insert(list.neighbours.end(), part.neighbours.begin(), part.neighbours.end());
            }
        }
        list.first.push_back(list.neighbours.size());
    }
}

void ClusterList::build(const ParticleStore& particles, std::array<std::vector<Cluster>, 3> clusters, double reach,
                        int threads) {
    clusters_ = std::move(clusters);
    if (particles.dimension() == 3) {
        find<3>(particles, reach, threads);
    } else {
        find<2>(particles, reach, threads);
    }
    built_ = true;
}

std::size_t ClusterList::size() const {
    std::size_t entries = 0;
    for (const List& list : lists_) entries += list.neighbours.size();
    return entries;
}

std::size_t ClusterList::bytes() const {
    std::size_t bytes = 0;
    for (const List& list : lists_)
        bytes += list.neighbours.capacity() * sizeof(std::int32_t) + list.first.capacity() * sizeof(std::size_t);
    return bytes;
}

}  // namespace dmp
