// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "base/vec.hpp"
#include "geometry/surface_crossings.hpp"
#include "mesher/uses.hpp"
#include "scene/scene.hpp"

namespace dmp::mesher {

/// A cubic, face-centred cubic (fcc) or hexagonal close-packed (hcp) lattice of points that fits a box, as lines of
/// points along x: along periodic axes a whole number of cells makes one period, along the others the first points lie
/// half a cell inside the box. A point stands for spacing^3 in all three, so that they have equally many particles; the
/// nearest ones are 1, 1.1225 and 1.1225 spacings apart.
class SpaceLattice {
  public:
    /// The points in the box widened by `margin` [m] along axes that are not periodic; along `fitted` axes the box is a
    /// whole number of cells long, as it is along periodic ones.
    SpaceLattice(const Box& box, const std::array<bool, 3>& periodic, double spacing, Arrangement arrangement,
                 double margin, const std::array<bool, 3>& fitted = {});

    /// Rows of lines along x, by ascending z.
    [[nodiscard]] const std::vector<LineRow>& rows() const { return rows_; }
    /// Points on each line.
    [[nodiscard]] int points() const { return points_; }
    [[nodiscard]] Vec at(std::size_t row, int line, int point) const {
        return {first_x(row, line) + point * step_[0], rows_[row].first_y + line * rows_[row].step_y, rows_[row].z};
    }
    /// The first point of a line.
    [[nodiscard]] double first_x(std::size_t row, int line) const;

    /// Distance of points, lines and rows [m].
    [[nodiscard]] const std::array<double, 3>& step() const { return step_; }
    /// The same before they are fitted to a period.
    static std::array<double, 3> wanted_step(double spacing, Arrangement arrangement);
    /// Volume each point stands for [m^3].
    [[nodiscard]] double cell_volume() const { return step_[0] * step_[1] * step_[2]; }

  private:
    Arrangement arrangement_;
    std::array<double, 3> step_{};
    std::array<int, 3> outside_{};  ///< points, lines and rows before the box's first
    double low_x_ = 0;
    int points_ = 0;
    std::vector<LineRow> rows_;
};

}  // namespace dmp::mesher
