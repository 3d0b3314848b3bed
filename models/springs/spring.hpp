// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "base/simd/vector.hpp"
#include "models/uses.hpp"

namespace dmp::models {

/// A spring sees its nodes through K arms, each from one of them to another.
template <int D, std::size_t K>
using Arms = std::array<Vector<double, D>, K>;

/// How far a spring's length or angle q is from rest, and its slope along each arm.
template <int D, std::size_t K>
struct Deviation {
    double value;         ///< q - q0 [m] or [rad]
    Arms<D, K> gradient;  ///< dq/d(arm) [1] or [rad/m]
};

/// What all springs have in common: U = k (q - q0)^2 (no 1/2) and a dashpot on dq/dt, the force on an arm's end being
///   F = -[2 k (q - q0) + c dq/dt] dq/d(arm)   [N]
/// and on its start -F. c = 2 zeta sqrt(2 k m) is the fraction zeta of critical damping of the spring alone, m the
/// reduced mass [kg] of a length, or moment of inertia [kg m^2] of an angle.
/// A law adds: its nodes and arms, `deviation(arms)` and, for implicit steps, `extra_stiffness(arms, visit)`: weights w
/// and directions g of the positive part of 2 k (q - q0) d2q/d(arm)2 ~ sum w g g^T.
struct Spring {
    double stiffness;  ///< k: [N/m] of a length, [J] of an angle
    double dashpot;    ///< c: [N s/m] of a length, [J s] of an angle

    Spring(double k, double damping, double reduced_mass)
        : stiffness(k), dashpot(2 * damping * std::sqrt(2 * k * reduced_mass)) {}
    Spring(double k, double c) : stiffness(k), dashpot(c) {}

    /// The size of the force: 2 k (q - q0) + c dq/dt.
    template <int D, std::size_t K>
    [[nodiscard]] double tension(const Deviation<D, K>& from_rest, const Arms<D, K>& arm_velocity) const {
        double rate = 0;
        for (std::size_t k = 0; k < K; ++k) rate += dot(from_rest.gradient[k], arm_velocity[k]);
        return 2 * stiffness * from_rest.value + dashpot * rate;
    }
    [[nodiscard]] double energy(double deviation) const { return stiffness * deviation * deviation; }
};

/// Node `end` minus node `start` of a spring's own numbering makes an arm.
struct ArmEnds {
    int end, start;
};

/// A unit vector at right angles to a unit vector.
inline Vector<double, 3> unit_across(const Vector<double, 3>& direction) {
    int least = 0;
    for (int axis = 1; axis < 3; ++axis)
        if (std::abs(direction[axis]) < std::abs(direction[least])) least = axis;
    Vector<double, 3> axis{};
    axis[least] = 1;
    const auto across = cross(direction, axis);
    return (1 / std::sqrt(dot(across, across))) * across;
}

}  // namespace dmp::models
