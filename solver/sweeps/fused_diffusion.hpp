// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/sweeps/pair_sweeps.hpp"
#include "solver/sweeps/point_reader.hpp"
#include "solver/sweeps/reproducible_sum.hpp"

namespace dmp::solver {

/// Sums the diffusion of a species between fluid particles of one diffusivity (SpeciesDiffusion) within a sweep that
/// has already computed the kernel's slope, L of a cluster's particles at a time.
/// If particles are then shifted by d, which follows from the same sweep, SpeciesDiffusion::law_with_shift is split
/// into terms that do not depend on d: with w_ij = V_i V_j (c_i - c_j) (1/r dW/dr),
///   dw_i = (2 D dt + d^2) SUM_j w_ij - d . SUM_j w_ij x_ij
/// The terms of the first sum are rounded as 2 D dt w_ij, the amounts that diffuse, so that one particle receives
/// exactly the amount that the other loses. If the diffusion is very slow, this would be too coarse for d^2; they are
/// then rounded as d^2 w_ij with the longest d.
template <class L, int D, bool Shifting>
class FusedDiffusion {
  public:
    /// @param steepest of the kernel, |dW/dr| [1/m^(D+1)]
    FusedDiffusion(ParticleStore& particles, const SpeciesSums& sums, double volume, double steepest)
        : sums_(sums),
          concentration_(particles.fluid().data(sums.values, sums.array_of_values)),
          result_(particles.fluid().data(sums.result, sums.array_of_result)),
          whole_(sums.largest_term),
          moments_(sums.largest_term * volume * steepest) {
        const double diffuses = 2 * sums.diffusivity * sums.time, shifts = sums.longest_shift * sums.longest_shift;
        exactly_ = diffuses > shifts / 1024;
        factor_ = exactly_ ? diffuses : shifts;
        left_ = exactly_ ? 0 : diffuses;
    }

    /// Sums of a cluster's particles so far.
    struct Sum {
        L concentration;                             ///< of the particles themselves
        L taken = 0.0;                               ///< amount received by diffusion; with shifting, SUM factor w_ij
        Vector<L, D> moment = Vector<L, D>::zero();  ///< SUM w_ij x_ij
    };
    [[nodiscard]] Sum around(const Cluster& cluster) const { return {load<L>(concentration_, cluster)}; }

    /// Adds a neighbour.
    void add(const L& volumes, std::int32_t neighbour, const Vector<L, D>& separation, const L& slope, Sum& sum) const {
        const L difference = sum.concentration - concentration_[neighbour];
        if constexpr (Shifting) {
            const L weighted = (slope * volumes) * difference;
            sum.taken += whole_(factor_ * weighted);
            sum.moment += moments_(weighted * separation);
        } else {
            sum.taken += whole_(slope * (sums_.time * (volumes * (2 * sums_.diffusivity) * difference)));
        }
    }

    /// @param shift_sum SUM of the shifting law; ignored without shifting
    void store(const Sum& sum, const Vector<L, D>& shift_sum, const Cluster& cluster) const {
        double* to = result_ + cluster.first;
        L amount = sum.taken;
        if constexpr (Shifting) {
            const Vector<L, D> shift = sums_.displacement(shift_sum);
            const L rest = (dot(shift, shift) + left_) * (1 / factor_) * sum.taken - dot(shift, sum.moment);
            amount = exactly_ ? amount + whole_(rest) : whole_(rest);
        }
        (sums_.adds ? L::load(to) + amount : amount).store(to, static_cast<std::size_t>(cluster.count));
    }

  private:
    const SpeciesSums& sums_;
    const double* concentration_;
    double* result_;
    ReproducibleSum whole_, moments_;
    bool exactly_;
    double factor_, left_;  ///< coefficients of SUM w_ij: in the terms; to be added with d^2 [m^2]
};

}  // namespace dmp::solver
