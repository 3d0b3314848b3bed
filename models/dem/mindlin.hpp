// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "models/dem/contact.hpp"
#include "models/registry.hpp"

namespace dmp::models {

/// What a contact does across its normal, and what it remembers.
template <class T>
struct Shear {
    Vector<T, 3> force;  ///< on i [N]
    Vector<T, 3> kept;   ///< what is remembered of the spring
};

/// What the tangential laws are told of the contact besides its slip.
template <class T>
struct ShearContact {
    T touch;    ///< its radius a [m]
    T modulus;  ///< k_t [Pa]
    T dashpot;  ///< c_t [N s/m]
    T largest;  ///< what friction can hold: mu times the force that presses [N]
};

/// A tangential spring and dashpot under Coulomb's bound:
///   F_t = -k_t a xi - c v,   |F_t| <= mu F_n,   k_t = 8 G*   [N]
/// with the displacement xi of a contact of radius a that does not slip (Mindlin 1949) and the velocity v.
/// While the contact grows or shrinks, xi is rescaled so that the spring's energy k_t a xi^2 / 2 stays: xi ~ a^(-1/2).
/// Changes of the normal force alone then give and take no energy, in either direction, and leave no trace once they
/// are undone (docs/contact.md compares the rules in use). What is remembered is xi sqrt(a) [m^(3/2)].
/// While the surfaces slide, the spring holds what friction can hold, not more.
struct RescaledHistory {
    static constexpr LawFacts facts{"mindlin", "Mindlin 1949; history that makes no energy (docs/contact.md)",
                                    "Mindlin's spring, its displacement rescaled as the contact grows and shrinks"};
    /// Forces take the directions of the middle of a step; the dashpot begins and ends with the overlap.
    static constexpr bool centred = true;

    /// A dashpot that acts on what moves with this mass [kg], in steps of dt: c / max(1 + x/4, x), x = c dt / m.
    /// It sees the velocity of half a step ago, which makes it too strong by the part x/4 as far as energy goes; and it
    /// stops a motion at most, however strong it is.
    template <class T>
    static T in_steps(const T& dashpot, const T& mass, double dt) {
        const T step = T(dt) * dashpot / mass;
        const T delayed = T(1.0) + 0.25 * step;
        return dashpot / where_less(delayed, step, step, delayed);
    }

    template <class T>
    static Shear<T> law(const Contact<T>& contact, const ShearContact<T>& shear, const Vector<T, 3>& kept_before,
                        double dt) {
        using std::sqrt;
        const T tiny(1e-300), one(1.0);
        const T root = sqrt(shear.touch);
        const Vector<T, 3> moved = turned(kept_before, contact.normal) + (T(dt) * root) * contact.slip;
        const T per_kept = shear.modulus * root;  // k_t a xi = k_t sqrt(a) (xi sqrt(a))
        const T held = per_kept * sqrt(dot(moved, moved));
        const Vector<T, 3> kept = where_less(shear.largest, held, shear.largest / (held + tiny), one) * moved;

        // 2/7 m*: a tangential force also turns solid spheres.
        const T dashpot = in_steps(shear.dashpot, (2.0 / 7) * contact.mass, dt);
        const Vector<T, 3> force = -per_kept * kept - dashpot * contact.slip;
        const T size = sqrt(dot(force, force));
        return {where_less(shear.largest, size, shear.largest / (size + tiny), one) * force, kept};
    }

    /// From a centre to the contact [m]: to the plane where the overlap of both surfaces is widest, so that what turns
    /// both bodies is one force, at one place.
    template <class T>
    static T lever(const T& radius, const T& effective_radius, const T& overlap) {
        return radius - overlap * effective_radius / radius;
    }

    /// Friction rests on what presses the surfaces together.
    template <class T>
    static T normal_load(const T& normal_force) {
        return where_less(T(0.0), normal_force, normal_force, T(0.0));
    }

    /// What the spring stores [J].
    static double energy(const Vector<double, 3>& kept, double /*touch*/, double modulus) {
        return 0.5 * modulus * dot(kept, kept);
    }

  private:
    /// A vector that was across the last normal, across this one: its part across it, as long as it was (to the fourth
    /// power of the angle in between).
    template <class T>
    static Vector<T, 3> turned(const Vector<T, 3>& vector, const Vector<T, 3>& normal) {
        const T along = dot(vector, normal);
        const T tilt = along * along / (dot(vector, vector) + T(1e-300));
        return (T(1.0) + 0.5 * tilt) * (vector - along * normal);
    }
};

/// The same spring with one displacement for any radius, as `pair_style gran/hertz/history` of LAMMPS has it (Silbert
/// et al. 2001; Brilliantov et al. 1996): the dashpot takes the slip as it is, the spring is drawn back so that spring
/// and dashpot together are what friction holds, and forces act at the spheres' radii. For comparison with other
/// programs: a growing contact gains energy from nothing, and a strong dashpot makes the spring swing.
struct PlainHistory {
    static constexpr LawFacts facts{"mindlin_unscaled", "Mindlin 1949; history as in LAMMPS' gran/hertz/history",
                                    "the same with the displacement kept as LAMMPS' gran/hertz/history keeps it"};
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
        // Without any displacement LAMMPS leaves out what friction cannot hold: the first evaluation of a run.
        const T felt = where_less(zero, length, share, where_less(shear.largest, size, zero, one));
        return {felt * force, share * (stretch + lag * contact.slip) - lag * contact.slip};
    }

    template <class T>
    static T in_steps(const T& dashpot, const T& /*mass*/, double /*dt*/) {
        return dashpot;
    }
    template <class T>
    static T lever(const T& radius, const T& /*effective_radius*/, const T& /*overlap*/) {
        return radius;
    }
    static double energy(const Vector<double, 3>& stretch, double touch, double modulus) {
        return 0.5 * modulus * touch * dot(stretch, stretch);
    }
    /// As there, friction also rests on a dashpot that pulls.
    template <class T>
    static T normal_load(const T& normal_force) {
        return where_less(normal_force, T(0.0), -normal_force, normal_force);
    }
};

}  // namespace dmp::models
