// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/vec.hpp"

namespace dmp::models {

/// The softened repulsion from a moving shape that chosen parts alone feel, a ghost for all others: of range r* and
/// strength K, in the distance d from the shape (the thesis, eq. 6.7, with the distance from a curve in place of those
/// from the particles on it):
///   f(d) = K (1 + cos(pi d / r*)), 0 < d < r*;   U(d) = K (r* - d - r*/pi sin(pi d / r*));   f = U = 0 beyond.
/// One-sided shapes push what is behind them (d < 0) back with f(0) = 2 K: U(d) = K r* - 2 K d.
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
    /// Half of 2 / omega, of the largest stiffness pi K / r* [s].
    [[nodiscard]] double step_limit(double mass) const {
        return std::sqrt(mass * range / (std::numbers::pi * strength));
    }
};

/// How far from a shape a point is, and which way from the nearest point of it. Across z all shapes are alike.
struct FromShape {
    double distance = 0;      ///< from the curve; below 0: behind a one-sided one [m]
    Vec away = Vec::UnitX();  ///< unit vector from the curve to the point, or back out from behind
};

/// Which of a shape's sides are pushed away from.
enum class ShapeSide { both, inside, outside };

/// An arc of the parabola y = height (x / half_width)^2, |x| <= half_width, about its vertex. Inside is where the focus
/// is.
struct ParabolaArc {
    double half_width = 1;  ///< [m]
    double height = 1;      ///< below 0: it opens downward [m]
    ShapeSide side = ShapeSide::both;

    /// x of the arc's point nearest to (x, y), x >= 0, of the whole parabola y = c x^2, c > 0: the only positive root
    /// of 2 c^2 s^3 + (1 - 2 c y) s - x, to which Newton's steps come down from above.
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

    /// Of a point given from the vertex.
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
        // On the curve itself: along its normal, to the inside.
        const Vec normal = Vec(-right * 2 * c * at, up, 0).normalized();
        Vec away = distance > 0 ? Vec(apart / distance) : normal;
        if (distance == 0 && side == ShapeSide::outside) away = -normal;
        const bool behind =
            !ended && side != ShapeSide::both && distance > 0 && is_inside != (side == ShapeSide::inside);
        return behind ? FromShape{-distance, Vec(-away)} : FromShape{distance, away};
    }
};

/// A circle about its centre.
struct Circle {
    double radius = 1;  ///< [m]
    ShapeSide side = ShapeSide::both;

    [[nodiscard]] FromShape from(const Vec& point) const {
        const double r = std::hypot(point[0], point[1]);
        const Vec outward = r > 0 ? Vec(point[0] / r, point[1] / r, 0) : Vec(Vec::UnitX());
        const bool pushes_out = side == ShapeSide::outside || (side == ShapeSide::both && r >= radius);
        const double distance = pushes_out ? r - radius : radius - r;
        return {distance, pushes_out ? outward : Vec(-outward)};
    }
};

}  // namespace dmp::models
