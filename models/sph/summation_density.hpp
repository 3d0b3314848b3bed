// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace dmp::models {

/// Density of particle i as a sum over its neighbours and itself (Monaghan 1992, eq. 2.9), in place of ContinuityRate:
///   rho_i = SUM_j m_j W_ij   [kg/m^3],   m_j = rho0_i V_j of a solid particle j, rho0_i the fluid's own rest density
/// Density then follows from the places alone, does not drift over time and needs no diffusion. It falls short at a
/// free surface, and is smeared out over the support where fluids of unlike density meet. On a lattice at rest it is
/// off by the kernel's sum (5e-3 for Wendland's C2 over 3 spacings), which acts as a pressure that is the same
/// everywhere.
struct SummationDensity {
    /// One term of the sum: the mass of j, as i counts it [kg], and W_ij [1/m^D].
    template <class T, class U>
    static auto law(const T& mass, const U& kernel_value) {
        return mass * kernel_value;
    }
};

}  // namespace dmp::models
