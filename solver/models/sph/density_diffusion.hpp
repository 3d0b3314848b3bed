// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/models/pair.hpp"

namespace dmp {

/// Numerical diffusion of density that quietens pressure (Molteni & Colagrossi 2009):
///   drho_i/dt = delta h c0 SUM_j V_j 2 (rho_i - rho_j) / r^2 x_ij . grad_i W_ij
///             = 2 delta h c0 SUM_j V_j (rho_i - rho_j) (1/r dW/dr),   h = support / 2   [kg/m^3/s]
/// Between fluid particles. SUM_i V_i drho_i = 0, so mass stays where the equations put it.
struct DensityDiffusion {
    double coefficient;  ///< 2 delta h c0 [m^2/s]

    DensityDiffusion(double delta, double support, double sound_speed) : coefficient(delta * support * sound_speed) {}

    template <class P>
    [[nodiscard]] auto law(const P& p) const {
        return coefficient * p.j.volume * (p.i.density - p.j.density) * p.slope;
    }
};

}  // namespace dmp
