// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <stdexcept>
#include <vector>

#include "base/uninitialized.hpp"
#include "solver/neighbours/space_order.hpp"
#include "solver/store/particle_store.hpp"

namespace dmp::solver {

class SearchGrid;

/// Selects clusters by their neighbours: inner clusters have only particles owned by this rank, border clusters also
/// ghosts.
enum class ClusterChoice { all, inner, border };

/// Members of a cluster: all, or the first or second four, for vector units that hold no more.
enum class Members { all, first_half, second_half };

/// Which halves of a cluster a particle is near to.
struct NearHalves {
    bool first, second;
};

/// The pairs in a list: interacting particles, or particles of the same solid, which the other lists leave out.
enum class Pairs { meeting, within_solids };

/// Neighbour list by cluster. For each cluster and each kind it contains every owned particle or ghost within the
/// support radius plus a skin of a member. Particles of the cluster's own body are left out, and walls for clusters
/// of walls; a list of pairs within solids contains only these (all rigid particles for a rigid cluster). Pairs
/// beyond the support are in the list too: kernels vanish there. The order is unspecified: sums over neighbours do
/// not depend on it (ReproducibleSum).
/// Only the entries that were near at the last pruning count as neighbours: a list with a wide skin lasts long, and
/// pruning costs a tenth of building it. (After the pair lists of GROMACS, Páll & Hess 2013.)
class ClusterList {
  public:
    ClusterList() = default;
    ClusterList(const ClusterList&) = delete;  // there are pointers to the entries
    ClusterList& operator=(const ClusterList&) = delete;
    ClusterList(ClusterList&&) = default;
    ClusterList& operator=(ClusterList&&) = default;
    ~ClusterList() = default;

    /// `reach` = support radius + skin [m]; clusters by kind, from sort_in_space.
    void build(const ParticleStore& particles, std::array<std::vector<Cluster>, 3> clusters, double reach, int threads,
               Pairs pairs = Pairs::meeting);

    [[nodiscard]] std::span<const Cluster> clusters(PartKind kind) const {
        return clusters_[static_cast<std::size_t>(kind)];
    }
    /// The neighbours of cluster number `cluster` of `own_kind`, or of one half of it, as indices into the group of
    /// `kind`: all entries of the list, after `prune` the near ones.
    [[nodiscard]] std::span<const std::int32_t> neighbours(PartKind own_kind, std::size_t cluster, PartKind kind,
                                                           Members members = Members::all) const {
        const auto& own = lists_[static_cast<std::size_t>(own_kind)];
        const std::size_t k = 3 * cluster + static_cast<std::size_t>(kind);
        const Near& near = own.near[k];
        switch (members) {
            case Members::all:
                return {own.first[k], own.first[k] + near.end};
            case Members::first_half:
                return {own.first[k], own.first[k] + near.end_of_first};
            case Members::second_half:
                return {own.first[k] + near.begin_of_second, own.first[k] + near.end};
        }
        throw std::logic_error("members that are none");
    }
    /// Prunes the list of cluster `cluster`: entries for which is_near(index), NearHalves, is true of a half become its
    /// neighbours. Each cluster must be pruned by one thread only; `thread` is its number.
    template <class IsNear>
    void prune(PartKind own_kind, std::size_t cluster, PartKind kind, const IsNear& is_near, int thread);

    /// True if the choice includes this cluster.
    [[nodiscard]] bool chosen(PartKind kind, std::size_t cluster, ClusterChoice choice) const {
        if (choice == ClusterChoice::all) return true;
        return lists_[static_cast<std::size_t>(kind)].at_border[cluster] == (choice == ClusterChoice::border ? 1 : 0);
    }

    [[nodiscard]] bool empty() const { return !built_; }
    /// Total number of entries, near or not.
    [[nodiscard]] std::size_t size() const;

  private:
    /// Entries for a run of consecutive clusters, written by one thread.
    using Entries = Uninitialized<std::int32_t>;
    /// Near entries come first: those near to the first half only, to both halves, to the second half only.
    struct Near {
        std::int32_t begin_of_second, end_of_first, end;
    };
    struct List {
        std::vector<Entries> of_run;
        std::vector<std::int32_t*> first;     ///< pointers into of_run, by cluster and kind
        std::vector<std::int32_t> count;      ///< number of entries, by cluster and kind
        std::vector<Near> near;               ///< by cluster and kind
        std::vector<std::uint8_t> at_border;  ///< by cluster: ghosts are listed
    };
    /// Removes the entries from `begin` on that are not within `reach` of a member.
    template <int D>
    static void drop_far(const ParticleGroup& group, const Cluster& cluster, const ParticleGroup& others, double reach,
                         Entries& entries, std::size_t begin);
    template <int D>
    void find(const ParticleStore& particles, double reach, int threads, Pairs pairs);
    /// Lists the neighbours of clusters [begin, end) of a kind.
    template <int D>
    void find_for(const ParticleStore& particles, const std::vector<SearchGrid>& grids, PartKind own, std::size_t begin,
                  std::size_t end, double reach, Pairs pairs, Entries& entries);

    bool built_ = false;
    std::array<std::vector<Cluster>, 3> clusters_;
    std::array<List, 3> lists_;         ///< by kind of the clusters
    std::size_t longest_ = 0;           ///< most entries of one cluster and kind
    std::vector<std::int32_t> pruned_;  ///< three buffers of the longest list's size for each thread
};

template <class IsNear>
void ClusterList::prune(PartKind own_kind, std::size_t cluster, PartKind kind, const IsNear& is_near, int thread) {
    List& own = lists_[static_cast<std::size_t>(own_kind)];
    const std::size_t k = 3 * cluster + static_cast<std::size_t>(kind);
    const std::int32_t count = own.count[k];
    std::int32_t* listed = own.first[k];
    std::int32_t* both = pruned_.data() + 3 * static_cast<std::size_t>(thread) * (longest_ + 1);
    std::int32_t *second = both + longest_ + 1, *far = second + longest_ + 1;
    // Writes all and counts one: a branch would be mispredicted. Keeps the order, so that memory is read in
    // ascending order.
    std::int32_t of_first = 0, of_both = 0, of_second = 0, of_none = 0;
    for (std::int32_t n = 0; n < count; ++n) {
        const std::int32_t index = listed[n];
        const NearHalves near = is_near(index);
        listed[of_first] = both[of_both] = second[of_second] = far[of_none] = index;
        of_first += near.first && !near.second ? 1 : 0;
        of_both += near.first && near.second ? 1 : 0;
        of_second += !near.first && near.second ? 1 : 0;
        of_none += near.first || near.second ? 0 : 1;
    }
    listed = std::copy_n(both, of_both, listed + of_first);
    listed = std::copy_n(second, of_second, listed);
    std::copy_n(far, of_none, listed);
    own.near[k] = {of_first, of_first + of_both, of_first + of_both + of_second};
}

}  // namespace dmp::solver
