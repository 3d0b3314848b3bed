// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/geometry.hpp"
#include "geometry/inside_test.hpp"
#include "geometry/nearest_curve.hpp"
#include "mesher/solid_cells.hpp"
#include "mesher/uses.hpp"

namespace dmp::mesher {

/// What an area of the geometry fills of the boxes of a lattice. Exact: boxes that its edge may pass through clip it
/// (Sutherland & Hodgman 1974).
class RegionOnBoxes {
  public:
    RegionOnBoxes(const Region& region, const BoxLattice& lattice);

    [[nodiscard]] Filling filling(const std::array<int, 3>& box) const;
    /// Whether the area is on the face between a box and the next one along an axis.
    [[nodiscard]] bool joined(const std::array<int, 3>& box, int axis) const;
    /// The boxes that it reaches: from the first to before the last.
    [[nodiscard]] std::array<std::array<int, 3>, 2> boxes() const;
    [[nodiscard]] SolidCells cells() const;

  private:
    const Region& region_;
    const BoxLattice& lattice_;
    InsideTest inside_;
    NearestCurve edge_;  ///< within half a diagonal of a box
};

}  // namespace dmp::mesher
