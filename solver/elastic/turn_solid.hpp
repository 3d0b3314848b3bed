// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "solver/neighbours/cluster_list.hpp"
#include "solver/store/particle_store.hpp"

namespace dmp::solver {

/// Turns this rank's fluid particles with these ids (sorted) into particles of elastic bodies. Id, part, mass,
/// velocity, volume and density stay the same; positions are advanced by `ahead` [s] at their velocity, as those of
/// the nodes of elastic bodies. The range of repulsion by walls is at most their distance to the walls. The list must
/// be up to date. Ghosts are dropped, and neighbours must be found again.
void solidify_particles(ParticleStore& particles, std::span<const std::int64_t> ids, double ahead,
                        const ClusterList& list);

}  // namespace dmp::solver
