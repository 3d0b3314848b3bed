// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <limits>

#include "models/contact/repulsion.hpp"

namespace dmp::models {

/// -dF/dr of a repelling pair [N/m]: K / r^2 [13 (r*/r)^12 - 7 (r*/r)^6] for r < r*, 0 beyond. It is 6 K / r*^2 at
/// first touch and 75 times that at 0.77 r*: a step that is short enough for particles that just touch is too long
/// for compressed ones.
inline double contact_stiffness(const Repulsion& repulsion, double distance_square, double range) {
    const double q = range * range / distance_square;
    if (!(q > 1)) return 0;
    const double q6 = q * q * q;
    return repulsion.strength * (13 * q6 * q6 - 7 * q6) / distance_square;
}

/// The contribution of a contact of stiffness k to the bound on the square of the highest frequency [1/s^2]: no
/// eigenvalue of the matrix k_ij / sqrt(m_i m_j) exceeds the largest row sum, SUM_j k_ij [1/m_i + 1/sqrt(m_i m_j)]
/// (Gershgorin). Inverse masses [1/kg], 0 for held particles.
inline double contact_rate(double stiffness, double inverse_mass, double inverse_mass_of_other) {
    return stiffness * (inverse_mass + std::sqrt(inverse_mass * inverse_mass_of_other));
}

/// Largest stable step [s] for a bound on the square of the highest frequency [1/s^2]: 2 / omega; a contact
/// becomes stiffer during a step.
inline double contact_step_limit(double largest_rate) {
    return largest_rate > 0 ? 2 / std::sqrt(largest_rate) : std::numeric_limits<double>::infinity();
}

}  // namespace dmp::models
