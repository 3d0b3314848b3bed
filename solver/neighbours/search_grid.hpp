// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "base/uninitialized.hpp"
#include "solver/store/particle_group.hpp"

namespace dmp::solver {

/// All particles of a group including ghosts, sorted into cells with contiguous coordinates, so that the particles
/// near a cluster are found in a few runs of memory.
class SearchGrid {
  public:
    /// Cells of at least `cell_size` (larger if there would be too many).
    SearchGrid(const ParticleGroup& group, double cell_size, int threads);

    /// Appends to `found` every particle within `reach` of the box [low, high].
    template <int D>
    void append_near(const std::array<double, 3>& low, const std::array<double, 3>& high, double reach,
                     Uninitialized<std::int32_t>& found) const;

  private:
    struct Gap {  ///< distance between an interval of the box and one cell along an axis
        double operator()(double low, double high, double cell_low, double cell_high) const {
            return std::max({0.0, low - cell_high, cell_low - high});
        }
    };
    [[nodiscard]] int cell_at(int axis, double x) const {
        return static_cast<int>(std::clamp((x - origin_[axis]) * inverse_size_, 0.0, cells_[axis] - 1.0));
    }
    template <int D>
    void append_run(std::int32_t begin, std::int32_t end, const std::array<double, 3>& low,
                    const std::array<double, 3>& high, double reach_square, Uninitialized<std::int32_t>& found) const;

    double size_ = 1, inverse_size_ = 1;
    std::array<double, 3> origin_{};
    std::array<int, 3> cells_{1, 1, 1};
    std::vector<std::int32_t> start_;    ///< first particle of each cell, x fastest
    Uninitialized<std::int32_t> index_;  ///< in the group
    std::array<Uninitialized<double>, 3> position_;
};

template <int D>
void SearchGrid::append_near(const std::array<double, 3>& low, const std::array<double, 3>& high, double reach,
                             Uninitialized<std::int32_t>& found) const {
    if (index_.empty()) return;
    const double reach_square = reach * reach;
    std::array<int, 3> first{}, last{};
    for (int axis = 1; axis < D; ++axis) {
        first[axis] = cell_at(axis, low[axis] - reach);
        last[axis] = cell_at(axis, high[axis] + reach);
    }
    const auto gap_square = [&](int axis, int cell) {
        // The first and last cells also contain the particles outside the grid, so they are unbounded outwards.
        const double cell_low = cell == 0 ? -HUGE_VAL : origin_[axis] + cell * size_;
        const double cell_high = cell == cells_[axis] - 1 ? HUGE_VAL : origin_[axis] + (cell + 1) * size_;
        const double gap = Gap{}(low[axis], high[axis], cell_low, cell_high);
        return gap * gap;
    };
    for (int z = first[2]; z <= last[2]; ++z) {
        const double beside_z = D == 3 ? gap_square(2, z) : 0;
        for (int y = first[1]; y <= last[1]; ++y) {
            const double rest = reach_square - beside_z - gap_square(1, y);
            if (rest <= 0) continue;
            const double along = std::sqrt(rest) + 1e-6 * size_;
            const std::int64_t row = (static_cast<std::int64_t>(z) * cells_[1] + y) * cells_[0];
            append_run<D>(start_[row + cell_at(0, low[0] - along)], start_[row + cell_at(0, high[0] + along) + 1], low,
                          high, reach_square, found);
        }
    }
}

template <int D>
void SearchGrid::append_run(std::int32_t begin, std::int32_t end, const std::array<double, 3>& low,
                            const std::array<double, 3>& high, double reach_square,
                            Uninitialized<std::int32_t>& found) const {
    std::size_t count = found.size();
    found.resize(count + static_cast<std::size_t>(end - begin));
    for (std::int32_t k = begin; k < end; ++k) {
        double square = 0;
        for (int axis = 0; axis < D; ++axis) {
            const double x = position_[axis][k];
            const double gap = std::max({0.0, low[axis] - x, x - high[axis]});
            square += gap * gap;
        }
        found[count] = index_[k];
        count += square < reach_square ? 1 : 0;
    }
    found.resize(count);
}

}  // namespace dmp::solver
