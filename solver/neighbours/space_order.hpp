// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "solver/store/particle_group.hpp"

namespace dmp::solver {

/// Most particles in a cluster: what the widest vector units work on at once.
inline constexpr std::int32_t cluster_size = 8;

/// Particles of one kind (of one body, for springs) that lie together in 3-D and in memory, and share one list of
/// neighbours: [first, first + count) of their group.
struct Cluster {
    std::int32_t first = 0;
    std::int32_t count = 0;
};

/// Sorts the owned particles of a group in 3-D (its copies go) and cuts them into clusters: strips two spacings high
/// (and deep), walked along x, eight particles at a time. A new cluster starts at a new strip and after a gap. Strips
/// are cut into columns, so that the neighbours of a cluster are near in memory too.
std::vector<Cluster> sort_in_space(ParticleGroup& group, double spacing, int threads);

}  // namespace dmp::solver
