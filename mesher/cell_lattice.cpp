// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "mesher/cell_lattice.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <map>
#include <numbers>
#include <span>
#include <sstream>
#include <utility>

#include "base/errors.hpp"

namespace dmp::mesher {

namespace {

using GridIndex = std::array<long, 3>;

/// Points by their place on a grid that may be periodic.
class Grid {
  public:
    Grid(const std::vector<Vec>& points, const Vec& step, int dimension, const std::array<long, 3>& period)
        : period_(period) {
        for (std::size_t n = 0; n < points.size(); ++n) {
            GridIndex position{};
            double off = 0;
            for (int axis = 0; axis < dimension; ++axis) {
                const double steps = (points[n][axis] - points[0][axis]) / step[axis];
                position[axis] = std::lround(steps);
                off = std::max(off, std::abs(steps - static_cast<double>(position[axis])));
                low_[axis] = std::min(low_[axis], position[axis]);
            }
            std::ostringstream what;
            what << "point " << n << " at (" << points[n].transpose() << ") m";
            if (!(off < 1e-6))
                throw InputError(what.str() + " is not on the grid that point 0 begins",
                                 "give points whose distances along each axis are whole numbers of spacings");
            const auto [there, is_new] = number_.emplace(position, static_cast<int>(n));
            if (!is_new)
                throw InputError(what.str() + " is point " + std::to_string(there->second) + " again", "give it once");
        }
    }
    [[nodiscard]] const std::map<GridIndex, int>& points() const { return number_; }
    /// The corners of the cell whose lowest is at `place`, eight or, in 2-D, four; corner k is moved along axis i
    /// where bit i of k is 1.
    bool corners_of(const GridIndex& position, std::span<int> corners) const {
        for (int k = 0; k < static_cast<int>(corners.size()); ++k) {
            GridIndex corner = position;
            for (int axis = 0; axis < 3; ++axis) {
                corner[axis] += k >> axis & 1;
                if (period_[axis] > 0 && corner[axis] - low_[axis] >= period_[axis]) corner[axis] -= period_[axis];
            }
            const auto found = number_.find(corner);
            if (found == number_.end()) return false;
            corners[k] = found->second;
        }
        return true;
    }

  private:
    std::array<long, 3> period_;
    GridIndex low_{};
    std::map<GridIndex, int> number_;
};

}  // namespace

CellConstants cell_constants(double youngs_modulus, double poisson_ratio, double spacing, int dimension) {
    if (!(poisson_ratio >= 0 && poisson_ratio <= 0.25)) {
        std::ostringstream problem;
        problem << "a lattice of cells cannot have a Poisson ratio of " << poisson_ratio;
        throw InputError(problem.str(), "give one from 0 to 1/4: bonds alone give 1/4, and hinges lower it");
    }
    const double lame = youngs_modulus * poisson_ratio / ((1 + poisson_ratio) * (1 - 2 * poisson_ratio));
    const double shear = youngs_modulus / (2 * (1 + poisson_ratio));
    CellConstants constants;
    constants.dimension = dimension;
    constants.spacing = spacing;
    constants.edge_stiffness = (shear - (dimension - 2) * lame / 2) * constants.depth();
    constants.diagonal_stiffness = lame * constants.depth() / 2;
    // At 1/4 rounding must not leave hinges.
    constants.hinge_stiffness = poisson_ratio == 0.25 ? 0 : (shear - lame) * spacing * spacing * constants.depth() / 8;
    return constants;
}

std::array<long, 3> points_in_period(const ParticleSpace& space, const Vec& step) {
    std::array<long, 3> period{};
    for (int axis = 0; axis < space.dimension; ++axis)
        if (space.periodic[axis]) period[axis] = std::lround(space.box.extent()[axis] / step[axis]);
    return period;
}

std::vector<bool> in_whole_cells(const std::vector<Vec>& points, const Vec& step, int dimension,
                                 const std::array<long, 3>& period) {
    const Grid grid(points, step, dimension, period);
    std::vector<bool> whole(points.size(), false);
    std::vector<int> corners(1U << dimension);
    for (const auto& [position, lowest] : grid.points()) {
        if (!grid.corners_of(position, corners)) continue;
        for (const int corner : corners) whole[static_cast<std::size_t>(corner)] = true;
    }
    return whole;
}

SpringLattice cell_lattice(const std::vector<Vec>& points, const CellConstants& constants, const Vec& step,
                           const std::array<long, 3>& period) {
    const int dimension = constants.dimension;
    const Grid grid(points, step, dimension, period);
    const auto between = [&](int from, int to) {
        Vec apart = points[to] - points[from];
        for (int axis = 0; axis < dimension; ++axis)
            if (const double length = static_cast<double>(period[axis]) * step[axis]; length > 0)
                apart[axis] -= length * std::round(apart[axis] / length);
        return apart;
    };
    const int count = 1 << dimension;  // corners of a cell
    const double cell = step.head(dimension).prod();
    std::map<std::pair<int, int>, double> bonds;  // stiffness by ends, the smaller number first
    std::map<std::array<int, 3>, double> hinges;  // by a, centre, b, a < b
    SpringLattice lattice;
    lattice.nodes = points;
    lattice.share.assign(points.size(), 0);
    std::vector<int> corners(static_cast<std::size_t>(count));
    for (const auto& [position, lowest] : grid.points()) {
        if (!grid.corners_of(position, corners)) continue;
        for (const int corner : corners) lattice.share[corner] += cell / count;
        for (int k = 0; k < count; ++k)
            for (int m = k + 1; m < count; ++m) {
                const int axes = std::popcount(static_cast<unsigned>(k ^ m));  // along which they differ
                if (axes == 3) continue;
                // In 3-D four cells share an edge and two a face, in 2-D two an edge.
                const double stiffness =
                    axes == 1 ? constants.edge_stiffness / (count / 2) : constants.diagonal_stiffness / (count / 4);
                if (stiffness > 0) bonds[std::minmax(corners[k], corners[m])] += stiffness;
            }
        for (int k = 0; k < count && constants.hinge_stiffness > 0; ++k)
            for (int first = 0; first < dimension; ++first)
                for (int second = 0; second < first; ++second) {
                    const auto [a, b] = std::minmax(corners[k ^ 1 << first], corners[k ^ 1 << second]);
                    hinges[{a, corners[k], b}] += constants.hinge_stiffness / (count / 4);
                }
    }
    const auto alone = std::find(lattice.share.begin(), lattice.share.end(), 0.0);
    if (alone != lattice.share.end())
        throw InputError("point " + std::to_string(alone - lattice.share.begin()) + " is the corner of no whole cell",
                         "leave it out, or give all corners of a cell");
    for (const auto& [ends, stiffness] : bonds)
        lattice.bonds.push_back({ends.first, ends.second, between(ends.second, ends.first).norm(), stiffness});
    for (const auto& [nodes, stiffness] : hinges) {
        // In 2-D angles have a sign: from the first arm to the second, counter-clockwise.
        const Vec first = between(nodes[1], nodes[0]), second = between(nodes[1], nodes[2]);
        const bool clockwise = dimension == 2 && first.x() * second.y() - first.y() * second.x() < 0;
        const double rest = (clockwise ? -1 : 1) * std::numbers::pi / 2;
        lattice.hinges.push_back({nodes[0], nodes[1], nodes[2], rest, stiffness});
    }
    return lattice;
}

}  // namespace dmp::mesher
