// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <limits>
#include <type_traits>

#include "models/pair.hpp"

namespace dmp::models {

/// A viscous force along the line between two particles, the common form of Monaghan's and Cleary's laws:
///   F_i = SUM_j V_i V_j S 2 mu_ij (1/r dW/dr) (v_ij . x_ij) / (r^2 + 0.01 h^2) x_ij   [N],   h = support / 2
/// Conserves linear and angular momentum. In the continuum with S = D + 2, the viscosity is 3 mu for compression
/// waves and mu for shear.
struct CentralViscosity {
    double strength;   ///< S [-]
    double softening;  ///< 0.01 h^2 [m^2]
    double
        largest_approach;  ///< upper bound of v_ij . x_ij in the force: 0 (approaching pairs only) or infinite [m^2/s]

    CentralViscosity(double strength_of_pairs, double support, bool approaching_only)
        : strength(strength_of_pairs),
          softening(0.01 * 0.25 * support * support),
          largest_approach(approaching_only ? 0.0 : std::numeric_limits<double>::infinity()) {}

    template <class P, class T>
    [[nodiscard]] auto law(const P& p, const T& twice_mean) const {
        using std::min;
        const auto opening = dot(p.i.velocity - p.j.velocity, p.separation);
        using Scalar = std::remove_const_t<decltype(opening)>;
        const auto counted = min(opening, Scalar(largest_approach));
        const auto distance_square = dot(p.separation, p.separation) + softening;
        return (p.weight() * strength * twice_mean * (counted / distance_square)) * p.separation;
    }
};

}  // namespace dmp::models
