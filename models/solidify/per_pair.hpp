// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "models/solidify/bond_candidate.hpp"

namespace dmp::models {

/// Every pair of a seed and a fluid particle within its reach has one random trial: with k seeds in reach, a fluid
/// particle solidifies with probability 1 - (1 - p)^k per event, and is bonded to each seed whose trial succeeded. A
/// single seed solidifies on average k (1 - (1 - p)^n) of k particles that stay within its reach in n events.
struct PerPair {
    double probability;  ///< p of a pair, per event [-]

    [[nodiscard]] bool binds(const BondCandidate& candidate, const RandomTrial& trial) const {
        return trial.of_pair(candidate) < probability;
    }
};

}  // namespace dmp::models
