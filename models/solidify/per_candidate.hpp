// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "models/solidify/bond_candidate.hpp"

namespace dmp::models {

/// Every liquid particle within reach of a seed, however many there are, turns solid with probability p in one event,
/// and has one bond, to the nearest seed.
struct PerCandidate {
    double probability;  ///< p of one liquid particle in one event [-]

    [[nodiscard]] bool binds(const BondCandidate& candidate, const RandomTrial& trial) const {
        return candidate.nearest_seed && trial.of_liquid(candidate) < probability;
    }
};

}  // namespace dmp::models
