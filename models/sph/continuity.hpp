// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "models/pair.hpp"

namespace dmp::models {

/// Rate of density of particle i (Monaghan 1994, in volume form):
///   drho_i/dt = rho_i SUM_j V_j v_ij . grad_i W_ij   [kg/m^3/s]
/// Reads velocity, density and volume.
struct ContinuityRate {
    template <class P>
    static auto law(const P& p) {
        return p.i.density * p.j.volume * p.slope * dot(p.i.velocity - p.j.velocity, p.separation);
    }
};

}  // namespace dmp::models
