// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "particles/particle_set.hpp"
#include "solver/parallel/ranks.hpp"
#include "solver/store/particle_group.hpp"
#include "solver/store/position_quantum.hpp"
#include "solver/uses.hpp"

namespace dmp::solver {

/// This rank's share of the set's spheres, wherever they lie, with the velocities they start with.
ParticleGroup sphere_group(const ParticleSet& set, const PositionQuantum& quantum, const Ranks& ranks);

}  // namespace dmp::solver
