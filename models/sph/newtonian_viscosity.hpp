// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "models/pair.hpp"
#include "models/registry.hpp"
#include "models/sph/viscous_scales.hpp"

namespace dmp::models {

/// Viscous force of a Newtonian fluid on particle i: Morris' form (Morris, Fox & Zhu 1997, eq. 22) with the kernel's
/// lattice sum corrected, plus the transposed velocity gradient, which Morris' form leaves out:
///   F_i = SUM_j V_i V_j mu_ij b_ij (1/r dW/dr) [2 v_ij + (G_i + G_j)^T x_ij]   [N],   b_ij = (b_i + b_j) / 2
/// with the corrected gradient G and b = tr B / D of the last density sweep (VelocityGradient); the image of a solid
/// takes those of the fluid particle. A rigid rotation of everything exerts no force, pair by pair: without the
/// transposed part, free bodies turn too fast and the traction at interfaces and free surfaces is wrong. Reads volume,
/// velocity, dynamic viscosity, G and b. Antisymmetric; conserves linear momentum. Largest stable explicit step:
/// kernel.viscous_limit support^2 / nu (linear theory).
struct NewtonianViscosity {
    static constexpr LawFacts facts{"newtonian", "Morris, Fox & Zhu 1997, eq. 22, with the transposed gradient",
                                    "Morris' form plus the transposed velocity gradient: the whole stress of a "
                                    "Newtonian fluid"};
    static constexpr bool linear = true, needs_gradient = true;

    explicit NewtonianViscosity(const ViscousScales& /*scales*/ = {}) {}

    template <class P, class T>
    static auto law(const P& p, const T& twice_mean) {
        return strength(p, twice_mean) * with_gradients(p, past_image(p));
    }
    /// The part in v_ij: symmetric and positive definite, for implicit stepping.
    template <class P, class T>
    static auto law_of_velocities(const P& p, const T& twice_mean) {
        return strength(p, twice_mean) * (p.i.velocity - p.j.velocity);
    }
    /// The rest of it.
    template <class P, class T>
    static auto law_of_gradients(const P& p, const T& twice_mean) {
        return strength(p, twice_mean) * with_gradients(p, p.i.velocity_by_gradient - p.j.velocity_by_gradient);
    }

    static double step_share() { return 1; }
    static LatticeViscosity on_lattice(const ViscousScales& /*scales*/) { return {1, 2}; }
    static std::string detail(double /*nu*/, double /*c0*/) { return {}; }

  private:
    template <class P, class T>
    static auto strength(const P& p, const T& twice_mean) {
        return p.weight() * twice_mean * (0.5 * (p.i.correction + p.j.correction));
    }
    /// v_ij, with the part that an image in a wall takes from G.
    template <class P>
    static auto past_image(const P& p) {
        return (p.i.velocity - p.j.velocity) - (p.j.velocity_by_gradient - p.i.velocity_by_gradient);
    }
    /// velocity + (G_i + G_j)^T x_ij / 2
    template <class I, class J, class T, int D, class R, class S>
    static Vector<T, D> with_gradients(const Pair<I, J, Vector<T, D>, R, S>& p, Vector<T, D> velocity) {
        for (int row = 0; row < D; ++row)
            velocity += (0.5 * p.separation[row]) * (p.i.gradient[row] + p.j.gradient[row]);
        return velocity;
    }
};

}  // namespace dmp::models
