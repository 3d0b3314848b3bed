// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <limits>

#include "models/pair.hpp"
#include "models/sph/viscosity_means.hpp"

namespace dmp::models {

/// Viscous force on particle i along the line between the particles (Monaghan & Gingold 1983; Monaghan 1992), whose
/// strength alpha gives a real viscosity (Monaghan 2005, eq. 8.8):
///   F_i = SUM_j V_i V_j rho alpha h c0 (v_ij . x_ij) / (r^2 + 0.01 h^2) grad_i W_ij   [N],   h = support / 2
///   nu = alpha h c0 / (2 (D + 2)): alpha h c0 / 8 in the plane, / 10 in space
/// so that rho alpha h c0 = 2 (D + 2) mu_ij, mu_ij the mean of both viscosities.
/// That holds when every pair takes part. Where only pairs that approach do, as in the shock capturing that the term
/// comes from, half of the pairs of a shear flow are left out, and the same viscosity takes twice the alpha.
/// They then also push, with a pressure like mu times the shear rate: a liquid that is not stiff against it is
/// compressed. Conserves linear and angular momentum. In the continuum waves of compression meet 3 mu, shear mu; a
/// lattice gives both with an error (LatticeViscosity). Reads volume, velocity and dynamic viscosity. Largest stable
/// explicit step: Morris' over 2.5, the largest ratio of both symbols over all waves and kernels (2.48, waves of
/// compression); half of that where only approach counts.
template <int D>
struct MonaghanViscosity {
    double twice_strength;  ///< 2 (D + 2) / 2 of the sum of the viscosities; twice that where only approach counts [-]
    double softening;       ///< 0.01 h^2 [m^2]
    double largest_approach;  ///< v_ij . x_ij beyond which a pair counts no more: 0 or infinite [m^2/s]
    double arithmetic;        ///< weight of the arithmetic mean against the harmonic one: 1 or 0 [-]

    MonaghanViscosity(double support, bool approaching_only, bool arithmetic_mean)
        : twice_strength((D + 2) * (approaching_only ? 2.0 : 1.0)),
          softening(0.01 * 0.25 * support * support),
          largest_approach(approaching_only ? 0.0 : std::numeric_limits<double>::infinity()),
          arithmetic(arithmetic_mean ? 1.0 : 0.0) {}

    template <class P>
    [[nodiscard]] auto law(const P& p) const {
        using std::min;
        const auto harmonic = HarmonicMean::twice(p.i.viscosity, p.j.viscosity);
        const auto twice_mean =
            harmonic + arithmetic * (ArithmeticMean::twice(p.i.viscosity, p.j.viscosity) - harmonic);
        const auto opening = dot(p.i.velocity - p.j.velocity, p.separation);
        using Scalar = std::remove_const_t<decltype(opening)>;
        const auto counted = min(opening, Scalar(largest_approach));
        const auto distance_square = dot(p.separation, p.separation) + softening;
        return (p.weight() * twice_strength * twice_mean * (counted / distance_square)) * p.separation;
    }

    /// Of Morris' largest stable step [-].
    static double share_of_morris_step(bool approaching_only) { return approaching_only ? 0.2 : 0.4; }
    /// alpha of a fluid of kinematic viscosity nu [m^2/s]; c0 [m/s].
    [[nodiscard]] double alpha(double nu, double support, double sound_speed) const {
        return 2 * twice_strength * nu / (0.5 * support * sound_speed);
    }
};

}  // namespace dmp::models
