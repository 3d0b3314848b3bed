// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "geometry/triangle_surface.hpp"
#include "mesher/solid_cells.hpp"
#include "mesher/uses.hpp"

namespace dmp::mesher {

/// What a closed surface encloses of the boxes of a lattice in 3-D: exact along x, by 7 x 7 lines a box across it. The
/// surface may be of any shape; parts that overlap count once.
class SolidOnBoxes {
  public:
    SolidOnBoxes(const TriangleSurface& surface, const BoxLattice& lattice);

    [[nodiscard]] SolidCells cells() const;
    /// What of the solid is in a box; nothing in one that it does not reach.
    [[nodiscard]] Filling filling(const std::array<int, 3>& box) const;
    /// Of all boxes [m^3].
    [[nodiscard]] double volume() const;
    /// The boxes that it reaches: from the first to before the last.
    [[nodiscard]] std::array<std::array<int, 3>, 2> boxes() const { return {first_, last_}; }

  private:
    /// Of the solid in one box, from its middle.
    struct Sums {
        double length = 0;                              ///< of lines in it [m]
        Vec first = Vec::Zero(), second = Vec::Zero();  ///< integrals of X_i and X_i^2 along them
        std::array<bool, 3> joined{};                   ///< solid on the face to the next box, by axis
    };
    /// A stretch of a line that is inside.
    struct Stretch {
        double from, to;
    };

    [[nodiscard]] std::size_t number(const std::array<int, 3>& box) const;
    void add_line(const std::array<int, 2>& box, const Vec& line, const std::vector<Stretch>& inside);
    void join_boxes(const std::array<int, 2>& box, int axis, const std::vector<Stretch>& last,
                    const std::vector<Stretch>& next);
    void join_ends(const std::array<int, 2>& box, const std::vector<Stretch>& inside);

    BoxLattice lattice_;
    std::array<int, 3> first_{}, last_{};  ///< boxes that the surface reaches; `last_` is left out
    std::vector<Sums> sums_;
};

}  // namespace dmp::mesher
