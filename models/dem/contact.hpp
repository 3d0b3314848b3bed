// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>

#include "base/simd/lanes.hpp"
#include "base/simd/vector.hpp"
#include "models/uses.hpp"

namespace dmp::models {

/// A sphere as contact laws see it. T is double, or Lanes for spheres side by side.
template <class T>
struct SpherePoint {
    Vector<T, 3> velocity, spin;  ///< [m/s], [1/s]
    T radius, mass;               ///< [m], [kg]
};

/// Two spheres that meet, or a sphere and a wall: i is the one acted upon, j the other or the wall.
template <class T>
struct Contact {
    T overlap;                   ///< d = R_i + R_j - r, or R_i less the distance to the wall; below 0: a gap [m]
    Vector<T, 3> normal;         ///< n: the unit vector from j to i
    T radius;                    ///< R* = R_i R_j / (R_i + R_j); R_i at a wall [m]
    T mass;                      ///< m* = m_i m_j / (m_i + m_j); m_i at a wall [kg]
    T normal_velocity;           ///< (v_i - v_j) . n: above 0 while they part [m/s]
    Vector<T, 3> slip;           ///< of i's surface over j's, across n [m/s]
    Vector<T, 3> relative_spin;  ///< omega_i - omega_j [1/s]; rolling friction alone looks at it
};

/// What the contact does to i; j takes the opposite force and the opposite rolling torque.
template <class T>
struct ContactForce {
    T normal;                 ///< along n: above 0 where it pushes them apart [N]
    Vector<T, 3> tangential;  ///< across n [N]
    Vector<T, 3> rolling;     ///< torque on i besides that of the tangential force [N m]

    [[nodiscard]] Vector<T, 3> on_i(const Vector<T, 3>& n) const { return normal * n + tangential; }
    /// On i, or on j, whose lever `arm` is (see levers); rolling friction comes on top.
    [[nodiscard]] Vector<T, 3> torque(const T& arm, const Vector<T, 3>& n) const { return -arm * cross(n, tangential); }
};

/// What a contact remembers from step to step: all zero when it begins, and again once it has ended.
/// The first values are vectors, three each, whose sign changes when i and j change their parts; the rest are numbers
/// that do not.
template <class T, int N>
using ContactHistory = std::array<T, static_cast<std::size_t>(N)>;

/// From the centres of i and j to their contact [m]; j's is without meaning at a wall.
template <class T>
struct Levers {
    T i, j;
};

/// The contact of two spheres. `separation` is x_i - x_j, `distance` its length, above 0.
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

/// The contact of a sphere and a wall of infinite mass, whose surface moves with `velocity` at the contact and turns
/// with `spin`. `normal` is the unit vector from the wall to the sphere's centre, `distance` that between them.
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
