// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "solver/neighbours/space_order.hpp"
#include "solver/sweeps/lanes.hpp"

namespace dmp {

/// Lanes L of single precision hold more numbers than a cluster has members: its members several times over, each time
/// (a strand) with a neighbour of their own. Or one strand with all members, or with some.
template <class L>
struct Strands {
    static constexpr std::size_t members = std::min<std::size_t>(L::width, cluster_size);
    static constexpr std::size_t count = L::width / members;
    /// The neighbour of each strand.
    using Neighbours = std::array<std::int32_t, count>;

    /// Half of the lanes in double precision, which fill a register as all of them do in single precision.
    static constexpr std::size_t half_width = L::width / 2;
    using Doubles [[gnu::vector_size(sizeof(typename L::Raw))]] = double;
    using HalfSingles [[gnu::vector_size(sizeof(typename L::Raw) / 2)]] = float;
    using Halves = std::array<Doubles, 2>;
    static constexpr std::size_t strand_of(std::size_t half) { return half * half_width / members; }
    static constexpr std::size_t first_member_of(std::size_t half) { return half * half_width % members; }

    static L joined(HalfSingles low, HalfSingles high) {
        typename L::Raw both;
        std::memcpy(&both, &low, sizeof low);
        std::memcpy(reinterpret_cast<char*>(&both) + sizeof low, &high, sizeof high);
        return L(both);
    }

    /// The members' values, once in each strand.
    static L of_members(const float* values) {
        if constexpr (count == 1) return L::load(values);
        L lanes;
        for (std::size_t k = 0; k < L::width; ++k) lanes.set(k, values[k % members]);
        return lanes;
    }
    /// The same in double precision.
    static Halves of_members(const double* values) {
        Halves halves;
        for (std::size_t half = 0; half < 2; ++half)
            std::memcpy(&halves[half], values + first_member_of(half), sizeof(Doubles));
        return halves;
    }
    /// Each strand's neighbour's value, for all members.
    static L of_neighbours(const float* values, const Neighbours& neighbours) {
        if constexpr (count == 1) {
            return L(static_cast<double>(values[neighbours[0]]));
        } else {
            const HalfSingles zero{};
            return joined(values[neighbours[0]] - zero, values[neighbours[1]] - zero);
        }
    }
    /// Members' positions minus their neighbours', taken in double precision.
    static L separation(const Halves& of_members, const double* positions, const Neighbours& neighbours) {
        const Doubles low = of_members[0] - positions[neighbours[strand_of(0)]];
        const Doubles high = of_members[1] - positions[neighbours[strand_of(1)]];
        return joined(__builtin_convertvector(low, HalfSingles), __builtin_convertvector(high, HalfSingles));
    }
};

/// A sum, for each member of a cluster, over the neighbours of all strands: terms in single precision, the sum in
/// double. Terms are whole numbers, so that it is exact and does not depend on their order.
template <class L>
class WideSum {
  public:
    WideSum& operator+=(const L& terms) {
        HalfSingles low, high;
        const typename L::Raw raw = terms.raw();
        std::memcpy(&low, &raw, sizeof low);
        std::memcpy(&high, reinterpret_cast<const char*>(&raw) + sizeof low, sizeof high);
        halves_[0] += __builtin_convertvector(low, typename Strands<L>::Doubles);
        halves_[1] += __builtin_convertvector(high, typename Strands<L>::Doubles);
        return *this;
    }
    /// Of one member.
    [[nodiscard]] double operator[](std::size_t member) const {
        double sum = 0;
        for (std::size_t half = 0; half < 2; ++half)
            for (std::size_t k = 0; k < Strands<L>::half_width; ++k)
                if (Strands<L>::first_member_of(half) + k == member) sum += halves_[half][k];
        return sum;
    }

  private:
    using HalfSingles = typename Strands<L>::HalfSingles;
    typename Strands<L>::Halves halves_{};
};

}  // namespace dmp
