// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <limits>

#include "models/contact/repulsion.hpp"

namespace dmp::models {

/// -dF/dr of a pair that repels [N/m]: K / r^2 [13 (r*/r)^12 - 7 (r*/r)^6] for r < r*, 0 beyond. 6 K / r*^2 at touch,
/// 75 times that at 0.77 r*: a step that is short enough for particles that touch is not for those that are pressed
/// together.
inline double contact_stiffness(const Repulsion& repulsion, double distance_square, double range) {
    const double q = range * range / distance_square;
    if (!(q > 1)) return 0;
    const double q6 = q * q * q;
    return repulsion.strength * (13 * q6 * q6 - 7 * q6) / distance_square;
}

/// What a contact of stiffness k adds to the bound of the square of the highest frequency [1/s^2]: of the matrix k_ij /
/// sqrt(m_i m_j) no eigenvalue exceeds the largest sum of a row, SUM_j k_ij [1/m_i + 1/sqrt(m_i m_j)] (Gershgorin).
/// Inverse masses [1/kg], 0 for what is held.
inline double contact_rate(double stiffness, double inverse_mass, double inverse_mass_of_other) {
    return stiffness * (inverse_mass + std::sqrt(inverse_mass * inverse_mass_of_other));
}

/// Largest stable step [s] for a bound of the square of the highest frequency [1/s^2]: half of 2 / omega, since a
/// contact gets stiffer while a step goes on.
inline double contact_step_limit(double largest_rate) {
    return largest_rate > 0 ? 0.5 * 2 / std::sqrt(largest_rate) : std::numeric_limits<double>::infinity();
}

}  // namespace dmp::models
