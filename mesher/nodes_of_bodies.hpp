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
    struct Kind {
        bool of_a_solid, anchored;
    };
    void add(const Vec& node, const Kind& kind) {
        for (int axis = 0; axis < 2; ++axis) points_[axis].push_back(node[axis]);
        kinds_.push_back(kind);
    }
    /// Before the next question; searches are to be about so far [m].
    void sort(double reach) { grid_ = CellGrid(points_, kinds_.size(), 2, reach); }

    /// Whether one is nearer to a point than a distance [m].
    [[nodiscard]] bool any_near(const Vec& point, double distance) const {
        return any_near(point, distance, [](const Kind&) { return true; });
    }
    /// The same of those alone for which chosen(Kind).
    template <class Chosen>
    [[nodiscard]] bool any_near(const Vec& point, double distance, const Chosen& chosen) const {
        if (kinds_.empty()) return false;
        bool found = false;
        grid_.for_each_near({point.x(), point.y(), 0}, distance, [&](int k) {
            const auto node = static_cast<std::size_t>(k);
            if (found || !chosen(kinds_[node])) return;
            found = std::hypot(points_[0][node] - point.x(), points_[1][node] - point.y()) < distance;
        });
        return found;
    }

  private:
    Coordinates points_;
    std::vector<Kind> kinds_;
    CellGrid grid_;
};

}  // namespace dmp::mesher
