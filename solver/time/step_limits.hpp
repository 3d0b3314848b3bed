// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <vector>

#include "solver/forcing/driving.hpp"
#include "solver/results/plan.hpp"

namespace dmp::solver {

/// Parts of the models' limits that steps may take: keys of [numerics] (scene.hpp).
struct StepFactors {
    double viscous = 0.5, species = 0.5, contact = 0.5, light_solid = 0.4, density_diffusion = 0.12, shifting = 1.2;
};

/// What the fluid step may depend on.
struct StepScales {
    double support = 0;                                           ///< R [m]
    double sound_speed = 0;                                       ///< c0 [m/s]
    double density_ratio = 1;                                     ///< of the heaviest liquid to the lightest [-]
    double kinematic_viscosity = 0;                               ///< largest nu of the scene [m^2/s]
    double viscous_limit = 0;                                     ///< of the kernel, nu dt / R^2 [-]
    double step_factor = 0;                                       ///< c0 dt / R asked for [-]
    double shifting = 0;                                          ///< s [-]
    double density_diffusion = 0;                                 ///< delta [-]
    double drive_time = std::numeric_limits<double>::infinity();  ///< in which what drives the scene changes [s]
    double contact_limit = 0;                                     ///< 2 / omega [s]; 0: no contact
    double surface_contact_limit = 0;                             ///< of surfaces [s]; 0: none
    bool elastic_solids = false;                                  ///< there are some that move
    double lightest_solid = 1;  ///< least mass of an elastic node over that of the liquid it displaces, at most 1 [-]
    bool implicit_viscosity = false;
    double diffusivity = 0;      ///< largest of any species [m^2/s]
    double diffusion_limit = 0;  ///< of the kernel, D dt / R^2 [-]
    bool implicit_species = false;
    bool at_rest = false;  ///< only species are stepped
    StepFactors factors;
};

/// Of explicit viscosity.
StepLimit viscous_step_limit(const StepScales& scales);
/// Of the explicit diffusion of species.
StepLimit species_step_limit(const StepScales& scales);

/// Largest fluid step by each model, at the given speed [m/s] and body acceleration [m/s^2] of the moment.
std::vector<StepLimit> fluid_step_limits(const StepScales& scales, double largest_speed, double acceleration);

/// Adds the limit of what drives the scene and changes in this time [s] (drive_time), 22 steps in a period of a sine,
/// where none of the others is shorter.
void add_drive_limit(std::vector<StepLimit>& limits, double drive_time);

/// Adds that of forces on parts and of moving shapes at time t, if there is one, of particles that see over `length`
/// [m].
void add_driving_limit(std::vector<StepLimit>& limits, const Driving& driving, double length, double t);

/// The shortest of them.
const StepLimit& ruling_limit(const std::vector<StepLimit>& limits);

}  // namespace dmp::solver
