// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "solver/parallel/exact_sum.hpp"
namespace dmp {
class Ranks {
  public:
    static Ranks alone() { return {}; }
    [[nodiscard]] int rank() const { return 0; }
    [[nodiscard]] int size() const { return 1; }
    [[nodiscard]] bool is_first() const { return true; }
    [[nodiscard]] double largest(double x) const { return x; }
    [[nodiscard]] double smallest(double x) const { return x; }
    [[nodiscard]] bool any(bool x) const { return x; }
    [[nodiscard]] std::int64_t sum(std::int64_t x) const { return x; }
    template <class T>
    std::vector<T> gather_to_first(const std::vector<T>& v) const {
        return v;
    }
    void sum(ExactSum&) const {}
    void sum(std::span<double>) const {}
};
}  // namespace dmp
