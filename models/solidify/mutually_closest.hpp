// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "models/solidify/bond_candidate.hpp"

namespace dmp::models {

/// Seeds and fluid particles each choose their nearest partner; those that chose each other bind with probability p.
/// So a particle receives at most one bond per event, as with LAMMPS' fix bond/create (Thompson et al. 2022, Comput.
/// Phys. Commun. 271, 108171). A single seed solidifies min(k, B) of k particles that stay within its reach in n
/// events, where B is binomial with n and p.
struct MutuallyClosest {
    double probability;  ///< p of two that chose each other, per event [-]

    [[nodiscard]] bool binds(const BondCandidate& candidate, const RandomTrial& trial) const {
        return candidate.nearest_seed && candidate.nearest_liquid && trial.of_pair(candidate) < probability;
    }
};

}  // namespace dmp::models
