// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <type_traits>

#include "models/dem/contact.hpp"
#include "models/dem/contact_constants.hpp"
#include "models/dem/contact_laws.hpp"
#include "models/dem/dashpot_ends.hpp"

namespace dmp::models {

/// The forces of one contact and its history.
template <ContactModel model>
struct ContactLaw {
    static_assert(model.is_consistent(), "an adhesive normal law cannot be combined with an adhesion law");
    using Normal = NormalLaws::Law<model.normal.number()>;
    using Tangential = TangentialLaws::Law<model.tangential.number()>;
    using Rolling = RollingLaws::Law<model.rolling.number()>;
    using Adhesion = AdhesionLaws::Law<model.adhesion.number()>;

    /// If a law depends on whether the surfaces have touched, the last history value is the contact radius at the
    /// last step.
    static constexpr bool keeps_touch = Normal::keeps_touch;
    /// A dashpot proportional to d^(1/4) starts and ends with the overlap; as in LAMMPS, every step has the same
    /// weight.
    static constexpr bool counts_ends = !keeps_touch && Tangential::centred;
    static constexpr int history_vectors = 1 + Rolling::history_vectors;
    static constexpr int history_values = 3 * history_vectors + (keeps_touch ? 1 : 0);

    template <class T>
    using History = ContactHistory<T, history_values>;

    /// Distance from a centre to the contact point [m].
    template <class T>
    static T lever(const T& radius, const T& effective_radius, const T& overlap) {
        return Tangential::lever(radius, effective_radius, overlap);
    }

    /// Largest gap across which a force can act [m]; 0 if forces act only in contact.
    static double reach(double radius, const ContactConstants<>& pair) {
        return std::max(Normal::reach(radius, pair), Adhesion::reach(radius, pair));
    }

    /// Energy that the contact stores [J]; of adhesion, relative to bodies far apart.
    static double energy(double overlap, double radius, const ContactConstants<>& pair,
                         const History<double>& history) {
        double held = 0, energy = 0;
        if constexpr (keeps_touch) held = history[history_values - 1];
        Contact<double> contact{};
        contact.overlap = overlap;
        contact.radius = radius;
        const double touch = Normal::law(contact, pair, held).touch;
        if (touch > 0)
            energy = Normal::energy(overlap, radius, pair) +
                     Tangential::energy(vector_of(history, 0), touch, pair.tangential_stiffness);
        if constexpr (history_vectors == 2)
            energy += Rolling::energy(vector_of(history, 1), {pair.normal_stiffness * touch, 0}, radius, pair);
        if constexpr (!std::is_same_v<Adhesion, NoAdhesion>) energy += Adhesion::energy(overlap, radius, pair);
        return energy;
    }

    /// The force of a contact after its surfaces have moved for dt [s] with the given velocities; updates `history`.
    /// With dt = 0 the history stays the same, and the force is the current one. If nothing touches, the history is
    /// zero and the force is the adhesion across the gap, if any. Constants is ContactConstants of double or T.
    template <class T, class Constants>
    static ContactForce<T> law(const Contact<T>& contact, const Constants& pair, History<T>& history, double dt) {
        using std::sqrt;
        const T zero(0.0);
        T before = zero;
        if constexpr (keeps_touch) before = history[history_values - 1];
        const NormalContact<T> normal = Normal::law(contact, pair, before);

        const T root = sqrt(contact.mass * normal.touch), mass_touch = contact.mass * normal.touch;
        const T pulling = where_less(normal.force, zero, normal.force, zero), least = pair.least_normal + pulling;
        const auto press = [&](const T& ends) {
            const T dashpot = pair.normal_dashpot * (ends * root) + pair.normal_rate * mass_touch;
            const T end = Tangential::end_of_step(dashpot, contact.mass, dt);
            // What pulls is left as it is: a pull-off force does not depend on the step.
            const T damped = pulling + (normal.force - pulling - dashpot * contact.normal_velocity) / end;
            return where_less(damped, least, least, damped);
        };
        T pressing = press(T(1.0));
        if constexpr (counts_ends) {
            const T part = contact.normal_velocity, slow = T(dt) * where_less(part, zero, -part, part);
            const T deep = where_less(zero, contact.overlap, contact.overlap, T(1e300));
            if (any_less(deep, T(2.0) * slow)) {
                // The distance travelled in the last step, or in the next step if they separate.
                const T next = T(dt) * (part + (T(dt) / contact.mass) * pressing);
                pressing = press(DashpotEnds::weight(deep, where_less(part, zero, slow, next)));
            }
        }
        const T normal_load = Tangential::normal_load(pressing + normal.adhesive_force);

        const ShearContact<T> shear{
            normal.touch, mean_root(contact, normal.touch, before, dt), T(pair.tangential_stiffness),
            pair.tangential_dashpot * root + pair.tangential_rate * mass_touch, pair.friction * normal_load};
        const Shear<T> sheared = Tangential::law(contact, shear, vector_of(history, 0), dt);
        ContactForce<T> force{pressing, sheared.force, Vector<T, 3>::zero()};
        if (dt > 0) keep(history, 0, sheared.kept, normal.touch);

        if constexpr (!std::is_same_v<Rolling, NoRolling>) {
            const RollingContact<T> rolling{pair.normal_stiffness * normal.touch, normal_load};
            const Vector<T, 3> angle = vector_of(history, std::size_t{history_vectors} - 1);
            const RollingTorque<T> rolled = Rolling::law(contact, pair, rolling, angle, dt);
            force.rolling = rolled.torque;
            if (history_vectors == 2 && dt > 0) keep(history, 1, rolled.angle, normal.touch);
        }
        // Friction depends on Hertz' force alone, which balances the sum of adhesion and external loads.
        if constexpr (!std::is_same_v<Adhesion, NoAdhesion>) force.normal += Adhesion::law(contact, pair);
        if constexpr (keeps_touch)
            if (dt > 0) history[history_values - 1] = normal.touch;
        return force;
    }

  private:
    /// Mean of sqrt(a) over a step [m^(1/2)], to second order, also where the overlap begins within it.
    template <class T>
    static T mean_root(const Contact<T>& contact, const T& touch, const T& before, double dt) {
        using std::sqrt;
        const T zero(0.0), one(1.0);
        const auto positive = [&](const T& value) { return where_less(zero, value, value, zero); };
        const T last = contact.overlap + T(dt) * contact.normal_velocity, now = positive(contact.overlap);
        // Of the step, in contact.
        const T part = where_less(last, zero, now / (now + where_less(last, zero, -last, one)), one);
        if constexpr (keeps_touch)
            return where_less(zero, before, sqrt(0.5 * (before + touch)), part * sqrt(touch));
        else
            return where_less(last, zero, 0.8 * part * sqrt(touch),
                              sqrt(sqrt(contact.radius * positive(0.5 * (last + contact.overlap)))));
    }
    template <class T>
    static Vector<T, 3> vector_of(const History<T>& history, std::size_t number) {
        return {{history[3 * number], history[3 * number + 1], history[3 * number + 2]}};
    }
    template <class T>
    static void keep(History<T>& history, std::size_t number, const Vector<T, 3>& vector, const T& touch) {
        for (std::size_t axis = 0; axis < 3; ++axis)
            history[3 * number + axis] = where_less(T(0.0), touch, vector[static_cast<int>(axis)], T(0.0));
    }
};

}  // namespace dmp::models
