// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/neighbours/cluster_list.hpp"

#include <algorithm>
#include <cmath>

#include "solver/neighbours/search_grid.hpp"
#include "solver/sweeps/lanes.hpp"

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

/// Kinds that clusters of `own` may have to do with: walls do not act on walls.
bool may_meet(ParticleKind own, ParticleKind other, Pairs pairs) {
    if (pairs == Pairs::within_solids) return own == other && own != ParticleKind::fluid;
    return own != ParticleKind::rigid || other != ParticleKind::rigid;
}

}  // namespace

template <int D>
void ClusterList::drop_far(const ParticleGroup& group, const Cluster& cluster, const ParticleGroup& others,
                           double reach, List& list) {
    constexpr std::size_t halves = cluster_size / Lanes::width;
    std::array<std::array<Lanes, D>, halves> member;
    std::array<const double*, D> x{};
    for (int axis = 0; axis < D; ++axis) {
        const double* own = group.data(Field::position, axis) + cluster.first;
        // Unused lanes repeat the first particle.
        for (std::size_t k = 0; k < cluster_size; ++k)
            member[k / Lanes::width][axis].set(k % Lanes::width,
                                               own[k < static_cast<std::size_t>(cluster.count) ? k : 0]);
        x[axis] = others.data(Field::position, axis);
    }
    std::size_t kept = list.first.back();
    for (std::size_t n = kept; n < list.listed.size(); ++n) {
        const std::int32_t j = list.listed[n];
        Lanes nearest(HUGE_VAL);
        for (const auto& half : member) {
            Lanes square = 0.0;
            for (int axis = 0; axis < D; ++axis) {
                const Lanes d = half[axis] - x[axis][j];
                square += d * d;
            }
            nearest = min(nearest, square);
        }
        list.listed[kept] = j;
        kept += least(nearest) < reach * reach ? 1 : 0;
    }
    list.listed.resize(kept);
}

template <int D>
void ClusterList::find(const ParticleStore& particles, double reach, int threads, Pairs pairs) {
    std::vector<SearchGrid> grids;
    grids.reserve(all_kinds.size());
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
            if (threads == 1) part.listed.swap(list.listed);  // memory that is there already
            part.listed.clear();
            for (std::size_t c = run(t); c < run(t + 1); ++c) {
                const Bounds bounds(group, clusters[c]);
                for (const ParticleKind other : all_kinds) {
                    part.first.push_back(part.listed.size());
                    if (!may_meet(own, other, pairs)) continue;
                    grids[static_cast<std::size_t>(other)].append_near<D>(bounds.low, bounds.high, reach, part.listed);
                    drop_far<D>(group, clusters[c], particles.of(other), reach, part);
                    if (own != ParticleKind::springs || other != own) continue;
                    const std::int32_t body = group.tags()[clusters[c].first].body;
                    const bool within = pairs == Pairs::within_solids;
                    const auto not_of_list = [&](std::int32_t j) { return (group.tags()[j].body == body) != within; };
                    const auto begin = part.listed.begin() + static_cast<std::ptrdiff_t>(part.first.back());
                    part.listed.erase(std::remove_if(begin, part.listed.end(), not_of_list), part.listed.end());
                }
            }
        }
        list.first.clear();
        if (threads == 1) {
            list = std::move(parts[0]);
        } else {
            list.listed.clear();
            for (const List& part : parts) {
                for (const std::size_t first : part.first) list.first.push_back(first + list.listed.size());
                list.listed.insert(list.listed.end(), part.listed.begin(), part.listed.end());
            }
        }
        list.first.push_back(list.listed.size());
        list.near.resize(list.first.size() - 1);
        for (std::size_t k = 0; k < list.near.size(); ++k) {
            const std::size_t entries = list.first[k + 1] - list.first[k];
            list.near[k] = static_cast<std::int32_t>(entries);
            longest_ = std::max(longest_, entries);
        }
    }
    far_.resize(static_cast<std::size_t>(threads) * (longest_ + 1));
}

void ClusterList::find_border(const ParticleStore& particles) {
    for (const ParticleKind own : all_kinds) {
        const auto& clusters = clusters_[static_cast<std::size_t>(own)];
        List& list = lists_[static_cast<std::size_t>(own)];
        list.at_border.assign(clusters.size(), false);
        for (std::size_t c = 0; c < clusters.size(); ++c)
            for (const ParticleKind other : all_kinds) {
                const auto owned = static_cast<std::int32_t>(particles.of(other).owned());
                if (std::ranges::any_of(neighbours(own, c, other), [=](std::int32_t j) { return j >= owned; }))
                    list.at_border[c] = true;
            }
    }
}

void ClusterList::build(const ParticleStore& particles, std::array<std::vector<Cluster>, 3> clusters, double reach,
                        int threads, Pairs pairs) {
    clusters_ = std::move(clusters);
    longest_ = 0;
    if (particles.dimension() == 3) {
        find<3>(particles, reach, threads, pairs);
    } else {
        find<2>(particles, reach, threads, pairs);
    }
    find_border(particles);
    built_ = true;
}

std::size_t ClusterList::size() const {
    std::size_t entries = 0;
    for (const List& list : lists_) entries += list.listed.size();
    return entries;
}

std::size_t ClusterList::bytes() const {
    std::size_t bytes = 0;
    for (const List& list : lists_)
        bytes += (list.listed.capacity() + list.near.capacity()) * sizeof(std::int32_t) +
                 list.first.capacity() * sizeof(std::size_t);
    return bytes;
}

}  // namespace dmp
