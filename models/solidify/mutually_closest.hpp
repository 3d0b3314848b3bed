// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "models/solidify/bond_candidate.hpp"

namespace dmp::models {

/// Seeds and liquid particles each choose the nearest of the others; those that chose each other bind with probability
/// p. So a particle gets at most one bond in one event, as with LAMMPS' fix bond/create (Thompson et al. 2022,
/// Comput. Phys. Commun. 271, 108171). A seed alone turns min(k, B) of k particles that stay within its reach in n
/// events, B binomial of n and p.
struct MutuallyClosest {
    double probability;  ///< p of two that chose each other, in one event [-]

    [[nodiscard]] bool binds(const BondCandidate& candidate, const RandomTrial& trial) const {
        return candidate.nearest_seed && candidate.nearest_liquid && trial.of_pair(candidate) < probability;
    }
};

}  // namespace dmp::models
