// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/uninitialized.hpp"
#include "solver/neighbours/space_order.hpp"
#include "solver/store/particle_store.hpp"

namespace dmp::solver {

class SearchGrid;

/// Clusters by what is listed for them: only particles that this rank owns, or copies too.
enum class ClusterChoice { all, inner, border };

/// Which pairs a list is of: those that meet, or those within solids, which the others leave out.
enum class Pairs { meeting, within_solids };

/// Which particles each cluster may meet (or, of pairs within solids, those of its own body, and of rigid clusters all
/// rigid ones): for each kind, every owned particle or copy within the support radius plus a
/// skin of one of its members. Particles of the cluster's own body, and walls of a wall, are left out. Pairs beyond the
/// support are in the list too: kernels vanish there. In no particular order: sums over neighbours do not depend on it
/// (ReproducibleSum).
/// Of what is listed, the neighbours are those found near when they were last looked through: a list with a wide skin
/// lasts long, and looking through it costs a tenth of making one. (After the pair lists of GROMACS, Páll & Hess 2013.)
class ClusterList {
  public:
    ClusterList() = default;
    ClusterList(const ClusterList&) = delete;  // entries are pointed to
    ClusterList& operator=(const ClusterList&) = delete;
    ClusterList(ClusterList&&) = default;
    ClusterList& operator=(ClusterList&&) = default;
    ~ClusterList() = default;

    /// `reach` = support radius + skin [m]; clusters by kind, as sort_in_space made them.
    void build(const ParticleStore& particles, std::array<std::vector<Cluster>, 3> clusters, double reach, int threads,
               Pairs pairs = Pairs::meeting);

    [[nodiscard]] std::span<const Cluster> clusters(PartKind kind) const {
        return clusters_[static_cast<std::size_t>(kind)];
    }
    /// Indices into the group of `kind`, of the neighbours of cluster number `cluster` of `own_kind`: all that is
    /// listed, after `prune` the near ones.
    [[nodiscard]] std::span<const std::int32_t> neighbours(PartKind own_kind, std::size_t cluster,
                                                           PartKind kind) const {
        const auto& own = lists_[static_cast<std::size_t>(own_kind)];
        const std::size_t k = 3 * cluster + static_cast<std::size_t>(kind);
        return {own.first[k], static_cast<std::size_t>(own.near[k])};
    }
    /// Looks through what is listed for cluster `cluster` and makes those that is_near(index) holds for its neighbours.
    /// To be called by one thread for a cluster; `thread` is its number.
    template <class IsNear>
    void prune(PartKind own_kind, std::size_t cluster, PartKind kind, const IsNear& is_near, int thread);

    /// Whether a cluster is among the chosen ones.
    [[nodiscard]] bool chosen(PartKind kind, std::size_t cluster, ClusterChoice choice) const {
        if (choice == ClusterChoice::all) return true;
        return lists_[static_cast<std::size_t>(kind)].at_border[cluster] == (choice == ClusterChoice::border ? 1 : 0);
    }

    [[nodiscard]] bool empty() const { return !built_; }
    /// Listed entries in all, near or not.
    [[nodiscard]] std::size_t size() const;

  private:
    /// What is listed for a run of clusters; one thread lists it.
    using Entries = Uninitialized<std::int32_t>;
    struct List {
        std::vector<Entries> of_run;
        std::vector<std::int32_t*> first;     ///< in them, by cluster and kind
        std::vector<std::int32_t> count;      ///< of entries, by cluster and kind
        std::vector<std::int32_t> near;       ///< how many of them are near, from the first on
        std::vector<std::uint8_t> at_border;  ///< by cluster: copies are listed
    };
    /// Of the entries from `begin` on, keeps those within `reach` of a member.
    template <int D>
    static void drop_far(const ParticleGroup& group, const Cluster& cluster, const ParticleGroup& others, double reach,
                         Entries& entries, std::size_t begin);
    template <int D>
    void find(const ParticleStore& particles, double reach, int threads, Pairs pairs);
    /// Lists what clusters [begin, end) of a kind may meet.
    template <int D>
    void find_for(const ParticleStore& particles, const std::vector<SearchGrid>& grids, PartKind own,
                  std::size_t begin, std::size_t end, double reach, Pairs pairs, Entries& entries);

    bool built_ = false;
    std::array<std::vector<Cluster>, 3> clusters_;
    std::array<List, 3> lists_;      ///< by the clusters' kind
    std::size_t longest_ = 0;        ///< entries of one cluster and kind
    std::vector<std::int32_t> far_;  ///< room for the longest, for each thread
};

template <class IsNear>
void ClusterList::prune(PartKind own_kind, std::size_t cluster, PartKind kind, const IsNear& is_near,
                        int thread) {
    List& own = lists_[static_cast<std::size_t>(own_kind)];
    const std::size_t k = 3 * cluster + static_cast<std::size_t>(kind);
    const std::int32_t count = own.count[k];
    std::int32_t* listed = own.first[k];
    std::int32_t* far = far_.data() + static_cast<std::size_t>(thread) * longest_;
    // Both written, one counted: which it is cannot be foreseen. The order stays, memory is walked through upwards.
    std::size_t near_ones = 0, far_ones = 0;
    for (std::int32_t n = 0; n < count; ++n) {
        const std::int32_t index = listed[n];
        const bool near = is_near(index);
        listed[near_ones] = index;
        far[far_ones] = index;
        near_ones += near ? 1 : 0;
        far_ones += near ? 0 : 1;
    }
    std::copy_n(far, far_ones, listed + near_ones);
    own.near[k] = static_cast<std::int32_t>(near_ones);
}

}  // namespace dmp::solver
