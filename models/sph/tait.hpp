// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "models/registry.hpp"

namespace dmp::models {

/// Tait's equation of state for a weakly compressible fluid (Monaghan 1994 with gamma = 7):
///   p = (c0^2 rho0 / 7) [(rho/rho0)^7 - 1]   [Pa]
struct TaitEquation {
    static constexpr LawFacts facts{"tait", "Monaghan 1994", "Tait's equation with exponent 7"};

    double sound_speed;   ///< c0 [m/s]
    double rest_density;  ///< rho0 [kg/m^3]

    template <class T>
    [[nodiscard]] T pressure(const T& density) const {
        const T ratio = density * (1 / rest_density);
        const T cube = ratio * ratio * ratio;
        return sound_speed * sound_speed * rest_density / 7 * (cube * cube * ratio - T(1.0));
    }

    /// The inverse: density at which the fluid has this pressure [kg/m^3]; pressure must exceed `lowest_pressure`.
    [[nodiscard]] double density(double pressure) const {
        return rest_density * std::pow(1 + 7 * pressure / (sound_speed * sound_speed * rest_density), 1.0 / 7);
    }
    /// The pressure at zero density [Pa].
    [[nodiscard]] double lowest_pressure() const { return -sound_speed * sound_speed * rest_density / 7; }
};

}  // namespace dmp::models
