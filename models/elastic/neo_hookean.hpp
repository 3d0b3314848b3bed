// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "models/elastic/strain.hpp"
#include "models/registry.hpp"

namespace dmp::models {

/// The compressible neo-Hookean law, for rubber and soft tissue. With C = F^T F, J = det F, in d dimensions, per
/// volume at rest,
///   psi = mu/2 (tr C - d) - mu ln J + lambda/2 ln^2 J     [J/m^3]
///   S = mu (I - C^-1) + lambda ln J C^-1                  [Pa]
/// (Belytschko et al. 2014, eq. 5.4.53); its energy grows without bound as a volume is pressed to nothing.
struct NeoHookean {
    static constexpr LawFacts facts{"neo_hookean", "Belytschko, Liu, Moran & Elkhodary 2014, eq. 5.4.53",
                                    "rubber and soft tissue at large strains"};

    LameConstants constants;

    /// ln J.
    template <int D>
    [[nodiscard]] static double log_volume(const Matrix<D>& c) {
        return 0.5 * std::log(c.determinant());
    }
    template <int D>
    [[nodiscard]] double energy(const Matrix<D>& c) const {
        const double log_j = log_volume<D>(c);
        return 0.5 * constants.mu * (c.trace() - D) - constants.mu * log_j + 0.5 * constants.lambda * log_j * log_j;
    }
    /// The second Piola-Kirchhoff stress S [Pa].
    template <int D>
    [[nodiscard]] Matrix<D> stress(const Matrix<D>& c) const {
        const Matrix<D> inverse = c.inverse();
        return constants.mu * (Matrix<D>::Identity() - inverse) + constants.lambda * log_volume<D>(c) * inverse;
    }
    /// S across the plane of a solid in plane strain [Pa].
    [[nodiscard]] double stress_across(const Matrix<2>& c) const { return constants.lambda * log_volume<2>(c); }
    /// dS/dE, of which only what is certainly positive is kept [Pa].
    template <int D>
    [[nodiscard]] typename Voigt<D>::Square tangent(const Matrix<D>& c) const {
        const Matrix<D> inverse = c.inverse();
        const double shear = std::max(0.0, constants.mu - constants.lambda * log_volume<D>(c));
        typename Voigt<D>::Square tangent;
        for (int row = 0; row < Voigt<D>::size; ++row)
            for (int column = 0; column < Voigt<D>::size; ++column) {
                const auto [i, j] = Voigt<D>::axes[row];
                const auto [k, l] = Voigt<D>::axes[column];
                tangent(row, column) = constants.lambda * inverse(i, j) * inverse(k, l) +
                                       shear * (inverse(i, k) * inverse(j, l) + inverse(i, l) * inverse(j, k));
            }
        return tangent;
    }
};

}  // namespace dmp::models
