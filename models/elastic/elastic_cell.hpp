// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <array>
#include <cmath>

#include "models/elastic/strain.hpp"

namespace dmp::models {

/// A finite element of a solid: a box with a node at each corner, of which the solid fills a part with the volume V,
/// the centroid c and the second moments S_i (the mean of (X_i - c_i)^2 in the solid). One integration point, at the
/// centroid, and the energy of bending and twist within the cell from the moments:
///
///   x(X) = F X + SUM q_m M_m(X) + ...       F = SUM x_k (x) b_k,   q_m = SUM s_km x_k,   y_m = F^T q_m
///   U = V psi(F) + 1/2 SUM y T(y)
///
/// where b_k and s_k are the first and the mixed second derivatives of the shape functions at c (mode m: M = X Y in
/// 2-D; Y Z, X Z, X Y and X Y Z in 3-D). T is the moment of a strain that varies linearly in the cell, with the fibres
/// free to contract sideways and without the shear that the shape functions add:
///   2-D:  U_y = V E'/2 (y_x^2 S_y + y_y^2 S_x),   E' = E / (1 - nu^2)
///   3-D:  U_y = V/2 SUM_g S_g { E' (A_i^2 + A_j^2 + 2 nu A_i A_j) + G (B_i + B_j)^2 } + V E/2 P |y_xyz|^2
/// with g over the axes, i and j the other two, A_i = (y_ig)_i, A_j = (y_jg)_j (bending), B_i = (y_jg)_i,
/// B_j = (y_ig)_j (twist), and P the mean of S_x S_y, S_y S_z, S_z S_x. y does not change when the body turns. Bending
/// is exact for any number of cells across, for any nu. Belytschko & Bachrach 1986; Belytschko & Bindeman 1993; Puso
/// 2000; Krysl 2014.
///
/// Corner k is moved along axis i where bit i of k is set. Columns of Corners are vectors of the corners.
template <int D>
struct ElasticCell {
    static_assert(D == 2 || D == 3);
    static constexpr int corners = 1 << D;
    static constexpr int modes = D == 2 ? 1 : 4;
    static constexpr int unknowns = corners * D;
    using Point = Eigen::Matrix<double, D, 1>;
    using Corners = Eigen::Matrix<double, D, corners>;
    using Modes = Eigen::Matrix<double, D, modes>;
    using Square = Eigen::Matrix<double, unknowns, unknowns>;

    Eigen::Matrix<double, corners, 1> share;      ///< shape functions at the centroid [-]
    Eigen::Matrix<double, corners, D> slope;      ///< b_k [1/m]
    Eigen::Matrix<double, corners, modes> twist;  ///< s_k [1/m^2]; for X Y Z [1/m^3]
    double volume = 0;                            ///< V [m^D]
    Point moment;                                 ///< S [m^2]
    double youngs_modulus = 0, poisson_ratio = 0;

    /// @param size of the box [m]
    /// @param centroid of the solid, from the middle of the box [m]
    ElasticCell(const Point& size, const Point& centroid, double solid_volume, const Point& moments, double e,
                double nu)
        : volume(solid_volume), moment(moments), youngs_modulus(e), poisson_ratio(nu) {
        for (int k = 0; k < corners; ++k) {
            Point value, rate;  // of the shape function's factor of each axis
            for (int i = 0; i < D; ++i) {
                const double sign = k >> i & 1 ? 1 : -1;
                value[i] = 0.5 + sign * centroid[i] / size[i];
                rate[i] = sign / size[i];
            }
            share[k] = value.prod();
            for (int i = 0; i < D; ++i) {
                slope(k, i) = rate[i];
                for (int j = 0; j < D; ++j)
                    if (j != i) slope(k, i) *= value[j];
            }
            if constexpr (D == 2) {
                twist(k, 0) = rate.prod();
            } else {
                for (int m = 0; m < D; ++m) twist(k, m) = value[m] * rate[(m + 1) % 3] * rate[(m + 2) % 3];
                twist(k, 3) = rate.prod();
            }
        }
    }

    [[nodiscard]] LameConstants constants() const { return LameConstants::of(youngs_modulus, poisson_ratio); }

    /// F, the deformation gradient at the centroid.
    [[nodiscard]] Matrix<D> gradient(const Corners& x) const { return x * slope; }

    template <class Law>
    [[nodiscard]] double energy(const Law& law, const Corners& x) const {
        const Matrix<D> f = gradient(x);
        const Modes y = f.transpose() * (x * twist);
        return volume * law.template energy<D>(f.transpose() * f) + 0.5 * y.cwiseProduct(bending_moments(y)).sum();
    }

    /// Forces on the corners at x that move with v [N]. `relaxation`: of Kelvin and Voigt's damping, the ratio of
    /// viscous to elastic moduli [s]; a body that turns as a whole has none.
    template <class Law>
    [[nodiscard]] Corners forces(const Law& law, double relaxation, const Corners& x, const Corners& v) const {
        const Matrix<D> f = gradient(x);
        const Modes q = x * twist;
        Matrix<D> s = law.template stress<D>(f.transpose() * f);
        Modes y = f.transpose() * q;
        if (relaxation > 0) {
            const Matrix<D> rate = gradient(v), half = 0.5 * f.transpose() * rate;
            s += relaxation * constants().template stress<D>(half + half.transpose());
            y += relaxation * (rate.transpose() * q + f.transpose() * (v * twist));
        }
        const Modes t = bending_moments(y);
        const Matrix<D> along_slope = volume * (f * s) + q * t.transpose();
        const Modes along_twist = f * t;
        return -along_slope * slope.transpose() - along_twist * twist.transpose();
    }

    /// Cauchy's stress at the centroid, F S F^T / J, without damping [Pa]; in 2-D with that across the plane.
    template <class Law>
    [[nodiscard]] Matrix<3> stress(const Law& law, const Corners& x) const {
        return stress(law, gradient(x), Matrix<D>::Zero());
    }

    /// The same at the corners of the solid in the box, the places +-(3 S_i)^(1/2) from the centroid along its axes:
    /// half the width of a slab with this second moment. With the stress that varies linearly in the cell (bending,
    /// twist):
    ///   2-D:  s_xx += E' y_x Y,   s_yy += E' y_y X
    ///   3-D:  s_ii += E' (A_i + nu A_j) X_g,   s_ij += G (B_i + B_j) X_g   for each g
    template <class Law>
    [[nodiscard]] std::array<Matrix<3>, corners> surface_stresses(const Law& law, const Corners& x) const {
        const Matrix<D> f = gradient(x);
        const Modes y = f.transpose() * (x * twist);
        const double e = youngs_modulus, nu = poisson_ratio, held = e / (1 - nu * nu), shear = e / (2 * (1 + nu));
        std::array<Matrix<3>, corners> stresses;
        for (int k = 0; k < corners; ++k) {
            Matrix<D> more = Matrix<D>::Zero();
            const auto off = [&](int axis) { return (k >> axis & 1 ? 1 : -1) * std::sqrt(3 * moment[axis]); };
            if constexpr (D == 2) {
                more(0, 0) = held * y(0, 0) * off(1);
                more(1, 1) = held * y(1, 0) * off(0);
            } else {
                for (int g = 0; g < 3; ++g) {
                    const int i = (g + 1) % 3, j = (g + 2) % 3;
                    more(i, i) += held * (y(i, j) + nu * y(j, i)) * off(g);
                    more(j, j) += held * (y(j, i) + nu * y(i, j)) * off(g);
                    more(i, j) += shear * (y(i, i) + y(j, j)) * off(g);
                    more(j, i) = more(i, j);
                }
            }
            stresses[static_cast<std::size_t>(k)] = stress(law, f, more);
        }
        return stresses;
    }

    /// Least and largest principal value of Green's strain at the centroid [-].
    [[nodiscard]] std::array<double, 2> principal_strains(const Corners& x) const {
        const Matrix<D> f = gradient(x);
        const Eigen::SelfAdjointEigenSolver<Matrix<D>> principal(0.5 * (f.transpose() * f - Matrix<D>::Identity()),
                                                                 Eigen::EigenvaluesOnly);
        return {principal.eigenvalues().minCoeff(), principal.eigenvalues().maxCoeff()};
    }

    /// `elastic` times the derivative of minus the elastic forces with respect to x plus `viscous` times that of the
    /// elastic moduli alone, without what may be negative: compression across the motion, and what the moments of
    /// bending do as a cell turns. Unknown k D + i is component i of corner k.
    template <class Law>
    [[nodiscard]] Square stiffness(const Law& law, const Corners& x, double elastic, double viscous) const {
        const Matrix<D> f = gradient(x), c = f.transpose() * f;
        const Modes q = x * twist;
        Eigen::Matrix<double, Voigt<D>::size, unknowns> strain;  // derivatives of the strain, shears twice
        Eigen::Matrix<double, D * modes, unknowns> bend;         // and of y
        for (int k = 0; k < corners; ++k)
            for (int i = 0; i < D; ++i) {
                const int unknown = k * D + i;
                for (int row = 0; row < Voigt<D>::size; ++row) {
                    const auto [p, r] = Voigt<D>::axes[row];
                    strain(row, unknown) = f(i, p) * slope(k, r) + (p == r ? 0 : f(i, r) * slope(k, p));
                }
                for (int m = 0; m < modes; ++m)
                    for (int p = 0; p < D; ++p)
                        bend(m * D + p, unknown) = slope(k, p) * q(i, m) + f(i, p) * twist(k, m);
            }
        const typename Voigt<D>::Square moduli =
            elastic * law.template tangent<D>(c) + viscous * constants().template tangent<D>();
        Square sum = volume * (strain.transpose() * moduli * strain);
        sum += (elastic + viscous) * (bend.transpose() * bending_moduli() * bend);

        const Eigen::SelfAdjointEigenSolver<Matrix<D>> principal(law.template stress<D>(c));
        const Point tension = principal.eigenvalues().cwiseMax(0.0);
        const Eigen::Matrix<double, corners, D> along = slope * principal.eigenvectors();
        const Eigen::Matrix<double, corners, corners> across =
            elastic * volume * (along * tension.asDiagonal() * along.transpose());
        for (int k = 0; k < corners; ++k)
            for (int l = 0; l < corners; ++l)
                for (int i = 0; i < D; ++i) sum(k * D + i, l * D + i) += across(k, l);
        return sum;
    }

  private:
    /// Cauchy's stress of the second Piola-Kirchhoff stress of the law and `more`, which in 2-D is of fibres that are
    /// held across the plane.
    template <class Law>
    [[nodiscard]] Matrix<3> stress(const Law& law, const Matrix<D>& f, const Matrix<D>& more) const {
        const Matrix<D> c = f.transpose() * f;
        Matrix<3> stress = Matrix<3>::Zero();
        stress.template topLeftCorner<D, D>() = f * (law.template stress<D>(c) + more) * f.transpose();
        if constexpr (D == 2) stress(2, 2) = law.stress_across(c) + poisson_ratio * more.trace();
        return stress / f.determinant();
    }

    /// T of y. In 3-D mode m is the one without axis m, and mode 3 has all.
    [[nodiscard]] Modes bending_moments(const Modes& y) const {
        const double e = youngs_modulus, nu = poisson_ratio, held = e / (1 - nu * nu);
        Modes t = Modes::Zero();
        if constexpr (D == 2) {
            t(0, 0) = held * volume * moment[1] * y(0, 0);
            t(1, 0) = held * volume * moment[0] * y(1, 0);
        } else {
            const double shear = e / (2 * (1 + nu));
            for (int g = 0; g < 3; ++g) {
                const int i = (g + 1) % 3, j = (g + 2) % 3;
                const double weight = volume * moment[g];
                t(i, j) += weight * held * (y(i, j) + nu * y(j, i));
                t(j, i) += weight * held * (y(j, i) + nu * y(i, j));
                t(i, i) += weight * shear * (y(i, i) + y(j, j));
                t(j, j) += weight * shear * (y(i, i) + y(j, j));
            }
            const double product = (moment[0] * moment[1] + moment[1] * moment[2] + moment[2] * moment[0]) / 3;
            t.col(3) = e * volume * product * y.col(3);
        }
        return t;
    }

    /// dT/dy; component m D + p is axis p of mode m.
    [[nodiscard]] Eigen::Matrix<double, D * modes, D * modes> bending_moduli() const {
        Eigen::Matrix<double, D * modes, D * modes> moduli;
        for (int column = 0; column < D * modes; ++column) {
            Modes unit = Modes::Zero();
            unit(column % D, column / D) = 1;
            moduli.col(column) = bending_moments(unit).reshaped();
        }
        return moduli;
    }
};

}  // namespace dmp::models
