// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/models/pair.hpp"

namespace dmp {

/// Numerical diffusion of density that quietens pressure (Molteni & Colagrossi 2009, eq. 14):
///   drho_i/dt = delta h c0 SUM_j V_j 2 (rho_i - rho_j) / (r^2 + eta^2) x_ij . grad_i W_ij,   h = support / 2
/// Between particles of one fluid. SUM_i V_i drho_i = 0, so mass stays where the equations put it.
struct DensityDiffusion {
    double coefficient;  ///< 2 delta h c0 [m^2/s]
    double eta_square;   ///< keeps r = 0 finite: 1e-4 h^2 [m^2]

    DensityDiffusion(double delta, double support, double sound_speed)
        : coefficient(delta * support * sound_speed), eta_square(0.25e-4 * support * support) {}

    template <class P>
    [[nodiscard]] auto law(const P& p) const {
        const auto distance_square = p.distance * p.distance;
        return coefficient * p.j.volume * (p.i.density - p.j.density) * p.slope * distance_square /
               (distance_square + eta_square);
    }
};

}  // namespace dmp
