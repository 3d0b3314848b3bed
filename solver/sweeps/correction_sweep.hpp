// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/simd/lanes.hpp"
#include "models/sph/gradient_correction.hpp"
#include "models/sph/walls.hpp"
#include "solver/sweeps/cluster_loop.hpp"
#include "solver/sweeps/point_reader.hpp"
#include "solver/sweeps/reproducible_sum.hpp"

namespace dmp::solver {

/// Rounding of the sums of a correction sweep.
struct CorrectionRounding {
    ReproducibleSum matrix, force, rate;
};

/// The corrected gradient (models/sph/gradient_correction.hpp), L of a cluster's particles at a time: `matrices` must
/// be called before the forces, for the fluid; `forces` and `rates` add to the results of the usual sweeps. `Solid`
/// is the wall model.
template <class L, int D, class Kernel, class Solid>
class CorrectionSweep {
  public:
    CorrectionSweep(ParticleStore& particles, const ClusterList& list, const Kernel& kernel, const Solid& solid,
                    const CorrectionRounding& rounding, int threads)
        : particles_(particles),
          list_(list),
          kernel_(kernel),
          solid_(solid),
          rounding_(rounding),
          threads_(threads),
          fluid_(particles.fluid()),
          rigid_(particles.of(PartKind::rigid)),
          springs_(particles.of(PartKind::elastic)) {}

    void matrices(ClusterChoice choice) {
        ParticleGroup& group = particles_.fluid();
        for_each_cluster<L::width>(list_, PartKind::fluid, choice, threads_, [&](const Neighbourhood& near) {
            const Matrix e = GradientCorrection::excess(moment_of(near));
            store<L, D>(e.diagonal, group, Field::correction, near.cluster);
            for (int k = 0; k < Matrix::off_diagonals; ++k)
                e.off[k].store(group.data(Field::correction_off_diagonal, k) + near.cluster.first,
                               static_cast<std::size_t>(near.cluster.count));
        });
    }

    void forces(ClusterChoice choice) {
        add(PartKind::fluid, choice, [this](const auto& near) { return force_on_fluid(near); });
        add(PartKind::rigid, choice, [this](const auto& near) { return reaction<true>(near, rigid_); });
        add(PartKind::elastic, choice, [this](const auto& near) { return reaction<false>(near, springs_); });
    }

    void rates(ClusterChoice choice) {
        double* rates = particles_.fluid().data(Field::density_rate);
        for_each_cluster<L::width>(list_, PartKind::fluid, choice, threads_, [&](const Neighbourhood& near) {
            const L rate = load<L>(rates, near.cluster) + rate_of(near);
            rate.store(rates + near.cluster.first, static_cast<std::size_t>(near.cluster.count));
        });
    }

  private:
    using Force = Vector<L, D>;
    using Matrix = Symmetric<L, D>;

    /// E of one particle, or of the particles of a cluster in lanes.
    template <class Index>
    [[nodiscard]] auto correction(const Index& at) const {
        using T = decltype(load<L>(static_cast<const double*>(nullptr), at));
        const ParticleGroup& group = particles_.fluid();
        Symmetric<T, D> e;
        for (int a = 0; a < D; ++a) e.diagonal[a] = load<L>(group.data(Field::correction, a), at);
        for (int k = 0; k < Matrix::off_diagonals; ++k)
            e.off[k] = load<L>(group.data(Field::correction_off_diagonal, k), at);
        return e;
    }

    [[nodiscard, gnu::flatten]] Matrix moment_of(const Neighbourhood& near) const {
        const auto i = fluid_(near.cluster);
        Matrix moment{Force::zero(), Vector<L, Matrix::off_diagonals>::zero()};
        const auto add_all = [&](PartKind kind, const auto& read) {
            for (const std::int32_t index : near.of(kind)) {
                const auto j = read(index);
                const Force separation = i.position - j.position;
                const L slope = kernel_.slope(sqrt(dot(separation, separation)));
                const Matrix term = GradientCorrection::term(j.volume, separation);
                moment.diagonal += rounding_.matrix(slope * term.diagonal);
                moment.off += rounding_.matrix(slope * term.off);
            }
        };
        add_all(PartKind::fluid, fluid_);
        add_all(PartKind::rigid, rigid_);
        add_all(PartKind::elastic, springs_);
        return moment;
    }

    template <class ForceOn>
    void add(PartKind kind, ClusterChoice choice, const ForceOn& force_on) {
        ParticleGroup& group = particles_.of(kind);
        for_each_cluster<L::width>(list_, kind, choice, threads_, [&](const Neighbourhood& near) {
            const auto force = load_vector<L, D>(axes_of<D>(group, Field::force), near.cluster);
            store<L, D>(force + force_on(near), group, Field::force, near.cluster);
        });
    }

    [[nodiscard, gnu::flatten]] Force force_on_fluid(const Neighbourhood& near) const {
        const auto i = fluid_(near.cluster);
        const auto own = correction(near.cluster);
        Force force = Force::zero();
        for (const std::int32_t index : near.of(PartKind::fluid))
            force += force_of_pair(i, fluid_(index), own, correction(index));
        for (const std::int32_t index : near.of(PartKind::rigid)) force += force_by<true>(i, rigid_(index), own);
        for (const std::int32_t index : near.of(PartKind::elastic)) force += force_by<false>(i, springs_(index), own);
        return force;
    }

    template <bool IsRigid, class Reader>
    [[nodiscard, gnu::flatten]] Force reaction(const Neighbourhood& near, const Reader& read) const {
        const auto solid = read(near.cluster);
        Force force = Force::zero();
        for (const std::int32_t index : near.of(PartKind::fluid))
            force -= force_by<IsRigid>(fluid_(index), solid, correction(index));
        return force;
    }

    template <class I, class J, class OfI, class OfJ>
    [[nodiscard]] Force force_of_pair(const I& i, const J& j, const OfI& of_i, const OfJ& of_j) const {
        const Force separation = i.position - j.position;
        const L distance = sqrt(dot(separation, separation));
        const L slope = kernel_.slope(distance);
        const Pair pair{i, j, separation, distance, 1.0};
        return rounding_.force(slope * GradientCorrection::force(pair, i.pressure, of_i)) +
               rounding_.force(slope * GradientCorrection::force(pair, j.pressure, of_j));
    }

    template <bool IsRigid, class F, class S, class OfFluid>
    [[nodiscard]] Force force_by(const F& fluid, const S& solid, const OfFluid& of_fluid) const {
        const Force separation = fluid.position - solid.position;
        if constexpr (IsRigid) {
            return force_of_pair(fluid, solid_.rigid(fluid, solid, separation), of_fluid, of_fluid);
        } else {
            return force_of_pair(fluid, solid_.springs(fluid, solid, separation), of_fluid, of_fluid);
        }
    }

    [[nodiscard, gnu::flatten]] L rate_of(const Neighbourhood& near) const {
        const auto i = fluid_(near.cluster);
        const auto own = correction(near.cluster);
        L rate = 0.0;
        const auto add_all = [&](PartKind kind, const auto& read, double weight) {
            for (const std::int32_t index : near.of(kind)) {
                const auto j = read(index);
                const Force separation = i.position - j.position;
                const L distance = sqrt(dot(separation, separation));
                const Pair pair{i, j, separation, distance, 1.0};
                rate += rounding_.rate(kernel_.slope(distance) * (weight * GradientCorrection::rate(pair, own)));
            }
        };
        add_all(PartKind::fluid, fluid_, 1);
        add_all(PartKind::rigid, rigid_, Solid::approach_weight);
        add_all(PartKind::elastic, springs_, Solid::approach_weight);
        return rate;
    }

    ParticleStore& particles_;
    const ClusterList& list_;
    const Kernel& kernel_;
    const Solid& solid_;
    const CorrectionRounding& rounding_;
    int threads_;
    FluidReader<L, D> fluid_;
    SolidReader<L, D, Solid::needs_state, Solid::needs_surface> rigid_;
    SolidReader<L, D, Solid::needs_state, false> springs_;
};

}  // namespace dmp::solver
