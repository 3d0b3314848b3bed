// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>

#include "base/simd/lanes.hpp"
#include "base/simd/vector.hpp"
#include "models/uses.hpp"

namespace dmp::models {

/// The state of a sphere that contact laws use. T is double, or Lanes for several spheres in SIMD lanes.
template <class T>
struct SpherePoint {
    Vector<T, 3> velocity, spin;  ///< [m/s], [1/s]
    T radius, mass;               ///< [m], [kg]
};

/// Two spheres, or a sphere and a wall; a law returns its effect on i. j is the other sphere or the wall.
template <class T>
struct Contact {
    T overlap;                   ///< d = R_i + R_j - r, or R_i less the distance to the wall; negative: a gap [m]
    Vector<T, 3> normal;         ///< n: the unit vector from j to i
    T radius;                    ///< R* = R_i R_j / (R_i + R_j); R_i at a wall [m]
    T mass;                      ///< m* = m_i m_j / (m_i + m_j); m_i at a wall [kg]
    T normal_velocity;           ///< (v_i - v_j) . n: positive while they separate [m/s]
    Vector<T, 3> slip;           ///< velocity of i's surface relative to j's, perpendicular to n [m/s]
    Vector<T, 3> relative_spin;  ///< omega_i - omega_j [1/s]; used only by rolling friction
};

/// Force and torque on i; the opposite force and the opposite rolling torque act on j.
template <class T>
struct ContactForce {
    T normal;                 ///< along n: positive if repulsive [N]
    Vector<T, 3> tangential;  ///< perpendicular to n [N]
    Vector<T, 3> rolling;     ///< torque on i in addition to that of the tangential force [N m]

    [[nodiscard]] Vector<T, 3> on_i(const Vector<T, 3>& n) const { return normal * n + tangential; }
    /// Torque of the tangential force on i or j, whose lever arm is `arm` (see Levers), without rolling friction.
    [[nodiscard]] Vector<T, 3> torque(const T& arm, const Vector<T, 3>& n) const { return -arm * cross(n, tangential); }
};

/// Values that a contact keeps from step to step, all zero when it begins and after it has ended. First come vectors
/// of three values each, whose sign changes when i and j are exchanged, then numbers that do not change.
template <class T, int N>
using ContactHistory = std::array<T, static_cast<std::size_t>(N)>;

/// Distances from the centres of i and j to the contact point [m]; for a wall, that of j is unused.
template <class T>
struct Levers {
    T i, j;
};

/// The contact of two spheres. `separation` is x_i - x_j, `distance` > 0 its length.
template <class Law, class T>
Contact<T> contact_of_spheres(const SpherePoint<T>& i, const SpherePoint<T>& j, const Vector<T, 3>& separation,
                              const T& distance) {
    const T overlap = i.radius + j.radius - distance;
    const T radius = i.radius * j.radius / (i.radius + j.radius);
    const Vector<T, 3> normal = (T(1.0) / distance) * separation;
    const Vector<T, 3> relative = i.velocity - j.velocity;
    const T normal_velocity = dot(relative, normal);
    const Levers<T> arm{Law::lever(i.radius, radius, overlap), Law::lever(j.radius, radius, overlap)};
    const Vector<T, 3> around = arm.i * i.spin + arm.j * j.spin;
    return {overlap,         normal,
            radius,          i.mass * j.mass / (i.mass + j.mass),
            normal_velocity, relative - normal_velocity * normal - cross(around, normal),
            i.spin - j.spin};
}

/// The contact of a sphere and a wall of infinite mass, whose surface moves with `velocity` at the contact and
/// rotates with `spin`. `normal` is the unit vector from the wall to the sphere's centre, `distance` the distance
/// between them.
template <class Law, class T>
Contact<T> contact_with_wall(const SpherePoint<T>& i, const Vector<T, 3>& normal, const T& distance,
                             const Vector<T, 3>& velocity, const Vector<T, 3>& spin) {
    const T overlap = i.radius - distance;
    const Vector<T, 3> relative = i.velocity - velocity;
    const T normal_velocity = dot(relative, normal);
    const Vector<T, 3> around = Law::lever(i.radius, i.radius, overlap) * i.spin;
    return {overlap,      normal,          i.radius,
            i.mass,       normal_velocity, relative - normal_velocity * normal - cross(around, normal),
            i.spin - spin};
}

}  // namespace dmp::models
