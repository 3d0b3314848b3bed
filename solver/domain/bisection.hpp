// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "base/vec.hpp"
#include "solver/parallel/ranks.hpp"

namespace dmp::solver {

/// Points with weights: `dimension` coordinates and one weight per point.
struct WeightedPoints {
    int dimension = 2;
    std::vector<double> coordinates;
    std::vector<float> weights;

    [[nodiscard]] std::array<double, 3> point(std::size_t k) const {
        std::array<double, 3> at{};
        for (int axis = 0; axis < dimension; ++axis) at[axis] = coordinates[k * dimension + axis];
        return at;
    }
};

/// Returns one box per rank, such that the points of all ranks together weigh about the same in each box: recursive
/// coordinate bisection (Berger and Bokhari, IEEE Transactions on Computers C-36, 1987) by Zoltan, always across the
/// longest side of the part to be cut. The outer boxes extend to +-infinity. Must be called by all ranks, of which
/// there must be several; all get the same boxes. Throws ResourceError if Zoltan fails. With hardly more points than
/// ranks the boxes may be meaningless.
std::vector<Box> bisect(const Ranks& ranks, const WeightedPoints& points);

}  // namespace dmp::solver
