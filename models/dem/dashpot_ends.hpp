// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

namespace dmp::models {

inline bool any_less(double a, double b) { return a < b; }

/// Weights of the first and the last step of an impact for a dashpot that grows with the overlap as d^(1/4). Near the
/// ends of an impact, d is p, p + 1, p + 2, ... times the distance travelled in one step, 0 < p <= 1, depending on
/// the instant of first touch within a step, and the steps add up (p + k)^(1/4). The integral from first touch is
/// that sum less zeta(-1/4, p), Hurwitz' zeta function (Navot, J. Math. Phys. 40 (1961) 271): the step with p must
/// contribute
///   -zeta(-1/4, 1 + p) = 4/5 a^(5/4) - 1/2 a^(1/4) + 1/48 a^(-3/4) - ...,   a = 1 + p
/// instead of p^(1/4). With a weight of one, 20 steps in a contact give a restitution of 0.6 to within 0.0135.
struct DashpotEnds {
    /// Factor of the dashpot; 1 if the overlap exceeds the distance `way` travelled in a step [m].
    template <class T>
    static T weight(const T& overlap, const T& way) {
        using std::sqrt;
        const T one(1.0), smallest(1e-12);
        const T part = overlap / where_less(overlap, way, way, one);
        const T p = where_less(part, smallest, smallest, part), a = one + p, root = sqrt(sqrt(a));
        const T count = root * (0.8 * a - 0.5 + T(1.0 / 48) / a);
        return where_less(overlap, way, count / sqrt(sqrt(p)), one);
    }
};

}  // namespace dmp::models
