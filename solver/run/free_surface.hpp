// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "particles/particle_set.hpp"
#include "solver/uses.hpp"

namespace dmp::solver {

/// Whether fluid particles lack neighbours on one side: the divergence of position, SUM_j V_j x_ji . grad_i W_ij, which
/// is D among neighbours all around, is less than 3/4 of that for any of them (Lee et al. 2008: 1.5 in 2-D).
/// With Wendland's C2 over three spacings, whatever the scene's kernel.
bool has_free_surface(const ParticleSet& set, int threads);

/// By elastic body: whether free nodes of it border on nothing, by the same measure; it is wet on one side at most.
/// Bodies beyond the last such one are left out: empty where there is none.
std::vector<bool> dry_bodies(const ParticleSet& set, int threads);

}  // namespace dmp::solver
