// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "base/vec.hpp"

namespace dmp::solver {

/// Shares of the control points of a quadratic curve at t in [0, 1].
inline std::array<double, 3> bernstein(double t) { return {(1 - t) * (1 - t), 2 * t * (1 - t), t * t}; }

/// A piece of a surface in 2-D: a quadratic Bezier curve, with the solid on its left.
struct CurvePiece {
    std::array<Vec, 3> control;

    [[nodiscard]] Vec at(double t) const {
        const auto share = bernstein(t);
        return share[0] * control[0] + share[1] * control[1] + share[2] * control[2];
    }
    /// dx/dt [m]
    [[nodiscard]] Vec tangent(double t) const {
        return 2 * (1 - t) * (control[1] - control[0]) + 2 * t * (control[2] - control[1]);
    }
    /// Unit vector out of the solid.
    [[nodiscard]] Vec normal(double t) const {
        const Vec along = tangent(t);
        const double length = along.norm();
        return length > 0 ? Vec(along[1] / length, -along[0] / length, 0) : Vec(Vec::Zero());
    }
    /// Low and high corner of a box that holds the curve.
    [[nodiscard]] std::pair<Vec, Vec> box() const {
        return {control[0].cwiseMin(control[1]).cwiseMin(control[2]),
                control[0].cwiseMax(control[1]).cwiseMax(control[2])};
    }
    /// t of the nearest point, by Newton's method from that of the chord.
    [[nodiscard]] double nearest(const Vec& point) const {
        constexpr int most = 8;
        constexpr double enough = 1e-15;
        const Vec chord = control[2] - control[0];
        double t = std::clamp((point - control[0]).dot(chord) / chord.squaredNorm(), 0.0, 1.0);
        const Vec curvature = 2 * (control[0] - 2 * control[1] + control[2]);
        for (int k = 0; k < most; ++k) {
            const Vec off = at(t) - point, along = tangent(t);
            const double square = along.squaredNorm();
            // Away from the centre of curvature the distance has one minimum; near it Newton's step is cut short.
            const double slope = std::max(square + off.dot(curvature), 0.3 * square);
            const double next = std::clamp(t - off.dot(along) / slope, 0.0, 1.0);
            const bool is_there = std::abs(next - t) <= enough;
            t = next;
            if (is_there) break;
        }
        return t;
    }
};

/// Gauss points of a piece: exact for polynomials of degree 7.
inline constexpr std::array<double, 4> gauss_points{0.069431844202973712, 0.33000947820757187, 0.66999052179242813,
                                                    0.93056815579702629};
inline constexpr std::array<double, 4> gauss_weights{0.17392742256872693, 0.32607257743127307, 0.32607257743127307,
                                                     0.17392742256872693};

}  // namespace dmp::solver
