// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/simd/vector.hpp"
#include "models/uses.hpp"

namespace dmp::models {

/// The state of a fluid particle that pair laws use. T is double, or Lanes for the particles of a cluster in SIMD
/// lanes.
template <class T, int D>
struct FluidPoint {
    Vector<T, D> position, velocity;
    T volume, density, pressure, viscosity;
    /// Of the corrected scheme (velocity_gradient.hpp); other schemes leave it as here.
    T correction = T(1.0);                                               ///< b = tr B / D [-]
    Vector<Vector<T, D>, D> gradient = Vector<Vector<T, D>, D>::zero();  ///< G, [a][b] = dv_a/dx_b [1/s]
    Vector<T, D> velocity_by_gradient = Vector<T, D>::zero();  ///< images of solids: what G adds to velocity [m/s]
};

/// A particle of a wall or an elastic body. Density and pressure are its own (only plain walls use them).
template <class T, int D>
struct SolidPoint {
    Vector<T, D> position, velocity;
    T volume, density, pressure;
    Vector<T, D> normal;                               ///< unit vector out of the surface, or 0 (SolidSurface)
    T depth;                                           ///< distance behind that surface [m]
    T slip = T(0.0);                                   ///< rigid walls: 1 where the fluid slips; otherwise 0
    Vector<T, D> acceleration = Vector<T, D>::zero();  ///< of moving rigid walls; otherwise 0 [m/s^2]
    Vector<T, D> motion = Vector<T, D>::zero();        ///< rigid walls: of the particle itself; otherwise 0 [m/s]
    T sliding = T(0.0);  ///< rigid walls: 1 where the surface slides or the fluid slips; otherwise 0
    /// Rigid walls: of the surface's velocity; elastic solids: of their own, [a][b] = dv_a/dx_b [1/s].
    Vector<Vector<T, D>, D> surface_gradient = Vector<Vector<T, D>, D>::zero();
    T opposite = T(0.0);  ///< elastic solids: distance to the surface on the other side, against the normal [m]
    T held = T(0.0);      ///< elastic solids: 1 where the body is clamped somewhere; otherwise 0
};

/// Two interacting particles; a law returns its effect on i. Every pair law is proportional to `slope`. The sweeps
/// set it to 1 and multiply the sum of the laws by the true slope at the end: the slope requires a square root, whose
/// latency then overlaps with the other computations.
template <class I, class J, class Separation, class Distance, class Slope>
struct Pair {
    const I& i;
    const J& j;
    Separation separation;  ///< x_i - x_j [m]
    Distance distance;      ///< |x_i - x_j| [m]
    Slope slope;            ///< (1/r) dW/dr [1/m^(D+2)]

    /// V_i V_j (1/r) dW/dr, common to the forces [m^(D-2)].
    [[nodiscard]] auto weight() const { return i.volume * j.volume * slope; }
};

template <class I, class J, class Separation, class Distance, class Slope>
Pair(const I&, const J&, Separation, Distance, Slope) -> Pair<I, J, Separation, Distance, Slope>;

}  // namespace dmp::models
