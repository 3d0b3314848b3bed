// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "particles/particle_set.hpp"

namespace dmp::particles {

/// Fluid between solids that are few particles apart.
struct NarrowGaps {
    std::size_t fluid = 0;    ///< particles of fluids
    std::size_t inside = 0;   ///< those of them in gaps that hold fewer particles across than asked for
    int fewest = 0;           ///< across the narrowest gap, where there is one
    Vec place = Vec::Zero();  ///< of a particle in it [m]
};

/// Where fewer than `across` particles fit between solids. At a fluid particle with solid particles at distances a and
/// b in opposite directions, within 30 degrees, there are n = (a + b) / dx - 1.
NarrowGaps find_narrow_gaps(const ParticleSet& set, int across);

}  // namespace dmp::particles
