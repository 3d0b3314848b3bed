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

/// Space, cut by planes across the axes into one box a rank. Every point has one owner, which depends on its
/// coordinates alone; a point on a cut belongs to one side or the other by its other coordinates, so that a layer of a
/// lattice can be divided too. Boxes are named with all their sides; they may reach to infinity, have no extent, or be
/// empty (low > high).
class Regions {
  public:
    /// All of `space` is the first rank's.
    Regions(const Box& space, int ranks);
    /// `space` cut where `boxes`, one a rank, meet, if a plane has the first ranks' boxes below it and the others'
    /// above, and so on within both halves; nothing otherwise. Points on a cut belong above it.
    static std::optional<Regions> along(const Box& space, std::span<const Box> boxes);

    /// Divides the points that lie on a cut between its sides, so that the weight is divided as the ranks are. Called
    /// by all ranks together, each with its own points.
    void divide_ties(const Ranks& ranks, const WeightedPoints& points);

    /// Of any point; points outside of the space belong to a box next to them.
    [[nodiscard]] int owner(const std::array<double, 3>& point) const {
        int part = root_;
        while (part >= 0) part = side(cuts_[static_cast<std::size_t>(part)], point);
        return -1 - part;
    }
    [[nodiscard]] const Box& box(int rank) const { return boxes_[static_cast<std::size_t>(rank)]; }

  private:
    /// A plane, and what lies below it and above: an index into cuts_, or -1 - rank.
    struct Cut {
        int axis = 0;
        /// Along this axis; on the plane, along the next; and on that line, along the one after it (x follows z).
        std::array<double, 3> position{0, -std::numeric_limits<double>::infinity(),
                                       -std::numeric_limits<double>::infinity()};
        int below = 0, above = 0;
        double share_below = 0;  ///< part of the ranks that are below
    };

    /// The part below a cut or above it.
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
    int depth_ = 0;  ///< most cuts between the whole and one rank's box
};

}  // namespace dmp::solver
