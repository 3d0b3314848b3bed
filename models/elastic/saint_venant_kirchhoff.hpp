// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "models/elastic/strain.hpp"
#include "models/registry.hpp"

namespace dmp::models {

/// Saint Venant and Kirchhoff's law: linear in Green's strain E = (C - I) / 2, C = F^T F. Per volume at rest,
///   psi = lambda/2 tr(E)^2 + mu E : E     [J/m^3]
///   S = lambda tr(E) I + 2 mu E           [Pa]
/// For large rotations and small strains; it softens under strong compression (Belytschko et al. 2014, 5.4).
struct SaintVenantKirchhoff {
    static constexpr LawFacts facts{"saint_venant_kirchhoff", "Belytschko, Liu, Moran & Elkhodary 2014, section 5.4",
                                    "linear in Green's strain: large rotations, small strains"};

    LameConstants constants;

    template <int D>
    [[nodiscard]] static Matrix<D> strain(const Matrix<D>& c) {
        return 0.5 * (c - Matrix<D>::Identity());
    }
    template <int D>
    [[nodiscard]] double energy(const Matrix<D>& c) const {
        const Matrix<D> e = strain<D>(c);
        return 0.5 * constants.lambda * e.trace() * e.trace() + constants.mu * e.squaredNorm();
    }
    /// The second Piola-Kirchhoff stress S [Pa].
    template <int D>
    [[nodiscard]] Matrix<D> stress(const Matrix<D>& c) const {
        return constants.stress<D>(strain<D>(c));
    }
    /// S across the plane of a solid in plane strain [Pa].
    [[nodiscard]] double stress_across(const Matrix<2>& c) const { return constants.lambda * strain<2>(c).trace(); }
    /// dS/dE, of which only what is certainly positive is kept [Pa].
    template <int D>
    [[nodiscard]] typename Voigt<D>::Square tangent(const Matrix<D>&) const {
        return constants.tangent<D>();
    }
};

}  // namespace dmp::models
