// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace dmp::solver {

/// Particle positions, in arrays of any layout.
struct Positions {
    std::size_t count = 0;
    int dimension = 2;
    std::array<const double*, 3> first{};  ///< by axis: coordinate of the first particle [m]
    std::size_t stride = 1;                ///< from one particle to the next, in doubles
    std::array<double, 3> common{};        ///< common displacement of all particles, to be ignored [m]
};

/// Particle positions at one moment, stored as precisely as displacements since then require.
class ReferencePositions {
  public:
    void take(const Positions& positions, int threads);
    /// The largest displacement [m] or slightly more; infinite if a position is NaN.
    [[nodiscard]] double farthest_gone(const Positions& now, int threads) const;
    /// The same with each displacement in units of the particle's own length, given as 1 / length^2 [1/m^2], with the
    /// shortest length [m]; accurate to the last digits.
    [[nodiscard]] double farthest_gone(const Positions& now, int threads, std::span<const float> inverse_squares,
                                       double shortest) const;
    [[nodiscard]] std::size_t bytes() const;

  private:
    int dimension_ = 2;
    std::array<std::vector<float>, 3> from_origin_;
    std::array<double, 3> origin_{};
    double inexact_ = 0;  ///< rounding error of the floats [m]
};

/// An upper bound of the particles' displacement since a moment. It adds up the distance covered by the fastest
/// particle at each time. When this sum reaches a given distance, the displacement is measured: it is usually
/// smaller, because the fastest particle is seldom the same one and does not move straight.
class DisplacementTracker {
  public:
    void start() { *this = {}; }
    /// Particles have moved by at most this additional distance [m].
    void add(double distance) { farthest_ += distance; }
    [[nodiscard]] double farthest() const { return farthest_; }
    /// True if particles have moved this far, or nearly so. `measure` returns the largest displacement, over all
    /// ranks if several share the particles.
    template <class Measure>
    [[nodiscard]] bool beyond(double distance, const Measure& measure) {
        if (too_far_ || farthest_ < distance) return too_far_;
        farthest_ = std::min(farthest_, measure());
        // Close to the limit, measuring again and again does not pay.
        too_far_ = farthest_ >= 0.8 * distance;
        return too_far_;
    }

  private:
    double farthest_ = 0;
    bool too_far_ = false;
};

}  // namespace dmp::solver
