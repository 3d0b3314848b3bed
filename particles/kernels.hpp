// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <numbers>

namespace dmp {

/// Smoothing kernels W(r) with compact support: W = 0 for r >= support, the integral of W over space is 1.
/// `value` is W(r) [1/m^D], `slope` is (1/r) dW/dr [1/m^(D+2)], so that grad_i W(|x_i - x_j|) = slope (x_i - x_j).
/// Both take a double or a SIMD value and vanish beyond the support without a branch.
/// `sound_limit` is the largest stable c dt / support and `viscous_limit` the largest stable nu dt / support^2 of a
/// staggered step in linear theory (von Neumann analysis of the continuous symbols, D = 2 or 3).

template <class T>
T square(const T& x) {
    return x * x;
}

namespace detail {

/// 1 - r/support inside the support, 0 outside.
template <class T>
T distance_to_edge(const T& r, double inverse_support) {
    using std::max;
    return max(T(0.0), T(1.0) - r * inverse_support);
}

}  // namespace detail

/// Wendland's C2 function, W = w (1 - q)^4 (1 + 4 q), q = r / support (Wendland 1995; Dehnen & Aly 2012).
template <int D>
class WendlandC2 {
  public:
    static constexpr double sound_limit = D == 2 ? 0.878 : 0.861;
    static constexpr double viscous_limit = 0.0714;

    explicit WendlandC2(double support)
        : inverse_support_(1 / support),
          constant_(D == 2 ? 7 / (pi * square(support)) : 21 / (2 * pi * square(support) * support)),
          slope_constant_(-20 * constant_ * square(inverse_support_)) {}

    template <class T>
    [[nodiscard]] T value(const T& r) const {
        const T edge = detail::distance_to_edge(r, inverse_support_);
        return square(square(edge)) * (constant_ * (T(5.0) - 4.0 * edge));
    }
    template <class T>
    [[nodiscard]] T slope(const T& r) const {
        const T edge = detail::distance_to_edge(r, inverse_support_);
        return (slope_constant_ * edge) * (edge * edge);
    }

  private:
    static constexpr double pi = std::numbers::pi;
    double inverse_support_, constant_, slope_constant_;
};

/// Lucy's function, W = w (1 + 3 q)(1 - q)^3, q = r / support (Lucy 1977).
template <int D>
class Lucy {
  public:
    static constexpr double sound_limit = D == 2 ? 1.001 : 0.967;
    static constexpr double viscous_limit = D == 2 ? 0.1 : 0.0952;

    explicit Lucy(double support)
        : inverse_support_(1 / support),
          constant_(D == 2 ? 5 / (pi * square(support)) : 105 / (16 * pi * square(support) * support)),
          slope_constant_(-12 * constant_ * square(inverse_support_)) {}

    template <class T>
    [[nodiscard]] T value(const T& r) const {
        const T edge = detail::distance_to_edge(r, inverse_support_);
        return (edge * edge) * (edge * (constant_ * (T(4.0) - 3.0 * edge)));
    }
    template <class T>
    [[nodiscard]] T slope(const T& r) const {
        const T edge = detail::distance_to_edge(r, inverse_support_);
        return slope_constant_ * edge * edge;
    }

  private:
    static constexpr double pi = std::numbers::pi;
    double inverse_support_, constant_, slope_constant_;
};

}  // namespace dmp
