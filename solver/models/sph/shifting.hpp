// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "particles/kernels.hpp"
#include "solver/models/pair.hpp"

namespace dmp {

/// Particle shifting that keeps particles evenly spread (after Sun, Colagrossi, Marrone & Zhang 2017):
///   dx_i = - s U dt R SUM_j [1 + 0.2 (W_ij / W(dx))^4] V_j grad_i W_ij,   |dx_i| <= 0.1 dx
/// with R the support radius and U the largest speed in the fluid. The sum vanishes where particles are even.
/// The pair law is the term of the sum [1/m]; `step` turns the sum into a displacement [m].
template <class Kernel>
struct Shifting {
    double strength;  ///< s [-]
    double support;   ///< R [m]
    double spacing;   ///< dx [m]
    double inverse_kernel_at_spacing;

    Shifting(double s, double support_radius, double dx, const Kernel& kernel)
        : strength(s), support(support_radius), spacing(dx), inverse_kernel_at_spacing(1 / kernel.value(dx)) {}

    template <class P>
    [[nodiscard]] auto law(const P& p, const Kernel& kernel) const {
        const auto ratio = kernel.value(p.distance) * inverse_kernel_at_spacing;
        return (0.2 * square(square(ratio)) + 1.0) * ((p.j.volume * p.slope) * p.separation);
    }

    /// Displacement per unit of the sum for one step [m^2], before the cap at 0.1 dx.
    [[nodiscard]] double step(double largest_speed, double dt) const {
        return -strength * largest_speed * dt * support;
    }
    [[nodiscard]] double longest() const { return 0.1 * spacing; }
};

}  // namespace dmp
