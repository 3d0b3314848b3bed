// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "scene/scene.hpp"
#include "solver/models/sph/linear_state.hpp"
#include "solver/models/sph/tait.hpp"

namespace dmp {

/// How the pressure of one fluid part follows from its density: the equation that the scene chose, and a background
/// pressure p_b on top [Pa]. The force between two particles goes with the sum of their pressures: p_b pushes particles
/// apart evenly, where there are any around, and keeps those of confined or periodic fluids under compression.
struct LiquidState {
    double sound_speed;              ///< c0 [m/s]
    double rest_density;             ///< rho0 [kg/m^3]
    double background_pressure = 0;  ///< p_b [Pa]
    EquationOfState equation = EquationOfState::tait;

    [[nodiscard]] double pressure(double density) const {
        const double own = equation == EquationOfState::tait
                               ? TaitEquation{sound_speed, rest_density}.pressure(density)
                               : LinearEquation{sound_speed, rest_density}.pressure(density);
        return own + background_pressure;
    }
};

}  // namespace dmp
