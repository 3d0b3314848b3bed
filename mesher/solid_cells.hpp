// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <limits>
#include <vector>

#include "base/vec.hpp"
#include "mesher/uses.hpp"
#include "particles/particle_set.hpp"

namespace dmp::mesher {

/// What fills a part of a box.
struct Filling {
    double volume = 0;           ///< [m^3], in 2-D [m^2]
    Vec centroid = Vec::Zero();  ///< [m]
    Vec moment = Vec::Zero();    ///< mean of (X_i - centroid_i)^2, by axis [m^2]

    /// Both together.
    void add(const Filling& other);
};

/// The boxes of a lattice: box (i, j, k) goes from origin + (i, j, k) step on.
struct BoxLattice {
    int dimension = 2;
    Vec origin = Vec::Zero();     ///< [m]
    Vec step = Vec::Zero();       ///< [m]; in 2-D z = 0
    std::array<int, 3> period{};  ///< by axis: boxes in a period, of which the first is box 0; 0: none
    /// By axis: the boxes of the scene, from the first to before the last, where it ends or repeats there.
    std::array<int, 3> first = {lowest, lowest, lowest}, last = {highest, highest, highest};
    static constexpr int lowest = std::numeric_limits<int>::min(), highest = std::numeric_limits<int>::max();

    [[nodiscard]] Vec corner(const std::array<int, 3>& box) const {
        return origin + Vec(box[0], box[1], box[2]).cwiseProduct(step);
    }
    [[nodiscard]] Vec middle(const std::array<int, 3>& box) const { return corner(box) + 0.5 * step; }
    /// The box that it is an image of.
    [[nodiscard]] std::array<int, 3> in_period(std::array<int, 3> box) const {
        for (std::size_t axis = 0; axis < 3; ++axis)
            if (period[axis] > 0) box[axis] = ((box[axis] % period[axis]) + period[axis]) % period[axis];
        return box;
    }
    [[nodiscard]] double volume() const { return step.head(dimension).prod(); }
};

/// A solid as cells (docs/elastic.md).
struct SolidCells {
    std::vector<CellNode> nodes;    ///< nobody is fixed yet
    std::vector<SolidCell> cells;   ///< their particle: the number of the cell
    std::vector<Filling> fillings;  ///< of each cell
    std::vector<int> piece;         ///< of each cell: of those that hang together by faces, by ascending first cell
    int pieces = 0;
    std::size_t cut = 0;     ///< cells that the surface passes through
    std::size_t merged = 0;  ///< boxes with too little solid, which went to a neighbour's cell
    std::size_t lost = 0;    ///< boxes with solid and no cell beside them
    double lost_volume = 0;  ///< [m^3], in 2-D [m^2]
    /// What is not drawn, and is in the cells all the same: behind a bent anchor [m^3], in 2-D [m^2].
    double behind_anchor = 0;

    [[nodiscard]] double volume() const;  ///< of all cells [m^3], in 2-D [m^2]
};

/// What a lattice is asked of a solid.
struct SolidOnLattice {
    /// What fills a box.
    std::function<Filling(const std::array<int, 3>& box)> filling;
    /// Whether there is solid on the face between a box and the next one along an axis, also where that is a period
    /// away; both have solid in them.
    std::function<bool(const std::array<int, 3>& box, int axis)> joined;
};

/// A cell for each box of which the solid fills at least a quarter, in 3-D a fifth. What is in other boxes goes to the
/// cell beside them whose solid is nearest, so that the solid's volume and moments stay what they are. Cells share the
/// nodes of a face where there is solid on it, and have nodes of their own elsewhere: a slit between two boxes stays
/// one. Through a periodic side the solid goes on. `first` to `last`, which is left out: the boxes to look at.
SolidCells solid_cells(const BoxLattice& lattice, const std::array<int, 3>& first, const std::array<int, 3>& last,
                       const SolidOnLattice& solid);

}  // namespace dmp::mesher
