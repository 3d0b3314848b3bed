// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/simd/lanes.hpp"
#include "base/simd/vector.hpp"
#include "models/uses.hpp"

namespace dmp::models {

// Of a sum of two products compilers may fuse either, and not always the same one: fused by name, its bits do not
// depend on that.

/// a b + c d
template <class A, class B>
auto sum_of_products(const A& a, const B& b, const A& c, const B& d) {
    return multiply_add(c, d, a * b);
}
template <class A, class B>
auto sum_of_products(const A& a, const B& b, const A& c, const B& d, const A& e, const B& f) {
    return multiply_add(e, f, sum_of_products(a, b, c, d));
}

/// A symmetric matrix in D dimensions: its diagonal, then xy (and yz, zx in 3-D).
template <class T, int D>
struct Symmetric {
    static constexpr int off_diagonals = D == 3 ? 3 : 1;
    Vector<T, D> diagonal;
    Vector<T, off_diagonals> off;

    template <class U>
    [[nodiscard]] auto operator*(const Vector<U, D>& v) const {
        Vector<Wider<T, U>, D> product;
        if constexpr (D == 2) {
            product[0] = sum_of_products(diagonal[0], v[0], off[0], v[1]);
            product[1] = sum_of_products(off[0], v[0], diagonal[1], v[1]);
        } else {
            product[0] = sum_of_products(diagonal[0], v[0], off[0], v[1], off[2], v[2]);
            product[1] = sum_of_products(off[0], v[0], diagonal[1], v[1], off[1], v[2]);
            product[2] = sum_of_products(off[2], v[0], off[1], v[1], diagonal[2], v[2]);
        }
        return product;
    }
};

/// Correction of the kernel's gradient that makes gradients of linear fields exact (Bonet & Lok 1999, eq. 29):
///   B_i = M_i^-1,   M_i = - SUM_j V_j (1/r dW/dr) x_ij x_ij^T   [-], symmetric
/// in the antisymmetric form of the pressure force, and in its variational partner, the density rate:
///   F_i = - SUM_j V_i V_j (p_i B_i + p_j B_j) grad_i W_ij   [N]
///   drho_i/dt = rho_i SUM_j V_j v_ij . B_i grad_i W_ij      [kg/m^3/s]
/// Linear momentum is conserved pair by pair, angular momentum only as far as B is uniform. For a solid neighbour the
/// fluid particle's own B is used. With too few neighbours, det M < 0.3 (a flat free surface has 0.37 in 2-D, 0.28 in
/// 3-D), B = 1, so that spray is not torn apart. The sweeps add the difference from the uncorrected sums: E = B - 1
/// replaces B.
struct GradientCorrection {
    static constexpr double smallest_determinant = 0.3;

    /// One term of M divided by the slope: -V_j x x^T, as diagonal and off-diagonal elements.
    template <class T, class V, int D>
    static Symmetric<T, D> term(const V& volume, const Vector<T, D>& x) {
        Symmetric<T, D> m;
        for (int a = 0; a < D; ++a) m.diagonal[a] = -1.0 * volume * (x[a] * x[a]);
        for (int k = 0; k < Symmetric<T, D>::off_diagonals; ++k) m.off[k] = -1.0 * volume * (x[k] * x[(k + 1) % D]);
        return m;
    }

    /// E = M^-1 - 1, or 0.
    template <class T, int D>
    static Symmetric<T, D> excess(const Symmetric<T, D>& m) {
        Symmetric<T, D> e = inverse(m, smallest_determinant);
        for (int a = 0; a < D; ++a) e.diagonal[a] = e.diagonal[a] - T(1.0);
        return e;
    }

    /// M^-1, or 1 where det M is below `smallest`.
    template <class T, int D>
    static Symmetric<T, D> inverse(const Symmetric<T, D>& m, double smallest) {
        Symmetric<T, D> adjugate;
        T determinant;
        const auto& [d, o] = m;
        const auto less = [](const T& product, const T& a, const T& b) { return multiply_add(-1.0 * a, b, product); };
        if constexpr (D == 2) {
            adjugate = {{{d[1], d[0]}}, {{-o[0]}}};
            determinant = less(d[0] * d[1], o[0], o[0]);
        } else {
            adjugate.diagonal = {
                {less(d[1] * d[2], o[1], o[1]), less(d[2] * d[0], o[2], o[2]), less(d[0] * d[1], o[0], o[0])}};
            adjugate.off = {
                {less(o[2] * o[1], o[0], d[2]), less(o[0] * o[2], o[1], d[0]), less(o[0] * o[1], o[2], d[1])}};
            determinant = sum_of_products(d[0], adjugate.diagonal[0], o[0], adjugate.off[0], o[2], adjugate.off[2]);
        }
        const auto unless_few = [&](const T& value, double otherwise) {
            return where_less(determinant, T(smallest), T(otherwise), value);
        };
        Symmetric<T, D> b;
        for (int a = 0; a < D; ++a) b.diagonal[a] = unless_few(adjugate.diagonal[a] / determinant, 1.0);
        for (int k = 0; k < Symmetric<T, D>::off_diagonals; ++k)
            b.off[k] = unless_few(adjugate.off[k] / determinant, 0.0);
        return b;
    }

    /// Correction of the force on i due to the pressure of one particle of the pair, i or j [N]. It is evaluated for
    /// one particle at a time so that both rounded terms of a pair cancel.
    template <class P, class T, class U, int D>
    static auto force(const P& p, const T& pressure, const Symmetric<U, D>& e) {
        return (-1.0 * p.weight() * pressure) * (e * p.separation);
    }
    /// Correction of the density rate.
    template <class P, class U, int D>
    static auto rate(const P& p, const Symmetric<U, D>& e) {
        return p.i.density * p.j.volume * p.slope * dot(p.i.velocity - p.j.velocity, e * p.separation);
    }
};

}  // namespace dmp::models
