// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "models/solidify/bond_candidate.hpp"

namespace dmp::models {

/// Every fluid particle within reach of one or more seeds solidifies with probability p per event, and is bonded to
/// the nearest seed.
struct PerCandidate {
    double probability;  ///< p of a fluid particle, per event [-]

    [[nodiscard]] bool binds(const BondCandidate& candidate, const RandomTrial& trial) const {
        return candidate.nearest_seed && trial.of_liquid(candidate) < probability;
    }
};

}  // namespace dmp::models
