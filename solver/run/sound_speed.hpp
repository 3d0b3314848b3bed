// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "particles/particle_set.hpp"
#include "scene/scene.hpp"
#include "solver/results/plan.hpp"
#include "solver/uses.hpp"

namespace dmp::solver {

/// "auto" is the fastest that any of these requires (SoundSpeed): the largest speed; the largest pressure, if given, in
/// the lightest fluid; else the pressures of column_pressures, each by the density of its fluid, and the viscous
/// pressure mu U / l next to a body that moves at the largest speed, l being four spacings, half of the smallest body
/// that particles resolve. Where the last determines c0, U R / nu < 0.75, and the viscous step limit is far shorter
/// than that of sound, so that it costs nothing. It is left out with implicit viscosity, where it would, and with the
/// plain scheme, whose answer depends on c0.
SoundSpeed choose_sound_speed(const Scene& scene, const ParticleSet& set);

/// Warns of a speed of sound, given or by a pressure that is given, with which the pressures of column_pressures change
/// a density by more than 5 %. As long as sound needs to cross the fluid the change is not seen in the densities
/// reached.
std::vector<Warning> sound_speed_warnings(const Scene& scene, const ParticleSet& set, const SoundSpeed& chosen);

/// Of the scene's fluids [kg/m^3]; infinite without any.
double lightest_density(const Scene& scene);

/// The scene with that speed of sound in place of an "auto" that looks at speeds alone.
Scene with_sound_speed(Scene scene, const SoundSpeed& chosen);

}  // namespace dmp::solver
