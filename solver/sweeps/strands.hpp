// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "solver/neighbours/space_order.hpp"
#include "solver/sweeps/single_lanes.hpp"

namespace dmp {

/// Lanes L of single precision hold more numbers than a cluster has members: its members several times over, each time
/// (a strand) with a neighbour of their own. Or one strand with all members, or with some.
template <class L>
struct Strands {
    static constexpr std::size_t members = std::min<std::size_t>(L::width, cluster_size);
    static constexpr std::size_t count = L::width / members;
    /// The neighbour of each strand.
    using Neighbours = std::array<std::int32_t, count>;

    /// As many lanes in double precision, in two registers.
    using Doubles = BasicLanes<double, sizeof(L)>;
    struct Halves {
        Doubles low, high;
    };
    static constexpr std::size_t strand_of(std::size_t half) { return half * Doubles::width / members; }
    static constexpr std::size_t first_member_of(std::size_t half) { return half * Doubles::width % members; }

    /// The members' values, once in each strand.
    static L of_members(const float* values) {
        if constexpr (count == 1) {
            return L::load(values);
        } else {
            return in_both_halves(values, L());
        }
    }
    /// The same in double precision.
    static Halves of_members(const double* values) {
        return {Doubles::load(values + first_member_of(0)), Doubles::load(values + first_member_of(1))};
    }
    /// Each strand's neighbour's value, for all members.
    static L of_neighbours(const float* values, const Neighbours& neighbours) {
        if constexpr (count == 1) {
            return L(static_cast<double>(values[neighbours[0]]));
        } else {
            return in_halves(values + neighbours[0], values + neighbours[1], L());
        }
    }
    /// Members' positions minus their neighbours', taken in double precision.
    static L separation(const Halves& of_members, const double* positions, const Neighbours& neighbours) {
        return in_single(of_members.low - positions[neighbours[strand_of(0)]],
                         of_members.high - positions[neighbours[strand_of(1)]]);
    }
};

/// A sum, for each member of a cluster, over the neighbours of all strands: terms in single precision, the sum in
/// double. Terms are whole numbers, so that it is exact and does not depend on their order.
template <class L>
class WideSum {
  public:
    WideSum& operator+=(const L& terms) {
        halves_.low += low_in_double(terms);
        halves_.high += high_in_double(terms);
        return *this;
    }
    /// Calls visit(sums, first) with the sums of the members from number `first` on, as many as there are lanes.
    template <class Visit>
    void by_member(const Visit& visit) const {
        if constexpr (Strands<L>::count == 1) {
            visit(halves_.low, 0);
            visit(halves_.high, Strands<L>::Doubles::width);
        } else {
            visit(halves_.low + halves_.high, 0);
        }
    }

  private:
    typename Strands<L>::Halves halves_{0.0, 0.0};
};

}  // namespace dmp
