// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/parallel/halo_targets.hpp"

#include <cmath>

namespace dmp {

namespace {

/// Distances carry rounding errors, of coordinates up to a million times as large: what lies as far as the reach is to
/// be found all the same.
constexpr double margin = 1e-9;

bool is_empty(const Box& box, int dimension) {
    for (int axis = 0; axis < dimension; ++axis)
        if (box.low[axis] > box.high[axis]) return true;
    return false;
}

/// The whole numbers of periods by which `own`, moved, may come within the reach of `other`.
struct Periods {
    int first = 0, last = 0;
};

Periods periods_between(const Box& own, const Box& other, int axis, double period, double reach) {
    if (period == 0) return {};
    // One more on either side, for rounding; what is too far is sorted out by its distance.
    return {static_cast<int>(std::floor((other.low[axis] - reach - own.high[axis]) / period)),
            static_cast<int>(std::ceil((other.high[axis] + reach - own.low[axis]) / period))};
}

/// From a box, moved as its particles are to be, to the target's.
double squared_distance(const Box& own, const HaloTarget& target, int dimension) {
    double squared = 0;
    for (int axis = 0; axis < dimension; ++axis) {
        const double shift = target.shift[axis];
        const double apart = std::max(
            {0.0, target.box.low[axis] - (own.high[axis] + shift), own.low[axis] + shift - target.box.high[axis]});
        squared += apart * apart;
    }
    return squared;
}

}  // namespace

HaloTargets::HaloTargets(const Domain& domain, const Ranks& ranks, const std::array<double, 3>& period, int dimension,
                         double reach)
    : dimension_(dimension) {
    const double far = reach * (1 + margin);
    squared_reach_ = far * far;
    const Box& own = domain.box(ranks.rank());
    for (int axis = 0; axis < 3; ++axis) {
        inner_low_[axis] = own.low[axis] + far;
        inner_high_[axis] = own.high[axis] - far;
    }
    if (is_empty(own, dimension)) return;
    for (int rank = 0; rank < ranks.size(); ++rank) {
        const Box& other = domain.box(rank);
        if (is_empty(other, dimension)) continue;
        std::array<Periods, 3> periods;
        for (int axis = 0; axis < 3; ++axis) periods[axis] = periods_between(own, other, axis, period[axis], far);
        for (int z = periods[2].first; z <= periods[2].last; ++z)
            for (int y = periods[1].first; y <= periods[1].last; ++y)
                for (int x = periods[0].first; x <= periods[0].last; ++x) {
                    if (rank == ranks.rank() && x == 0 && y == 0 && z == 0) continue;
                    const HaloTarget target{rank, {x * period[0], y * period[1], z * period[2]}, other};
                    if (squared_distance(own, target, dimension) <= squared_reach_) list_.push_back(target);
                }
    }
}

}  // namespace dmp
