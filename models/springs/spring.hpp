// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "base/simd/vector.hpp"
#include "models/uses.hpp"

namespace dmp::models {

/// The K arms of a spring: vectors from one of its nodes to another.
template <int D, std::size_t K>
using Arms = std::array<Vector<double, D>, K>;

/// Deviation of a spring's length or angle q from its rest value, and its derivative with respect to each arm.
template <int D, std::size_t K>
struct Deviation {
    double value;         ///< q - q0 [m] or [rad]
    Arms<D, K> gradient;  ///< dq/d(arm) [1] or [rad/m]
};

/// Common part of all springs: U = k (q - q0)^2 (no 1/2) and a dashpot on dq/dt. The force on an arm's end is
///   F = -[2 k (q - q0) + c dq/dt] dq/d(arm)   [N]
/// and on its start -F. c = 2 zeta sqrt(2 k m), where zeta is the fraction of critical damping of the spring alone
/// and m the reduced mass [kg] for a length, or the moment of inertia [kg m^2] for an angle. A law adds its nodes and
/// arms, `deviation(arms)` and, for implicit steps, `extra_stiffness(arms, visit)`: weights w and directions g of the
/// positive part of 2 k (q - q0) d2q/d(arm)2 ~ sum w g g^T.
struct Spring {
    double stiffness;  ///< k: [N/m] for a length, [J] for an angle
    double dashpot;    ///< c: [N s/m] for a length, [J s] for an angle

    Spring(double k, double damping, double reduced_mass)
        : stiffness(k), dashpot(2 * damping * std::sqrt(2 * k * reduced_mass)) {}
    Spring(double k, double c) : stiffness(k), dashpot(c) {}

    /// Magnitude of the force (or moment): 2 k (q - q0) + c dq/dt.
    template <int D, std::size_t K>
    [[nodiscard]] double tension(const Deviation<D, K>& from_rest, const Arms<D, K>& arm_velocity) const {
        double rate = 0;
        for (std::size_t k = 0; k < K; ++k) rate += dot(from_rest.gradient[k], arm_velocity[k]);
        return 2 * stiffness * from_rest.value + dashpot * rate;
    }
    [[nodiscard]] double energy(double deviation) const { return stiffness * deviation * deviation; }
};

/// An arm: position of node `end` minus position of node `start`, as numbered in the spring.
struct ArmEnds {
    int end, start;
};

/// A unit vector perpendicular to a unit vector.
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
