// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "solver/parallel/ranks.hpp"
#include "solver/store/particle_group.hpp"

namespace dmp::solver {

/// The owned particles of one group that leave this rank, in ascending order, and their new ranks.
struct Departures {
    std::vector<std::int32_t> particles;
    std::vector<int> to;
};

/// Sends particles, one `departures` per group, with their tags and state fields. Particles that stay keep their
/// order; arriving particles are appended, sorted by the rank they come from and then by their order there. Ghost
/// particles are dropped.
void send_particles(const Ranks& ranks, const std::vector<ParticleGroup*>& groups,
                    const std::vector<Departures>& departures);

}  // namespace dmp::solver
