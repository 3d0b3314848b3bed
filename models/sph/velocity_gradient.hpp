// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "models/pair.hpp"
#include "models/sph/gradient_correction.hpp"

namespace dmp::models {

/// The velocity gradient corrected to first order (Bonet & Lok 1999, eq. 29): exact for linear velocities whatever the
/// arrangement of the particles, so that the density rate of a divergence-free linear flow is zero:
///   M_i = - SUM_j V_j (1/r dW/dr) x_ij x_ij^T   [-],     B_i = M_i^-1
///   A_i = - SUM_j V_j (1/r dW/dr) v_ij x_ij^T   [1/s],   G_i = A_i B_i,   [a][b] = dv_a/dx_b
///   drho_i/dt = - rho_i tr (A'_i B_i)           [kg/m^3/s]
/// A' is A but for solid neighbours, which count twice with their own velocity v_j, less what a rotation of both is:
///   v_ij = 2 (v_i - v_j) - W_i x_ij,   W = (G - G^T) / 2, of the step before.
/// Counting twice makes the rate
/// the partner of the pressure force, in which solids count twice too (p_j = p_i): with a = SUM_j (1, solids 2) V_j
/// (1/r dW/dr) x_ij, the motion of a particle on its own obeys dv/dt ~ - p a, dp/dt ~ v . B a, an oscillation. With the
/// velocities of A, extrapolated into the solids, the second vector is another one. In gaps one particle wide, where
/// a is small, it points away from a, and the particle's pressure and velocity grow exponentially.
/// Along a wall whose surface slides, or where the fluid slips, this would take fluid that passes the wall's particles,
/// steps of a lattice, as fluid that approaches them. There, with the normal n,
///   v_ij = n n . [2 (v_i - v_j) - G_i t] + s (1 - n n^T) G_i (x_ij - t),   t = (1 - n n^T) x_ij,
/// s = 0 where the fluid slips and 1 elsewhere.
/// In a scene with a free surface the rate takes B = 1 everywhere: where neighbours are missing, B a is too unlike a.
/// B = 1 where det M < 0.3: too few neighbours (a flat free surface has 0.5). The gradients of velocity and
/// density that are kept, for all but this rate, take B = 1 below det M = 0.03: where fluids differ, they are those
/// among the particles of one fluid and the solids, and a flat interface has 1/4, in 3-D 1/8.
struct VelocityGradient {
    static constexpr double smallest_determinant = GradientCorrection::smallest_determinant;
    static constexpr double smallest_determinant_of_kept = 0.03;

    template <class T, int D>
    using Rows = Vector<Vector<T, D>, D>;

    /// G = A B.
    template <class T, int D>
    static Rows<T, D> corrected(const Rows<T, D>& a, const Symmetric<T, D>& b) {
        Rows<T, D> g;
        for (int row = 0; row < D; ++row) g[row] = b * a[row];
        return g;
    }
    /// v_ij of the density rate for a solid neighbour; `past`: v_i - v_j.
    template <class T, int D>
    static Vector<T, D> past_solid(const Vector<T, D>& past, const Rows<T, D>& g, const Vector<T, D>& x) {
        Vector<T, D> v;
        for (int a = 0; a < D; ++a) {
            v[a] = 2.0 * past[a];
            for (int b = 0; b < D; ++b)  // fused by name, see gradient_correction.hpp
                if (a != b) v[a] = multiply_add(0.5 * (g[b][a] - g[a][b]), x[b], v[a]);
        }
        return v;
    }
    /// The same for a wall whose surface slides, or where the fluid slips (`slip` 1).
    template <class T, int D, class W>
    static Vector<T, D> past_sliding_wall(const Vector<T, D>& past, const Rows<T, D>& g, const Vector<T, D>& x,
                                          const Vector<W, D>& normal, const W& slip) {
        const T distance = dot(x, normal);
        Vector<T, D> across, along, shear;
        for (int a = 0; a < D; ++a) across[a] = distance * normal[a];
        for (int a = 0; a < D; ++a) along[a] = x[a] - across[a];
        T approach = 2.0 * dot(past, normal);
        for (int a = 0; a < D; ++a) {
            approach = approach - normal[a] * dot(g[a], along);
            shear[a] = (1.0 - slip) * dot(g[a], across);
        }
        approach = approach - dot(shear, normal);
        Vector<T, D> v;
        for (int a = 0; a < D; ++a) v[a] = approach * normal[a] + shear[a];
        return v;
    }
    template <class T, int D>
    static T divergence(const Rows<T, D>& g) {
        T trace = g[0][0];
        for (int axis = 1; axis < D; ++axis) trace = trace + g[axis][axis];
        return trace;
    }
    /// b = tr B / D, the part of the correction that does not depend on direction.
    template <class T, int D>
    static T mean(const Symmetric<T, D>& b) {
        T trace = b.diagonal[0];
        for (int axis = 1; axis < D; ++axis) trace = trace + b.diagonal[axis];
        return (1.0 / D) * trace;
    }
};

}  // namespace dmp::models
