// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

#include "models/pair.hpp"
#include "models/sph/kernels.hpp"

namespace dmp::models {

/// Particle shifting, which keeps particles evenly spread (after Sun, Colagrossi, Marrone & Zhang 2017):
///   dx_i = - s U dt R SUM_j [1 + 0.2 (W_ij / W(dx))^4] V_j grad_i W_ij,   |dx_i| <= 0.1 dx
/// with the support radius R and the speed U of the flow: 2.5 times the quartic mean of the fluid's speeds,
/// <v^4>^(1/4), at most the largest speed. (The authors use the largest speed alone, which may be that of a single
/// particle that shifting itself has disturbed, and this would increase the shifting.) The sum vanishes where
/// particles are evenly spread. Near a free surface it points out of the fluid. There the displacement decreases with
/// the divergence of position, SUM_j V_j x_ji . grad_i W_ij, from full at D, with neighbours on all sides, to none at
/// 3/4 D (Lee et al. 2008; Mokos, Rogers & Stansby 2017). The pair law is the term of the sum [1/m]; `step` converts
/// the sum into a displacement [m].
template <class Kernel>
struct Shifting {
    double strength;       ///< s [-]
    double support;        ///< R [m]
    double spacing;        ///< dx [m]
    double fourth_factor;  ///< 0.2 / W(dx)^4

    Shifting(double s, double support_radius, double dx, const Kernel& kernel)
        : strength(s), support(support_radius), spacing(dx), fourth_factor(0.2 / square(square(kernel.value(dx)))) {}

    template <class P>
    [[nodiscard]] auto law(const P& p, const Kernel& kernel) const {
        return factor(p.distance, kernel) * ((p.j.volume * p.slope) * p.separation);
    }
    /// 1 + 0.2 (W_ij / W(dx))^4, times `scale`.
    template <class T>
    [[nodiscard]] auto factor(const T& distance, const Kernel& kernel, double scale = 1) const {
        return (scale * fourth_factor) * square(square(kernel.value(distance))) + scale;
    }

    /// Term of the divergence of position [-].
    template <class P>
    static auto divergence(const P& p) {
        return -1.0 * (p.j.volume * p.slope) * (p.distance * p.distance);
    }
    /// Factor of the displacement near a free surface [-].
    template <int D, class T>
    static T kept(const T& divergence) {
        using std::max;
        using std::min;
        return max(T(0.0), min(T(1.0), (4.0 / D) * divergence - T(3.0)));
    }

    /// The normal of the walls nearby, shorter than 1 from the second row of particles on [-]; from - SUM_j V_j (1/r
    /// dW/dr) x_ij over the walls' particles [1/m].
    template <class T, int D>
    [[nodiscard]] Vector<T, D> normal_of_walls(const Vector<T, D>& sum) const {
        using std::max;
        using std::sqrt;
        constexpr double beyond = 0.1;  // a flat wall gives 0.42 at the first row, 0.08 at the second
        const T size = spacing * sqrt(dot(sum, sum));
        return (T(spacing) / max(size, T(beyond))) * sum;
    }

    /// U from the quartic mean and the largest speed of the fluid [m/s].
    static double speed(double quartic_mean, double largest) { return std::min(2.5 * quartic_mean, largest); }
    /// Displacement per unit of the sum for one step [m^2], before the cap at 0.1 dx; with U [m/s].
    [[nodiscard]] double step(double speed, double dt) const { return -strength * speed * dt * support; }
    /// The same with the speed of sound in place of U (corrected scheme), at most at the limit of what is stable,
    /// s c0 dt / R = 0.1 [m^2]. Fluid at rest is kept evenly spread too, and what shifting does in a given time does
    /// not depend on the step. With a free surface, where the sum vanishes for no arrangement, 20 U takes the place of
    /// a faster speed of sound: fluid at rest is left alone.
    [[nodiscard]] double step_by_sound(double sound_speed, double dt) const {
        return -std::min(strength * sound_speed * dt / support, 0.1) * support * support;
    }
    [[nodiscard]] double longest() const { return 0.1 * spacing; }
};

/// The part of a shift by which velocity and density are interpolated anew: not that along a wall's normal, which
/// pressure takes back without interpolating. With it, each step would add momentum to fluid beside walls.
template <class T, int D>
Vector<T, D> interpolated_part(const Vector<T, D>& shift, const Vector<T, D>& off_walls) {
    return shift - dot(shift, off_walls) * off_walls;
}

}  // namespace dmp::models
