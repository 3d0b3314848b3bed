// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "solver/spheres/sphere_step.hpp"

namespace dmp::solver {

/// The largest overlap of two spheres, or of a sphere and a wall, over the smaller radius, on this rank.
struct LargestOverlap {
    double ratio = 0;
    std::int32_t row = -1;
    bool at_wall = false;
    std::size_t touching = 0;  ///< pairs of spheres in contact, those across borders on the side of the lower id
};
LargestOverlap largest_overlap(const SphereStep& step);

/// Beyond this overlap over the smaller radius contact laws mean nothing any more.
inline constexpr double most_overlap = 0.9;

/// What is wrong with this rank's spheres, as "problem\nwhat to do"; empty: nothing.
std::string trouble_with_spheres(const SphereStep& step, const ParticleSpace& space);

}  // namespace dmp::solver
