// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "models/sph/walls.hpp"
#include "solver/sweeps/cluster_loop.hpp"
#include "solver/sweeps/point_reader.hpp"
#include "solver/sweeps/reproducible_sum.hpp"

namespace dmp::solver {

/// The viscous force alone, as a linear function of the velocities in a given field, for implicit viscosity. Solids
/// act as in the force sweep. L of a cluster's particles at a time.
template <class L, int D, class Kernel, class Solid, class Viscosity>
class ViscousSweep {
  public:
    struct Motion {
        ReproducibleSum rounding;
        Field velocity;      ///< of fluid particles and elastic bodies
        double wall_motion;  ///< factor for the walls' velocity: 1, or 0 for the part proportional to `velocity`
    };

    ViscousSweep(ParticleStore& particles, const ClusterList& list, const Kernel& kernel, const Solid& solid,
                 const Viscosity& viscosity, const Motion& motion, int threads)
        : particles_(particles),
          list_(list),
          kernel_(kernel),
          solid_(solid),
          viscosity_(viscosity),
          rounding_(motion.rounding),
          wall_motion_(motion.wall_motion),
          threads_(threads),
          fluid_(particles.fluid()),
          rigid_(particles.of(PartKind::rigid)),
          springs_(particles.of(PartKind::elastic)),
          fluid_velocity_(axes_of<D>(particles.fluid(), motion.velocity)),
          elastic_velocity_(axes_of<D>(particles.of(PartKind::elastic), motion.velocity)) {}

    /// Sets viscous_force of fluid and elastic bodies and, if walls move, of walls.
    void forces(ClusterChoice choice) {
        sweep(PartKind::fluid, Field::viscous_force, choice, [this](const auto& near) { return force_on_fluid(near); });
        sweep(PartKind::elastic, Field::viscous_force, choice,
              [this](const auto& near) { return reaction_to_fluid<false>(near, spring_at()); });
        if (wall_motion_ != 0)
            sweep(PartKind::rigid, Field::viscous_force, choice,
                  [this](const auto& near) { return reaction_to_fluid<true>(near, wall_at()); });
    }

    /// Sets viscous_diagonal of fluid and elastic bodies: by axis, minus the derivative of a particle's force with
    /// respect to its own velocity [kg/s].
    void diagonal(ClusterChoice choice) {
        sweep(PartKind::fluid, Field::viscous_diagonal, choice,
              [this](const auto& near) { return diagonal_of_fluid(near); });
        sweep(PartKind::elastic, Field::viscous_diagonal, choice,
              [this](const auto& near) { return diagonal_of_elastic(near); });
    }

  private:
    using Force = Vector<L, D>;

    template <class SumOver>
    void sweep(PartKind kind, Field result, ClusterChoice choice, const SumOver& sum_over) {
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
            point.velocity = load_vector<L, D>(elastic_velocity_, at);
            return point;
        };
    }
    [[nodiscard]] auto wall_at() const {
        return [this](const auto& at) {
            auto point = rigid_(at);
            point.velocity = wall_motion_ * point.velocity;
            for (int a = 0; a < D; ++a) point.surface_gradient[a] = wall_motion_ * point.surface_gradient[a];
            return point;
        };
    }

    // Flattened: inlines every law into the loop, regardless of size.
    [[nodiscard, gnu::flatten]] Force force_on_fluid(const Neighbourhood& near) const {
        const auto i = fluid_at(near.cluster);
        Force force = Force::zero();
        for (const std::int32_t index : near.of(PartKind::fluid)) {
            const auto j = fluid_at(index);
            force += rounding_(pair(i, j, i.position - j.position));
        }
        for (const std::int32_t index : near.of(PartKind::rigid)) force += force_by<true>(i, wall_at()(index));
        for (const std::int32_t index : near.of(PartKind::elastic)) force += force_by<false>(i, spring_at()(index));
        return force;
    }

    template <bool IsRigid, class ReadAt>
    [[nodiscard, gnu::flatten]] Force reaction_to_fluid(const Neighbourhood& near, const ReadAt& read_at) const {
        const auto solid = read_at(near.cluster);
        Force force = Force::zero();
        for (const std::int32_t index : near.of(PartKind::fluid)) force -= force_by<IsRigid>(fluid_at(index), solid);
        return force;
    }

    [[nodiscard, gnu::flatten]] Force diagonal_of_fluid(const Neighbourhood& near) const {
        const auto i = fluid_(near.cluster);
        Force sum = Force::zero();
        for (int axis = 0; axis < D; ++axis) {
            const auto moving = moving_along(axis, i);
            for (const std::int32_t index : near.of(PartKind::fluid)) {
                const auto j = at_rest(fluid_(index));
                const Force separation = moving.position - j.position;
                // The neighbours of a cluster include its own members.
                const L term =
                    where_less(L(0.0), dot(separation, separation), pair(moving, j, separation)[axis], L(0.0));
                sum[axis] -= rounding_(term);
            }
            for (const std::int32_t index : near.of(PartKind::rigid))
                sum[axis] -= force_by<true>(moving, at_rest(rigid_(index)))[axis];
            for (const std::int32_t index : near.of(PartKind::elastic))
                sum[axis] -= force_by<false>(moving, at_rest(springs_(index)))[axis];
        }
        return sum;
    }

    [[nodiscard, gnu::flatten]] Force diagonal_of_elastic(const Neighbourhood& near) const {
        const auto node = springs_(near.cluster);
        Force sum = Force::zero();
        for (int axis = 0; axis < D; ++axis)
            for (const std::int32_t index : near.of(PartKind::fluid))
                sum[axis] += force_by<false>(at_rest(fluid_(index)), moving_along(axis, node))[axis];
        return sum;
    }

    template <class P>
    static P at_rest(P point) {
        for (int axis = 0; axis < D; ++axis) {
            point.velocity[axis] = 0.0;
            if constexpr (requires { point.surface_gradient; })
                point.surface_gradient[axis] = std::decay_t<decltype(point.velocity)>::zero();
        }
        return point;
    }
    template <class P>
    static P moving_along(int axis, const P& point) {
        P moving = at_rest(point);
        moving.velocity[axis] = 1.0;
        return moving;
    }

    /// Force on a fluid particle by a solid particle, which the wall model replaces by a fluid particle.
    template <bool IsRigid, class F, class S>
    [[nodiscard]] Force force_by(const F& fluid, const S& solid) const {
        const auto separation = fluid.position - solid.position;
        if constexpr (IsRigid) {
            return rounding_(pair(fluid, solid_.rigid(fluid, solid, separation), separation));
        } else {
            return rounding_(pair(fluid, solid_.springs(fluid, solid, separation), separation));
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
    ReproducibleSum rounding_;
    double wall_motion_;
    int threads_;
    FluidReader<L, D, Viscosity::needs_gradient> fluid_;
    SolidReader<L, D, Solid::needs_state, Solid::needs_surface, Solid::needs_motion> rigid_;
    BodyReader<L, D, Solid::needs_state, Solid::needs_surface> springs_;
    std::array<const double*, D> fluid_velocity_, elastic_velocity_;
};

}  // namespace dmp::solver
