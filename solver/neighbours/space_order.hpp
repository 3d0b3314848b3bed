// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "solver/store/particle_group.hpp"

namespace dmp::solver {

/// Maximum number of particles in a cluster: the width of the widest vector units.
inline constexpr std::int32_t cluster_size = 8;

/// Particles of one kind (of one body, for elastic solids) that are close together, also in memory, and share
/// one neighbour list: [first, first + count) of their group.
struct Cluster {
    std::int32_t first = 0;
    std::int32_t count = 0;
};

/// Spatially sorts the owned particles of a group, drops its ghosts, and cuts the particles into clusters: strips two
/// spacings high (and deep), traversed along x, eight particles at a time. A new strip or a gap starts a new cluster.
/// Strips are cut into columns, so that the neighbours of a cluster are close in memory too.
std::vector<Cluster> sort_in_space(ParticleGroup& group, double spacing, int threads);

}  // namespace dmp::solver
