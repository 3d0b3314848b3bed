// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

#include "solver/neighbours/cluster_list.hpp"

namespace dmp::solver {

/// Particles that are processed together (a cluster, or the part of one that fits into the lanes) and their
/// neighbours.
struct Neighbourhood {
    const ClusterList& list;
    PartKind kind;       ///< of the cluster
    std::size_t number;  ///< of the cluster
    Cluster cluster;     ///< the part of it that is in the lanes
    Members members;     ///< which this part is among

    /// Indices into the group of `other`.
    [[nodiscard]] std::span<const std::int32_t> of(PartKind other) const {
        return list.neighbours(kind, number, other, members);
    }
};

/// Calls visit(Neighbourhood) for every chosen cluster of a kind, for `width` of its particles at a time. Each
/// particle is written by one thread only.
template <std::size_t Width, class Visit>
void for_each_cluster(const ClusterList& list, PartKind kind, ClusterChoice choice, int threads, const Visit& visit) {
    constexpr auto width = static_cast<std::int32_t>(Width);
    const auto clusters = list.clusters(kind);
    const auto count = static_cast<std::ptrdiff_t>(clusters.size());
#pragma omp parallel for num_threads(threads) schedule(static)
    for (std::ptrdiff_t c = 0; c < count; ++c) {
        if (!list.chosen(kind, static_cast<std::size_t>(c), choice)) continue;
        for (std::int32_t done = 0; done < clusters[c].count; done += width) {
            const Cluster part{clusters[c].first + done, std::min(width, clusters[c].count - done)};
            const Members members = width == cluster_size     ? Members::all
                                    : done < cluster_size / 2 ? Members::first_half
                                                              : Members::second_half;
            visit(Neighbourhood{list, kind, static_cast<std::size_t>(c), part, members});
        }
    }
}

}  // namespace dmp::solver
