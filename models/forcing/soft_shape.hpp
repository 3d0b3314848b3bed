// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/unlisted_value.hpp"
#include "base/vec.hpp"

namespace dmp::models {

/// Softened repulsion from a moving shape. It acts only on chosen parts; other particles pass through the shape. With
/// range r*, strength K and distance d from the shape (the thesis, eq. 6.7, with the distance from a curve instead of
/// the distances from the particles on it):
///   f(d) = K (1 + cos(pi d / r*)), 0 < d < r*;   U(d) = K (r* - d - r*/pi sin(pi d / r*));   f = U = 0 beyond.
/// One-sided shapes push particles behind them (d < 0) back with f(0) = 2 K: U(d) = K r* - 2 K d.
struct SoftRepulsion {
    double strength = 0;  ///< K [N]
    double range = 0;     ///< r* [m]

    /// Away from the shape [N].
    [[nodiscard]] double force(double distance) const {
        if (distance >= range) return 0;
        return distance <= 0 ? 2 * strength : strength * (1 + std::cos(std::numbers::pi * distance / range));
    }
    /// [J]
    [[nodiscard]] double energy(double distance) const {
        if (distance >= range) return 0;
        if (distance <= 0) return strength * (range - 2 * distance);
        const double angle = std::numbers::pi * distance / range;
        return strength * (range - distance - range / std::numbers::pi * std::sin(angle));
    }
    /// Half of 2 / omega for the largest stiffness pi K / r* [s].
    [[nodiscard]] double step_limit(double mass) const {
        return std::sqrt(mass * range / (std::numbers::pi * strength));
    }
};

/// Distance of a point from a shape, and direction from the nearest point of the shape. All shapes are uniform along
/// z.
struct FromShape {
    double distance = 0;      ///< from the curve; negative behind a one-sided curve [m]
    Vec away = Vec::UnitX();  ///< unit vector from the curve to the point; behind the curve, the opposite direction
};

/// The side of a shape on which it repels.
enum class ShapeSide { both, inside, outside };

/// Whether it repels on its inside, or else on its outside.
[[nodiscard]] inline bool repels_on(ShapeSide side, bool is_inside) {
    switch (side) {
        case ShapeSide::both:
            return true;
        case ShapeSide::inside:
            return is_inside;
        case ShapeSide::outside:
            return !is_inside;
    }
    unlisted_value(side);
}

/// An arc of the parabola y = height (x / half_width)^2, |x| <= half_width, relative to its vertex. The inside
/// contains the focus.
struct ParabolaArc {
    double half_width = 1;  ///< [m]
    double height = 1;      ///< negative: it opens downward [m]
    ShapeSide side = ShapeSide::both;

    /// x of the point of the whole parabola y = c x^2, c > 0, nearest to (x, y), x >= 0: the only positive root of 2
    /// c^2 s^3 + (1 - 2 c y) s - x. Newton's method starts above the root and decreases towards it.
    static double nearest(double c, double x, double y) {
        const double cubic = 2 * c * c, linear = 1 - 2 * c * y;
        double s = std::cbrt(x / cubic) + std::sqrt(std::max(0.0, -linear) / cubic);
        for (int step = 0; step < 200; ++step) {
            const double slope = 3 * cubic * s * s + linear;
            if (!(slope > 0)) return s;
            const double next = s - ((cubic * s * s + linear) * s - x) / slope;
            if (!(next < s)) return s;
            s = next;
        }
        return s;
    }

    /// Distance and direction of a point given relative to the vertex.
    [[nodiscard]] FromShape from(const Vec& point) const {
        const double up = height < 0 ? -1 : 1, right = point[0] < 0 ? -1 : 1;
        const double c = std::abs(height) / (half_width * half_width);
        const double x = right * point[0], y = up * point[1];
        const double s = nearest(c, x, y);
        const bool ended = s > half_width;
        const double at = std::min(s, half_width);
        const Vec apart(right * (x - at), up * (y - c * at * at), 0);
        const double distance = apart.norm();
        const bool is_inside = y > c * x * x;
        // A point on the curve: along the normal, to the inside.
        const Vec normal = Vec(-right * 2 * c * at, up, 0).normalized();
        Vec away = distance > 0 ? Vec(apart / distance) : normal;
        if (distance == 0 && !repels_on(side, true)) away = -normal;
        const bool behind = !ended && distance > 0 && !repels_on(side, is_inside);
        return behind ? FromShape{-distance, Vec(-away)} : FromShape{distance, away};
    }
};

/// A circle, relative to its centre.
struct Circle {
    double radius = 1;  ///< [m]
    ShapeSide side = ShapeSide::both;

    [[nodiscard]] FromShape from(const Vec& point) const {
        const double r = std::hypot(point[0], point[1]);
        const Vec outward = r > 0 ? Vec(point[0] / r, point[1] / r, 0) : Vec(Vec::UnitX());
        const bool pushes_out = repels_on(side, false) && (r >= radius || !repels_on(side, true));
        const double distance = pushes_out ? r - radius : radius - r;
        return {distance, pushes_out ? outward : Vec(-outward)};
    }
};

}  // namespace dmp::models
