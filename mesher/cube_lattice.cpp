// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "mesher/cube_lattice.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <map>
#include <numbers>
#include <sstream>
#include <utility>

#include "base/errors.hpp"

namespace dmp {

namespace {

using GridPlace = std::array<long, 3>;

/// Point numbers by their place on the grid.
std::map<GridPlace, int> on_grid(const std::vector<Vec>& points, const Vec& step) {
    std::map<GridPlace, int> number;
    for (std::size_t n = 0; n < points.size(); ++n) {
        GridPlace place{};
        double off = 0;
        for (int axis = 0; axis < 3; ++axis) {
            const double steps = (points[n][axis] - points[0][axis]) / step[axis];
            place[axis] = std::lround(steps);
            off = std::max(off, std::abs(steps - static_cast<double>(place[axis])));
        }
        std::ostringstream what;
        what << "point " << n << " at (" << points[n].transpose() << ") m";
        if (!(off < 1e-6))
            throw InputError(what.str() + " is not on the cubic grid that point 0 begins",
                             "give points whose distances along each axis are whole numbers of spacings");
        const auto [there, is_new] = number.emplace(place, static_cast<int>(n));
        if (!is_new)
            throw InputError(what.str() + " is point " + std::to_string(there->second) + " again", "give it once");
    }
    return number;
}

/// The eight corners of the cell whose lowest is at `place`; corner k is moved along axis i where bit i of k is 1.
bool corners_of(const std::map<GridPlace, int>& number, const GridPlace& place, std::array<int, 8>& corners) {
    for (int k = 0; k < 8; ++k) {
        const auto found = number.find({place[0] + (k & 1), place[1] + (k >> 1 & 1), place[2] + (k >> 2 & 1)});
        if (found == number.end()) return false;
        corners[k] = found->second;
    }
    return true;
}

}  // namespace

CubeConstants cube_constants(double youngs_modulus, double poisson_ratio, double spacing) {
    if (!(poisson_ratio >= 0 && poisson_ratio <= 0.25)) {
        std::ostringstream problem;
        problem << "a cubic lattice cannot have a Poisson ratio of " << poisson_ratio;
        throw InputError(problem.str(), "give one from 0 to 1/4: bonds alone give 1/4, and hinges lower it");
    }
    const double lame = youngs_modulus * poisson_ratio / ((1 + poisson_ratio) * (1 - 2 * poisson_ratio));
    const double shear = youngs_modulus / (2 * (1 + poisson_ratio));
    CubeConstants constants;
    constants.spacing = spacing;
    constants.edge_stiffness = (shear - lame / 2) * spacing;
    constants.diagonal_stiffness = lame * spacing / 2;
    // At 1/4 rounding must not leave hinges.
    constants.hinge_stiffness = poisson_ratio == 0.25 ? 0 : (shear - lame) * spacing * spacing * spacing / 8;
    return constants;
}

std::vector<bool> in_whole_cells(const std::vector<Vec>& points, const Vec& step) {
    const std::map<GridPlace, int> number = on_grid(points, step);
    std::vector<bool> whole(points.size(), false);
    for (const auto& [place, lowest] : number) {
        std::array<int, 8> corners{};
        if (!corners_of(number, place, corners)) continue;
        for (const int corner : corners) whole[static_cast<std::size_t>(corner)] = true;
    }
    return whole;
}

SpringLattice cube_lattice(const std::vector<Vec>& points, const CubeConstants& constants, const Vec& step) {
    const std::map<GridPlace, int> number = on_grid(points, step);
    std::map<std::pair<int, int>, double> bonds;  // stiffness by ends, the smaller number first
    std::map<std::array<int, 3>, double> hinges;  // by a, centre, b, a < b
    SpringLattice lattice;
    lattice.nodes = points;
    lattice.share.assign(points.size(), 0);
    for (const auto& [place, lowest] : number) {
        std::array<int, 8> corners{};
        if (!corners_of(number, place, corners)) continue;
        for (const int corner : corners) lattice.share[corner] += step.prod() / 8;
        for (int k = 0; k < 8; ++k)
            for (int m = k + 1; m < 8; ++m) {
                const int axes = std::popcount(static_cast<unsigned>(k ^ m));  // along which they differ
                if (axes == 3) continue;
                // Four cells share an edge, two a face.
                const double stiffness = axes == 1 ? constants.edge_stiffness / 4 : constants.diagonal_stiffness / 2;
                if (stiffness > 0) bonds[std::minmax(corners[k], corners[m])] += stiffness;
            }
        for (int k = 0; k < 8 && constants.hinge_stiffness > 0; ++k)
            for (int first = 0; first < 3; ++first)
                for (int second = 0; second < first; ++second) {
                    const auto [a, b] = std::minmax(corners[k ^ 1 << first], corners[k ^ 1 << second]);
                    hinges[{a, corners[k], b}] += constants.hinge_stiffness / 2;
                }
    }
    const auto alone = std::find(lattice.share.begin(), lattice.share.end(), 0.0);
    if (alone != lattice.share.end())
        throw InputError("point " + std::to_string(alone - lattice.share.begin()) + " is the corner of no whole cell",
                         "leave it out, or give all eight corners of a cell");
    for (const auto& [ends, stiffness] : bonds)
        lattice.bonds.push_back(
            {ends.first, ends.second, (points[ends.first] - points[ends.second]).norm(), stiffness});
    for (const auto& [nodes, stiffness] : hinges)
        lattice.hinges.push_back({nodes[0], nodes[1], nodes[2], std::numbers::pi / 2, stiffness});
    return lattice;
}

}  // namespace dmp
