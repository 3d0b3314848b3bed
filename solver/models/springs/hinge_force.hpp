// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "solver/models/pair.hpp"

namespace dmp {

/// A hinge in the plane with a rotational dashpot: U = k_a (theta - theta0)^2 (no 1/2), theta the signed angle at the
/// centre from arm a to arm b; moment M = 2 k_a (theta - theta0) + c dtheta/dt,
///   F_a = M n_a / |a|,  F_b = -M n_b / |b|,  F_centre = -F_a - F_b   [N]
/// with n the arm's direction turned by +90 degrees. The forces have no resultant and no moment.
/// c = 2 zeta sqrt(2 k_a I) is the fraction zeta of critical damping of the hinge alone, I the reduced moment of
/// inertia of its two arms about the centre.
struct HingeForce {
    double cosine, sine;  ///< of the rest angle
    double stiffness;     ///< k_a [J]
    double dashpot;       ///< c [J s]

    HingeForce(double rest_angle, double k_a, double damping, double reduced_inertia)
        : cosine(std::cos(rest_angle)),
          sine(std::sin(rest_angle)),
          stiffness(k_a),
          dashpot(2 * damping * std::sqrt(2 * k_a * reduced_inertia)) {}

    /// An arm from the centre: x_end - x_centre and v_end - v_centre.
    struct Arm {
        Vector<double, 2> reach, velocity;
    };
    struct Forces {
        Vector<double, 2> on_a, on_b;
    };

    /// theta - theta0 in (-pi, pi].
    [[nodiscard]] double deviation(const Vector<double, 2>& a, const Vector<double, 2>& b) const {
        const double along = dot(a, b), across = a[0] * b[1] - a[1] * b[0];
        return std::atan2(across * cosine - along * sine, along * cosine + across * sine);
    }
    [[nodiscard]] Forces law(const Arm& a, const Arm& b) const {
        const double per_a = 1 / dot(a.reach, a.reach), per_b = 1 / dot(b.reach, b.reach);
        const double rate = per_b * turning(b) - per_a * turning(a);
        const double moment = 2 * stiffness * deviation(a.reach, b.reach) + dashpot * rate;
        const double on_a = moment * per_a, on_b = moment * per_b;
        return {{{-on_a * a.reach[1], on_a * a.reach[0]}}, {{on_b * b.reach[1], -on_b * b.reach[0]}}};
    }
    [[nodiscard]] double energy(const Vector<double, 2>& a, const Vector<double, 2>& b) const {
        const double off = deviation(a, b);
        return stiffness * off * off;
    }

  private:
    static double turning(const Arm& arm) { return arm.reach[0] * arm.velocity[1] - arm.reach[1] * arm.velocity[0]; }
};

}  // namespace dmp
