// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "models/elastic/strain.hpp"

namespace dmp::models {

/// The surface of an elastic solid near a particle, as the deformation carries it. Planes of the material stay planes
/// to first order in the deformation gradient F (Nanson 1878; Truesdell & Toupin 1960, section 20): those with the
/// normal N at rest, a distance D apart, have
///   n = F^-T N / |F^-T N| [-]      d = D / |F^-T N| [m]
/// Energy: none; it is geometry.
template <int D>
struct CarriedSurface {
    using Column = Eigen::Matrix<double, D, 1>;

    Column normal;   ///< n; 0 where N is
    double stretch;  ///< d / D

    /// `to_rest`: F^-1.
    static CarriedSurface of(const Column& normal_at_rest, const Matrix<D>& to_rest) {
        const Column carried = to_rest.transpose() * normal_at_rest;
        const double length = carried.norm();
        if (!(length > 0)) return {Column::Zero(), 1};
        return {carried / length, 1 / length};
    }
};

/// F^-1 and the gradient of the velocity at a particle from what its neighbours do, by least squares over the present
/// arms x_k to them, at rest X_k, with relative velocities v_k:
///   F^-1 = (SUM X_k x_k^T) P      L = (SUM v_k x_k^T) P [1/s]      P = (SUM x_k x_k^T)^-1
/// Exact where the deformation is uniform.
template <int D>
class MotionAround {
  public:
    using Column = Eigen::Matrix<double, D, 1>;

    void add(const Column& at_rest, const Column& now, const Column& velocity) {
        rest_ += at_rest * now.transpose();
        rate_ += velocity * now.transpose();
        arms_ += now * now.transpose();
    }
    /// False where the arms do not span space: along a thread, or with too few neighbours.
    [[nodiscard]] bool spans_space() const {
        constexpr double least = 1e-3;  // of the determinant over that of arms in all directions
        const double mean = arms_.trace() / D;
        double cube = 1;
        for (int axis = 0; axis < D; ++axis) cube *= mean;
        return arms_.determinant() > least * cube;
    }
    [[nodiscard]] Matrix<D> to_rest() const { return rest_ * arms_.inverse(); }
    [[nodiscard]] Matrix<D> velocity_gradient() const { return rate_ * arms_.inverse(); }

  private:
    Matrix<D> rest_ = Matrix<D>::Zero(), rate_ = Matrix<D>::Zero(), arms_ = Matrix<D>::Zero();
};

}  // namespace dmp::models
