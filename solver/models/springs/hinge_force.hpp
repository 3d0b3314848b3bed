// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "solver/models/pair.hpp"

namespace dmp {

/// A hinge in the plane: U = k_a (theta - theta0)^2 (no 1/2), theta the signed angle at the centre from arm a to arm b.
///   F_a = 2 k_a (theta - theta0) n_a / |a|,  F_b = -2 k_a (theta - theta0) n_b / |b|,  F_centre = -F_a - F_b   [N]
/// with n the arm's direction turned by +90 degrees. The forces have no resultant and no moment.
struct HingeForce {
    double cosine, sine;  ///< of the rest angle
    double stiffness;     ///< k_a [J]

    HingeForce(double rest_angle, double k_a)
        : cosine(std::cos(rest_angle)), sine(std::sin(rest_angle)), stiffness(k_a) {}

    struct Forces {
        Vector<double, 2> on_a, on_b;
    };

    /// theta - theta0 in (-pi, pi], from the arms x_a - x_centre and x_b - x_centre.
    [[nodiscard]] double deviation(const Vector<double, 2>& a, const Vector<double, 2>& b) const {
        const double along = dot(a, b), across = a[0] * b[1] - a[1] * b[0];
        return std::atan2(across * cosine - along * sine, along * cosine + across * sine);
    }
    [[nodiscard]] Forces law(const Vector<double, 2>& a, const Vector<double, 2>& b) const {
        const double moment = 2 * stiffness * deviation(a, b);
        const double per_a = moment / dot(a, a), per_b = moment / dot(b, b);
        return {{{-per_a * a[1], per_a * a[0]}}, {{per_b * b[1], -per_b * b[0]}}};
    }
    [[nodiscard]] double energy(const Vector<double, 2>& a, const Vector<double, 2>& b) const {
        const double off = deviation(a, b);
        return stiffness * off * off;
    }
};

}  // namespace dmp
