// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

#include "base/simd/vector.hpp"
#include "models/sph/viscosity_means.hpp"
#include "models/uses.hpp"

namespace dmp::models {

/// The state of a particle used by the diffusion of a species. T is double, or Lanes for the particles of a cluster
/// in SIMD lanes.
template <class T, int D>
struct SpeciesPoint {
    Vector<T, D> position;
    T volume;         ///< V [m^3]
    T concentration;  ///< c, in the species' unit
    T diffusivity;    ///< D [m^2/s]; 0: impermeable to the species
};

/// The state of a particle of a rigid part. `concentration` is that of the surface if it is held, or the flux out of
/// it per area if that is given.
template <class T, int D>
struct SpeciesWallPoint : SpeciesPoint<T, D> {
    Vector<T, D> normal;  ///< from the surface into the fluid
    T depth;              ///< distance behind the surface [m]
    T held;               ///< 1: the surface is held at a concentration; otherwise 0
    T gives;              ///< 1: the surface has a given flux; otherwise 0
};

/// The state of a particle of an elastic part.
template <class T, int D>
struct SpeciesBodyPoint : SpeciesPoint<T, D> {
    T held;  ///< 1: the part's surface is held at the concentration; otherwise 0
};

/// Diffusion of a species between two particles: the amount that particle i gains from j per unit of time (Brookshaw
/// 1985; Cleary & Monaghan 1999, eq. 18, for amounts w = c V):
///   dw_i/dt = SUM_j V_i V_j [4 D_i D_j / (D_i + D_j)] (c_i - c_j) (1/r dW/dr)
/// It is antisymmetric, so that the total amount is conserved. The harmonic mean keeps the flux continuous where the
/// diffusivity jumps, and prevents flux into impermeable particles. The law omits the factor (1/r dW/dr), by which
/// the sweeps multiply the sum. Reads volume, concentration and diffusivity. Largest stable explicit step:
/// kernel.viscous_limit support^2 / D (linear theory, as for viscosity).
struct SpeciesDiffusion {
    double nearest;  ///< smallest distance to a surface used for a particle: dx/2 [m]

    /// V_i V_j times twice the mean diffusivity [m^6 m^2/s]: all factors but the difference of concentrations.
    template <class I, class J>
    [[nodiscard]] auto conductance(const I& i, const J& j) const {
        return (i.volume * j.volume) * (HarmonicMean::twice(i.diffusivity, j.diffusivity) + surface(i, j));
    }
    /// The amount that i gains from j, divided by the kernel's slope.
    template <class I, class J>
    [[nodiscard]] auto law(const I& i, const J& j) const {
        return conductance(i, j) * (i.concentration - j.concentration) + given(i, j);
    }

    /// The amount that i gains from j, divided by the kernel's slope, while `time` passes and shifting moves i by
    /// `shift` relative to the fluid. The fluid and the dissolved species stay in place: c(x + d) = c + d . grad c +
    /// (d . grad)^2 c / 2, with the gradient as SUM_j V_j (c_j - c_i) grad_i W_ij (Xu, Stansby & Laurence 2009 for
    /// velocities) and the second order as diffusion by d^2 / 2, with which an explicit step stays stable (Lax &
    /// Wendroff 1960). It is not antisymmetric: the change of the total amount has to be redistributed
    /// (SpeciesTransport).
    template <class I, class J, class Time, class Shift>
    [[nodiscard]] auto law_with_shift(const I& i, const J& j, const Time& time, const Shift& shift) const {
        const auto spreading = dot(shift, shift) - dot(shift, i.position - j.position);
        return (time * conductance(i, j) + (i.volume * j.volume) * spreading) * (i.concentration - j.concentration);
    }

  private:
    template <class P>
    static constexpr bool is_wall = requires(const P& p) {
        p.normal;
    };
    template <class P>
    static constexpr bool is_body = !is_wall<P> && requires(const P& p) {
        p.held;
    };

    /// A held surface lies between the particle and the wall particle. The concentration of the wall particle is
    /// extrapolated linearly from the particle's through the surface's, c_j = c_w - (d_j / d_i) (c_i - c_w), where d
    /// are the distances to the surface (as Morris, Fox & Zhu 1997, section 2.6, for velocities), so that c_i - c_j =
    /// (1 + d_j / d_i) (c_i - c_w).
    /// The surface of an elastic part, whose nodes have no normals, is half-way: d_j = d_i, as if the part conducted
    /// infinitely well.
    template <class I, class J>
    [[nodiscard]] auto surface(const I& i, const J& j) const {
        using T = decltype(i.volume * j.volume);
        T sum = T(0.0);
        if constexpr (is_wall<J>) sum = sum + j.held * (2.0 * i.diffusivity * behind(i, j));
        if constexpr (is_wall<I>) sum = sum + i.held * (2.0 * j.diffusivity * behind(j, i));
        if constexpr (is_body<J>) sum = sum + j.held * (4.0 * i.diffusivity);
        if constexpr (is_body<I>) sum = sum + i.held * (4.0 * j.diffusivity);
        return sum;
    }
    /// 1 + d_wall / d_particle.
    template <class P, class W>
    [[nodiscard]] auto behind(const P& particle, const W& wall) const {
        using std::max;
        using T = decltype(particle.volume * wall.volume);
        const T distance = T(dot(particle.position - wall.position, wall.normal)) - wall.depth;
        return T(1.0) + wall.depth / max(distance, T(nearest));
    }
    /// A flux J out of a surface: the amount J A of an area A is distributed over the particles in front of it,
    /// weighted by the kernel (after Ryan, Tartakovsky & Amon 2010): dw_i/dt = -2 J SUM_j V_i V_j n_j . x_ij (1/r
    /// dW/dr).
    template <class I, class J>
    [[nodiscard]] auto given(const I& i, const J& j) const {
        using T = decltype(i.volume * j.volume);
        T sum = T(0.0);
        if constexpr (is_wall<J> && !is_wall<I>)
            sum = sum -
                  j.gives * (2.0 * (i.volume * j.volume) * j.concentration) * dot(i.position - j.position, j.normal);
        if constexpr (is_wall<I> && !is_wall<J>)
            sum = sum +
                  i.gives * (2.0 * (i.volume * j.volume) * i.concentration) * dot(j.position - i.position, i.normal);
        return sum;
    }
};

}  // namespace dmp::models
