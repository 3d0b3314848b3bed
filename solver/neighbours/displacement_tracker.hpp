// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace dmp::solver {

/// Where particles stand, in arrays of any layout.
struct Positions {
    std::size_t count = 0;
    int dimension = 2;
    std::array<const double*, 3> first{};  ///< by axis: of the first particle [m]
    std::size_t stride = 1;                ///< from one particle to the next [numbers]
    std::array<double, 3> common{};        ///< what all have gone together, which does not count [m]
};

/// Where particles stood at one moment, as exact as telling how far they have gone since then needs.
class ReferencePositions {
  public:
    void take(const Positions& positions, int threads);
    /// How far the farthest has gone [m], or a little more; infinite where a place is no number.
    [[nodiscard]] double farthest_gone(const Positions& now, int threads) const;
    /// The same in lengths of each particle's own, as 1 / length^2 [1/m^2] and the shortest of them [m]: exact to their
    /// last digits.
    [[nodiscard]] double farthest_gone(const Positions& now, int threads, std::span<const float> inverse_squares,
                                       double shortest) const;
    [[nodiscard]] std::size_t bytes() const;

  private:
    int dimension_ = 2;
    std::array<std::vector<float>, 3> from_origin_;
    std::array<double, 3> origin_{};
    double inexact_ = 0;  ///< what floats cannot tell [m]
};

/// How far particles may have gone since a moment: a bound, by how fast the fastest one is at each time, until that
/// says that they went too far; then it is measured, as it is seldom the same one that is the fastest, nor goes
/// straight on.
class DisplacementTracker {
  public:
    void start() { *this = {}; }
    /// They have gone at most this much farther [m].
    void add(double distance) { farthest_ += distance; }
    [[nodiscard]] double farthest() const { return farthest_; }
    /// Whether some have gone this far, or nearly so. `measure` returns how far the farthest has gone; where ranks
    /// share particles, over all of them.
    template <class Measure>
    [[nodiscard]] bool beyond(double distance, const Measure& measure) {
        if (too_far_ || farthest_ < distance) return too_far_;
        farthest_ = std::min(farthest_, measure());
        // Measuring for the little that is left does not pay.
        too_far_ = farthest_ >= 0.8 * distance;
        return too_far_;
    }

  private:
    double farthest_ = 0;
    bool too_far_ = false;
};

}  // namespace dmp::solver
