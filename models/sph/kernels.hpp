// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <numbers>

namespace dmp::models {

/// Smoothing kernels W(r) with compact support: W = 0 for r >= support, the integral of W over space is 1. `value` is
/// W(r) [1/m^D], `slope` is (1/r) dW/dr [1/m^(D+2)], so that grad_i W(|x_i - x_j|) = slope (x_i - x_j). Both accept a
/// double or a SIMD value and vanish beyond the support without a branch. `sound_limit` is the largest stable c dt /
/// support, and `viscous_limit` the largest stable nu dt / support^2, of a staggered step in linear theory, D = 2 or
/// 3. They follow from a von Neumann analysis of the continuous symbols, with wave number k and the Fourier transform
/// ^. The pressure force and continuity both multiply a wave's amplitude by c k W^(k), and a staggered pair of them
/// is stable below 2. Morris' viscosity damps a wave by 2 nu [F^(k) - F^(0)], where F is the slope, and an explicit
/// step is stable below 2. So sound_limit = min 2 / (k R W^), viscous_limit = min 1 / (R^2 [F^(k) - F^(0)]).

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

/// Wendland's C4 function, W = w (1 - q)^6 (1 + 6 q + 35 q^2 / 3), q = r / support (Wendland 1995; Dehnen & Aly 2012).
template <int D>
class WendlandC4 {
  public:
    static constexpr double sound_limit = D == 2 ? 0.765 : 0.753;
    static constexpr double viscous_limit = D == 2 ? 0.0555 : 0.0545;

    explicit WendlandC4(double support)
        : inverse_support_(1 / support),
          constant_(D == 2 ? 9 / (pi * square(support)) : 495 / (32 * pi * square(support) * support)),
          slope_constant_(-56.0 / 3 * constant_ * square(inverse_support_)) {}

    template <class T>
    [[nodiscard]] T value(const T& r) const {
        const T edge = detail::distance_to_edge(r, inverse_support_);
        const T q = T(1.0) - edge, cube = edge * edge * edge;
        return square(cube) * (constant_ * (T(1.0) + q * (T(6.0) + (35.0 / 3) * q)));
    }
    template <class T>
    [[nodiscard]] T slope(const T& r) const {
        const T edge = detail::distance_to_edge(r, inverse_support_);
        return (slope_constant_ * edge) * square(edge * edge) * (T(6.0) - 5.0 * edge);
    }

  private:
    static constexpr double pi = std::numbers::pi;
    double inverse_support_, constant_, slope_constant_;
};

/// The cubic B-spline, W = w [(2 - s)^3 / 4 - (1 - s)^3], s = r / h, h = support / 2, where negative brackets count
/// as 0 (Monaghan & Lattanzio 1985).
template <int D>
class CubicSpline {
  public:
    static constexpr double sound_limit = D == 2 ? 0.939 : 0.914;
    static constexpr double viscous_limit = D == 2 ? 0.0874 : 0.0833;

    explicit CubicSpline(double support)
        : inverse_h_(2 / support),
          constant_(D == 2 ? 40 / (7 * pi * square(support)) : 8 / (pi * square(support) * support)),
          slope_constant_(-0.75 * constant_ * square(inverse_h_)) {}

    template <class T>
    [[nodiscard]] T value(const T& r) const {
        using std::max;
        const T s = r * inverse_h_;
        const T outer = max(T(0.0), T(2.0) - s), inner = max(T(0.0), T(1.0) - s);
        return constant_ * (0.25 * outer * square(outer) - inner * square(inner));
    }
    /// Within r = h it is the outer part's value at h plus a linear term, which avoids a division by r.
    template <class T>
    [[nodiscard]] T slope(const T& r) const {
        using std::max;
        const T s = r * inverse_h_, beyond = max(T(1.0), s);
        const T outer = max(T(0.0), T(2.0) - beyond), inner = max(T(0.0), T(1.0) - s);
        return slope_constant_ * (square(outer) / beyond + 3.0 * inner);
    }

  private:
    static constexpr double pi = std::numbers::pi;
    double inverse_h_, constant_, slope_constant_;
};

/// The quintic B-spline, W = w [(3 - s)^5 - 6 (2 - s)^5 + 15 (1 - s)^5], s = r / h, h = support / 3, where negative
/// brackets count as 0 (Schoenberg 1946; Morris, Fox & Zhu 1997).
template <int D>
class QuinticSpline {
  public:
    static constexpr double sound_limit = D == 2 ? 0.770 : 0.757;
    static constexpr double viscous_limit = D == 2 ? 0.0574 : 0.0555;

    explicit QuinticSpline(double support)
        : inverse_h_(3 / support),
          constant_(D == 2 ? 63 / (478 * pi * square(support)) : 27 / (120 * pi * square(support) * support)),
          slope_constant_(-5 * constant_ * square(inverse_h_)) {}

    template <class T>
    [[nodiscard]] T value(const T& r) const {
        using std::max;
        const T s = r * inverse_h_;
        const T a = max(T(0.0), T(3.0) - s), b = max(T(0.0), T(2.0) - s), c = max(T(0.0), T(1.0) - s);
        return constant_ * (a * square(square(a)) - 6.0 * (b * square(square(b))) + 15.0 * (c * square(square(c))));
    }
    /// Within r = h it is the outer parts' value at h plus a polynomial of 1 - s, which avoids a division by r.
    template <class T>
    [[nodiscard]] T slope(const T& r) const {
        using std::max;
        const T s = r * inverse_h_, beyond = max(T(1.0), s);
        const T a = max(T(0.0), T(3.0) - beyond), b = max(T(0.0), T(2.0) - beyond), c = max(T(0.0), T(1.0) - s);
        const T outer = (square(square(a)) - 6.0 * square(square(b))) / beyond;
        return slope_constant_ * (outer + c * (T(18.0) + c * (T(6.0) - 10.0 * c)));
    }

  private:
    static constexpr double pi = std::numbers::pi;
    double inverse_h_, constant_, slope_constant_;
};

}  // namespace dmp::models
