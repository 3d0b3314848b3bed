// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/neighbours/search_grid.hpp"

#include <limits>
#include <span>
#include <utility>

#include "solver/neighbours/sort_by_cell.hpp"
#include "solver/parallel/low_and_high.hpp"
#include "solver/parallel/select.hpp"

namespace dmp::solver {

SearchGrid::SearchGrid(const ParticleGroup& group, double cell_size, int threads) : size_(cell_size) {
    const auto count = static_cast<std::ptrdiff_t>(group.total());
    if (count == 0) return;
    constexpr auto many = static_cast<std::ptrdiff_t>(worth_threads);
    std::array<double, 3> extent{};
    for (int axis = 0; axis < group.dimension(); ++axis) {
        const double* x = group.data(Field::position, axis);
        const auto [low, high] = low_and_high(count, threads, [x](std::ptrdiff_t i) { return x[i]; });
        origin_[axis] = low;
        extent[axis] = high - low;
    }
    // A single stray particle must not cause a grid of billions of empty cells.
    const auto cells_at = [&](double size) {
        double cells = 1;
        for (const double length : extent) cells *= std::floor(length / size) + 1;
        return cells;
    };
    constexpr double most_cells = std::numeric_limits<std::int32_t>::max();
    while (cells_at(size_) > std::min(4.0 * static_cast<double>(count) + 1024, most_cells)) size_ *= 2;
    inverse_size_ = 1 / size_;
    for (int axis = 0; axis < 3; ++axis) cells_[axis] = static_cast<int>(std::floor(extent[axis] / size_)) + 1;

    Uninitialized<std::int32_t> cell(group.total());
    std::array<const double*, 3> x{};
    for (int axis = 0; axis < group.dimension(); ++axis) x[axis] = group.data(Field::position, axis);
#pragma omp parallel for num_threads(threads) schedule(static) if (count >= many)
    for (std::ptrdiff_t i = 0; i < count; ++i) {
        std::int32_t number = 0;
        for (int axis = group.dimension() - 1; axis >= 0; --axis)
            number = number * cells_[axis] + cell_at(axis, x[axis][i]);
        cell[i] = number;
    }
    const std::size_t cells = static_cast<std::size_t>(cells_[0]) * cells_[1] * cells_[2];
    auto [order, start] = sort_by_cell(std::span<const std::int32_t>(cell), cells, threads);
    index_ = std::move(order);
    start_ = std::move(start);
    for (int axis = 0; axis < group.dimension(); ++axis) {
        position_[axis].resize(group.total());
#pragma omp parallel for num_threads(threads) schedule(static) if (count >= many)
        for (std::ptrdiff_t k = 0; k < count; ++k) position_[axis][k] = x[axis][index_[k]];
    }
}

}  // namespace dmp::solver
