// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "mesher/space_lattice.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/unlisted_value.hpp"
#include "mesher/whole_cells.hpp"

namespace dmp::mesher {

namespace {

bool is_odd(long k) { return k % 2 != 0; }

/// Points, lines and rows that make the cell which repeats.
std::array<int, 3> repeat_of(Arrangement arrangement) {
    switch (arrangement) {
        case Arrangement::square:
            return {1, 1, 1};
        case Arrangement::hexagonal:
        case Arrangement::fcc:
            return {1, 2, 2};
    }
    unlisted_value(arrangement);
}

}  // namespace

std::array<double, 3> SpaceLattice::wanted_step(double spacing, Arrangement arrangement) {
    const double edge = spacing * std::cbrt(4.0);  // of the cube that holds four points
    const double nearest = spacing * std::pow(2.0, 1.0 / 6);
    switch (arrangement) {
        case Arrangement::square:
            return {spacing, spacing, spacing};
        case Arrangement::hexagonal:
            return {nearest, nearest * std::numbers::sqrt3 / 2, nearest * std::sqrt(2.0 / 3)};
        case Arrangement::fcc:
            return {edge, edge / 2, edge / 2};
    }
    unlisted_value(arrangement);
}

SpaceLattice::SpaceLattice(const Box& box, const std::array<bool, 3>& periodic, double spacing, Arrangement arrangement,
                           double margin, const std::array<bool, 3>& fitted)
    : arrangement_(arrangement), step_(wanted_step(spacing, arrangement)), low_x_(box.low[0]) {
    const std::array<int, 3> repeat = repeat_of(arrangement);
    std::array<int, 3> count{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double extent = box.extent()[static_cast<Eigen::Index>(axis)];
        const double cell = periodic.at(axis) ? repeat.at(axis) : 1;
        if (periodic.at(axis) || fitted.at(axis))
            step_.at(axis) = extent / (cell * whole_cells(extent / (cell * step_.at(axis))));
        outside_.at(axis) = periodic.at(axis) ? 0 : static_cast<int>(std::ceil(margin / step_.at(axis)));
        count.at(axis) = static_cast<int>(std::ceil(extent / step_.at(axis) - 1e-9)) + 2 * outside_.at(axis);
    }
    points_ = count[0];
    for (int k = 0; k < count[2]; ++k) {
        const int layer = k - outside_[2];
        const double shift = arrangement == Arrangement::hexagonal ? (is_odd(layer) ? 1.0 : -1.0) / 6 : 0;
        rows_.push_back({box.low[2] + (layer + 0.5) * step_[2], box.low[1] + (0.5 + shift - outside_[1]) * step_[1],
                         step_[1], count[1]});
    }
}

double SpaceLattice::first_x(std::size_t row, int line) const {
    const long layer = static_cast<long>(row) - outside_[2], j = line - outside_[1];
    double stagger = 0;
    if (arrangement_ == Arrangement::fcc || arrangement_ == Arrangement::hexagonal)
        stagger = is_odd(layer + j) ? 0.25 : -0.25;
    return low_x_ + (0.5 + stagger - outside_[0]) * step_[0];
}

}  // namespace dmp::mesher
