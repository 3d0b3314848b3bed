// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>

namespace dmp::models {

/// The numbers of contact laws that follow from the two materials, the same for all spheres of them. T is double, or
/// Lanes where contacts of several pairs of materials lie side by side. What is zero is off.
/// With the contact's radius a = sqrt(R* d) and effective mass m*, dashpots are
///   c = dashpot sqrt(m* a) + rate m* a   [N s/m]
template <class T = double>
struct ContactConstants {
    T normal_stiffness = T(0.0);                                   ///< k_n: F = k_n a d [Pa]
    T tangential_stiffness = T(0.0);                               ///< k_t: F = k_t a xi [Pa]
    T normal_dashpot = T(0.0);                                     ///< from a restitution [Pa^(1/2)]
    T tangential_dashpot = T(0.0);                                 ///< [Pa^(1/2)]
    T normal_rate = T(0.0);                                        ///< g_n, from coefficients [1/(m s)]
    T tangential_rate = T(0.0);                                    ///< g_t [1/(m s)]
    T least_normal = T(-std::numeric_limits<double>::infinity());  ///< 0 where the dashpot may not pull, else -infinity
    T friction = T(0.0);                                           ///< mu, Coulomb's [1]
    T rolling_friction = T(0.0);                                   ///< mu_r [1]
    T rolling_damping = T(0.0);                                    ///< of the rolling spring, of critical [1]
    T adhesion_energy = T(0.0);                                    ///< W of the two surfaces together [J/m^2]
    T adhesion_distance = T(0.0);                                  ///< Bradley's z0 [m]
    T adhesion_range = T(0.0);                                     ///< gap at which Bradley's force is cut off [m]
};

}  // namespace dmp::models
