// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "particles/cell_grid.hpp"
#include "particles/particle_set.hpp"

namespace dmp::particles {

/// The particles of a set sorted into cells, with their images across periodic sides.
class SetGrid {
  public:
    /// For searches within `reach` [m]. Throws InputError for a particle whose position is not finite.
    SetGrid(const ParticleSet& set, double reach);

    /// Calls visit(j, offset from i to j) for each other particle, or image of one, within the reach of particle i, in
    /// an order that depends on the positions alone. Several images of one particle, also of i, may come.
    template <class Visit>
    void for_each_near(std::size_t i, const Visit& visit) const {
        const std::array<double, 3> centre{points_[0][i], points_[1][i], points_[2][i]};
        grid_.for_each_near(centre, reach_, [&](int k) {
            if (k == static_cast<int>(i)) return;
            const Vec offset(points_[0][k] - centre[0], points_[1][k] - centre[1], points_[2][k] - centre[2]);
            if (offset.squaredNorm() < reach_ * reach_) visit(static_cast<std::size_t>(id_[k]), offset);
        });
    }

  private:
    double reach_;
    Coordinates points_;
    std::vector<int> id_;
    CellGrid grid_;
};

}  // namespace dmp::particles
