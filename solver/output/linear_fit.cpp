// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/output/linear_fit.hpp"

#include <Eigen/Eigenvalues>

namespace dmp::solver {

namespace {

/// Samples spread along a direction if their standard deviation is at least this many spacings: two rows have 0.5,
/// one row of moved particles about 0.1.
constexpr double least_spread = 0.3;

}  // namespace

void LinearFit::add(const Vec& x, double weight) {
    auto sum = sums_.begin();
    (sum++)->add(weight);
    for (int a = 0; a < 3; ++a) (sum++)->add(weight * x[a]);
    for (int a = 0; a < 3; ++a)
        for (int b = 0; b <= a; ++b) (sum++)->add(weight * x[a] * x[b]);
}

void LinearFit::finish(const Ranks& ranks, double spacing) {
    ranks.sum(sums_);
    sum_of_weights_ = sums_[0].value();
    if (!has_samples()) return;
    auto sum = sums_.begin() + 1;
    for (int a = 0; a < 3; ++a) centre_[a] = (sum++)->value() / sum_of_weights_;
    Eigen::Matrix3d spread;
    for (int a = 0; a < 3; ++a)
        for (int b = 0; b <= a; ++b)
            spread(a, b) = spread(b, a) = (sum++)->value() / sum_of_weights_ - centre_[a] * centre_[b];
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(spread);
    for (int k = 0; k < 3; ++k) {
        const double variance = axes.eigenvalues()[k];
        const Vec along = axes.eigenvectors().col(k);
        if (variance > least_spread * least_spread * spacing * spacing) slope_ += along.dot(centre_) / variance * along;
    }
}

double LinearFit::share(const Vec& x, double weight) const {
    return weight / sum_of_weights_ * (1 - slope_.dot(x - centre_));
}

}  // namespace dmp::solver
