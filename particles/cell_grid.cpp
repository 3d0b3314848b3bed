// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/cell_grid.hpp"

#include <cmath>
#include <numeric>

namespace dmp::particles {

CellGrid::CellGrid(const Coordinates& points, std::size_t count, int dimension, double cell_size)
    : dimension_(dimension) {
    if (count == 0) return;
    std::array<double, 3> high{};
    for (int axis = 0; axis < dimension; ++axis) {
        const auto [low_at, high_at] = std::minmax_element(points[axis].begin(), points[axis].begin() + count);
        origin_[axis] = *low_at;
        high[axis] = *high_at;
    }
    // A lone stray particle must not make a grid of billions of empty cells.
    double size = cell_size;
    const auto cells_at = [&](double s) {
        double cells = 1;
        for (int axis = 0; axis < dimension; ++axis) cells *= std::floor((high[axis] - origin_[axis]) / s) + 1;
        return cells;
    };
    while (cells_at(size) > 16.0 * static_cast<double>(count) + 64) size *= 2;
    inverse_size_ = 1 / size;
    for (int axis = 0; axis < dimension; ++axis)
        cells_[axis] = static_cast<int>(std::floor((high[axis] - origin_[axis]) / size)) + 1;

    const std::size_t cells = static_cast<std::size_t>(cells_[0]) * cells_[1] * cells_[2];
    start_.assign(cells + 1, 0);
    std::vector<int> cell(count);
    for (std::size_t i = 0; i < count; ++i) {
        std::array<double, 3> point{};
        for (int axis = 0; axis < dimension; ++axis) point[axis] = points[axis][i];
        const auto c = cell_of(point);
        cell[i] = (c[2] * cells_[1] + c[1]) * cells_[0] + c[0];
        ++start_[cell[i] + 1];
    }
    std::partial_sum(start_.begin(), start_.end(), start_.begin());
    order_.resize(count);
    std::vector<int> next(start_.begin(), start_.end() - 1);
    for (std::size_t i = 0; i < count; ++i) order_[next[cell[i]]++] = static_cast<int>(i);
}

}  // namespace dmp::particles
