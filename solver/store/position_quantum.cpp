// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/store/position_quantum.hpp"

#include <algorithm>
#include <cmath>

namespace dmp::solver {

PositionQuantum::PositionQuantum(const ParticleSpace& space) {
    double farthest = space.spacing;
    for (int axis = 0; axis < space.dimension; ++axis)
        farthest = std::max({farthest, std::abs(space.box.low[axis]), std::abs(space.box.high[axis]),
                             space.box.high[axis] - space.box.low[axis]});
    // Eight times the farthest coordinate is still below 2^51 quanta.
    size_ = std::ldexp(1.0, std::ilogb(farthest) + 1 + 3 - 51);
    magic_ = 1.5 * std::ldexp(size_, 52);
}

ParticleSpace with_whole_periods(const ParticleSpace& space, const PositionQuantum& quantum) {
    ParticleSpace whole = space;
    for (int axis = 0; axis < space.dimension; ++axis) {
        whole.box.low[axis] = quantum.round(space.box.low[axis]);
        whole.box.high[axis] = quantum.round(space.box.high[axis]);
    }
    return whole;
}

}  // namespace dmp::solver
