// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <chrono>
#include <optional>

#include "solver/domain/domain.hpp"
#include "solver/domain/halo.hpp"
#include "solver/neighbours/cluster_list.hpp"
#include "solver/neighbours/displacement_tracker.hpp"

namespace dmp::solver {

/// Keeps at hand what is near each particle: particles spatially sorted on the rank that owns their place, copies of
/// those beyond its border, and the list of neighbours.
class Neighbours {
  public:
    /// `support` radius [m].
    Neighbours(const Ranks& ranks, const ParticleSpace& space, double support, int threads);

    /// Particles have moved by at most this much more [m] in half a step; the same on all ranks.
    void moved(double distance) {
        since_list_.add(distance);
        since_pruning_.add(distance);
        ++half_steps_;
    }
    /// Whether the list may miss pairs. All ranks take part.
    [[nodiscard]] bool outdated(const ParticleStore& particles) {
        return list_.empty() || since_list_.beyond(skin_ / 2, [&] { return farthest_gone(particles, listed_at_); });
    }
    /// Brings the near ones among those that are listed up to date when they may miss pairs, through
    /// `prune(list, reach)`. Copies must have their present positions. Returns whether it did.
    template <class KeepNear>
    bool prune_list(const ParticleStore& particles, const KeepNear& prune) {
        if (!pruned_list_outdated(particles)) return false;
        near_skin_ = best_near_skin();
        prune(list_, support_ + near_skin_);
        note_positions(particles, pruned_at_);
        since_pruning_.start();
        return true;
    }
    /// Whether prune_list would look. All ranks take part.
    [[nodiscard]] bool pruned_list_outdated(const ParticleStore& particles) {
        return near_skin_ == 0 ||
               since_pruning_.beyond(near_skin_ / 2, [&] { return farthest_gone(particles, pruned_at_); });
    }
    /// Particles are no longer those that were listed.
    void forget() { list_ = {}; }
    /// From the next list on, pairs within solids are listed as well.
    void list_within_solids() { within_solids_.emplace(); }
    /// Those pairs; null where nobody asked for them.
    [[nodiscard]] const ClusterList* within_solids() const { return within_solids_ ? &*within_solids_ : nullptr; }
    /// Sorts, sends particles to their ranks, copies and lists anew. Indices of particles change.
    void renew(ParticleStore& particles);
    /// Gives copies the present values of these fields, where their group has them.
    void exchange(ParticleStore& particles, const FieldList& fields) {
        start_exchange(particles, fields);
        finish_exchange(particles);
    }
    /// The same in two steps, between which particles that are near no copies may be worked on.
    void start_exchange(ParticleStore& particles, const FieldList& fields);
    void finish_exchange(ParticleStore& particles);

    [[nodiscard]] const ClusterList& list() const { return list_; }
    /// The busiest rank's load over the mean, as of the last list; 1 is perfect.
    [[nodiscard]] double imbalance() const { return imbalance_; }
    /// Copies for each owned particle over all ranks and kinds. All ranks take part.
    [[nodiscard]] double ghosts_per_owned(const ParticleStore& particles) const;
    /// What this rank has sent.
    [[nodiscard]] HaloTraffic traffic() const;
    [[nodiscard]] const Ranks& ranks() const { return *ranks_; }
    /// Distance by which two particles may approach each other before the list is out of date [m].
    [[nodiscard]] double skin() const { return skin_; }
    /// Times the list was made.
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
    double near_skin_ = 0;  ///< with which the list was looked through [m]; 0: it was not
    long half_steps_ = 0;   ///< since the list was made
    long renewals_ = 0;

    using Clock = std::chrono::steady_clock;
    KindWeights weights_;
    Clock::time_point last_renewal_ = Clock::now();
    double imbalance_ = 1;
    double time_lost_ = 0;       ///< that ranks waited for the busiest one since space was divided [s]
    double time_to_divide_ = 0;  ///< what dividing it took [s]
};

}  // namespace dmp::solver
