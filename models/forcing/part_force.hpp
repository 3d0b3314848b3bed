// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstddef>

namespace dmp::models {

/// A force on a part that the scene prescribes, F(t, x) [N].
///   per particle: each particle takes F;  total: the N particles of the part take F / N each.
/// What it does to the momentum, the integral of the sum of F over the particles, is part of the body forces' impulse.
/// It has no energy of its own: F may depend on time.
struct PartForce {
    bool total = false;
    std::size_t particles = 1;  ///< of the part, held ones among them, on all ranks

    /// Of F on one particle [N].
    [[nodiscard]] double share(double force) const { return total ? force / static_cast<double>(particles) : force; }
    /// A quarter of the time in which the acceleration a moves a particle at rest by `length`: as the body force's
    /// limit.
    static double step_limit(double length, double acceleration) {
        return 0.25 * std::sqrt(0.5 * length / acceleration);
    }
};

}  // namespace dmp::models
