// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "base/vec.hpp"
#include "solver/domain/bisection.hpp"
#include "solver/parallel/ranks.hpp"

namespace dmp::solver {

/// Space, cut into one box per rank by planes normal to the axes. Every point has one owner, which depends on its
/// coordinates alone; the other coordinates of a point on a cut decide on which side it is, so that a layer of a
/// lattice can be divided too. Boxes include all their sides; they may extend to infinity, have no extent, or be
/// empty (low > high).
class Regions {
  public:
    /// Rank 0 owns all of `space`.
    Regions(const Box& space, int ranks);
    /// Cuts `space` where `boxes`, one per rank, meet. This requires a plane with the boxes of the first ranks below
    /// and the others above, and the same again within both halves; otherwise returns nothing. Points on a cut belong
    /// above it.
    static std::optional<Regions> along(const Box& space, std::span<const Box> boxes);

    /// Divides the points that lie on a cut between its sides, such that the weights on the sides are in proportion
    /// to their numbers of ranks. Must be called by all ranks together, each with its own points.
    void divide_ties(const Ranks& ranks, const WeightedPoints& points);

    /// The owner of any point; a point outside the space belongs to an adjacent box.
    [[nodiscard]] int owner(const std::array<double, 3>& point) const {
        int part = root_;
        while (part >= 0) part = side(cuts_[static_cast<std::size_t>(part)], point);
        return -1 - part;
    }
    [[nodiscard]] const Box& box(int rank) const { return boxes_[static_cast<std::size_t>(rank)]; }

  private:
    /// A plane and the parts below and above it: an index into cuts_, or -1 - rank.
    struct Cut {
        int axis = 0;
        /// Position along this axis; for points on the plane, along the next axis; on that line, along the one after
        /// it (x follows z).
        std::array<double, 3> position{0, -std::numeric_limits<double>::infinity(),
                                       -std::numeric_limits<double>::infinity()};
        int below = 0, above = 0;
        double share_below = 0;  ///< fraction of the ranks that are below
    };

    /// The part below the cut or the part above it, whichever contains the point.
    static int side(const Cut& cut, const std::array<double, 3>& point) {
        for (int k = 0; k < 3; ++k) {
            const double coordinate = point[(cut.axis + k) % 3];
            if (coordinate != cut.position[k]) return coordinate < cut.position[k] ? cut.below : cut.above;
        }
        return cut.above;
    }

    bool cut(std::span<const Box> boxes, int first, int depth, int& part);
    void set_boxes(int part, const Box& box);

    std::vector<Cut> cuts_;
    std::vector<Box> boxes_;
    int root_ = -1;
    int depth_ = 0;  ///< largest number of cuts between all of space and one rank's box
};

}  // namespace dmp::solver
