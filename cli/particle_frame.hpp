// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "cli/uses.hpp"
#include "particles/particle_set.hpp"
#include "solver/results/frame.hpp"

namespace dmp::cli {

/// Particles as the mesher made them, at time 0, with volume, mass, body and what keeps them; springs with their bonds.
[[nodiscard]] Frame particle_frame(const ParticleSet& particles);

}  // namespace dmp::cli
