// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "models/springs/spring.hpp"

namespace dmp::models {

/// A dihedral with a rotational dashpot over nodes a, b, c, d: U = k_d (phi - phi0)^2 (no 1/2). phi in (-pi, pi] is
/// the angle between the planes abc and bcd, positive when d is turned clockwise from a, seen from b to c; phi = pi:
/// all nodes in one plane, a and d on different sides of bc. With the arms F = x_a - x_b, G = x_b - x_c, H = x_d -
/// x_c and A = F x G, B = H x G,
///   phi = atan2((B x A) . G / |G|, A . B),
///   dphi/dF = -|G| / A^2 A,   dphi/dH = |G| / B^2 B,   dphi/dG = (F . G) / (A^2 |G|) A - (H . G) / (B^2 |G|) B
/// (Blondel & Karplus 1996: no division by sin phi). If three nodes are collinear, the angle is undefined and the
/// force is 0. See Spring for the dashpot; its moment of inertia is the reduced moment of inertia of a and d about
/// bc.
struct DihedralForce : Spring {
    static constexpr int nodes = 4;                                          ///< a, b, c, d
    static constexpr std::array<ArmEnds, 3> arms{{{0, 1}, {1, 2}, {3, 2}}};  ///< F, G, H

    double rest_angle;    ///< phi0 [rad]
    double cosine, sine;  ///< of it

    DihedralForce(double phi0, double k_d, double damping, double reduced_inertia)
        : DihedralForce(phi0, Spring(k_d, damping, reduced_inertia)) {}
    DihedralForce(double phi0, const Spring& spring)
        : Spring(spring), rest_angle(phi0), cosine(std::cos(phi0)), sine(std::sin(phi0)) {}

    /// phi of the arms, in (-pi, pi] [rad].
    static double angle(const Arms<3, 3>& arm) {
        const auto a = cross(arm[0], arm[1]), b = cross(arm[2], arm[1]);
        return std::atan2(dot(cross(b, a), arm[1]) / std::sqrt(dot(arm[1], arm[1])), dot(a, b));
    }

    /// phi - phi0, in (-pi, pi].
    [[nodiscard]] Deviation<3, 3> deviation(const Arms<3, 3>& arm) const {
        const auto& [f, g, h] = arm;
        const auto a = cross(f, g), b = cross(h, g);
        const double a2 = dot(a, a), b2 = dot(b, b), g2 = dot(g, g), length = std::sqrt(g2);
        if (!(a2 > line * dot(f, f) * g2) || !(b2 > line * dot(h, h) * g2)) return {0, {}};
        const double across = dot(cross(b, a), g) / length, along = dot(a, b);
        return {
            std::atan2(across * cosine - along * sine, along * cosine + across * sine),
            {(-length / a2) * a, (dot(f, g) / (a2 * length)) * a - (dot(h, g) / (b2 * length)) * b, (length / b2) * b}};
    }

    /// None: all omitted terms are of the order of the deviation.
    template <class Visit>
    void extra_stiffness(const Arms<3, 3>& /*arm*/, const Visit& /*visit*/) const {}

  private:
    static constexpr double line = 1e-24;  ///< below this square of the sine, three nodes count as collinear
};

}  // namespace dmp::models
