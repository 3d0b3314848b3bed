// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "base/vec.hpp"
#include "mesher/uses.hpp"
#include "scene/scene.hpp"

namespace dmp::mesher {

/// A square or hexagonal lattice of points that fits a box: along periodic axes a whole number of cells makes one
/// period, along the others the first row lies half a cell inside the box. A point stands for spacing^2 in both, so
/// that they have equally many particles; on the hexagonal lattice the nearest are then 1.0746 spacings apart.
class Lattice {
  public:
    /// Along `fitted` axes the box is a whole number of cells long, as it is along periodic ones.
    Lattice(const Box& box, const std::array<bool, 3>& periodic, double spacing, Arrangement arrangement,
            const std::array<bool, 3>& fitted = {});

    /// All points in the box widened by `margin` along axes that are not periodic, row after row (y, then x).
    [[nodiscard]] std::vector<Vec> points(double margin) const;

    /// Distance of columns and rows before they are fitted to a period [m].
    static std::array<double, 2> wanted_step(double spacing, Arrangement arrangement);

    /// Area each point stands for [m^2].
    [[nodiscard]] double cell_area() const { return step_[0] * step_[1]; }
    /// Distance of columns and rows [m].
    [[nodiscard]] const std::array<double, 2>& step() const { return step_; }

  private:
    Box box_;
    std::array<bool, 3> periodic_;
    Arrangement arrangement_;
    std::array<double, 2> step_{};
};

}  // namespace dmp::mesher
