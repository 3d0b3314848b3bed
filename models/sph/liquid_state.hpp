// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string_view>

#include "base/enum_names.hpp"
#include "models/sph/linear_state.hpp"
#include "models/sph/tait.hpp"

namespace dmp::models {

enum class EquationOfState { tait, linear };

/// How the pressure of one fluid part follows from its density: the equation that the scene chose, and a background
/// pressure p_b on top [Pa]. The force between two particles goes with the sum of their pressures: p_b pushes particles
/// apart evenly, where there are any around, and keeps those of confined or periodic fluids under compression.
struct LiquidState {
    double sound_speed;              ///< c0 [m/s]
    double rest_density;             ///< rho0 [kg/m^3]
    double background_pressure = 0;  ///< p_b [Pa]
    EquationOfState equation = EquationOfState::tait;

    [[nodiscard]] double pressure(double density) const {
        return by_equation([&](const auto& state) { return state.pressure(density); }) + background_pressure;
    }
    /// Density at which the liquid has this pressure over the background [kg/m^3]; it must exceed `lowest_pressure`.
    [[nodiscard]] double density(double over_background) const {
        return by_equation([&](const auto& state) { return state.density(over_background); });
    }
    /// The pressure of a vanishing density, less the background [Pa].
    [[nodiscard]] double lowest_pressure() const {
        return by_equation([](const auto& state) { return state.lowest_pressure(); });
    }

  private:
    template <class Value>
    [[nodiscard]] double by_equation(const Value& value) const {
        return equation == EquationOfState::tait ? value(TaitEquation{sound_speed, rest_density})
                                                 : value(LinearEquation{sound_speed, rest_density});
    }
};

}  // namespace dmp::models

namespace dmp {

template <>
inline constexpr auto enum_names<models::EquationOfState> =
    std::to_array<std::string_view>({"tait", "linear"});

}  // namespace dmp
