// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <vector>

#include "particles/periodic_images.hpp"

namespace dmp::particles {

/// Points sorted into square or cubic cells, x fastest, so that the cells around a point are a few runs of memory.
class CellGrid {
  public:
    CellGrid() = default;
    /// `count` points of `points`; cells of at least `cell_size` (larger if there would be too many of them).
    CellGrid(const Coordinates& points, std::size_t count, int dimension, double cell_size);

    /// Calls visit(index) for every point in the cells that touch the box [low, high], in an order that depends on
    /// the points alone. Points outside the box come too: the caller tests the distance.
    template <class Visit>
    void for_each_near(const std::array<double, 3>& low, const std::array<double, 3>& high, Visit&& visit) const {
        const auto first = cell_of(low), last = cell_of(high);
        for (int z = first[2]; z <= last[2]; ++z)
            for (int y = first[1]; y <= last[1]; ++y) {
                const std::size_t row = (static_cast<std::size_t>(z) * cells_[1] + y) * cells_[0];
                for (int k = start_[row + first[0]]; k < start_[row + last[0] + 1]; ++k) visit(order_[k]);
            }
    }

    /// The same around one point.
    template <class Visit>
    void for_each_near(const std::array<double, 3>& point, double radius, Visit&& visit) const {
        std::array<double, 3> low{}, high{};
        for (int axis = 0; axis < 3; ++axis) {
            low[axis] = point[axis] - radius;
            high[axis] = point[axis] + radius;
        }
        for_each_near(low, high, visit);
    }

    /// All points, cell by cell.
    [[nodiscard]] const std::vector<int>& order() const { return order_; }

  private:
    [[nodiscard]] std::array<int, 3> cell_of(const std::array<double, 3>& point) const {
        std::array<int, 3> cell{};
        for (int axis = 0; axis < (dimension_ == 3 ? 3 : 2); ++axis) {
            const double position = (point[axis] - origin_[axis]) * inverse_size_;
            cell[axis] = static_cast<int>(std::clamp(position, 0.0, cells_[axis] - 1.0));
        }
        return cell;
    }

    int dimension_ = 2;
    double inverse_size_ = 1;
    std::array<double, 3> origin_{};
    std::array<int, 3> cells_{1, 1, 1};
    std::vector<int> start_{0, 0};
    std::vector<int> order_;
};

}  // namespace dmp::particles
