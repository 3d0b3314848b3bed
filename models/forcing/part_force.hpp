// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstddef>

namespace dmp::models {

/// A prescribed force on a part, F(t, x) [N].
///   per particle: F acts on each particle;  total: F / N acts on each of the N particles of the part, where their
///   volumes differ F V / SUM V, V / mean V times as much.
/// Its contribution to the momentum, the integral of the sum of F over the particles, is part of the impulse of the
/// body forces. It has no potential energy, since F may depend on time.
struct PartForce {
    bool total = false;
    std::size_t particles = 1;  ///< of the part, on all ranks, including held particles

    /// The force on one particle [N].
    [[nodiscard]] double share(double force) const { return total ? force / static_cast<double>(particles) : force; }
    /// A quarter of the time in which the acceleration a moves a particle by `length` from rest, as for body forces.
    static double step_limit(double length, double acceleration) {
        return 0.25 * std::sqrt(0.5 * length / acceleration);
    }
};

}  // namespace dmp::models
