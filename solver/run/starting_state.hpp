// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "models/sph/liquid_state.hpp"
#include "particles/particle_set.hpp"
#include "scene/scene.hpp"
#include "solver/store/particle_store.hpp"
#include "solver/uses.hpp"

namespace dmp::solver {

/// Whether the scene's fluid starts with other than no velocity and no pressure.
bool has_starting_state(const Scene& scene);

/// The particles as they start: at rest and at rest density, or as flow.initial_velocity and flow.initial_pressure say.
/// A fluid particle keeps the volume that the mesher gave it; under pressure its mass is that volume's at the density
/// of the equation of state. `states` by part number.
/// Throws InputError where a formula gives no number, less than the lowest pressure of the liquid, or a speed beyond
/// that of sound.
ParticleStore starting_particles(const Scene& scene, const ParticleSet& set, const std::vector<LiquidState>& states,
                                 const Ranks& ranks);

/// Puts the density that belongs to the starting pressure into a store that has that field.
void fill_starting_density(const Scene& scene, const ParticleSet& set, const std::vector<LiquidState>& states,
                           ParticleStore& particles);

}  // namespace dmp::solver
