// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "solver/models/dem/contact.hpp"

namespace dmp {

/// What a contact does across its normal, and the stretch of its spring after it.
template <class T>
struct Shear {
    Vector<T, 3> force, stretch;  ///< on i [N], [m]
};

/// What the tangential laws are told of the contact besides its slip.
template <class T>
struct ShearContact {
    T touch;      ///< its radius a [m]
    T before;     ///< the radius at the last step; 0 when it begins [m]
    T stiffness;  ///< k_t a [N/m]
    T dashpot;    ///< c_t [N s/m]
    T largest;    ///< what friction can hold: mu times the normal force [N]
};

/// A tangential spring and dashpot under Coulomb's bound:
///   F_t = -k_t a xi - c v,   |F_t| <= mu F_n,   k_t = 8 G*   [N]
/// with the tangential displacement xi of no slip (Mindlin 1949), a the contact's radius and v the slip.
/// Where the contact grows, its spring force stays (new surface comes without stress) and xi follows from it; where it
/// shrinks, xi stays and the force shrinks with it (Walton 1987; Thornton, Cummins & Cleary 2013). No closed path in
/// overlap and displacement then gives work (Elata & Berryman 1996); plain history does.
/// The dashpot is taken at the end of the step, c / (1 + c dt / m_t) with m_t = 2/7 m* (solid spheres: a tangential
/// force also turns them), so that it stops the slip at most, however strong it is. While the surfaces slide, the
/// spring holds what friction can hold, not more.
struct RescaledHistory {
    template <class T>
    static Shear<T> law(const Contact<T>& contact, const ShearContact<T>& shear, const Vector<T, 3>& stretch_before,
                        double dt) {
        using std::sqrt;
        const T tiny(1e-300), one(1.0);
        const T grown = where_less(shear.before, shear.touch, shear.before / (shear.touch + tiny), one);
        const Vector<T, 3> stretch = grown * turned(stretch_before, contact.normal) + T(dt) * contact.slip;
        const T dashpot = shear.dashpot / (one + (3.5 * dt) * shear.dashpot / contact.mass);

        const T held = shear.stiffness * sqrt(dot(stretch, stretch));
        const T share = where_less(shear.largest, held, shear.largest / (held + tiny), one);
        const Vector<T, 3> kept = share * stretch;
        const Vector<T, 3> force = -shear.stiffness * kept - dashpot * contact.slip;
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
    static T gripping(const T& normal_force) {
        return where_less(T(0.0), normal_force, normal_force, T(0.0));
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
    template <class T>
    static Shear<T> law(const Contact<T>& contact, const ShearContact<T>& shear, const Vector<T, 3>& stretch_before,
                        double dt) {
        using std::sqrt;
        const T zero(0.0), one(1.0), tiny(1e-300);
        Vector<T, 3> stretch = stretch_before + T(dt) * contact.slip;
        const T length = sqrt(dot(stretch, stretch));
        stretch -= dot(stretch, contact.normal) * contact.normal;
        const Vector<T, 3> force = -shear.stiffness * stretch - shear.dashpot * contact.slip;
        const T size = sqrt(dot(force, force));
        const T share = where_less(shear.largest, size, shear.largest / (size + tiny), one);
        const T lag =
            where_less(shear.largest, size,
                       where_less(zero, shear.stiffness, shear.dashpot / (shear.stiffness + tiny), zero), zero);
        // Without any displacement LAMMPS leaves out what friction could not hold: the first evaluation of a run.
        const T felt = where_less(zero, length, share, where_less(shear.largest, size, zero, one));
        return {felt * force, share * (stretch + lag * contact.slip) - lag * contact.slip};
    }

    template <class T>
    static T lever(const T& radius, const T&, const T&) {
        return radius;
    }
    /// As there, friction also rests on a dashpot that pulls.
    template <class T>
    static T gripping(const T& normal_force) {
        return where_less(normal_force, T(0.0), -normal_force, normal_force);
    }
};

}  // namespace dmp
