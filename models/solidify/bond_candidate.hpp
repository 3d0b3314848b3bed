// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "base/random_number.hpp"

namespace dmp::models {

/// A fluid particle within reach of an active seed.
struct BondCandidate {
    std::int64_t seed = 0, liquid = 0;  ///< ids
    double distance = 0;                ///< [m]
    /// Whether no other active seed is nearer to the fluid particle, and no other fluid particle to the seed. Among
    /// equally near ones the lowest id counts as nearest.
    bool nearest_seed = false, nearest_liquid = false;
};

/// The random trials of one event of one [[solidify]]: numbers in [0, 1) that depend only on the ids (random_number).
struct RandomTrial {
    std::uint64_t seed = 0;   ///< seed of the scene
    std::uint64_t rule = 0;   ///< number of the [[solidify]]
    std::uint64_t event = 0;  ///< counted from 0

    [[nodiscard]] double of_pair(const BondCandidate& of) const {
        return random_number(
            {seed, rule, event, static_cast<std::uint64_t>(of.seed) + 1, static_cast<std::uint64_t>(of.liquid)});
    }
    [[nodiscard]] double of_liquid(const BondCandidate& of) const {
        return random_number({seed, rule, event, 0, static_cast<std::uint64_t>(of.liquid)});
    }
};

}  // namespace dmp::models
