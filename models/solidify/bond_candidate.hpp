// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "base/random_number.hpp"

namespace dmp::models {

/// A liquid particle within reach of a seed that is active.
struct BondCandidate {
    std::int64_t seed = 0, liquid = 0;  ///< ids
    double distance = 0;                ///< [m]
    /// Whether no other active seed is nearer to the liquid particle, and no other liquid particle to the seed. Of
    /// equally near ones the lowest id is the nearest.
    bool nearest_seed = false, nearest_liquid = false;
};

/// The random trials of one event of one [[solidify]]: numbers in [0, 1) that follow from the ids alone (random_number).
struct RandomTrial {
    std::uint64_t seed = 0;   ///< the scene's
    std::uint64_t rule = 0;   ///< which [[solidify]]
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
