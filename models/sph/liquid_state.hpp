// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "models/sph/fluid_law_list.hpp"
#include "models/sph/linear_state.hpp"
#include "models/sph/tait.hpp"

namespace dmp::models {

// A law of EquationsOfState is constructed from the speed of sound c0 [m/s] and the rest density rho0 [kg/m^3], and has
//   pressure(density)   [Pa], 0 at rest
//   density(pressure)   its inverse [kg/m^3]
//   lowest_pressure()   at zero density [Pa]

/// Equation of state of a fluid part: the chosen equation plus a background pressure p_b [Pa]. The force between two
/// particles is proportional to the sum of their pressures: p_b pushes particles apart evenly where they have
/// neighbours, and keeps those of confined or periodic fluids under compression.
struct LiquidState {
    double sound_speed;              ///< c0 [m/s]
    double rest_density;             ///< rho0 [kg/m^3]
    double background_pressure = 0;  ///< p_b [Pa]
    EquationOfState equation = EquationOfState::of<TaitEquation>();

    [[nodiscard]] double pressure(double density) const {
        return by_equation([&](const auto& state) { return state.pressure(density); }) + background_pressure;
    }
    /// Density at which the fluid has this pressure above the background [kg/m^3]; it must exceed `lowest_pressure`.
    [[nodiscard]] double density(double over_background) const {
        return by_equation([&](const auto& state) { return state.density(over_background); });
    }
    /// The pressure at zero density, less the background [Pa].
    [[nodiscard]] double lowest_pressure() const {
        return by_equation([](const auto& state) { return state.lowest_pressure(); });
    }

  private:
    template <class Value>
    [[nodiscard]] double by_equation(const Value& value) const {
        return equation.visit([&]<class Law>() { return value(Law{sound_speed, rest_density}); });
    }
};

}  // namespace dmp::models
