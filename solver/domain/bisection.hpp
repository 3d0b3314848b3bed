// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "base/vec.hpp"
#include "solver/parallel/ranks.hpp"

namespace dmp::solver {

/// Points with weights: `dimension` coordinates and one weight a point.
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

/// One box a rank, so that the ranks' points, taken together, weigh about the same in each: recursive coordinate
/// bisection (Berger and Bokhari, IEEE Transactions on Computers C-36, 1987) by Zoltan, always across the longest side
/// of what is to be cut. The outer boxes reach to +-infinity. Called by all ranks, who must be several; all get the
/// same boxes. Throws ResourceError where Zoltan fails. With hardly more points than ranks the boxes may be nonsense.
std::vector<Box> bisect(const Ranks& ranks, const WeightedPoints& points);

}  // namespace dmp::solver
