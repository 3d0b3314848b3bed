// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "solver/neighbours/cluster_list.hpp"
#include "solver/parallel/domain.hpp"
#include "solver/parallel/halo.hpp"

namespace dmp {

/// Keeps at hand what is near each particle: particles sorted in space on the rank that owns their place, copies of
/// those beyond its border, and the list of neighbours.
class Neighbours {
  public:
    /// `support` radius [m].
    Neighbours(const Ranks& ranks, const ParticleSpace& space, double support, int threads);

    /// Particles have moved by at most this much more [m]; the same on all ranks.
    void moved(double distance) { moved_ += distance; }
    /// Whether the list may miss pairs.
    [[nodiscard]] bool outdated() const { return list_.empty() || moved_ >= skin_ / 2; }
    /// Particles are no longer those that were listed.
    void forget() { list_ = {}; }
    /// Sorts, sends particles to their ranks, copies and lists anew. Indices of particles change.
    void renew(ParticleStore& particles);
    /// Gives copies the present values of these fields, where their group has them.
    void exchange(ParticleStore& particles, const FieldList& fields);

    [[nodiscard]] const ClusterList& list() const { return list_; }
    [[nodiscard]] const Ranks& ranks() const { return *ranks_; }
    /// Times the list was made.
    [[nodiscard]] long renewals() const { return renewals_; }

  private:
    const Ranks* ranks_;
    double spacing_, skin_, reach_;
    int threads_;
    Domain domain_;
    std::array<Halo, 3> halos_;
    ClusterList list_;
    double moved_ = 0;
    long renewals_ = 0;
};

}  // namespace dmp
