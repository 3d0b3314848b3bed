// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "particles/particle_set.hpp"

namespace dmp::particles {

/// Two particles nearer to each other than this [spacings] count as one place taken twice.
inline constexpr double nearest_apart = 1e-3;

/// Throws InputError, with ids, parts and place, when a position is not finite or two particles (periods counted) lie
/// nearer to each other than nearest_apart: forces between them would be without measure.
void check_apart(const ParticleSet& particles);

}  // namespace dmp::particles
