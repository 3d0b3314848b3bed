// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "mesher/lattice.hpp"

#include <algorithm>
#include <cmath>

#include "base/unlisted_value.hpp"
#include "mesher/whole_cells.hpp"

namespace dmp::mesher {

std::array<double, 2> Lattice::wanted_step(double spacing, Arrangement arrangement) {
    const double nearest = spacing * std::sqrt(2 / std::sqrt(3.0));
    switch (arrangement) {
        case Arrangement::square:
            return {spacing, spacing};
        case Arrangement::hexagonal:
            return {nearest, nearest * std::sqrt(0.75)};
        case Arrangement::fcc:
            break;  // in 3-D only: the scene's checks refuse it
    }
    unlisted_value(arrangement);
}

Lattice::Lattice(const Box& box, const std::array<bool, 3>& periodic, double spacing, Arrangement arrangement,
                 const std::array<bool, 3>& fitted)
    : box_(box), periodic_(periodic), arrangement_(arrangement) {
    const bool hexagonal = arrangement == Arrangement::hexagonal;
    step_ = wanted_step(spacing, arrangement);
    for (int axis = 0; axis < 2; ++axis) {
        if (!periodic[axis] && !fitted[axis]) continue;
        const double period = box.extent()[axis];
        // Hexagonal rows alternate, so two of them make the cell that repeats in y.
        const double rows = hexagonal && axis == 1 && periodic[axis] ? 2 : 1;
        step_[axis] = period / (rows * whole_cells(period / (rows * step_[axis])));
    }
}

std::vector<Vec> Lattice::points(double margin) const {
    std::array<long, 2> first{}, last{};
    for (int axis = 0; axis < 2; ++axis) {
        const long outside = periodic_[axis] ? 0 : static_cast<long>(std::ceil(margin / step_[axis]));
        const double cells = box_.extent()[axis] / step_[axis];
        first[axis] = -outside;
        last[axis] = (periodic_[axis] ? std::lround(cells) : static_cast<long>(std::ceil(cells - 1e-9))) + outside;
    }
    std::vector<Vec> points;
    points.reserve(static_cast<std::size_t>((last[0] - first[0]) * (last[1] - first[1])));
    for (long row = first[1]; row < last[1]; ++row) {
        const double stagger = arrangement_ == Arrangement::hexagonal && row % 2 != 0 ? 0.25 : -0.25;
        const double offset = arrangement_ == Arrangement::hexagonal ? stagger : 0.0;
        for (long column = first[0]; column < last[0]; ++column)
            points.emplace_back(box_.low[0] + (static_cast<double>(column) + 0.5 + offset) * step_[0],
                                box_.low[1] + (static_cast<double>(row) + 0.5) * step_[1], 0.0);
    }
    return points;
}

}  // namespace dmp::mesher
