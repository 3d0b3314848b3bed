// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace dmp {

/// The mixing function of the generator SplitMix64 (Steele, Lea & Flood 2014).
inline std::uint64_t mixed(std::uint64_t bits) {
    bits += 0x9e3779b97f4a7c15U;
    bits = (bits ^ (bits >> 30U)) * 0xbf58476d1ce4e5b9U;
    bits = (bits ^ (bits >> 27U)) * 0x94d049bb133111ebU;
    return bits ^ (bits >> 31U);
}

/// A random number evenly distributed in [0, 1): a hash of seed, id and which of the id's numbers it is, so it does not
/// depend on how many there are or in which order they are asked for.
inline double hashed_random(std::uint64_t seed, std::uint64_t id, std::uint64_t which) {
    return static_cast<double>(mixed(mixed(mixed(seed) ^ id) ^ which) >> 11U) * 0x1p-53;
}

}  // namespace dmp
