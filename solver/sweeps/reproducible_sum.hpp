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
///
/// Terms that are products can be rounded as they are added, in one instruction: a running sum starts at a number so
/// large that its last bit is the quantum, and has to stay within 32 times the largest term.
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
    static constexpr double full_mantissa = 1.2599210498948732;  ///< a number whose bits are like random ones

    /// A running sum, of 0 so far.
    template <class T>
    void start(T& sum) const {
        sum = T(magic_);
    }
    template <class T, int D>
    void start(Vector<T, D>& sum) const {
        for (int axis = 0; axis < D; ++axis) start(sum[axis]);
    }
    /// Adds a b to it. If a b is half-way between two multiples of the quantum, the even sum is taken, which depends on
    /// the order. It never happens as long as both factors have all their bits: the 50 last ones of a b would have to
    /// be a one and zeros. A factor that may be a number of few digits, such as 1, has to be multiplied by
    /// `full_mantissa`.
    template <class T>
    static void add(T& sum, const T& a, const T& b) {
        sum = multiply_add(a, b, sum);
    }
    template <class T, int D>
    static void add(Vector<T, D>& sum, const T& a, const Vector<T, D>& b) {
        for (int axis = 0; axis < D; ++axis) add(sum[axis], a, b[axis]);
    }
    /// What has been added up.
    template <class T>
    [[nodiscard]] T total(const T& sum) const {
        return sum - T(magic_);
    }
    template <class T, int D>
    [[nodiscard]] Vector<T, D> total(const Vector<T, D>& sum) const {
        Vector<T, D> result;
        for (int axis = 0; axis < D; ++axis) result[axis] = total(sum[axis]);
        return result;
    }
    /// Terms are multiples of this.
    [[nodiscard]] double quantum() const { return std::ldexp(magic_ / 1.5, -52); }

  private:
    double magic_;
};

}  // namespace dmp::solver
