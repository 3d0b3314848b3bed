// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "particles/particle_set.hpp"
#include "solver/uses.hpp"

namespace dmp::solver {

/// Across planes of symmetry, at most one on each axis.
struct Reflection {
    std::uint8_t axes = 0;    ///< bit k: across a plane on axis k
    Vec twice = Vec::Zero();  ///< where the planes are, times two [m]

    [[nodiscard]] bool is_none() const { return axes == 0; }
    [[nodiscard]] static bool has(std::uint8_t axes, int axis) { return ((axes >> axis) & 1) != 0; }
    [[nodiscard]] static Vec of_vector(std::uint8_t axes, Vec vector) {
        for (int axis = 0; axis < 3; ++axis)
            if (has(axes, axis)) vector[axis] = -vector[axis];
        return vector;
    }
    [[nodiscard]] Vec of_vector(const Vec& vector) const { return of_vector(axes, vector); }
    [[nodiscard]] Vec of_point(const Vec& point) const { return of_vector(axes, point) + twice; }
    /// Of what this has reflected, across another plane.
    void add(int axis, double plane) {
        axes = static_cast<std::uint8_t>(axes | (1U << axis));
        twice[axis] = 2 * plane;
    }

    /// What brings a point back that is beyond planes of symmetry by more than 1e-6 spacings.
    [[nodiscard]] static Reflection back_from(const Vec& point, const ParticleSpace& space);
    /// On how many planes of symmetry it lies, to 1e-6 spacings.
    [[nodiscard]] static int planes_through(const Vec& point, const ParticleSpace& space);
};

/// A drawn point, or its image beyond planes of symmetry.
struct DrawnPoint {
    int source = 0;  ///< the number of the point that it is the image of; its own
    Reflection reflection{};
};

/// Adds the images of drawn points and pieces beyond planes of symmetry to those of the space, where bodies and walls
/// go on; of walls what is within `walls_within` [m] of a plane. Points on a plane are their own images. Returns what
/// each point is.
std::vector<DrawnPoint> add_images(ParticleSpace& space, double walls_within);

}  // namespace dmp::solver
