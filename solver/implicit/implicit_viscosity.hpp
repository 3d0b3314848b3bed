// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <functional>

#include "base/errors.hpp"
#include "solver/elastic/spring_bodies.hpp"
#include "solver/implicit/conjugate_gradients.hpp"
#include "solver/neighbours/neighbours.hpp"
#include "solver/results/run_summary.hpp"
#include "solver/sweeps/pair_sweeps.hpp"

namespace dmp::solver {

class SurfaceContact;

/// The viscous forces of a step cannot be found.
class UnsolvedViscosity : public DivergenceError {
  public:
    using DivergenceError::DivergenceError;
};

/// Viscous forces of the velocities at the end of the step (backward Euler), so that they set no limit to it:
///   (m_i / dt) (v_i - v*_i) = SUM_j V_i V_j mu_ij (1/r dW/dr) (v_i - v_j) = F_i(v)   [N]
/// v* the velocity that all other forces leave, mu_ij and v_j as in the explicit force, walls and spring bodies
/// included (a body's nodes are unknowns beside the fluid's velocities). The matrix m/dt - dF/dv is symmetric, because
/// pairs are, and positive definite, because slopes are negative. Conjugate gradients without a matrix, preconditioned
/// with its diagonal; they start from the last velocities (after Weiler, Koschier, Brand & Bender 2018).
/// What acts in the end is the force F(v) of the solution, pair by pair: momentum is kept to rounding whatever the
/// tolerance, and a residual r leaves an error dt r / m of the velocity.
class ImplicitViscosity {
  public:
    /// Exchanges these fields and calls the function for the clusters.
    using Sweep = std::function<void(const FieldList&, const std::function<void(ClusterChoice)>&)>;

    /// `tolerance`: of the velocities' error dt r / m, root mean square by mass, over that of the velocities.
    ImplicitViscosity(const PairSweeps& sweeps, const Ranks& ranks, double tolerance, int threads);

    /// Adds the viscous forces of the velocities after this step to `force`, which has all others but those of
    /// `contact`, null where nothing may touch. `g`: body acceleration. Throws UnsolvedViscosity.
    void add_forces(ParticleStore& particles, const ClusterList& list, SpringBodies& springs, SurfaceContact* contact,
                    double dt, const std::array<double, 3>& g, const Sweep& sweep);

    void archive(Archive& file);
    [[nodiscard]] const ViscousSolves& solves() const { return solves_; }

  private:
    [[noreturn]] void give_up(double error, long iterations, bool may_touch) const;

    const PairSweeps& sweeps_;
    const Ranks& ranks_;
    double tolerance_;
    int threads_;
    ViscousSolves solves_;
};

}  // namespace dmp::solver
