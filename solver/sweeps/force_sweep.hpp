// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "models/sph/pressure_force.hpp"
#include "models/sph/walls.hpp"
#include "solver/sweeps/contact_sum.hpp"
#include "solver/sweeps/point_reader.hpp"

namespace dmp::solver {

/// Sums pressure, viscous and contact forces over the neighbours of each cluster, L of its particles at a time.
/// `Viscosity` is a law of models/sph/ (NoViscosity if viscous forces are computed elsewhere).
template <class L, int D, class Kernel, class Solid, class Viscosity>
class ForceSweep {
  public:
    ForceSweep(ParticleStore& particles, const ClusterList& list, const Kernel& kernel, const Solid& solid,
               const Viscosity& viscosity, const Repulsion& repulsion, bool solids_repel,
               const ReproducibleSum& rounding, int threads)
        : particles_(particles),
          list_(list),
          kernel_(kernel),
          solid_(solid),
          viscosity_(viscosity),
          contact_(particles, repulsion, rounding),
          solids_repel_(solids_repel),
          rounding_(rounding),
          threads_(threads),
          fluid_(particles.fluid()),
          rigid_(particles.of(PartKind::rigid)),
          springs_(particles.of(PartKind::elastic)) {}

    void run(ClusterChoice choice) {
        sweep(PartKind::fluid, choice, [this](const auto& near) { return force_on_fluid(near); });
        sweep(PartKind::rigid, choice, [this](const auto& near) { return force_on_rigid(near); });
        sweep(PartKind::elastic, choice, [this](const auto& near) { return force_on_elastic(near); });
    }

  private:
    using Force = Vector<L, D>;

    template <class ForceOn>
    void sweep(PartKind kind, ClusterChoice choice, const ForceOn& force_on) {
        ParticleGroup& group = particles_.of(kind);
        for_each_cluster<L::width>(list_, kind, choice, threads_, [&](const Neighbourhood& near) {
            store<L, D>(force_on(near), group, Field::force, near.cluster);
        });
    }

    // Flattened: inlines every law into the loop, regardless of size.
    [[nodiscard, gnu::flatten]] Force force_on_fluid(const Neighbourhood& near) const {
        const auto i = fluid_(near.cluster);
        Force sum;
        rounding_.start(sum);
        for (const std::int32_t index : near.of(PartKind::fluid)) {
            const auto j = fluid_(index);
            add_pair(sum, L(1.0), i, j, i.position - j.position);
        }
        for (const std::int32_t index : near.of(PartKind::rigid)) add_force_by<true>(sum, L(1.0), i, rigid_(index));
        for (const std::int32_t index : near.of(PartKind::elastic))
            add_force_by<false>(sum, L(1.0), i, springs_(index));
        return rounding_.total(sum) + contact_(near, PartKind::rigid, Field::contact_range) +
               contact_(near, PartKind::elastic, Field::contact_range);
    }

    [[nodiscard, gnu::flatten]] Force force_on_rigid(const Neighbourhood& near) const {
        return reaction_to_fluid<true>(near, rigid_) +
               contact_of_solids(near, PartKind::elastic, Field::wall_contact_range);
    }

    [[nodiscard, gnu::flatten]] Force force_on_elastic(const Neighbourhood& near) const {
        return reaction_to_fluid<false>(near, springs_) +
               contact_of_solids(near, PartKind::rigid, Field::wall_contact_range) +
               contact_of_solids(near, PartKind::elastic, Field::contact_range);
    }

    [[nodiscard]] Force contact_of_solids(const Neighbourhood& near, PartKind kind, Field ranges) const {
        return solids_repel_ ? contact_(near, kind, ranges) : Force::zero();
    }

    /// Reaction to the force on the fluid, on the solid.
    template <bool IsRigid, class Reader>
    [[nodiscard]] Force reaction_to_fluid(const Neighbourhood& near, const Reader& read) const {
        const auto solid = read(near.cluster);
        Force sum;
        rounding_.start(sum);
        for (const std::int32_t index : near.of(PartKind::fluid))
            add_force_by<IsRigid>(sum, L(-1.0), fluid_(index), solid);
        return rounding_.total(sum) + contact_(near, PartKind::fluid, Field::contact_range);
    }

    /// Adds the force on a fluid particle by a solid particle, which the wall model replaces by a fluid particle.
    template <bool IsRigid, class F, class S>
    void add_force_by(Force& sum, const L& sign, const F& fluid, const S& solid) const {
        const auto separation = fluid.position - solid.position;
        if constexpr (IsRigid) {
            add_pair(sum, sign, fluid, solid_.rigid(fluid, solid, separation), separation);
        } else {
            add_pair(sum, sign, fluid, solid_.springs(fluid, solid, separation), separation);
        }
    }

    /// Adds `sign` times the force on i. The slope and the laws are products that have all their bits (see
    /// ReproducibleSum::add), so that the force on j is exactly the opposite one.
    template <class I, class J>
    void add_pair(Force& sum, const L& sign, const I& i, const J& j, const Vector<L, D>& separation) const {
        const L distance = sqrt(dot(separation, separation));
        const Pair pair{i, j, separation, distance, 1.0};
        ReproducibleSum::add(sum, sign * kernel_.slope(distance), PressureForce::law(pair) + viscosity_.law(pair));
    }

    ParticleStore& particles_;
    const ClusterList& list_;
    const Kernel& kernel_;
    const Solid& solid_;
    const Viscosity& viscosity_;
    ContactSum<L, D> contact_;
    bool solids_repel_;
    const ReproducibleSum& rounding_;
    int threads_;
    FluidReader<L, D, Viscosity::needs_gradient> fluid_;
    SolidReader<L, D, Solid::needs_state, Solid::needs_surface, Solid::needs_motion> rigid_;
    BodyReader<L, D, Solid::needs_state, Solid::needs_surface> springs_;
};

}  // namespace dmp::solver
