// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "particles/particle_set.hpp"

namespace dmp::particles {

/// A hash (XXH64) of all that a set took from its geometry, as 16 hex digits: space, parts, places, walls, and which
/// particles springs connect at which rest lengths and angles. Left out is what follows from values of the scene at the
/// same places: masses, stiffnesses and the motion at the start.
[[nodiscard]] std::string fingerprint(const ParticleSet& set);

}  // namespace dmp::particles
