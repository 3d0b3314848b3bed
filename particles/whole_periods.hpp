// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "particles/particle_set.hpp"

namespace dmp::particles {

/// The whole periods that are added to the vector between two points to make it the shortest [m]: nearest_image() less
/// the vector.
inline Vec periods_to_nearest(const Vec& apart, const ParticleSpace& space) {
    Vec periods = Vec::Zero();
    for (int axis = 0; axis < space.dimension; ++axis) {
        if (!space.periodic[static_cast<std::size_t>(axis)]) continue;
        const double period = space.box.extent()[axis];
        periods[axis] = -period * std::round(apart[axis] / period);
    }
    return periods;
}

}  // namespace dmp::particles
