// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/neighbours/cluster_list.hpp"

#include <algorithm>
#include <cmath>

#include "base/simd/lanes.hpp"
#include "solver/neighbours/search_grid.hpp"
#include "solver/parallel/each_of.hpp"

namespace dmp::solver {

namespace {

/// The bounding box of a cluster.
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

/// True if particles of these kinds can interact: walls do not act on walls.
bool may_meet(PartKind own, PartKind other, Pairs pairs) {
    if (pairs == Pairs::within_solids) return own == other && own != PartKind::fluid;
    return own != PartKind::rigid || other != PartKind::rigid;
}

}  // namespace

template <int D>
void ClusterList::drop_far(const ParticleGroup& group, const Cluster& cluster, const ParticleGroup& others,
                           double reach, Entries& entries, std::size_t begin) {
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
    std::size_t kept = begin;
    for (std::size_t n = begin; n < entries.size(); ++n) {
        const std::int32_t j = entries[n];
        Lanes nearest(HUGE_VAL);
        for (const auto& half : member) {
            Lanes square = 0.0;
            for (int axis = 0; axis < D; ++axis) {
                const Lanes d = half[axis] - x[axis][j];
                square += d * d;
            }
            nearest = min(nearest, square);
        }
        entries[kept] = j;
        kept += least(nearest) < reach * reach ? 1 : 0;
    }
    entries.resize(kept);
}

template <int D>
void ClusterList::find_for(const ParticleStore& particles, const std::vector<SearchGrid>& grids, PartKind own,
                           std::size_t begin, std::size_t end, double reach, Pairs pairs, Entries& entries) {
    const ParticleGroup& group = particles.of(own);
    const auto& clusters = clusters_[static_cast<std::size_t>(own)];
    List& list = lists_[static_cast<std::size_t>(own)];
    entries.clear();
    for (std::size_t c = begin; c < end; ++c) {
        const Bounds bounds(group, clusters[c]);
        list.at_border[c] = 0;
        for (const PartKind other : all_kinds) {
            const ParticleGroup& others = particles.of(other);
            const std::size_t first = entries.size();
            if (may_meet(own, other, pairs)) {
                grids[static_cast<std::size_t>(other)].append_near<D>(bounds.low, bounds.high, reach, entries);
                drop_far<D>(group, clusters[c], others, reach, entries, first);
            }
            const auto found = [&entries, first] { return entries.begin() + static_cast<std::ptrdiff_t>(first); };
            if (own == PartKind::elastic && other == own) {
                const std::int32_t body = group.tags()[clusters[c].first].body;
                const bool within = pairs == Pairs::within_solids;
                const auto not_of_list = [&](std::int32_t j) { return (group.tags()[j].body == body) != within; };
                entries.erase(std::remove_if(found(), entries.end(), not_of_list), entries.end());
            }
            const auto owned = static_cast<std::int32_t>(others.owned());
            if (others.total() > others.owned() &&
                std::any_of(found(), entries.end(), [=](auto j) { return j >= owned; }))
                list.at_border[c] = 1;
            list.count[3 * c + static_cast<std::size_t>(other)] = static_cast<std::int32_t>(entries.size() - first);
        }
    }
    std::int32_t* first = entries.data();
    for (std::size_t k = 3 * begin; k < 3 * end; first += list.count[k++]) list.first[k] = first;
    for (std::size_t k = 3 * begin; k < 3 * end; ++k) list.near[k] = {0, list.count[k], list.count[k]};
}

template <int D>
void ClusterList::find(const ParticleStore& particles, double reach, int threads, Pairs pairs) {
    std::vector<SearchGrid> grids;
    grids.reserve(all_kinds.size());
    for (const PartKind kind : all_kinds)
        grids.emplace_back(particles.of(kind), 2 * particles.space().spacing, threads);

    std::int32_t longest = 0;
    for (const PartKind own : all_kinds) {
        const std::size_t clusters = clusters_[static_cast<std::size_t>(own)].size();
        List& list = lists_[static_cast<std::size_t>(own)];
        list.of_run.resize(static_cast<std::size_t>(threads));
        list.first.resize(3 * clusters);
        list.count.resize(3 * clusters);
        list.near.resize(3 * clusters);
        list.at_border.resize(clusters);
        // One run of clusters per thread, each listed separately.
        const auto begin = [&](std::ptrdiff_t run) {
            return clusters * static_cast<std::size_t>(run) / static_cast<std::size_t>(threads);
        };
        each_of(threads, threads, [&](std::ptrdiff_t run) {
            // A local vector: it grows continuously, and the runs' own vectors are adjacent in memory (false
            // sharing).
            Entries entries = std::move(list.of_run[run]);
            find_for<D>(particles, grids, own, begin(run), begin(run + 1), reach, pairs, entries);
            list.of_run[run] = std::move(entries);
        });
        for (const std::int32_t count : list.count) longest = std::max(longest, count);
    }
    longest_ = static_cast<std::size_t>(longest);
    // One more for each: while a list is pruned, an entry is written behind each of them.
    pruned_.resize(3 * static_cast<std::size_t>(threads) * (longest_ + 1));
}

void ClusterList::build(const ParticleStore& particles, std::array<std::vector<Cluster>, 3> clusters, double reach,
                        int threads, Pairs pairs) {
    clusters_ = std::move(clusters);
    if (particles.dimension() == 3) {
        find<3>(particles, reach, threads, pairs);
    } else {
        find<2>(particles, reach, threads, pairs);
    }
    built_ = true;
}

std::size_t ClusterList::size() const {
    std::size_t entries = 0;
    for (const List& list : lists_)
        for (const Entries& found : list.of_run) entries += found.size();
    return entries;
}

}  // namespace dmp::solver
