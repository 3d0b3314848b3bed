// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "models/sph/liquid_state.hpp"
#include "scene/scene.hpp"
#include "solver/parallel/resources.hpp"
#include "solver/sweeps/pair_sweeps.hpp"
#include "solver/time/step_limits.hpp"
#include "solver/uses.hpp"

namespace dmp::solver {

/// c0: the scene's, or the largest speed it expects over numerics.mach_number: 0.1 keeps density within about 1 %
/// [m/s].
double sound_speed(const Scene& scene);

/// What the pair terms need; "auto" values decided.
PairSettings pair_settings(const Scene& scene, const Resources& resources);

/// The same with what the particles at the start decide: whether the hydrostatic correction is needed.
PairSettings pair_settings(const Scene& scene, const ParticleSet& set, const Resources& resources);

/// Equation of state by part number; solids stand in for the first fluid part.
std::vector<LiquidState> equations_of_state(const Scene& scene, const ParticleSpace& space);

/// By part number: of the liquid that a particle is, or stands in for [kg/m^3].
std::vector<double> rest_densities(const Scene& scene, const ParticleSet& set);

/// Writes what a particle has of its part's values alone: viscosity, and whether a wall slips or slides.
void fill_by_part(const Scene& scene, ParticleStore& particles);

/// Writes the fluid's density and viscosity, wall surfaces and contact ranges into the fields that the store has.
void fill_store(const Scene& scene, const ParticleSet& set, ParticleStore& particles);

/// What the fluid step depends on.
StepScales step_scales(const Scene& scene, const ParticleSet& set, const PairSettings& settings, double viscous_limit);

/// Largest stable explicit step of two liquid particles with a bond that the rule makes [s].
double new_bond_limit(const Scene& scene, const Solidify& rule);

}  // namespace dmp::solver
