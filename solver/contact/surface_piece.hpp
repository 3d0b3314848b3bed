// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <utility>

#include "base/vec.hpp"

namespace dmp::solver {

/// A place on a piece of a surface: the shares of its corners, which add up to 1; two in 2-D, three in 3-D. A share of
/// exactly 0 is on the border: the other end of a curve, the edge across from that corner of a triangle.
using PiecePlace = std::array<double, 3>;

/// A piece of a surface with quadratic shape: in 2-D a Bezier curve with the solid on its left, in 3-D a Bezier
/// triangle, counter-clockwise seen from outside the solid.
struct SurfacePiece {
    static constexpr std::size_t most_controls = 6;

    std::size_t corners = 2;                   ///< of a curve 2, of a triangle 3
    std::array<Vec, most_controls> control{};  ///< the corners; then for each edge, from each corner to the next, its
                                               ///< middle one [m]

    [[nodiscard]] static constexpr std::size_t controls_of(std::size_t corners) { return corners == 2 ? 3 : 6; }
    [[nodiscard]] std::size_t controls() const { return controls_of(corners); }
    [[nodiscard]] PiecePlace middle() const {
        return corners == 2 ? PiecePlace{0.5, 0.5, 0} : PiecePlace{1.0 / 3, 1.0 / 3, 1.0 / 3};
    }

    /// Of the control points.
    [[nodiscard]] std::array<double, most_controls> shares(const PiecePlace& place) const {
        const auto [a, b, c] = place;
        if (corners == 2) return {a * a, b * b, 2 * a * b, 0, 0, 0};
        return {a * a, b * b, c * c, 2 * a * b, 2 * b * c, 2 * c * a};
    }
    [[nodiscard]] Vec at(const PiecePlace& place) const {
        const auto share = shares(place);
        Vec point = Vec::Zero();
        for (std::size_t k = 0; k < controls(); ++k) point += share[k] * control[k];
        return point;
    }
    /// dx by the shares of the second and of the third corner; the latter is zero on a curve [m].
    [[nodiscard]] std::array<Vec, 2> tangents(const PiecePlace& place) const;
    /// Unit vector out of the solid; zero where the piece has collapsed.
    [[nodiscard]] Vec normal(const PiecePlace& place) const;
    /// The weight of the normal there where pieces meet: at a corner of a triangle its angle, else 1 [rad].
    [[nodiscard]] double angle_at(const PiecePlace& place) const;
    /// Length, or area, per share of the second (and third) corner, such that that of the whole is the mean of it [m,
    /// m^2].
    [[nodiscard]] double measure(const PiecePlace& place) const;
    /// Gradient along the surface of what has these values at the corners and is linear in the shares [1/m].
    [[nodiscard]] Vec gradient(const PiecePlace& place, const std::array<double, 3>& of_corners) const;
    /// Gradients along the surface of the control points' shares [1/m].
    [[nodiscard]] std::array<Vec, most_controls> share_slopes(const PiecePlace& place) const;
    /// Low and high corner of a box that holds the piece.
    [[nodiscard]] std::pair<Vec, Vec> box() const;
    /// The place nearest to a point.
    [[nodiscard]] PiecePlace nearest(const Vec& point) const;
    /// Forces on the corners without a sum whose moment is this: the least ones, as of a rigid turn. [N m] -> [N]
    [[nodiscard]] std::array<Vec, 3> couple(const Vec& moment) const;

  private:
    [[nodiscard]] std::array<Vec, 2> corner_slopes(const PiecePlace& place) const;
    [[nodiscard]] PiecePlace nearest_on_triangle(const Vec& point) const;
    [[nodiscard]] PiecePlace nearest_on_border(const Vec& point, const PiecePlace& from) const;
};

/// A point at which a piece is sampled, with its share of the piece's measure().
struct QuadraturePoint {
    PiecePlace place;
    double weight;
};
/// Of a curve 4 Gauss points, exact for polynomials of degree 7; of a triangle 3, exact for degree 2.
[[nodiscard]] std::span<const QuadraturePoint> quadrature(std::size_t corners);

}  // namespace dmp::solver
