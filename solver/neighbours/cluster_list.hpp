// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "solver/neighbours/space_order.hpp"
#include "solver/store/particle_store.hpp"

namespace dmp {

/// Which particles each cluster may meet: for each kind, every owned particle or copy within the support radius plus a
/// skin of the cluster's box. Particles of the cluster's own body, and walls of a wall, are left out. Pairs beyond the
/// support are in the list too: kernels vanish there. In no particular order: sums over neighbours do not depend on it
/// (OrderFreeSum).
class ClusterList {
  public:
    /// `reach` = support radius + skin [m]; clusters by kind, as sort_in_space made them.
    void build(const ParticleStore& particles, std::array<std::vector<Cluster>, 3> clusters, double reach, int threads);

    [[nodiscard]] std::span<const Cluster> clusters(ParticleKind kind) const {
        return clusters_[static_cast<std::size_t>(kind)];
    }
    /// Indices into the group of `kind`, of the neighbours of cluster number `cluster` of `own_kind`.
    [[nodiscard]] std::span<const std::int32_t> neighbours(ParticleKind own_kind, std::size_t cluster,
                                                           ParticleKind kind) const {
        const auto& own = lists_[static_cast<std::size_t>(own_kind)];
        const std::size_t k = 3 * cluster + static_cast<std::size_t>(kind);
        return {own.neighbours.data() + own.first[k], own.neighbours.data() + own.first[k + 1]};
    }
    [[nodiscard]] bool empty() const { return !built_; }
    /// Entries in all.
    [[nodiscard]] std::size_t size() const;
    [[nodiscard]] std::size_t bytes() const;

  private:
    struct List {
        std::vector<std::int32_t> neighbours;
        std::vector<std::size_t> first;  ///< by cluster and kind; one more at the end
    };
    /// Of the last entries, keeps those within `reach` of a member.
    template <int D>
    static void drop_far(const ParticleGroup& group, const Cluster& cluster, const ParticleGroup& others, double reach,
                         List& list);
    template <int D>
    void find(const ParticleStore& particles, double reach, int threads);

    bool built_ = false;
    std::array<std::vector<Cluster>, 3> clusters_;
    std::array<List, 3> lists_;  ///< by the clusters' kind
};

}  // namespace dmp
