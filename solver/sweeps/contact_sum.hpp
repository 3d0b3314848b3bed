// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "models/contact/repulsion.hpp"
#include "solver/sweeps/cluster_loop.hpp"
#include "solver/sweeps/point_reader.hpp"
#include "solver/sweeps/reproducible_sum.hpp"

namespace dmp::solver {

/// Sums the repulsion by the neighbours of a cluster, L of its particles at a time. It does not depend on the fluid's
/// laws, so that it is compiled only once for all of them.
template <class L, int D>
class ContactSum {
  public:
    ContactSum(const ParticleStore& particles, const Repulsion& repulsion, const ReproducibleSum& rounding)
        : particles_(particles), repulsion_(repulsion), rounding_(rounding) {}

    /// Repulsion by the particles of one kind [N]; `ranges` is the field with r* by particle. Zero if the scene has
    /// no contact.
    [[nodiscard]] Vector<L, D> operator()(const Neighbourhood& near, PartKind kind, Field ranges) const {
        if (repulsion_.strength == 0 || near.of(kind).empty()) return Vector<L, D>::zero();
        return sum(near, kind, ranges);
    }

  private:
    [[nodiscard, gnu::noinline, gnu::flatten]] Vector<L, D> sum(const Neighbourhood& near, PartKind kind,
                                                                Field ranges) const {
        const ParticleGroup& own = particles_.of(near.kind);
        const ParticleGroup& others = particles_.of(kind);
        const auto position = load_vector<L, D>(axes_of<D>(own, Field::position), near.cluster);
        const auto other_position = axes_of<D>(others, Field::position);
        const L range = load<L>(own.data(ranges), near.cluster);
        const double* other_range = others.data(ranges);
        Vector<L, D> force = Vector<L, D>::zero();
        for (const std::int32_t index : near.of(kind))
            force += rounding_(repulsion_.law(position - load_vector<L, D>(other_position, index),
                                              min(range, L(load<L>(other_range, index)))));
        return force;
    }

    const ParticleStore& particles_;
    const Repulsion& repulsion_;
    const ReproducibleSum& rounding_;
};

}  // namespace dmp::solver
