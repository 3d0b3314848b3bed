// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <functional>
#include <vector>

#include "solver/implicit/conjugate_gradients.hpp"
#include "solver/neighbours/neighbours.hpp"
#include "solver/sweeps/pair_sweeps.hpp"

namespace dmp::solver {

/// The equations of one step's implicit diffusion of a species (backward Euler), as conjugate_gradients wants them:
///   V_i c_i - dt SUM_j G_ij (c_j - c_i) = w_i
/// V the volume at rest over the share that uptake leaves of what comes in during the step (FirstOrderUptake; 1
/// without), w the amount before, less what was taken up before anything came in, G the pair's conductance; walls that
/// are held at a concentration stand on the right. The matrix is symmetric, because pairs are, and positive definite.
/// The unknowns are Field::concentration of the particles that carry the species, from where they stand. All sums are
/// exact or order-free: results are the same bits on any number of threads and ranks.
class SpeciesSystem {
  public:
    struct Around {
        ParticleStore& particles;
        Neighbours& neighbours;
        const PairSweeps& sweeps;
        const Ranks& ranks;
        int threads;
        /// V of an owned particle [m^3].
        const std::function<double(const ParticleGroup&, std::size_t)>& volume;
    };

    /// `sums`: of the species, with the step as its time and the largest conductance of a pair during it as its largest
    /// term [m^3].
    SpeciesSystem(const Around& around, const SpeciesSums& sums);

    /// Largest eigenvalue of the preconditioned matrix over its smallest, by Gershgorin's circles, at most.
    [[nodiscard]] double condition() const { return condition_; }
    /// Works out the residual of the present concentrations. Returns its error, sqrt(SUM r^2 / V).
    double true_error();
    /// What errors are compared with: sqrt(SUM V c^2), or a thousandth of what it were with the largest concentration
    /// everywhere, whichever is larger.
    [[nodiscard]] double scale() const { return scale_; }

    Residual start();
    double curvature();
    Residual step(double alpha);
    void turn(double beta);

  private:
    /// Calls visit(arrays, i, V) for the owned particles whose concentration is unknown.
    template <class Visit>
    void for_each_unknown(const Visit& visit);
    /// The same, with sums that the visits add to.
    template <std::size_t Count, class Visit>
    [[nodiscard]] std::array<double, Count> sums_over_unknowns(const Visit& visit);
    [[nodiscard]] Residual residual_sums();
    /// What particles take by these values in the place of concentrations.
    void find_change(Field values, int array, double largest_value);
    [[nodiscard]] double largest(Field values, int array) const;

    struct Arrays {
        double *concentration, *amount, *change, *residual, *direction, *diagonal;
        const double* diffusivity;  ///< null: all are unknown
    };
    [[nodiscard]] Arrays arrays_of(ParticleGroup& group) const;

    Around on_;
    SpeciesSums sums_;
    std::vector<ParticleGroup*> groups_;
    double condition_ = 1, largest_diagonal_ = 0, scale_ = 0;
};

}  // namespace dmp::solver
