// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "solver/models/pair.hpp"

namespace dmp {

/// A harmonic bond with a dashpot along it: U = k_b (r - r0)^2 (no 1/2),
///   F_a = -[2 k_b (r - r0) + c (v_a - v_b) . e] e,   e = (x_a - x_b) / r,   F_b = -F_a   [N]
/// c = 2 zeta sqrt(2 k_b m_eff) is the fraction zeta of critical damping of the bond alone, m_eff the reduced mass.
template <int D>
struct BondForce {
    double rest_length, stiffness, dashpot;

    BondForce(double r0, double k_b, double damping, double reduced_mass)
        : rest_length(r0), stiffness(k_b), dashpot(2 * damping * std::sqrt(2 * k_b * reduced_mass)) {}

    /// Force on a, from x_a - x_b and v_a - v_b.
    [[nodiscard]] Vector<double, D> law(const Vector<double, D>& separation,
                                        const Vector<double, D>& relative_velocity) const {
        const double length = std::sqrt(dot(separation, separation));
        const double inverse = 1 / length;
        const double rate = dot(relative_velocity, separation) * inverse;
        return (-(2 * stiffness * (length - rest_length) + dashpot * rate) * inverse) * separation;
    }
    [[nodiscard]] double energy(double length) const {
        return stiffness * (length - rest_length) * (length - rest_length);
    }
};

}  // namespace dmp
