// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>

#include "base/wall_clock.hpp"
#include "solver/domain/domain.hpp"
#include "solver/domain/halo.hpp"
#include "solver/neighbours/cluster_list.hpp"
#include "solver/neighbours/displacement_tracker.hpp"

namespace dmp::solver {

/// Maintains the neighbourhood of each particle: spatially sorted particles on the rank that owns their position,
/// ghosts of those beyond its border, and the neighbour list.
class Neighbours {
  public:
    /// `support` radius [m].
    Neighbours(const Ranks& ranks, const ParticleSpace& space, double support, int threads);

    /// Particles have moved by at most this additional distance [m] in half a step; the same on all ranks.
    void moved(double distance) {
        since_list_.add(distance);
        since_pruning_.add(distance);
        ++half_steps_;
    }
    /// The same besides what a half step moves them by.
    void moved_besides(double distance) {
        since_list_.add(distance);
        since_pruning_.add(distance);
    }
    /// True if the list may miss pairs. All ranks must call it.
    [[nodiscard]] bool outdated(const ParticleStore& particles) {
        return list_.empty() || since_list_.beyond(skin_ / 2, [&] { return farthest_gone(particles, listed_at_); });
    }
    /// Prunes the list with `prune(list, reach)` if the pruned list may miss pairs. Ghosts must have their current
    /// positions. Returns true if it did.
    template <class KeepNear>
    bool prune_list(const ParticleStore& particles, const KeepNear& prune) {
        if (!pruned_list_outdated(particles)) return false;
        near_skin_ = best_near_skin();
        prune(list_, support_ + near_skin_);
        note_positions(particles, pruned_at_);
        since_pruning_.start();
        return true;
    }
    /// True if prune_list would prune. All ranks must call it.
    [[nodiscard]] bool pruned_list_outdated(const ParticleStore& particles) {
        return near_skin_ == 0 ||
               since_pruning_.beyond(near_skin_ / 2, [&] { return farthest_gone(particles, pruned_at_); });
    }
    /// Discards the list because the particles have changed.
    void forget() { list_ = {}; }
    /// From the next list on, pairs within solids are listed as well.
    void list_within_solids() { within_solids_.emplace(); }
    /// List of the pairs within solids; null without list_within_solids().
    [[nodiscard]] const ClusterList* within_solids() const { return within_solids_ ? &*within_solids_ : nullptr; }
    /// Sorts the particles, sends them to their ranks, and builds ghosts and list again. Indices of particles change.
    void renew(ParticleStore& particles);
    /// Copies the current values of these fields to the ghosts, where their group has them.
    void exchange(ParticleStore& particles, const FieldList& fields) {
        start_exchange(particles, fields);
        finish_exchange(particles);
    }
    /// The same in two steps; between them, particles without ghosts among their neighbours can be processed.
    void start_exchange(ParticleStore& particles, const FieldList& fields);
    void finish_exchange(ParticleStore& particles);

    [[nodiscard]] const ClusterList& list() const { return list_; }
    /// Load of the busiest rank divided by the mean, at the last list; 1 is perfect.
    [[nodiscard]] double imbalance() const { return imbalance_; }
    /// Ghosts per owned particle over all ranks and kinds. All ranks must call it.
    [[nodiscard]] double ghosts_per_owned(const ParticleStore& particles) const;
    /// Data that this rank has sent.
    [[nodiscard]] HaloTraffic traffic() const;
    [[nodiscard]] const Ranks& ranks() const { return *ranks_; }
    /// Distance by which two particles may approach each other before the list is outdated [m].
    [[nodiscard]] double skin() const { return skin_; }
    /// Number of times the list was built.
    [[nodiscard]] long renewals() const { return renewals_; }

  private:
    using PositionsByKind = std::array<ReferencePositions, 3>;
    void note_positions(const ParticleStore& particles, PositionsByKind& then) const;
    [[nodiscard]] double farthest_gone(const ParticleStore& particles, const PositionsByKind& then) const;
    [[nodiscard]] double best_skin() const;
    [[nodiscard]] double best_near_skin() const;
    [[nodiscard]] double skin_for(double cost, double least, double most, double otherwise) const;
    void balance(const GroupList& groups);
    [[nodiscard]] KindWeights measured_weights(const ParticleStore& particles) const;

    const Ranks* ranks_;
    double spacing_, support_, skin_;
    int threads_;
    Domain domain_;
    std::array<Halo, 3> halos_;
    ClusterList list_;
    std::optional<ClusterList> within_solids_;
    PositionsByKind listed_at_, pruned_at_;
    DisplacementTracker since_list_, since_pruning_;
    double near_skin_ = 0;  ///< of the last pruning [m]; 0: not pruned since the list was built
    long half_steps_ = 0;   ///< since the list was built
    long renewals_ = 0;

    KindWeights weights_;
    WallClock::time_point last_renewal_ = WallClock::now();
    double imbalance_ = 1;
    double time_lost_ = 0;       ///< time that ranks waited for the busiest one since space was last divided [s]
    double time_to_divide_ = 0;  ///< duration of the last division [s]
};

}  // namespace dmp::solver
