// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <vector>

#include "base/vec.hpp"
#include "mesher/uses.hpp"
#include "particles/cell_grid.hpp"

namespace dmp::mesher {

/// Where the nodes of spring bodies in 2-D stand, for others to keep away from them.
class NodesOfBodies {
  public:
    void add(const Vec& node, bool of_a_solid) {
        for (int axis = 0; axis < 2; ++axis) points_[axis].push_back(node[axis]);
        of_a_solid_.push_back(of_a_solid);
    }
    /// Before the next question; searches are to be about so far [m].
    void sort(double reach) { grid_ = CellGrid(points_, of_a_solid_.size(), 2, reach); }

    /// Whether one is nearer to a point than a distance [m].
    [[nodiscard]] bool any_near(const Vec& point, double distance, bool of_solids_only = false) const {
        if (of_a_solid_.empty()) return false;
        bool found = false;
        grid_.for_each_near({point.x(), point.y(), 0}, distance, [&](int k) {
            const auto node = static_cast<std::size_t>(k);
            if (found || (of_solids_only && !of_a_solid_[node])) return;
            found = std::hypot(points_[0][node] - point.x(), points_[1][node] - point.y()) < distance;
        });
        return found;
    }

  private:
    Coordinates points_;
    std::vector<bool> of_a_solid_;
    CellGrid grid_;
};

}  // namespace dmp::mesher
