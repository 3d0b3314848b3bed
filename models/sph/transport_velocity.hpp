// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "models/pair.hpp"

namespace dmp::models {

/// Transport velocity (Adami, Hu & Adams 2013): particles move with v~ = v + u, where u is the velocity that a
/// uniform background pressure p_b = rho c0^2 would cause in half a step from rest; it spreads particles evenly:
///   u_i = -(dt/2) (p_b / m_i) SUM_j (V_i^2 + V_j^2) grad_i W_ij   [m/s]
/// The momentum that particles thereby carry along is corrected by the divergence of a stress A = rho v u:
///   F_i = SUM_j V_i V_j (A_i + A_j) grad_i W_ij   [N]
/// (their eq. 15 with 2 V_i V_j for V_i^2 + V_j^2, as in all forces here; antisymmetric). Solids contribute to the
/// spreading with their volumes; they have no such stress. For confined or periodic fluids only: it would blow a free
/// surface apart.
struct TransportVelocity {
    /// Term of SUM_j (V_i^2 + V_j^2) / V_i grad_i W_ij [1/m].
    template <class P>
    static auto spreading(const P& p) {
        return ((p.i.volume * p.i.volume + p.j.volume * p.j.volume) / p.i.volume * p.slope) * p.separation;
    }

    /// Force on i due to the stress of one particle of the pair, i or j [N]; u is its transport velocity less its own
    /// velocity [m/s]. One particle at a time, so that both rounded terms of a pair cancel.
    template <class P, class Point, class U>
    static auto law(const P& p, const Point& of, const U& u) {
        return (p.weight() * (of.density * dot(u, p.separation))) * of.velocity;
    }

    /// Displacement of a whole step per unit of the spreading sum [m^2]: dt u, with p_b V_i / m_i = c0^2.
    static double step(double sound_speed, double dt) { return -0.5 * dt * dt * sound_speed * sound_speed; }
};

}  // namespace dmp::models
