// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "solver/parallel/ranks.hpp"
#include "solver/store/particle_group.hpp"

namespace dmp::solver {

/// The owned particles of one group that leave this rank, in ascending order, and where each goes.
struct Departures {
    std::vector<std::int32_t> particles;
    std::vector<int> to;
};

/// Sends particles, one `departures` a group, with their tags and state fields. Those that stay keep their order; those
/// that come stand behind them, by the rank they come from and then in its order. Copies go.
void send_particles(const Ranks& ranks, const std::vector<ParticleGroup*>& groups,
                    const std::vector<Departures>& departures);

}  // namespace dmp::solver
