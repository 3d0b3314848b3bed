// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "base/simd/vector.hpp"

namespace dmp::solver {

/// Rounds the terms of a sum to multiples of a power of two. Such sums are exact and therefore have the same bits for
/// any order of neighbours, any number of threads and ranks, and any time of building the list.
/// (Fixed-point accumulation in the mantissa of a double; after Demmel & Nguyen 2013, with one bin.)
/// The quantum is 2^-46 of the largest expected term: terms up to 32 times as large, and sums up to 128 times as
/// large, stay exact. Larger ones are added like any other numbers, and only their last bits then depend on the
/// order.
class ReproducibleSum {
  public:
    explicit ReproducibleSum(double largest_term) : magic_(1.5 * std::ldexp(1.0, std::ilogb(largest_term) - 46 + 52)) {}

    template <class T>
    [[nodiscard]] T operator()(const T& term) const {
        return (term + T(magic_)) - T(magic_);
    }
    template <class T, int D>
    [[nodiscard]] Vector<T, D> operator()(const Vector<T, D>& term) const {
        Vector<T, D> rounded;
        for (int axis = 0; axis < D; ++axis) rounded[axis] = (*this)(term[axis]);
        return rounded;
    }
    /// Terms are multiples of this.
    [[nodiscard]] double quantum() const { return std::ldexp(magic_ / 1.5, -52); }

  private:
    double magic_;
};

}  // namespace dmp::solver
