// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "particles/particle_set.hpp"
#include "scene/scene.hpp"
#include "solver/uses.hpp"

namespace dmp::solver {

/// The shortest time scale of the formulas that drive the scene: the range of a formula's values over the median rate
/// at which it changes where it does. 0.45 periods of a sine; infinite for what is constant or only jumps [s]. Formulas
/// of place are taken at one particle of each part concerned.
double drive_time(const Scene& scene, const ParticleSet& set);

}  // namespace dmp::solver
