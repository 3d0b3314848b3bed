// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

#include "models/uses.hpp"

namespace dmp::models {

/// What closes voids in a liquid without a free surface. Forces are of pressures less their mean over the liquid, so
/// that a void has the mean pressure: where solids part it can grow, and no pressure around it takes it back. A real
/// one has the pressure of vapour, below all others. So while there is a void what is subtracted is less than the mean
/// by the suction
///     dq/dt = (3 s - q) / T,   s^2 = <(p' - <p'>)^2>   [Pa],   T = 10 R / c0,
/// p' being less the level and its hydrostatic slope. It pulls at the edges of voids, and presses together solids that
/// touch, as no liquid is between them. Elsewhere it acts like any p': it stiffens the arrangement of the particles,
/// which adds a viscosity of about 0.75 q dt (viscosity_in_tension.hpp). Without a void q goes to 0. It does work on
/// what it moves, and needs no shorter step: q is of the size of the pressures that there are.
///
/// Particles beside a void have neighbours on one side only. The mean of the diagonal of their correction B
/// (gradient_correction.hpp) is 1.35 or more then: at a flat free surface in 2-D it is 1.67, in sound runs up to 1.07,
/// beside clots 1.17. Or B is 1 for want of neighbours, as at a flat surface in 3-D; nowhere else is it exactly 1. One
/// or two such particles may be there for some steps where solids part.
struct VoidClosing {
    static constexpr int fewest_particles = 3;

    [[nodiscard]] static bool is_beside_void(double mean_correction) {
        return mean_correction >= 1.35 || mean_correction == 1;
    }
    /// T [s]
    [[nodiscard]] static double time(double support, double sound_speed) { return 10 * support / sound_speed; }
    /// q after a step of this share of T, with so many particles beside voids and the deviation s; exactly 0 once it
    /// has faded.
    [[nodiscard]] static double suction(double before, double particles, double deviation, double share) {
        const bool is_open = particles >= fewest_particles;
        const double target = is_open ? 3 * deviation : 0;
        const double after = before + std::min(1.0, share) * (target - before);
        return is_open || (deviation > 0 && after > 1e-3 * deviation) ? after : 0;
    }
};

}  // namespace dmp::models
