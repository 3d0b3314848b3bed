// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "particles/particle_set.hpp"

namespace dmp::particles {

/// Two spheres that touch or lie in each other.
struct TouchingSpheres {
    int a = 0, b = 0;    ///< particles, a < b; the same twice for a sphere that reaches around a period
    double overlap = 0;  ///< sum of the radii less the distance of the centres, >= 0 [m]
};

/// All pairs of spheres that touch, periods counted, by a and then b. The work grows with the number of spheres and of
/// pairs whatever the mix of radii: each size class has its own grid, and larger spheres look for smaller ones.
std::vector<TouchingSpheres> touching_spheres(const ParticleSet& set);

}  // namespace dmp::particles
