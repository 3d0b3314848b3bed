// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "solver/store/particle_store.hpp"

namespace dmp {

/// FNV-1a (64 bit) over the bits of all positions, velocities and densities in id order, as 16 hex digits.
std::string state_hash(const ParticleStore& particles);

}  // namespace dmp
