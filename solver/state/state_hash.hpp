// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>

#include "solver/parallel/ranks.hpp"
#include "solver/store/particle_store.hpp"

namespace dmp::solver {

/// A hash of all bits of the particles' ids, positions, velocities and densities, as 16 hex digits: the sum of a hash
/// of each particle, which needs neither an order nor memory. Positions are first moved into the box, along periodic
/// axes and between planes of symmetry.
/// All ranks must call it; rank 0 gets the hash.
std::string state_hash(std::span<const ParticleGroup> groups, const ParticleSpace& space, const Ranks& ranks);
inline std::string state_hash(const ParticleStore& particles, const Ranks& ranks) {
    return state_hash(particles.groups(), particles.space(), ranks);
}

}  // namespace dmp::solver
