// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace dmp::models {

/// Density of particle i as a sum over its neighbours and itself (Monaghan 1992, eq. 2.9), instead of ContinuityRate:
///   rho_i = SUM_j m_j W_ij   [kg/m^3],   m_j = rho0_i V_j of a solid particle j, rho0_i the fluid's own rest density
/// The density then depends only on positions, does not drift over time and needs no diffusion. It is too low at a
/// free surface, and is smeared over the support where fluids of different density meet. On a lattice at rest it
/// differs by the kernel's sum (5e-3 for Wendland's C2 over 3 spacings), which acts as a uniform pressure.
struct SummationDensity {
    /// One term of the sum: the mass of j as defined for i [kg], and W_ij [1/m^D].
    template <class T, class U>
    static auto law(const T& mass, const U& kernel_value) {
        return mass * kernel_value;
    }
};

}  // namespace dmp::models
