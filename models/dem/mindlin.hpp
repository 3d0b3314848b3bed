// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "models/dem/contact.hpp"
#include "models/registry.hpp"

namespace dmp::models {

/// The tangential force of a contact, and its history.
template <class T>
struct Shear {
    Vector<T, 3> force;  ///< on i [N]
    Vector<T, 3> kept;   ///< history of the spring
};

/// Input of the tangential laws besides the slip.
template <class T>
struct ShearContact {
    T touch;      ///< contact radius a [m]
    T mean_root;  ///< mean of sqrt(a) over the step, of 0 while the surfaces do not touch [m^(1/2)]
    T modulus;    ///< k_t [Pa]
    T dashpot;    ///< c_t [N s/m]
    T largest;    ///< Coulomb's limit: mu times the pressing force [N]
};

/// A tangential spring and dashpot with Coulomb's limit:
///   F_t = -k_t a xi - c v,   |F_t| <= mu F_n,   k_t = 8 G*   [N]
/// with the displacement xi of a contact of radius a that does not slip (Mindlin 1949) and the velocity v. While the
/// contact grows or shrinks, xi is rescaled so that the spring's energy k_t a xi^2 / 2 stays the same: xi ~ a^(-1/2).
/// Changes of the normal force alone then neither add nor remove energy, and leave no trace once they are reversed
/// (docs/contact.md compares the models in use). The history is xi sqrt(a) [m^(3/2)]. While the surfaces slide, the
/// spring force is also limited to Coulomb's limit.
struct RescaledHistory {
    static constexpr LawFacts facts{"mindlin", "Mindlin 1949; history without spurious energy (docs/contact.md)",
                                    "Mindlin's spring, its displacement rescaled as the contact grows and shrinks"};
    /// Without friction's sliding and dashpots; all tangential laws say whether they do.
    static constexpr bool conserves_energy = true;
    /// Forces use the directions at mid-step; the dashpot starts and ends with the overlap.
    static constexpr bool centred = true;

    /// Divides the force of a spring and a dashpot that was found with the velocity of half a step ago, for a moving
    /// mass [kg] and steps of dt, into that with the velocity at the end of the step, the force itself included: 1 +
    /// x/2, x = c dt / m. At least x, so that a dashpot of any strength can stop a motion but not reverse it.
    template <class T>
    static T end_of_step(const T& dashpot, const T& mass, double dt) {
        const T step = T(dt) * dashpot / mass, half = T(1.0) + 0.5 * step;
        return where_less(half, step, step, half);
    }

    template <class T>
    static Shear<T> law(const Contact<T>& contact, const ShearContact<T>& shear, const Vector<T, 3>& kept_before,
                        double dt) {
        using std::sqrt;
        const T tiny(1e-300), one(1.0);
        // 2/7 m*: a tangential force also rotates solid spheres.
        const T end = end_of_step(shear.dashpot, (2.0 / 7) * contact.mass, dt);
        const Vector<T, 3> moved = turned(kept_before, contact.normal) + (T(dt) * shear.mean_root) * contact.slip;
        const T per_kept = shear.modulus * sqrt(shear.touch);  // k_t a xi = k_t sqrt(a) (xi sqrt(a))
        const T held = per_kept * sqrt(dot(moved, moved));
        // The spring's own limit, but so that what rests is held up to Coulomb's.
        const T still = end * shear.largest - shear.dashpot * sqrt(dot(contact.slip, contact.slip));
        const T most = where_less(shear.largest, still, still, shear.largest);
        const Vector<T, 3> kept = where_less(most, held, most / (held + tiny), one) * moved;
        const Vector<T, 3> force = (one / end) * (-per_kept * kept - shear.dashpot * contact.slip);
        const T size = sqrt(dot(force, force));
        return {where_less(shear.largest, size, shear.largest / (size + tiny), one) * force, kept};
    }

    /// Distance from a centre to the contact [m]: to the plane where the overlap is widest, so that the same force at
    /// the same point acts on both bodies.
    template <class T>
    static T lever(const T& radius, const T& effective_radius, const T& overlap) {
        return radius - overlap * effective_radius / radius;
    }

    /// Friction depends on the force that presses the surfaces together.
    template <class T>
    static T normal_load(const T& normal_force) {
        return where_less(T(0.0), normal_force, normal_force, T(0.0));
    }

    /// Energy stored in the spring [J].
    static double energy(const Vector<double, 3>& kept, double /*touch*/, double modulus) {
        return 0.5 * modulus * dot(kept, kept);
    }

  private:
    /// Rotates a vector perpendicular to the last normal into the plane perpendicular to this one: its projection,
    /// scaled to the former length (to the fourth power of the angle between the normals).
    template <class T>
    static Vector<T, 3> turned(const Vector<T, 3>& vector, const Vector<T, 3>& normal) {
        const T along = dot(vector, normal);
        const T tilt = along * along / (dot(vector, vector) + T(1e-300));
        return (T(1.0) + 0.5 * tilt) * (vector - along * normal);
    }
};

/// The same spring with a displacement that is not rescaled, as in `pair_style gran/hertz/history` of LAMMPS (Silbert
/// et al. 2001; Brilliantov et al. 1996): the dashpot uses the slip velocity unchanged, the spring is reset so that
/// spring and dashpot together equal Coulomb's limit, and forces act at the spheres' radii. For comparison with other
/// programs: a growing contact gains spurious energy, and a strong dashpot makes the spring oscillate.
struct PlainHistory {
    static constexpr LawFacts facts{"mindlin_unscaled", "Mindlin 1949; history as in LAMMPS' gran/hertz/history",
                                    "the same with the displacement not rescaled, as in LAMMPS' gran/hertz/history"};
    static constexpr bool conserves_energy = false;
    static constexpr bool centred = false;

    template <class T>
    static Shear<T> law(const Contact<T>& contact, const ShearContact<T>& shear, const Vector<T, 3>& stretch_before,
                        double dt) {
        using std::sqrt;
        const T zero(0.0), one(1.0), tiny(1e-300);
        const T stiffness = shear.modulus * shear.touch;
        Vector<T, 3> stretch = stretch_before + T(dt) * contact.slip;
        const T length = sqrt(dot(stretch, stretch));
        stretch -= dot(stretch, contact.normal) * contact.normal;
        const Vector<T, 3> force = -stiffness * stretch - shear.dashpot * contact.slip;
        const T size = sqrt(dot(force, force));
        const T share = where_less(shear.largest, size, shear.largest / (size + tiny), one);
        const T lag = where_less(shear.largest, size, shear.dashpot / (stiffness + tiny), zero);
        // If the displacement is zero, LAMMPS omits a force beyond Coulomb's limit: the first evaluation of a run.
        const T felt = where_less(zero, length, share, where_less(shear.largest, size, zero, one));
        return {felt * force, share * (stretch + lag * contact.slip) - lag * contact.slip};
    }

    template <class T>
    static T end_of_step(const T& /*dashpot*/, const T& /*mass*/, double /*dt*/) {
        return T(1.0);
    }
    template <class T>
    static T lever(const T& radius, const T& /*effective_radius*/, const T& /*overlap*/) {
        return radius;
    }
    static double energy(const Vector<double, 3>& stretch, double touch, double modulus) {
        return 0.5 * modulus * touch * dot(stretch, stretch);
    }
    /// As in LAMMPS, friction uses the magnitude of the normal force, also when a dashpot pulls.
    template <class T>
    static T normal_load(const T& normal_force) {
        return where_less(normal_force, T(0.0), -normal_force, normal_force);
    }
};

}  // namespace dmp::models
