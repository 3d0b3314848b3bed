// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "models/pair.hpp"

namespace dmp::models {

/// Transport velocity (Adami, Hu & Adams 2013): particles move with v~ = v + u, u the velocity that a background
/// pressure p_b = rho c0^2, constant in 3-D, would give them in half a step from rest, which spreads them evenly:
///   u_i = -(dt/2) (p_b / m_i) SUM_j (V_i^2 + V_j^2) grad_i W_ij   [m/s]
/// What they then carry astray of their momentum comes back as the divergence of a stress A = rho v u:
///   F_i = SUM_j V_i V_j (A_i + A_j) grad_i W_ij   [N]
/// (their eq. 15 with 2 V_i V_j for V_i^2 + V_j^2, as in all forces here; antisymmetric). Solids count in the
/// spreading, with their volumes; they carry no stress. For confined or periodic fluids: it would blow a free surface
/// apart.
struct TransportVelocity {
    /// Term of SUM_j (V_i^2 + V_j^2) / V_i grad_i W_ij [1/m].
    template <class P>
    static auto spreading(const P& p) {
        return ((p.i.volume * p.i.volume + p.j.volume * p.j.volume) / p.i.volume * p.slope) * p.separation;
    }

    /// Force on i by the stress of one particle of the pair, i or j [N]; u its velocity of transport less its own
    /// [m/s]. Apart, so that both rounded terms of a pair cancel.
    template <class P, class Point, class U>
    static auto law(const P& p, const Point& of, const U& u) {
        return (p.weight() * (of.density * dot(u, p.separation))) * of.velocity;
    }

    /// Displacement of a whole step per unit of the spreading sum [m^2]: dt u, with p_b V_i / m_i = c0^2.
    static double step(double sound_speed, double dt) { return -0.5 * dt * dt * sound_speed * sound_speed; }
};

}  // namespace dmp::models
