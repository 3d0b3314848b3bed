// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <numbers>

namespace dmp::models {

/// The dashpot that gives a Hertz contact the restitution e at any speed, size and stiffness (Tsuji, Tanaka & Ishida
/// 1992):
///   F = k_n a d - alpha sqrt(k_n m* a) v,   a = sqrt(R* d),   v = -dd/dt,   alpha = sqrt(5) zeta
/// With u = d^(5/4) and dT = d^(1/4) dt this is a linear spring and dashpot of damping ratio zeta (Antypov & Elliott,
/// EPL 94, 2011), for which the impact has a closed form: until the overlap ends, if the dashpot may pull shortly
/// before,
///   e = exp(-pi zeta / sqrt(1 - zeta^2))
/// and until the force ends (Schwager & Poeschel, Granul. Matter 9, 2007)
///   e = exp(-2 zeta acos(zeta) / sqrt(1 - zeta^2)),   acosh(zeta) / sqrt(zeta^2 - 1) from zeta = 1 on
struct RestitutionDashpot {
    /// zeta of a dashpot that may pull; 0 < e <= 1.
    static double ratio_with_pull(double restitution) {
        const double logarithm = std::log(restitution);
        return -logarithm / std::hypot(logarithm, std::numbers::pi);
    }

    /// zeta of a force that is cut off at 0; 0 < e <= 1. Bisection to machine precision.
    static double ratio_without_pull(double restitution) {
        if (restitution == 1) return 0;
        double low = 0, high = 1;
        while (rebound(high) > restitution) high *= 2;
        for (double middle = high / 2; middle > low && middle < high; middle = (low + high) / 2)
            (rebound(middle) > restitution ? low : high) = middle;
        return high;
    }

    /// e of a force that is cut off at 0.
    static double rebound(double ratio) {
        const double square = (1 - ratio) * (1 + ratio);
        if (std::abs(square) < 1e-12) return std::exp(-2.0);
        const double root = std::sqrt(std::abs(square));
        return std::exp(-2 * ratio * (square > 0 ? std::acos(ratio) : std::acosh(ratio)) / root);
    }

    /// Factor of sqrt(m* a) in the normal dashpot: alpha sqrt(k_n) [Pa^(1/2)].
    static double normal(double ratio, double normal_stiffness) { return std::sqrt(5 * normal_stiffness) * ratio; }

    /// The tangential dashpot has the same ratio to its critical damping: 2 zeta sqrt(5/6) sqrt(k_t) [Pa^(1/2)].
    static double tangential(double ratio, double tangential_stiffness) {
        return std::sqrt(10.0 / 3 * tangential_stiffness) * ratio;
    }
};

}  // namespace dmp::models
