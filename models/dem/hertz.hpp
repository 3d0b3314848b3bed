// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "models/dem/contact.hpp"
#include "models/dem/contact_constants.hpp"
#include "models/registry.hpp"

namespace dmp::models {

/// Normal forces between two bodies, without dashpots.
template <class T>
struct NormalContact {
    T touch;           ///< radius a of the contact circle [m]
    T force;           ///< positive: repulsive [N]
    T adhesive_force;  ///< added to the contact force in Coulomb's limit, since adhesion presses the bodies together
                       ///< [N]
};

/// Two elastic spheres (Hertz 1882; Johnson, Contact Mechanics, 1985, 4.2):
///   F = k_n a d,   a = sqrt(R* d),   k_n = 4/3 E*   [N]
/// Energy 2/5 k_n sqrt(R*) d^(5/2), stiffness dF/dd = 3/2 k_n a.
struct HertzContact {
    static constexpr LawFacts facts{"hertz", "Hertz 1882", "Hertz' elastic contact"};
    static constexpr bool adhesive = false, has_range = false, keeps_touch = false;

    template <class T, class Constants>
    static NormalContact<T> law(const Contact<T>& contact, const Constants& pair, const T& /*held*/ = T(0.0)) {
        using std::sqrt;
        const T overlap = where_less(T(0.0), contact.overlap, contact.overlap, T(0.0));
        const T touch = sqrt(contact.radius * overlap);
        return {touch, pair.normal_stiffness * touch * overlap, T(0.0)};
    }

    static double reach(double /*radius*/, const ContactConstants<>& /*pair*/) { return 0; }
    /// Stored energy [J].
    static double energy(double overlap, double radius, const ContactConstants<>& pair) {
        return overlap > 0 ? 0.4 * pair.normal_stiffness * std::sqrt(radius) * std::pow(overlap, 2.5) : 0;
    }
};

}  // namespace dmp::models
