// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <cmath>

#include "base/vec.hpp"

namespace dmp::particles {

/// phi of a Dihedral with these arms, a - b, b - c and d - c, in (-pi, pi] [rad].
inline double dihedral_angle(const Vec& from_b, const Vec& axis, const Vec& from_c) {
    const Vec first = from_b.cross(axis), second = from_c.cross(axis);
    return std::atan2(second.cross(first).dot(axis) / axis.norm(), first.dot(second));
}

/// The same over these places.
inline double dihedral_angle(const Vec& a, const Vec& b, const Vec& c, const Vec& d) {
    return dihedral_angle(a - b, b - c, d - c);
}

}  // namespace dmp::particles
