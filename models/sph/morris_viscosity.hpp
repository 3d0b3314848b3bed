// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "models/pair.hpp"
#include "models/sph/viscosity_means.hpp"

namespace dmp::models {

/// Viscous force on particle i (Morris, Fox & Zhu 1997, eq. 22, times m_i):
///   F_i = SUM_j V_i V_j 2 mu_ij (1/r dW/dr) v_ij   [N],   mu_ij the mean of both viscosities
/// Reads volume, velocity and dynamic viscosity. Antisymmetric.
/// Largest stable explicit step: kernel.viscous_limit support^2 / nu (linear theory).
template <class Mean>
struct MorrisLaw {
    template <class P>
    static auto law(const P& p) {
        return (p.weight() * Mean::twice(p.i.viscosity, p.j.viscosity)) * (p.i.velocity - p.j.velocity);
    }
};

using MorrisViscosity = MorrisLaw<ArithmeticMean>;
using HarmonicMorrisViscosity = MorrisLaw<HarmonicMean>;

}  // namespace dmp::models
