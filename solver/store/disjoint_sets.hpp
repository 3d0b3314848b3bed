// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <vector>

namespace dmp::solver {

/// Sets of the numbers 0, 1, ... that are joined pair by pair (Tarjan 1975, with path halving). The root of a set is
/// its lowest number, whatever the order of the pairs.
class DisjointSets {
  public:
    explicit DisjointSets(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0); }

    [[nodiscard]] std::size_t root(std::size_t i) {
        while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
        return i;
    }
    void join(std::size_t i, std::size_t j) {
        const auto [low, high] = std::minmax({root(i), root(j)});
        parent_[high] = low;
    }

  private:
    std::vector<std::size_t> parent_;
};

}  // namespace dmp::solver
