// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/neighbours/search_grid.hpp"

#include <numeric>

namespace dmp {

SearchGrid::SearchGrid(const ParticleGroup& group, double cell_size) : size_(cell_size) {
    const std::size_t count = group.total();
    if (count == 0) return;
    std::array<double, 3> extent{};
    for (int axis = 0; axis < group.dimension(); ++axis) {
        const double* x = group.data(Field::position, axis);
        const auto [low, high] = std::minmax_element(x, x + count);
        origin_[axis] = *low;
        extent[axis] = *high - *low;
    }
    // A lone stray particle must not make a grid of billions of empty cells.
    const auto cells_at = [&](double size) {
        double cells = 1;
        for (const double length : extent) cells *= std::floor(length / size) + 1;
        return cells;
    };
    while (cells_at(size_) > 4.0 * static_cast<double>(count) + 1024) size_ *= 2;
    inverse_size_ = 1 / size_;
    for (int axis = 0; axis < 3; ++axis) cells_[axis] = static_cast<int>(std::floor(extent[axis] / size_)) + 1;

    start_.assign(static_cast<std::size_t>(cells_[0]) * cells_[1] * cells_[2] + 1, 0);
    std::vector<std::int32_t> cell(count, 0);
    for (int axis = group.dimension() - 1; axis >= 0; --axis) {
        const double* x = group.data(Field::position, axis);
        for (std::size_t i = 0; i < count; ++i) cell[i] = cell[i] * cells_[axis] + cell_at(axis, x[i]);
    }
    for (const std::int32_t c : cell) ++start_[c + 1];
    std::partial_sum(start_.begin(), start_.end(), start_.begin());
    std::vector<std::int32_t> next(start_.begin(), start_.end() - 1);
    index_.resize(count);
    for (std::size_t i = 0; i < count; ++i) index_[next[cell[i]]++] = static_cast<std::int32_t>(i);
    for (int axis = 0; axis < group.dimension(); ++axis) {
        const double* x = group.data(Field::position, axis);
        position_[axis].resize(count);
        for (std::size_t k = 0; k < count; ++k) position_[axis][k] = x[index_[k]];
    }
}

}  // namespace dmp
