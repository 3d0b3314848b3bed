// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "solver/neighbours/cluster_list.hpp"
#include "solver/sweeps/pair_sweeps.hpp"

namespace dmp {

/// Magnitude of the viscous shear stress mu sqrt(2 D : D) of each fluid particle [Pa], D the symmetric part of the
/// velocity gradient. The gradient is exact for linear fields (kernel-gradient correction of Bonet & Lok 1999)
/// and uses fluid neighbours alone, so it is one-sided at walls. Particles with too few neighbours for a gradient
/// (a droplet of one or two) have none: 0. In the order of ids(fluid).
std::vector<double> shear_stress(const ParticleStore& particles, const ClusterList& list, const PairSweeps& sweeps);

}  // namespace dmp
