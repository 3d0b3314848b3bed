// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "base/simd/lanes.hpp"
#include "models/pair.hpp"
#include "models/uses.hpp"

namespace dmp::models {

/// Short-range repulsion that separates particles of different bodies (Monaghan 1994, exponents 12 and 6):
///   F_i = K [(r*/r)^12 - (r*/r)^6] x_ij / r^2   for r < r*,   0 beyond   [N]
/// It is cut off at r*, where attraction would begin. Energy per pair U(r) = K [(r*/r)^12/12 - (r*/r)^6/6 + 1/12].
struct Repulsion {
    double strength;  ///< K [J]

    /// `range` is r* of the pair [m]; 0 for pairs without contact.
    template <class T, class Separation>
    [[nodiscard]] auto law(const Separation& separation, const T& range) const {
        const auto distance_square = dot(separation, separation);
        const auto range_square = range * range;
        const auto q = range_square / distance_square;
        const auto q6 = q * q * q;
        const auto over_square = strength * (q6 * q6 - q6) / distance_square;
        using Scalar = std::remove_const_t<decltype(over_square)>;
        return where_less(Scalar(distance_square), Scalar(range_square), Scalar(over_square), Scalar(0.0)) * separation;
    }

    [[nodiscard]] double energy(double distance, double range) const {
        if (distance >= range) return 0;
        const double q6 = std::pow(range / distance, 6);
        return strength * (q6 * q6 / 12 - q6 / 6 + 1.0 / 12);
    }

    /// Largest stable step [s]: 2 / omega for the stiffness 6 K / r*^2 at first touch and the lighter mass of
    /// the pair, with both particles free.
    [[nodiscard]] double step_limit(double range, double lightest_mass) const {
        return 2 / std::sqrt(2 * 6 * strength / (range * range) / lightest_mass);
    }
};

}  // namespace dmp::models
