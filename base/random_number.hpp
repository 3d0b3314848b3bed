// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <initializer_list>

namespace dmp {

/// The mixing function of the generator SplitMix64 (Steele, Lea & Flood 2014): every bit depends on every bit.
constexpr std::uint64_t mixed_bits(std::uint64_t bits) {
    bits += 0x9e3779b97f4a7c15U;
    bits = (bits ^ (bits >> 30U)) * 0xbf58476d1ce4e5b9U;
    bits = (bits ^ (bits >> 27U)) * 0x94d049bb133111ebU;
    return bits ^ (bits >> 31U);
}

/// A number evenly distributed in [0, 1) that follows from what it is for alone: a seed, the ids of particles, the
/// number of an event. It has no state: whoever asks, on whichever rank, when and in which order, gets the same.
constexpr double random_number(std::initializer_list<std::uint64_t> of) {
    std::uint64_t bits = 0;
    bool first = true;
    for (const std::uint64_t key : of) {
        bits = mixed_bits(first ? key : bits ^ key);
        first = false;
    }
    return static_cast<double>(bits >> 11U) * 0x1p-53;
}

}  // namespace dmp
