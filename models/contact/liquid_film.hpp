// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

namespace dmp::models {

/// A film of liquid between two surfaces that is thinner than particles resolve (Reynolds 1886; Batchelor 1967, section
/// 4.8): its pressure p, less that of the liquid around, follows from how the gap g changes and how the surfaces slide
/// past each other, with the velocity u of the other one,
///   div(h^3 / (12 mu) grad p) = dg/dt + div(h u / 2),   p = 0 where h = h_0,   h = max(g, roughness)   [m/s]
/// and its shear stress on the surface is mu u (1/h - 1/h_0) + h/2 grad p. Beyond h_0 particles resolve what flows.
/// Between a cylinder, or a sphere, and a plane p = 6 mu V R (1/h^2 - 1/h_0^2), or half of that.
struct LiquidFilmLaw {
    double viscosity = 0;  ///< mu [Pa s]
    double thickest = 0;   ///< h_0 [m]

    /// Over h_0. Surfaces that touch keep it.
    static constexpr double roughness = 0.02;

    /// h [m]
    [[nodiscard]] double thickness(double gap) const { return std::max(gap, roughness * thickest); }
    /// h^3 / (12 mu) [m^3/(Pa s)]
    [[nodiscard]] double conductance(double gap) const {
        const double h = thickness(gap);
        return h * h * h / (12 * viscosity);
    }
    /// mu (1/h - 1/h_0) [Pa s/m]
    [[nodiscard]] double drag(double gap) const { return viscosity * std::max(0.0, 1 / thickness(gap) - 1 / thickest); }
};

}  // namespace dmp::models
