// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>

#include "base/vec.hpp"
#include "solver/parallel/exact_sum.hpp"
#include "solver/parallel/ranks.hpp"
#include "solver/uses.hpp"

namespace dmp::solver {

/// The value at a point of the linear function that fits scattered values best: weighted least squares (moving least
/// squares of first order; Lancaster & Salkauskas 1981, Math. Comput. 37). Exact for linear functions wherever the
/// samples lie, so it reads right beside walls, where all of them are on one side. A mean weighted by the kernel reads
/// the value at the samples' centre there.
///
///     value = SUM_k s_k f_k,    s_k = w_k [1 - m . C^-1 (x_k - m)] / SUM w
///     m = SUM w x / SUM w,      C = SUM w x x^T / SUM w - m m^T
///
/// with x from the point. Along directions in which the samples do not spread, the function is taken as constant.
/// All sums are exact, so the bits do not depend on the ranks.
class LinearFit {
  public:
    /// x from the point [m], weight [-], above 0.
    void add(const Vec& x, double weight);
    /// Once all samples are added; all ranks together. `spacing`: of the particles [m].
    void finish(const Ranks& ranks, double spacing);

    [[nodiscard]] bool has_samples() const { return sum_of_weights_ > 0; }
    /// s_k of a sample; their sum over all samples is 1.
    [[nodiscard]] double share(const Vec& x, double weight) const;

  private:
    std::array<ExactSum, 10> sums_;  ///< of w, w x, w x x^T
    double sum_of_weights_ = 0;
    Vec centre_ = Vec::Zero();  ///< m
    Vec slope_ = Vec::Zero();   ///< C^-1 m
};

}  // namespace dmp::solver
