// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "particles/particle_set.hpp"
#include "solver/uses.hpp"

namespace dmp::solver {

/// Whether fluid particles lack neighbours on one side: the divergence of position, SUM_j V_j x_ji . grad_i W_ij, which
/// is D among neighbours all around, is less than 3/4 of that for any of them (Lee et al. 2008: 1.5 in 2-D).
/// With Wendland's C2 over three spacings, whatever the scene's kernel. Of elastic solids, whether free nodes border on
/// nothing: such a solid is wet on one side at most.
bool has_free_surface(const ParticleSet& set, int threads, PartKind kind = PartKind::fluid);

}  // namespace dmp::solver
