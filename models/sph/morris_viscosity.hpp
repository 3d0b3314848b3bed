// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "models/pair.hpp"
#include "models/registry.hpp"
#include "models/sph/viscous_scales.hpp"

namespace dmp::models {

/// Viscous force on particle i (Morris, Fox & Zhu 1997, eq. 22, times m_i):
///   F_i = SUM_j V_i V_j 2 mu_ij (1/r dW/dr) v_ij   [N],   mu_ij the mean of both viscosities
/// Reads volume, velocity and dynamic viscosity. Antisymmetric; conserves linear but not angular momentum. Largest
/// stable explicit step: kernel.viscous_limit support^2 / nu (linear theory).
struct MorrisViscosity {
    static constexpr LawFacts facts{"morris", "Morris, Fox & Zhu 1997, eq. 22", "Morris' form, along the velocities"};
    static constexpr bool linear = true;

    explicit MorrisViscosity(const ViscousScales& /*scales*/ = {}) {}

    template <class P, class T>
    static auto law(const P& p, const T& twice_mean) {
        return (p.weight() * twice_mean) * (p.i.velocity - p.j.velocity);
    }

    static double step_share() { return 1; }
    static LatticeViscosity on_lattice(const ViscousScales& scales) { return scales.morris_on_lattice; }
    static std::string detail(double /*nu*/, double /*c0*/) { return {}; }
};

}  // namespace dmp::models
