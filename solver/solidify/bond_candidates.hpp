// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <span>
#include <unordered_map>
#include <vector>

#include "models/solidify/bond_candidate.hpp"
#include "particles/particle_set.hpp"
#include "scene/scene.hpp"
#include "solver/uses.hpp"

namespace dmp::solver {

/// A particle by its id and place [m].
struct ParticlePosition {
    std::int64_t id = 0;
    Vec position = Vec::Zero();
};

/// All pairs of a seed and a liquid particle no farther apart than `reach`, which must be less than half of each
/// period. Nothing is said yet of who is nearest.
std::vector<BondCandidate> find_bond_candidates(std::span<const ParticlePosition> seeds,
                                                std::span<const ParticlePosition> liquid, double reach,
                                                const ParticleSpace& space);

/// Puts candidates in the order of liquid and seed, whoever found them, and says who is nearest. Distances that differ
/// by less than a thousand millionth of the reach count as equal.
void find_nearest(std::vector<BondCandidate>& candidates, double reach);

/// Whether the rule binds this pair.
using Binds = std::function<bool(const BondCandidate&, const RandomTrial&)>;
Binds binding_rule(SolidifyRule rule, double probability);

/// The candidates that become bonds. `room` of a seed: how many more bonds it may have; a liquid particle may have
/// `most_bonds`. Encounters are in the order of find_nearest, and those come first that are asked first.
std::vector<BondCandidate> binding_ones(std::span<const BondCandidate> candidates, const Binds& binds,
                                        const RandomTrial& trial, std::unordered_map<std::int64_t, int> room,
                                        int most_bonds);

}  // namespace dmp::solver
