// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <numbers>
#include <utility>
#include <vector>

#include "particles/particle_set.hpp"
#include "solver/contact/surface_piece.hpp"
#include "solver/uses.hpp"

namespace dmp::solver {

/// Where a surface turns by more it has a corner, or an edge; by less it is straight there, or flat [rad].
inline constexpr double sharp_turn = 30 * std::numbers::pi / 180, straight_turn = 1e-4;

/// The drawn surfaces that touch as smooth pieces between corners, or edges (30 degrees). Control points are shares of
/// drawn points; pieces that meet at an end, or at an edge, share its control points.
struct DrawnSurfaces {
    using OfPoints = std::vector<std::pair<int, double>>;

    struct Piece {
        int part = 0;
        double thickness = 0;  ///< [m]
        std::array<int, SurfacePiece::most_controls> control{};
    };

    std::size_t corners = 2;  ///< of each piece
    std::vector<OfPoints> controls;
    std::vector<Piece> pieces;
    /// By control point: whether the surface sticks out there as a corner, or an edge.
    std::vector<bool> is_sharp;
    /// By control point: whether it does, or the surface ends there: nothing is beyond it.
    std::vector<bool> is_end;
};

/// In 2-D: quadratic B-splines through the drawn points, so that the normal has no steps; straight lines stay lines,
/// piece by piece.
DrawnSurfaces draw_curves(const ParticleSpace& space);

/// In 3-D: each triangle with edges that are curved as the quadratic surface through the points around them, so that
/// the steps of the normal are of the order of the square of a triangle's size.
DrawnSurfaces draw_triangles(const ParticleSpace& space);

}  // namespace dmp::solver
