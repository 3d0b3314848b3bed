// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "models/dem/contact.hpp"
#include "models/dem/contact_constants.hpp"
#include "models/registry.hpp"

namespace dmp::models {

/// Van der Waals adhesion of hard spheres, added to Hertz' repulsion: in contact the constant attraction of
/// Derjaguin, Muller & Toporov (1975), across a gap z = -d that of Bradley (1932):
///   F = -F_c                                 z < z0
///   F = -4/3 F_c [(z0/z)^2 - (z0/z)^8 / 4]   z0 < z < range,   0 beyond
///   F_c = 2 pi W R*   [N],   W = gamma_i + gamma_j - gamma_ij, 2 gamma of equal surfaces [J/m^2]
/// Work to separate bodies with overlap d: F_c (d + 16/7 z0), less the part beyond the range, about 4/3 F_c z0^2 /
/// range.
struct BradleyAdhesion {
    static constexpr LawFacts facts{"bradley", "Bradley 1932; Derjaguin, Muller & Toporov 1975",
                                    "Bradley's force between rigid spheres (constant in contact, as DMT)"};
    static constexpr bool adhesive = true, has_range = true;

    /// Force along the normal: negative or 0.
    template <class T, class Constants>
    static T law(const Contact<T>& contact, const Constants& pair) {
        const T gap = -contact.overlap;
        const T z0 = pair.adhesion_distance, range = pair.adhesion_range;
        const T ratio = where_less(gap, z0, T(1.0), z0 / where_less(gap, z0, z0, gap));
        const T square = ratio * ratio, cube = square * ratio;
        const T pull = (4.0 / 3) * pull_off(contact.radius, pair) * (square - 0.25 * (cube * cube * square));
        return where_less(gap, range, -pull, T(0.0));
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

    static double reach(double /*radius*/, const ContactConstants<>& pair) { return pair.adhesion_range; }

    /// Energy; 0 beyond the range [J].
    static double energy(double overlap, double radius, const ContactConstants<>& pair) {
        const double z0 = pair.adhesion_distance, gap = -overlap;
        if (gap >= pair.adhesion_range) return 0;
        const auto to_infinity = [&](double z) { return z0 * z0 / z - std::pow(z0 / z, 7) * z0 / 28; };
        const double outer = 4.0 / 3 * (to_infinity(std::max(gap, z0)) - to_infinity(pair.adhesion_range));
        return -pull_off(radius, pair) * (outer + std::max(0.0, z0 - gap));
    }

    /// The steepest slope of the force [N/m]: 1.026 F_c / z0, at z = 3^(1/6) z0.
    static double stiffness(double radius, const ContactConstants<>& pair) {
        return 4.0 / 3 * 4 / (3 * std::sqrt(3.0)) * pull_off(radius, pair) / pair.adhesion_distance;
    }
};

}  // namespace dmp::models
