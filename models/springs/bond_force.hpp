// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "models/springs/spring.hpp"

namespace dmp::models {

/// A harmonic bond between nodes a and b with a dashpot along it: U = k_b (r - r0)^2 (no 1/2),
///   F_a = -[2 k_b (r - r0) + c (v_a - v_b) . e] e,   e = (x_a - x_b) / r,   F_b = -F_a   [N]
/// See Spring for the dashpot; its mass is the reduced mass of the two nodes.
template <int D>
struct BondForce : Spring {
    static constexpr int nodes = 2;                          ///< a, b
    static constexpr std::array<ArmEnds, 1> arms{{{0, 1}}};  ///< x_a - x_b

    double rest_length;  ///< r0 [m]

    BondForce(double r0, double k_b, double damping, double reduced_mass)
        : BondForce(r0, Spring(k_b, damping, reduced_mass)) {}
    BondForce(double r0, const Spring& spring) : Spring(spring), rest_length(r0) {}

    [[nodiscard]] Deviation<D, 1> deviation(const Arms<D, 1>& arm) const {
        const double length = std::sqrt(dot(arm[0], arm[0]));
        return {length - rest_length, {(1 / length) * arm[0]}};
    }

    /// A bond under tension has the lateral stiffness 2 k_b (r - r0) / r (that of a compressed bond is negative and
    /// is left out). Visits the directions across the bond.
    template <class Visit>
    void extra_stiffness(const Arms<D, 1>& arm, const Visit& visit) const {
        const auto [stretch, gradient] = deviation(arm);
        if (!(stretch > 0)) return;
        const double weight = 2 * stiffness * stretch / (stretch + rest_length);
        // I - e e^T from an orthonormal basis perpendicular to e.
        Arms<D, 1> across{};
        if constexpr (D == 2) {
            across[0] = {{-gradient[0][1], gradient[0][0]}};
            visit(weight, across);
        } else {
            const auto first = unit_across(gradient[0]);
            across[0] = first;
            visit(weight, across);
            across[0] = cross(gradient[0], first);
            visit(weight, across);
        }
    }
};

}  // namespace dmp::models
