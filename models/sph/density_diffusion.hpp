// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "models/pair.hpp"

namespace dmp::models {

/// Numerical diffusion of density that reduces pressure noise (Molteni & Colagrossi 2009):
///   drho_i/dt = delta h c0 SUM_j V_j 2 (rho_i - rho_j) / r^2 x_ij . grad_i W_ij
///             = 2 delta h c0 SUM_j V_j (rho_i - rho_j) (1/r dW/dr),   h = support / 2   [kg/m^3/s]
/// Acts between fluid particles. SUM_i V_i drho_i = 0, so the total mass is unchanged.
struct DensityDiffusion {
    double coefficient;  ///< 2 delta h c0 [m^2/s]

    DensityDiffusion(double delta, double support, double sound_speed) : coefficient(delta * support * sound_speed) {}

    template <class P>
    [[nodiscard]] auto law(const P& p) const {
        return coefficient * p.j.volume * (p.i.density - p.j.density) * p.slope;
    }
};

/// The same less what a smooth density field has (Antuono, Colagrossi, Marrone & Molteni 2010): zero where the density
/// is linear, so that neither waves nor a hydrostatic density are worn down:
///   drho_i/dt = 2 delta h c0 SUM_j V_j [(rho_i - rho_j) - (g_i + g_j) . x_ij / 2] (1/r dW/dr)
/// with the corrected gradient g of the density among particles of one fluid. The law is the bracket.
struct SmoothDensityDiffusion {
    template <class T, int D>
    static T law(const T& difference, const Vector<T, D>& sum_of_gradients, const Vector<T, D>& separation) {
        // Fused by name, see gradient_correction.hpp.
        T linear = sum_of_gradients[0] * separation[0];
        for (int axis = 1; axis < D; ++axis) linear = multiply_add(sum_of_gradients[axis], separation[axis], linear);
        return difference - 0.5 * linear;
    }
};

/// The same with the hydrostatic correction, for use with body forces (Fourtakas, Dominguez, Vacondio & Rogers 2019):
/// only the pressure difference of a pair beyond the hydrostatic difference is diffused. At rest the term is zero,
/// both inside and at a free surface or a wall, where the uncorrected term would erode the hydrostatic
/// stratification:
///   drho_i/dt = 2 delta h c0 SUM_j V_j [(p_i - p_j) - (rho_i + rho_j)/2 g . x_ij] / c0^2 (1/r dW/dr)
template <int D>
struct HydrostaticDiffusion {
    double coefficient;              ///< 2 delta h / c0 [s]
    Vector<double, D> acceleration;  ///< g along the axes that are not periodic [m/s^2]

    HydrostaticDiffusion(double delta, double support, double sound_speed, const Vector<double, D>& g)
        : coefficient(delta * support / sound_speed), acceleration(g) {}

    template <class P>
    [[nodiscard]] auto law(const P& p) const {
        const auto hydrostatic = 0.5 * (p.i.density + p.j.density) * dot(acceleration, p.separation);
        return coefficient * p.j.volume * ((p.i.pressure - p.j.pressure) - hydrostatic) * p.slope;
    }
};

}  // namespace dmp::models
