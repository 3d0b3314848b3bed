// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <limits>
#include <string>
#include <vector>

#include "cli/uses.hpp"
#include "geometry/geometry.hpp"

namespace dmp::cli {

/// What a named curve of a geometry in 2-D looks like.
enum class CurveRole {
    wall,      ///< fluid on one side
    flexible,  ///< open, with fluid on both sides
    end,       ///< of the period
    nothing    ///< without fluid beside it, or closed with fluid on both sides
};

struct CurveGuess {
    std::string name;
    CurveRole role = CurveRole::nothing;
    double longest = 0;                                         ///< its longest piece [m]
    double shortest = std::numeric_limits<double>::infinity();  ///< and its shortest one [m]
    std::vector<Vec> held_ends{};  ///< of a flexible one: where it meets the edge of the fluid
    std::string anchor{};          ///< of a flexible one: the points or the wall that most of them lie on; empty: none
    std::size_t anchored = 0;      ///< how many of them
};

/// What a geometry in the plane of which nothing is known but its shapes looks like.
struct PlaneGuess {
    Box box;          ///< around all areas
    double area = 0;  ///< of them together [m^2]
    std::vector<CurveGuess> curves;
    std::array<bool, 2> periodic{};            ///< by axis
    std::vector<FaceSelection> caps{}, walls;  ///< of edges without a name: ends of the period, all others
    double across = 0;                         ///< the usual distance between walls: the median over their length [m]
    double narrowest_tip =
        std::numeric_limits<double>::infinity();  ///< from a loose end of a flexible curve to what is next to it [m]

    [[nodiscard]] bool is_flexible() const;  ///< whether it has flexible curves
    /// Two straight walls with nothing between them, along the one periodic axis.
    [[nodiscard]] bool is_a_straight_channel() const;
    [[nodiscard]] int longest_axis() const { return box.extent().y() > box.extent().x() ? 1 : 0; }
};

/// Every area is taken for fluid. first_scene_in_plane (cli/first_scene.hpp) tells the rules.
PlaneGuess guess_of_plane(const Geometry& geometry);

}  // namespace dmp::cli
