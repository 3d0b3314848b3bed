// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "solver/neighbours/cluster_list.hpp"
#include "solver/store/particle_store.hpp"

namespace dmp::solver {

/// Makes liquid particles of this rank, of those whose ids these are (in order), particles of spring bodies. Id, part,
/// mass, velocity, volume and density stay what they are; they stand `ahead` [s] of their velocity further on, as the
/// nodes of spring bodies do. Walls repel them from no farther than where they stand. The list must be up to date.
/// Copies go, and neighbours have to be found anew.
void solidify_particles(ParticleStore& particles, std::span<const std::int64_t> ids, double ahead,
                        const ClusterList& list);

}  // namespace dmp::solver
