// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "models/sph/walls.hpp"
#include "solver/sweeps/cluster_loop.hpp"
#include "solver/sweeps/point_reader.hpp"
#include "solver/sweeps/reproducible_sum.hpp"

namespace dmp::solver {

/// The viscous force alone, as a linear function of the velocities in a field of one's choice: what implicit viscosity
/// solves for. Solids act as they do in the force sweep. L of a cluster's particles at a time.
template <class L, int D, class Kernel, class Solid, class Viscosity>
class ViscousSweep {
  public:
    struct Motion {
        OrderFree order_free;
        Field velocity;      ///< of fluid particles and spring bodies
        double wall_motion;  ///< times the walls' own velocity: 1, or 0 for what is proportional to `velocity`
    };

    ViscousSweep(ParticleStore& particles, const ClusterList& list, const Kernel& kernel, const Solid& solid,
                 const Viscosity& viscosity, const Motion& motion, int threads)
        : particles_(particles),
          list_(list),
          kernel_(kernel),
          solid_(solid),
          viscosity_(viscosity),
          order_free_(motion.order_free),
          wall_motion_(motion.wall_motion),
          threads_(threads),
          fluid_(particles.fluid()),
          rigid_(particles.of(ParticleKind::rigid)),
          springs_(particles.of(ParticleKind::springs)),
          fluid_velocity_(axes_of<D>(particles.fluid(), motion.velocity)),
          springs_velocity_(axes_of<D>(particles.of(ParticleKind::springs), motion.velocity)) {}

    /// viscous_force on fluid and spring bodies; where walls move, theirs too.
    void forces(ClusterChoice choice) {
        sweep(ParticleKind::fluid, Field::viscous_force, choice,
              [this](const auto& near) { return force_on_fluid(near); });
        sweep(ParticleKind::springs, Field::viscous_force, choice,
              [this](const auto& near) { return reaction_to_fluid<false>(near, spring_at()); });
        if (wall_motion_ != 0)
            sweep(ParticleKind::rigid, Field::viscous_force, choice,
                  [this](const auto& near) { return reaction_to_fluid<true>(near, wall_at()); });
    }

    /// viscous_diagonal of fluid and spring bodies: by axis, how much force a particle's own velocity costs it [kg/s].
    void diagonal(ClusterChoice choice) {
        sweep(ParticleKind::fluid, Field::viscous_diagonal, choice,
              [this](const auto& near) { return diagonal_of_fluid(near); });
        sweep(ParticleKind::springs, Field::viscous_diagonal, choice,
              [this](const auto& near) { return diagonal_of_springs(near); });
    }

  private:
    using Force = Vector<L, D>;

    template <class SumOver>
    void sweep(ParticleKind kind, Field result, ClusterChoice choice, const SumOver& sum_over) {
        ParticleGroup& group = particles_.of(kind);
        for_each_cluster<L::width>(list_, kind, choice, threads_, [&](const Neighbourhood& near) {
            store<L, D>(sum_over(near), group, result, near.cluster);
        });
    }

    template <class Index>
    [[nodiscard]] auto fluid_at(const Index& at) const {
        auto point = fluid_(at);
        point.velocity = load_vector<L, D>(fluid_velocity_, at);
        return point;
    }
    [[nodiscard]] auto spring_at() const {
        return [this](const auto& at) {
            auto point = springs_(at);
            point.velocity = load_vector<L, D>(springs_velocity_, at);
            return point;
        };
    }
    [[nodiscard]] auto wall_at() const {
        return [this](const auto& at) {
            auto point = rigid_(at);
            point.velocity = wall_motion_ * point.velocity;
            return point;
        };
    }

    // Flattened: every law becomes part of its loop, whatever the compiler thinks of their size.
    [[nodiscard, gnu::flatten]] Force force_on_fluid(const Neighbourhood& near) const {
        const auto i = fluid_at(near.cluster);
        Force force = Force::zero();
        for (const std::int32_t index : near.of(ParticleKind::fluid)) {
            const auto j = fluid_at(index);
            force += order_free_(pair(i, j, i.position - j.position));
        }
        for (const std::int32_t index : near.of(ParticleKind::rigid)) force += force_by<true>(i, wall_at()(index));
        for (const std::int32_t index : near.of(ParticleKind::springs)) force += force_by<false>(i, spring_at()(index));
        return force;
    }

    template <bool IsRigid, class ReadAt>
    [[nodiscard, gnu::flatten]] Force reaction_to_fluid(const Neighbourhood& near, const ReadAt& read_at) const {
        const auto solid = read_at(near.cluster);
        Force force = Force::zero();
        for (const std::int32_t index : near.of(ParticleKind::fluid))
            force -= force_by<IsRigid>(fluid_at(index), solid);
        return force;
    }

    [[nodiscard, gnu::flatten]] Force diagonal_of_fluid(const Neighbourhood& near) const {
        const auto i = fluid_(near.cluster);
        Force sum = Force::zero();
        for (int axis = 0; axis < D; ++axis) {
            const auto moving = moving_along(axis, i);
            for (const std::int32_t index : near.of(ParticleKind::fluid)) {
                const auto j = at_rest(fluid_(index));
                const Force separation = moving.position - j.position;
                // A cluster's members are among their own neighbours.
                const L term =
                    where_less(L(0.0), dot(separation, separation), pair(moving, j, separation)[axis], L(0.0));
                sum[axis] -= order_free_(term);
            }
            for (const std::int32_t index : near.of(ParticleKind::rigid))
                sum[axis] -= force_by<true>(moving, at_rest(rigid_(index)))[axis];
            for (const std::int32_t index : near.of(ParticleKind::springs))
                sum[axis] -= force_by<false>(moving, at_rest(springs_(index)))[axis];
        }
        return sum;
    }

    [[nodiscard, gnu::flatten]] Force diagonal_of_springs(const Neighbourhood& near) const {
        const auto node = springs_(near.cluster);
        Force sum = Force::zero();
        for (int axis = 0; axis < D; ++axis)
            for (const std::int32_t index : near.of(ParticleKind::fluid))
                sum[axis] += force_by<false>(at_rest(fluid_(index)), moving_along(axis, node))[axis];
        return sum;
    }

    template <class P>
    static P at_rest(P point) {
        for (int axis = 0; axis < D; ++axis) point.velocity[axis] = 0.0;
        return point;
    }
    template <class P>
    static P moving_along(int axis, const P& point) {
        P moving = at_rest(point);
        moving.velocity[axis] = 1.0;
        return moving;
    }

    /// On a fluid particle by a solid one, in whose place it sees liquid.
    template <bool IsRigid, class F, class S>
    [[nodiscard]] Force force_by(const F& fluid, const S& solid) const {
        const auto separation = fluid.position - solid.position;
        if constexpr (IsRigid) {
            return order_free_(pair(fluid, solid_.rigid(fluid, solid, separation), separation));
        } else {
            return order_free_(pair(fluid, solid_.springs(fluid, solid, separation), separation));
        }
    }

    template <class I, class J>
    [[nodiscard]] auto pair(const I& i, const J& j, const Force& separation) const {
        const L distance = sqrt(dot(separation, separation));
        const Pair law{i, j, separation, distance, 1.0};
        return kernel_.slope(distance) * viscosity_.law(law);
    }

    ParticleStore& particles_;
    const ClusterList& list_;
    const Kernel& kernel_;
    const Solid& solid_;
    const Viscosity& viscosity_;
    OrderFree order_free_;
    double wall_motion_;
    int threads_;
    FluidReader<L, D> fluid_;
    SolidReader<L, D, Solid::needs_state, Solid::needs_surface, Solid::needs_motion> rigid_;
    SolidReader<L, D, Solid::needs_state, false> springs_;
    std::array<const double*, D> fluid_velocity_, springs_velocity_;
};

}  // namespace dmp::solver
