// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "solver/parallel/ranks.hpp"
#include "solver/store/particle_store.hpp"

namespace dmp {

/// FNV-1a (64 bit) over the bits of all positions, velocities and densities in id order, as 16 hex digits; positions as
/// they are in the box, along periodic axes. All ranks take part; the first one gets the hash.
std::string state_hash(const ParticleStore& particles, const Ranks& ranks);

}  // namespace dmp
