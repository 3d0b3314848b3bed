// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "particles/particle_set.hpp"
#include "scene/scene.hpp"
#include "solver/uses.hpp"

namespace dmp::solver {

/// The shortest time over which one of the formulas that drive the scene runs through its values: their range over the
/// median of the rate at which it changes. 0.45 periods of a sine; infinite for what is constant or jumps [s].
/// Formulas of place are taken at one fluid particle.
double drive_time(const Scene& scene, const ParticleSet& set);

}  // namespace dmp::solver
