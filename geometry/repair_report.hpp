// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "geometry/fill_holes.hpp"

namespace dmp::geometry {

/// A piece of a surface that was thrown away.
struct ThrownPiece {
    std::size_t triangles = 0;
    Vec position = Vec::Zero();  ///< the middle of its box [m]
    double diagonal = 0;         ///< of its box [m]
    double area = 0;             ///< [m^2]
    bool is_small = false;       ///< smaller than the limit; else it is closed without any volume
};

/// By which rung of the ladder a surface got an inside.
enum class RepairedBy {
    nothing,  ///< it was closed
    closing,  ///< what it was made of closes, after the first rungs
    vote,     ///< it has holes: the winding number says what is inside
    wrap      ///< another surface stands around it
};

/// What repair_surface found and did, rung by rung.
struct RepairReport {
    double spacing = 0;  ///< of the particles [m]
    std::size_t triangles_before = 0, triangles = 0;
    std::size_t equal_corners = 0;   ///< corners that became one with another at the same place
    std::size_t welded_corners = 0;  ///< and with one nearby
    double weld_distance = 0;        ///< [m]
    std::size_t without_area = 0, duplicates = 0, inner_walls = 0;  ///< triangles that were dropped
    std::size_t t_junctions = 0;                                    ///< corners put on edges of other triangles
    std::size_t separated_edges = 0;                                ///< in which closed pieces touched others
    std::size_t turned = 0;                                         ///< triangles
    std::vector<SurfaceHole> holes;                                 ///< filled or not
    std::vector<ThrownPiece> thrown;
    std::size_t pieces = 0;  ///< that are left
    RepairedBy by = RepairedBy::nothing;
    double doubt = 0;                        ///< WindingVote::doubt, of a surface with holes
    double wrap_alpha = 0, wrap_offset = 0;  ///< [m]; of a wrapped surface
    std::size_t self_intersections = 0;      ///< pairs of triangles that meet where they should not; not of a wrap
    std::optional<Vec> first_self_intersection;

    /// Whether the surface is another than it was, besides corners at the same place.
    [[nodiscard]] bool changed() const;
    /// What was found and done in words, one rung a line; none for a surface that was in order.
    [[nodiscard]] std::vector<std::string> lines() const;
};

}  // namespace dmp::geometry
