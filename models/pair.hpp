// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/simd/vector.hpp"
#include "models/uses.hpp"

namespace dmp::models {

/// A fluid particle as pair laws see it. T is double, or Lanes for the particles of a cluster side by side.
template <class T, int D>
struct FluidPoint {
    Vector<T, D> position, velocity;
    T volume, density, pressure, viscosity;
};

/// A particle of a wall or a spring body. Density and pressure are its own (used by plain walls alone).
template <class T, int D>
struct SolidPoint {
    Vector<T, D> position, velocity;
    T volume, density, pressure;
    Vector<T, D> normal;                               ///< rigid walls: from the surface into the fluid; else 0
    T depth;                                           ///< rigid walls: distance behind the surface; else 0 [m]
    T slip = T(0.0);                                   ///< rigid walls: 1 where the fluid slips; else 0
    Vector<T, D> acceleration = Vector<T, D>::zero();  ///< of rigid walls that move; else 0 [m/s^2]
};

/// Two particles that meet: i is the one acted upon.
/// Every pair law is proportional to `slope`. The sweeps give it as 1 and multiply their sum of laws by it: the slope
/// follows from a square root, and what can be computed while that takes its time should be.
template <class I, class J, class Separation, class Distance, class Slope>
struct Pair {
    const I& i;
    const J& j;
    Separation separation;  ///< x_i - x_j [m]
    Distance distance;      ///< |x_i - x_j| [m]
    Slope slope;            ///< (1/r) dW/dr [1/m^(D+2)]

    /// V_i V_j (1/r) dW/dr, which the forces share [m^(D-2)].
    [[nodiscard]] auto weight() const { return i.volume * j.volume * slope; }
};

template <class I, class J, class Separation, class Distance, class Slope>
Pair(const I&, const J&, Separation, Distance, Slope) -> Pair<I, J, Separation, Distance, Slope>;

}  // namespace dmp::models
