// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>

namespace dmp::models {

/// Constants of contact laws that depend only on the two materials. T is double, or Lanes for contacts of several
/// pairs of materials in SIMD lanes. A value of zero switches its term off. With the contact radius a = sqrt(R* d)
/// and effective mass m*, a dashpot is
///   c = dashpot sqrt(m* a) + rate m* a   [N s/m]
template <class T = double>
struct ContactConstants {
    T normal_stiffness = T(0.0);                                   ///< k_n: F = k_n a d [Pa]
    T tangential_stiffness = T(0.0);                               ///< k_t: F = k_t a xi [Pa]
    T normal_dashpot = T(0.0);                                     ///< from the restitution [Pa^(1/2)]
    T tangential_dashpot = T(0.0);                                 ///< [Pa^(1/2)]
    T normal_rate = T(0.0);                                        ///< g_n, from coefficients [1/(m s)]
    T tangential_rate = T(0.0);                                    ///< g_t [1/(m s)]
    T least_normal = T(-std::numeric_limits<double>::infinity());  ///< 0 if the dashpot may not pull, else -infinity
    T friction = T(0.0);                                           ///< Coulomb's mu [1]
    T rolling_friction = T(0.0);                                   ///< mu_r [1]
    T rolling_damping = T(0.0);                                    ///< of the rolling spring, fraction of critical [1]
    T adhesion_energy = T(0.0);                                    ///< W of the pair of surfaces [J/m^2]
    T adhesion_distance = T(0.0);                                  ///< Bradley's z0 [m]
    T adhesion_range = T(0.0);                                     ///< gap at which Bradley's force is cut off [m]
};

}  // namespace dmp::models
