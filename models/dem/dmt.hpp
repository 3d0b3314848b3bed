// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <numbers>

#include "models/dem/contact.hpp"
#include "models/dem/contact_constants.hpp"
#include "models/registry.hpp"

namespace dmp::models {

/// Adhesion of stiff spheres with short-range forces (Derjaguin, Muller & Toporov, J. Colloid Interface Sci. 53,
/// 1975, in Maugis' form), added to Hertz' repulsion: a constant attraction while the surfaces touch, and none across
/// a gap:
///   F = -F_c, d >= 0;   0, d < 0;   F_c = 2 pi W R*   [N]
/// Bradley's law without its range. Work to separate bodies with overlap d: F_c d.
struct DmtAdhesion {
    static constexpr LawFacts facts{"dmt", "Derjaguin, Muller & Toporov 1975",
                                    "DMT's constant attraction in contact, none across a gap"};
    static constexpr bool adhesive = true, has_range = false;

    /// Force along the normal: negative or 0.
    template <class T, class Constants>
    static T law(const Contact<T>& contact, const Constants& pair) {
        return where_less(contact.overlap, T(0.0), T(0.0), -pull_off(contact.radius, pair));
    }

    /// F_c [N].
    template <class T, class Constants>
    static T pull_off(const T& radius, const Constants& pair) {
        return (2 * std::numbers::pi) * pair.adhesion_energy * radius;
    }
    /// W for a pull-off force measured on spheres of this effective radius [J/m^2].
    static double adhesion_energy(double pull_off, double radius) { return pull_off / (2 * std::numbers::pi * radius); }

    /// Overlap at which Hertz' force with stiffness k_n balances the attraction for this work of adhesion [m].
    static double rest_overlap(double radius, double normal_stiffness, double work) {
        const double pull = 2 * std::numbers::pi * work * radius;
        return std::pow(pull / (normal_stiffness * std::sqrt(radius)), 2.0 / 3);
    }

    static double reach(double /*radius*/, const ContactConstants<>& /*pair*/) { return 0; }
    /// Energy; 0 if the bodies do not touch [J].
    static double energy(double overlap, double radius, const ContactConstants<>& pair) {
        return overlap > 0 ? -pull_off(radius, pair) * overlap : 0;
    }
    /// Slope of the force [N/m]: 0, since the force is constant.
    static double stiffness(double /*radius*/, const ContactConstants<>& /*pair*/) { return 0; }
};

}  // namespace dmp::models
