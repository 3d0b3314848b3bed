// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "particles/particle_set.hpp"
#include "solver/parallel/ranks.hpp"
#include "solver/uses.hpp"

namespace dmp::solver {

/// Copies rank 0's particles to all ranks; each then selects its share (ParticleStore).
void share_particles(ParticleSet& particles, const Ranks& ranks);

}  // namespace dmp::solver
