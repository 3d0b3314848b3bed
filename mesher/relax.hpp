// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "particles/particle_set.hpp"

namespace dmp {

/// Moves fluid particles near spring bodies until they are evenly spread: where a slanted body cuts the lattice,
/// particles stand too near or leave gaps. Steepest descent on the same sum that particle shifting uses; other
/// particles stay on the lattice. `support` is the kernel's support radius [m].
void relax_around_bodies(ParticleSet& particles, double support);

}  // namespace dmp
