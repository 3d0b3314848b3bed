// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "solver/domain/domain.hpp"

namespace dmp::solver {

/// Maps a particle to its ghost, axis by axis: x becomes x + shift, or shift - x where the axis is mirrored.
struct HaloImage {
    std::array<double, 3> shift{};  ///< whole periods, or twice the position of the plane [m]
    std::array<bool, 3> mirrored{};
    [[nodiscard]] double position(double x, int axis) const { return (mirrored[axis] ? -x : x) + shift[axis]; }
};

/// A rank that may need ghosts of this rank's particles, as they appear in `image`.
struct HaloTarget {
    int rank = 0;
    HaloImage image;
    Box box;  ///< of that rank
};

/// The ranks that may need ghosts of a rank's particles: all boxes, including its own, that lie within the reach of
/// its box after a shift by whole periods and mirroring at planes of symmetry.
class HaloTargets {
  public:
    HaloTargets(const Domain& domain, const Ranks& ranks, const ParticleSpace& space, double reach);

    /// Sorted by rank, then in an order that depends on the boxes alone.
    [[nodiscard]] const std::vector<HaloTarget>& list() const { return list_; }

    /// False if particle i of this rank is so far inside its box that no target needs it.
    [[nodiscard]] bool may_need(const std::array<const double*, 3>& x, std::size_t i) const {
        int deep = 1;  // no branches: they would be mispredicted
        for (int axis = 0; axis < dimension_; ++axis)
            deep &= static_cast<int>(x[axis][i] > inner_low_[axis]) & static_cast<int>(x[axis][i] < inner_high_[axis]);
        return deep == 0;
    }

    /// True if the image of particle i lies within the reach of the target's box.
    [[nodiscard]] bool needs(const HaloTarget& target, const std::array<const double*, 3>& x, std::size_t i) const {
        double squared = 0;
        for (int axis = 0; axis < dimension_; ++axis) {
            const double moved = target.image.position(x[axis][i], axis);  // exact; moving the box might not be
            const double outside = std::max({0.0, target.box.low[axis] - moved, moved - target.box.high[axis]});
            squared += outside * outside;
        }
        return squared <= squared_reach_;
    }

  private:
    int dimension_;
    double squared_reach_;
    std::array<double, 3> inner_low_{}, inner_high_{};
    std::vector<HaloTarget> list_;
};

}  // namespace dmp::solver
