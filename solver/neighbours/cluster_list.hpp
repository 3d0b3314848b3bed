// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

#include "solver/store/particle_store.hpp"
#include "solver/sweeps/lanes.hpp"

namespace dmp {

/// Up to eight particles of one kind (of one body, for springs) that lie together in space, one a SIMD lane.
struct Cluster {
    std::array<int, Lanes::width> member{};  ///< unused lanes repeat the first member
    std::size_t count = 0;                   ///< lanes in use
    std::array<int, 4> first{};              ///< neighbours of kind k: [first[k], first[k + 1]) of the list
};

/// Which particles each cluster may meet: for each kind, every owned particle or image within the support radius plus
/// a skin of any member. Particles of the cluster's own body, and walls of a wall, are left out. Pairs beyond the
/// support are in the list too: kernels vanish there. The order of neighbours depends on positions alone, not on
/// threads.
class ClusterList {
  public:
    /// `reach` = support radius + skin [m].
    void build(const ParticleStore& particles, const ParticleSet& set, double reach, int threads);

    [[nodiscard]] std::span<const Cluster> clusters(ParticleKind kind) const {
        return clusters_[static_cast<std::size_t>(kind)];
    }
    [[nodiscard]] std::span<const int> neighbours(const Cluster& cluster, ParticleKind kind) const {
        const auto k = static_cast<std::size_t>(kind);
        return {neighbours_.data() + cluster.first[k], neighbours_.data() + cluster.first[k + 1]};
    }
    [[nodiscard]] std::size_t size() const { return neighbours_.size(); }

  private:
    std::array<std::vector<Cluster>, 3> clusters_;
    std::vector<int> neighbours_;
};

}  // namespace dmp
