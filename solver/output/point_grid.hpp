// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "particles/particle_set.hpp"
#include "solver/uses.hpp"

namespace dmp::solver {

/// Points in a box that may be periodic, sorted into cells.
class PointGrid {
  public:
    PointGrid(const ParticleSpace& space, double reach, std::vector<Vec> points)
        : space_(space), reach_(reach), points_(std::move(points)) {
        for (int axis = 0; axis < 3; ++axis)
            if (space.periodic[axis]) {
                const double length = space.box.high[axis] - space.box.low[axis];
                cells_[axis] = std::max(1, static_cast<int>(length / reach));
                size_[axis] = length / cells_[axis];
            } else {
                size_[axis] = reach;
            }
        for (std::size_t k = 0; k < points_.size(); ++k) in_cell_[cell_of(points_[k])].push_back(k);
    }

    /// Calls visit(k, vector from `place` to the nearest image of point k) for the points within reach, in ascending
    /// order of k.
    template <class Visit>
    void for_each_near(const Vec& place, const Visit& visit) const {
        std::vector<std::size_t> near;
        for (const Cell& cell : around(cell_of(place)))
            if (const auto found = in_cell_.find(cell); found != in_cell_.end())
                near.insert(near.end(), found->second.begin(), found->second.end());
        std::ranges::sort(near);
        for (const std::size_t k : near) {
            const Vec apart = nearest_image(points_[k] - place, space_);
            if (apart.norm() < reach_) visit(k, apart);
        }
    }

    [[nodiscard]] bool any_near(const Vec& place) const {
        return std::ranges::any_of(around(cell_of(place)), [&](const Cell& cell) {
            const auto found = in_cell_.find(cell);
            return found != in_cell_.end() && std::ranges::any_of(found->second, [&](std::size_t k) {
                       return nearest_image(points_[k] - place, space_).norm() < reach_;
                   });
        });
    }

  private:
    using Cell = std::array<int, 3>;

    [[nodiscard]] Cell cell_of(const Vec& point) const {
        Cell cell{};
        for (int axis = 0; axis < space_.dimension; ++axis)
            cell[axis] = at(axis, static_cast<int>(std::floor((point[axis] - space_.box.low[axis]) / size_[axis])));
        return cell;
    }
    [[nodiscard]] int at(int axis, int index) const {
        const int cells = cells_[axis];
        return cells == 0 ? index : (index % cells + cells) % cells;
    }
    /// The cell and those beside it, each once.
    [[nodiscard]] std::vector<Cell> around(const Cell& cell) const {
        std::vector<Cell> cells;
        const int deep = space_.dimension == 3 ? 1 : 0;
        for (int z = -deep; z <= deep; ++z)
            for (int y = -1; y <= 1; ++y)
                for (int x = -1; x <= 1; ++x)
                    cells.push_back({at(0, cell[0] + x), at(1, cell[1] + y), at(2, cell[2] + z)});
        std::ranges::sort(cells);
        cells.erase(std::ranges::unique(cells).begin(), cells.end());
        return cells;
    }

    const ParticleSpace& space_;
    double reach_;
    std::array<double, 3> size_{};
    std::array<int, 3> cells_{};  ///< in a period; 0: not periodic
    std::vector<Vec> points_;
    std::map<Cell, std::vector<std::size_t>> in_cell_;
};

}  // namespace dmp::solver
