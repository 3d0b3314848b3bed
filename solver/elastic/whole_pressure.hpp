// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "solver/parallel/ranks.hpp"
#include "solver/store/particle_store.hpp"
#include "solver/uses.hpp"

namespace dmp::solver {

/// Marks the particles of elastic bodies that feel the whole pressure (Field::whole_pressure, where the store has it).
/// `dry_bodies`: by number of the body, whether it borders on nothing.
void fill_whole_pressure(const std::vector<bool>& dry_bodies, ParticleStore& particles);

/// After bodies have changed: one that has joined a body that feels the whole pressure feels it too. All ranks must
/// call it. `bodies`: how many there are.
void spread_whole_pressure(ParticleStore& particles, std::size_t bodies, const Ranks& ranks);

}  // namespace dmp::solver
