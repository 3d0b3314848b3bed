// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesher/uses.hpp"
#include "particles/particle_set.hpp"
#include "scene/scene.hpp"

namespace dmp::mesher {

/// Throws InputError where a wall between fluids has a single row of particles. A particle of a wall has one surface;
/// the fluid on the other side is behind it, by more than a spacing, where the stability monitor takes it for lost.
/// Wherever the nearest wall particle has the fluid behind it, those up to a spacing further away are asked, and
/// nothing is said where an elastic solid is nearer, as in the monitor.
void refuse_single_rows(const ParticleSet& set, const Scene& scene);

}  // namespace dmp::mesher
