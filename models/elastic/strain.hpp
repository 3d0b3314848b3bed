// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <array>

#include "models/uses.hpp"

namespace dmp::models {

template <int D>
using Matrix = Eigen::Matrix<double, D, D>;

/// A symmetric tensor as a column: xx, yy, xy in 2-D; xx, yy, zz, xy, yz, xz in 3-D.
template <int D>
struct Voigt {
    static constexpr int size = D * (D + 1) / 2;
    using Column = Eigen::Matrix<double, size, 1>;
    using Square = Eigen::Matrix<double, size, size>;
    /// The row and column of each component.
    static constexpr auto axes = [] {
        if constexpr (D == 2)
            return std::array<std::array<int, 2>, 3>{{{0, 0}, {1, 1}, {0, 1}}};
        else
            return std::array<std::array<int, 2>, 6>{{{0, 0}, {1, 1}, {2, 2}, {0, 1}, {1, 2}, {0, 2}}};
    }();
};

/// Lame's constants of an isotropic material [Pa]; in 2-D in plane strain.
struct LameConstants {
    double lambda = 0, mu = 0;

    /// Of Young's modulus E [Pa] and Poisson's ratio nu, -1 < nu < 1/2.
    static LameConstants of(double youngs_modulus, double poisson_ratio) {
        return {youngs_modulus * poisson_ratio / ((1 + poisson_ratio) * (1 - 2 * poisson_ratio)),
                youngs_modulus / (2 * (1 + poisson_ratio))};
    }

    /// Stress of a small strain, lambda tr(e) I + 2 mu e [Pa].
    template <int D>
    [[nodiscard]] Matrix<D> stress(const Matrix<D>& strain) const {
        return lambda * strain.trace() * Matrix<D>::Identity() + 2 * mu * strain;
    }

    /// The derivative of that stress with respect to the strain, whose shears count twice (2 e_xy) [Pa].
    template <int D>
    [[nodiscard]] typename Voigt<D>::Square tangent() const {
        typename Voigt<D>::Square tangent = Voigt<D>::Square::Zero();
        tangent.template topLeftCorner<D, D>().setConstant(lambda);
        for (int k = 0; k < Voigt<D>::size; ++k) tangent(k, k) += k < D ? 2 * mu : mu;
        return tangent;
    }
};

}  // namespace dmp::models
