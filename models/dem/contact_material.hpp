// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "models/dem/contact_constants.hpp"

namespace dmp::models {

/// The material of a sphere or a wall.
struct ContactMaterial {
    double young_modulus;  ///< E [Pa]; infinity: rigid
    double poisson_ratio;  ///< nu, above -1 and at most 1/2 [1]
};

enum class ContactDamping {
    restitution,          ///< the dashpot may pull just before the contact ends
    restitution_no_pull,  ///< the dashpot may not pull
    coefficients,         ///< g_n, g_t
};

/// Settings of a pair of materials, apart from its elasticity.
struct ContactSettings {
    double normal_stiffness_factor = 1;      ///< of k_n = 4/3 E* [1]
    double tangential_stiffness_factor = 1;  ///< of k_t = 8 G* [1]
    ContactDamping damping = ContactDamping::restitution;
    double restitution = 1;            ///< e, above 0 and at most 1 [1]
    double normal_rate = 0;            ///< g_n [1/(m s)]
    double tangential_rate = 0;        ///< g_t [1/(m s)]
    double friction = 0;               ///< mu [1]
    double rolling_friction = 0;       ///< mu_r [1]
    double rolling_damping = 0.3;      ///< of the rolling spring, fraction of critical [1]
    double adhesion_energy = 0;        ///< W of both surfaces: 2 gamma for equal ones [J/m^2]
    double adhesion_distance = 4e-10;  ///< z0 of Bradley's force [m]
    double adhesion_range = 2e-8;      ///< gap at which it is cut off [m]
};

/// The constants of contacts between two materials: k_n = 4/3 E*, k_t = 8 G*, times their factors.
///   1/E* = (1 - nu_i^2)/E_i + (1 - nu_j^2)/E_j,   1/G* = (2 - nu_i)/G_i + (2 - nu_j)/G_j,   G = E / (2 (1 + nu))
/// Throws InputError with the value that is out of its bounds, or if both materials are rigid.
ContactConstants<> contact_constants(const ContactMaterial& i, const ContactMaterial& j,
                                     const ContactSettings& settings);

}  // namespace dmp::models
