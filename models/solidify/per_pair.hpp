// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "models/solidify/bond_candidate.hpp"

namespace dmp::models {

/// Every seed tries each liquid particle within its reach, one random trial a pair: of k seeds in reach, a liquid
/// particle turns solid with 1 - (1 - p)^k in one event, and has a bond to each seed whose throw succeeded.
/// A seed alone turns k (1 - (1 - p)^n) of k particles that stay within its reach, on average, in n events.
struct PerPair {
    double probability;  ///< p of one pair in one event [-]

    [[nodiscard]] bool binds(const BondCandidate& candidate, const RandomTrial& trial) const {
        return trial.of_pair(candidate) < probability;
    }
};

}  // namespace dmp::models
