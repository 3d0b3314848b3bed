// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <numbers>

#include "models/springs/spring.hpp"

namespace dmp::models {

/// A hinge with a rotational dashpot at a node between arms to nodes a and b: U = k_a (theta - theta0)^2 (no 1/2).
///
/// In 2-D theta is the signed angle from arm a to arm b, in (-pi, pi]; in 3-D it is the angle between them, in [0,
/// pi]. With M = 2 k_a (theta - theta0) + c dtheta/dt and n the unit normal of the plane of the arms (z in 2-D)
///   F_a = -M (a x n) / a^2,   F_b = M (b x n) / b^2,   F_centre = -F_a - F_b   [N]
/// The forces have no resultant and no moment. They are finite at any angle because nothing is divided by a sine. For
/// collinear arms in 3-D this plane is undefined; any plane through the arms is used, and a hinge whose rest angle is
/// straight has no force there. See Spring for the dashpot; its moment of inertia is the reduced moment of inertia of
/// the two arms about the centre. It damps bending, but not the rotation of a bent pair of arms about its bisector.
template <int D>
struct HingeForce : Spring {
    static constexpr int nodes = 3;                                  ///< a, centre, b
    static constexpr std::array<ArmEnds, 2> arms{{{0, 1}, {2, 1}}};  ///< a and b from the centre

    double rest_angle;    ///< theta0 [rad]
    double cosine, sine;  ///< of it

    HingeForce(double theta0, double k_a, double damping, double reduced_inertia)
        : HingeForce(theta0, Spring(k_a, damping, reduced_inertia)) {}
    HingeForce(double theta0, const Spring& spring)
        : Spring(spring),
          rest_angle(theta0),
          cosine(std::cos(theta0)),
          sine(theta0 == std::numbers::pi ? 0 : std::sin(theta0)) {}

    /// theta - theta0, in (-pi, pi].
    [[nodiscard]] Deviation<D, 2> deviation(const Arms<D, 2>& arm) const {
        const Vector<double, D>&a = arm[0], &b = arm[1];
        const double along = dot(a, b), per_a = 1 / dot(a, a), per_b = 1 / dot(b, b);
        if constexpr (D == 2) {
            const double across = a[0] * b[1] - a[1] * b[0];
            return {from_rest(along, across), {{{{per_a * a[1], -per_a * a[0]}}, {{-per_b * b[1], per_b * b[0]}}}}};
        } else {
            const auto normal = unit_normal(a, b);
            const auto turned = cross(a, b);
            return {from_rest(along, std::sqrt(dot(turned, turned))),
                    {per_a * cross(a, normal), -per_b * cross(b, normal)}};
        }
    }

    /// In 3-D the arms also rotate out of their plane. With the rotations p, q,
    ///   d2theta = [cos theta (p^2 + q^2) - 2 p q] / sin theta = [-tan(theta/2) (p + q)^2 + cot(theta/2) (p - q)^2]
    ///   / 2.
    /// One of the two terms is positive after multiplication by (theta - theta0), and is visited; for hinges with a
    /// straight rest angle it is as large as the stiffness within the plane. In 2-D the omitted terms are of the
    /// order of the deviation.
    template <class Visit>
    void extra_stiffness(const Arms<D, 2>& arm, const Visit& visit) const {
        if constexpr (D == 3) {
            const Vector<double, 3>&a = arm[0], &b = arm[1];
            const double value = deviation(arm).value;
            if (value == 0 && sine != 0) return;
            const double length_a = std::sqrt(dot(a, a)), length_b = std::sqrt(dot(b, b));
            const auto normal = unit_normal(a, b);
            const auto turned = cross(a, b);
            const double s = std::sqrt(dot(turned, turned)) / (length_a * length_b);
            const double c = dot(a, b) / (length_a * length_b);
            const double opposite = value < 0 || (value == 0 && cosine < 0) ? 1 : -1;  // p + q, or p - q
            // |value| / sin theta tends to 1 as the angle tends to a straight rest angle.
            const double over_sine = s > flat ? std::abs(value) / s : (sine == 0 ? 1 : std::abs(value) / flat);
            visit(stiffness * over_sine * (1 - opposite * c),
                  Arms<3, 2>{(1 / length_a) * normal, (opposite / length_b) * normal});
        }
    }

  private:
    static constexpr double flat = 1e-6;  ///< below this sine, the arms count as collinear

    [[nodiscard]] double from_rest(double along, double across) const {
        return std::atan2(across * cosine - along * sine, along * cosine + across * sine);
    }
    static Vector<double, 3> unit_normal(const Vector<double, 3>& a, const Vector<double, 3>& b) {
        const auto normal = cross(a, b);
        const double square = dot(normal, normal), smallest = std::numeric_limits<double>::epsilon();
        if (!(square > smallest * smallest * dot(a, a) * dot(b, b))) return unit_across((1 / std::sqrt(dot(a, a))) * a);
        return (1 / std::sqrt(square)) * normal;
    }
};

}  // namespace dmp::models
