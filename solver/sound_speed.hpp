// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "particles/particle_set.hpp"
#include "scene/scene.hpp"
#include "solver/uses.hpp"

namespace dmp::solver {

/// The speed of sound that a scene runs with, and what it follows from. A weakly compressible liquid stays within Ma^2
/// of its rest density (Ma = accuracy.mach_number) when c0 >= U / Ma (the dynamic pressure rho U^2, Monaghan 1994) and
/// c0^2 >= p / (Ma^2 rho) (any other pressure; Morris, Fox & Zhu 1997, eq. 9).
struct SoundSpeed {
    double value = 0;                    ///< c0 [m/s]
    double largest_pressure = 0;         ///< expected, by flow.largest_pressure or the estimate [Pa]
    bool pressure_is_estimated = false;  ///< from the body acceleration and the fluid's extent
    bool pressure_rules = false;         ///< else the largest speed does, or the scene gives c0
};

/// Where the scene leaves the pressure open, it is that of a column of the densest liquid under the body acceleration,
/// as long as the fluid is at the start, summed over the axes that are not periodic; the acceleration is the largest of
/// 64 instants of the run (components that depend on place count 0).
SoundSpeed choose_sound_speed(const Scene& scene, const ParticleSet& set);

/// The scene with that speed of sound in place of an "auto" that looks at speeds alone.
Scene with_sound_speed(Scene scene, const SoundSpeed& chosen);

}  // namespace dmp::solver
