// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <cmath>

#include "base/vec.hpp"

namespace dmp::particles {

/// phi of a Dihedral over these places, in (-pi, pi] [rad].
inline double dihedral_angle(const Vec& a, const Vec& b, const Vec& c, const Vec& d) {
    const Vec axis = b - c, first = (a - b).cross(axis), second = (d - c).cross(axis);
    return std::atan2(second.cross(first).dot(axis) / axis.norm(), first.dot(second));
}

}  // namespace dmp::particles
