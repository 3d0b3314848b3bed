// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "models/registry.hpp"

namespace dmp::models {

/// The linear equation of state of a weakly compressible fluid (Morris, Fox & Zhu 1997, eq. 8, less its constant):
///   p = c0^2 (rho - rho0)   [Pa]
/// Tait's equation to first order in the compression; the speed of sound is c0 at every density.
struct LinearEquation {
    static constexpr LawFacts facts{"linear", "Morris, Fox & Zhu 1997, eq. 8", "Tait's equation to first order"};

    double sound_speed;   ///< c0 [m/s]
    double rest_density;  ///< rho0 [kg/m^3]

    template <class T>
    [[nodiscard]] T pressure(const T& density) const {
        return (sound_speed * sound_speed) * (density - T(rest_density));
    }

    /// The inverse: density at which the fluid has this pressure [kg/m^3]; pressure must exceed `lowest_pressure`.
    [[nodiscard]] double density(double pressure) const {
        return rest_density + pressure / (sound_speed * sound_speed);
    }
    /// The pressure at zero density [Pa].
    [[nodiscard]] double lowest_pressure() const { return -sound_speed * sound_speed * rest_density; }
};

}  // namespace dmp::models
