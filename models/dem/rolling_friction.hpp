// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "models/dem/contact.hpp"
#include "models/dem/contact_constants.hpp"
#include "models/registry.hpp"

namespace dmp::models {

/// A torque on i against its rolling on j, and the angle of its spring afterwards.
template <class T>
struct RollingTorque {
    Vector<T, 3> torque, angle;  ///< [N m], [rad]
};

/// Input of the rolling laws besides the relative angular velocity.
template <class T>
struct RollingContact {
    T stiffness;  ///< k_n a of the normal force [N/m]
    T pressing;   ///< force that presses the surfaces together, as for friction [N]
};

/// The component of omega_i - omega_j perpendicular to the normal; spin about the normal is not resisted.
template <class T>
Vector<T, 3> rolling_rate(const Contact<T>& contact) {
    return contact.relative_spin - dot(contact.relative_spin, contact.normal) * contact.normal;
}

/// No rolling friction.
struct NoRolling {
    static constexpr LawFacts facts{"none", "", "none"};
    static constexpr int history_vectors = 0;
};

/// A torque of constant magnitude against the rolling (Zhou et al. 1999; model A of Ai et al., Powder Technol. 206,
/// 2011):
///   M = -mu_r R* F_n w / |w|   [N m],   w the rolling rate
/// but at most the torque that stops a sphere within the step, so that a sphere at rest does not oscillate. It cannot
/// hold a sphere on a slope; the spring can.
struct ConstantRolling {
    static constexpr LawFacts facts{"constant", "constant torque", "a torque of constant magnitude"};
    static constexpr int history_vectors = 0;

    template <class T, class Constants>
    static RollingTorque<T> law(const Contact<T>& contact, const Constants& pair, const RollingContact<T>& rolling,
                                const Vector<T, 3>& angle, double dt) {
        using std::sqrt;
        const Vector<T, 3> rate = rolling_rate(contact);
        const T speed = sqrt(dot(rate, rate));
        const T most = pair.rolling_friction * contact.radius * rolling.pressing;
        if (!(dt > 0)) return {-(most / (speed + T(1e-300))) * rate, angle};
        const T stop = (0.4 / dt) * contact.mass * contact.radius * contact.radius * speed;
        return {-(where_less(stop, most, stop, most) / (speed + T(1e-300))) * rate, angle};
    }
};

/// A rolling spring that yields, with a dashpot until it does (model C, "elastic-plastic spring-dashpot", of Ai et
/// al., Powder Technol. 206, 2011; spring of Iwashita & Oda 1998):
///   M = -k_r theta - c_r w,   |k_r theta| <= mu_r R* F_n,   k_r = 9/4 k_n a (mu_r R*)^2   [N m]
/// theta is the integral of the rolling rate w. c_r = 2 zeta sqrt(k_r I) with I = 7/5 m* R*^2 (a sphere that rolls on
/// a plane), and 0 once the spring yields. The sum of spring and dashpot is also limited to mu_r R* F_n.
struct RollingSpring {
    static constexpr LawFacts facts{"spring", "spring and dashpot", "the torque of a spring that yields"};
    static constexpr int history_vectors = 1;

    template <class T, class Constants>
    static RollingTorque<T> law(const Contact<T>& contact, const Constants& pair, const RollingContact<T>& rolling,
                                const Vector<T, 3>& angle_before, double dt) {
        using std::sqrt;
        const T zero(0.0), one(1.0), tiny(1e-300);
        const Vector<T, 3> rate = rolling_rate(contact);
        const Vector<T, 3> angle = angle_before - dot(angle_before, contact.normal) * contact.normal + T(dt) * rate;
        const T arm = pair.rolling_friction * contact.radius;
        const T stiffness = spring(rolling.stiffness, arm);
        const T most = arm * rolling.pressing;
        const T size = stiffness * sqrt(dot(angle, angle));
        const Vector<T, 3> kept = where_less(most, size, most / (size + tiny), one) * angle;
        const T inertia = 1.4 * contact.mass * contact.radius * contact.radius;
        const T dashpot = where_less(most, size, zero, 2.0 * pair.rolling_damping * sqrt(stiffness * inertia));
        const Vector<T, 3> torque = -stiffness * kept - dashpot * rate;
        const T total = sqrt(dot(torque, torque));
        return {where_less(most, total, most / (total + tiny), one) * torque, kept};
    }

    /// Energy stored in the spring [J].
    static double energy(const Vector<double, 3>& angle, const RollingContact<double>& rolling, double radius,
                         const ContactConstants<>& pair) {
        return 0.5 * spring(rolling.stiffness, pair.rolling_friction * radius) * dot(angle, angle);
    }

  private:
    /// k_r [N m], `arm` = mu_r R*.
    template <class T>
    static T spring(const T& stiffness, const T& arm) {
        return 2.25 * stiffness * arm * arm;
    }
};

}  // namespace dmp::models
