// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "particles/particle_set.hpp"
#include "solver/uses.hpp"

namespace dmp::solver {

/// Triangles sorted into cells, each into all that its box, widened by the reach, touches: one look finds what is near
/// a point.
class TriangleGrid {
  public:
    TriangleGrid(const std::vector<std::array<Vec, 3>>& triangles, double reach);

    /// Calls visit(number) for every triangle within the reach of the point, in ascending order, and for some others.
    template <class Visit>
    void for_each_near(const Vec& point, const Visit& visit) const {
        std::int64_t cell = 0;
        for (int axis = 2; axis >= 0; --axis) {
            const double position = (point[axis] - low_[axis]) * inverse_cell_;
            if (!(position >= 0 && position < static_cast<double>(cells_[static_cast<std::size_t>(axis)]))) return;
            cell = cell * cells_[static_cast<std::size_t>(axis)] + static_cast<std::int64_t>(position);
        }
        for (std::int32_t k = start_[static_cast<std::size_t>(cell)]; k < start_[static_cast<std::size_t>(cell) + 1];
             ++k)
            visit(static_cast<std::size_t>(number_[static_cast<std::size_t>(k)]));
    }

  private:
    Vec low_ = Vec::Zero();
    double inverse_cell_ = 1;
    std::array<std::int64_t, 3> cells_{1, 1, 1};
    std::vector<std::int32_t> start_;  ///< of each cell, x fastest
    std::vector<std::int32_t> number_;
};

/// No shift, and those by whole periods after which something within `reach` of the point, which lies in the box or
/// near it, may come from the other side.
std::vector<Vec> shifts_near(const ParticleSpace& space, const Vec& point, double reach);

}  // namespace dmp::solver
