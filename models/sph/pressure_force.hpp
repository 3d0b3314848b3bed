// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "models/pair.hpp"

namespace dmp::models {

/// Pressure force on particle i (Bonet & Lok 1999; the variational partner of ContinuityRate):
///   F_i = - SUM_j V_i V_j (p_i + p_j) grad_i W_ij   [N]
/// Reads volume and pressure. Antisymmetric: momentum is conserved pair by pair.
struct PressureForce {
    template <class P>
    static auto law(const P& p) {
        return (-1.0 * p.weight() * (p.i.pressure + p.j.pressure)) * p.separation;
    }
};

}  // namespace dmp::models
