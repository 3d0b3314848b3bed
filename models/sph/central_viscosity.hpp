// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <limits>
#include <type_traits>

#include "models/pair.hpp"

namespace dmp::models {

/// A viscous force along the line between two particles, which Monaghan's and Cleary's laws share:
///   F_i = SUM_j V_i V_j S 2 mu_ij (1/r dW/dr) (v_ij . x_ij) / (r^2 + 0.01 h^2) x_ij   [N],   h = support / 2
/// Conserves linear and angular momentum. In the continuum waves of compression meet 3 mu and shear mu with S = D + 2.
struct CentralViscosity {
    double strength;          ///< S [-]
    double softening;         ///< 0.01 h^2 [m^2]
    double largest_approach;  ///< v_ij . x_ij beyond which a pair does not count: 0 or infinite [m^2/s]

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
