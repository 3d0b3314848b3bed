// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "models/dem/hertz.hpp"

namespace dmp::models {

/// Soft adhesive spheres (Johnson, Kendall & Roberts, Proc. R. Soc. A 324, 1971), instead of Hertz:
///   F = k_n a^3 / R* - sqrt(8 pi W E*) a^(3/2),   d = a^2 / R* - sqrt(2 pi W a / E*),   E* = 3/4 k_n   [N]
/// Surfaces that have touched (d > 0) adhere until d = -3 a_c^2 / R*, where a_c^3 = pi W R*^2 / (8 E*); there they
/// separate suddenly, and the stored energy is lost. Largest attraction 3/2 pi W R*, 3/4 of Bradley's and DMT's. In
/// units x^2 = a / a_c: F = pi W R* (x^6/6 - x^3) and d R* / a_c^2 = x^4 - 4 x, x >= 1.
struct JkrContact {
    static constexpr LawFacts facts{"jkr", "Johnson, Kendall & Roberts 1971", "JKR's contact of soft adhesive spheres"};
    static constexpr bool adhesive = true, has_range = false, keeps_touch = true;

    /// `held` is positive if the surfaces touched at the last step.
    template <class T, class Constants>
    static NormalContact<T> law(const Contact<T>& contact, const Constants& pair, const T& held) {
        const T zero(0.0);
        const T smallest = smallest_touch(contact.radius, pair);
        const T above = contact.overlap * contact.radius / (smallest * smallest) + T(3.0);
        const T root = T(1.0) + over_one(where_less(zero, above, above, zero));
        const T square = root * root, cube = square * root;
        const T present = where_less(zero, contact.overlap, T(1.0),
                                     where_less(zero, held, where_less(zero, above, T(1.0), zero), zero));
        const T scale = std::numbers::pi * pair.adhesion_energy * contact.radius * present;
        // k_n a^3 / R*, not the equal expression in W, since it becomes Hertz' force without adhesion.
        const T touch = present * smallest * square;
        return {touch, pair.normal_stiffness * touch * touch * touch / contact.radius - scale * cube, 3.0 * scale};
    }

    /// a_c: the contact radius at separation [m].
    template <class T, class Constants>
    static T smallest_touch(const T& radius, const Constants& pair) {
        // 1e-12 R* without adhesion: the equations are then those of Hertz.
        const T cube = (std::numbers::pi / 6) * pair.adhesion_energy / pair.normal_stiffness + 1e-36 * radius;
        return cube_root(radius * radius * cube);
    }

    /// Largest attraction [N].
    static double pull_off(double radius, const ContactConstants<>& pair) {
        return 1.5 * std::numbers::pi * pair.adhesion_energy * radius;
    }
    /// W for a pull-off force measured on spheres of this effective radius [J/m^2].
    static double adhesion_energy(double pull_off, double radius) {
        return pull_off / (1.5 * std::numbers::pi * radius);
    }

    /// Overlap at which the force is zero, for a stiffness k_n [m].
    static double rest_overlap(double radius, double normal_stiffness, double work) {
        const double modulus = 0.75 * normal_stiffness;
        const double contact = std::cbrt(4.5 * std::numbers::pi * work * radius * radius / modulus);
        return contact * contact / (3 * radius);
    }

    /// Gap at which surfaces that have touched separate [m].
    static double reach(double radius, const ContactConstants<>& pair) {
        const double touch = smallest_touch(radius, pair);
        return 3 * touch * touch / radius;
    }

    /// Energy of two surfaces that touch, relative to bodies far apart [J].
    ///   U = 2/5 k_n a^5 / R*^2 - k_n B a^(7/2) / R* + pi W a^2,   B = sqrt(2 pi W / E*)
    static double energy(double overlap, double radius, const ContactConstants<>& pair) {
        const double smallest = smallest_touch(radius, pair);
        const double x = 1 + over_one(std::max(0.0, overlap * radius / (smallest * smallest) + 3));
        const double a = smallest * x * x;
        const double b = std::sqrt(8 * std::numbers::pi * pair.adhesion_energy / (3 * pair.normal_stiffness));
        return 0.4 * pair.normal_stiffness * std::pow(a, 5) / (radius * radius) -
               pair.normal_stiffness * b * std::pow(a, 3.5) / radius + std::numbers::pi * pair.adhesion_energy * a * a;
    }

  private:
    /// Solves y^4 + 4 y^3 + 6 y^2 = above for y >= 0 by Newton's method; it starts above the root, as the polynomial
    /// is convex.
    template <class T>
    static T over_one(const T& above) {
        using std::sqrt;
        const T small = sqrt(above / 6.0), large = sqrt(sqrt(above));
        T y = where_less(small, large, small, large) + T(1e-150);
        for (int turn = 0; turn < 6; ++turn)
            y = y - (y * y * (y * (y + T(4.0)) + T(6.0)) - above) / (y * (y * (4.0 * y + T(12.0)) + T(12.0)));
        return y;
    }
    static double cube_root(double value) { return std::cbrt(value); }
    template <class Lanes>
    static Lanes cube_root(Lanes values) {
        for (std::size_t k = 0; k < Lanes::width; ++k) values.set(k, std::cbrt(values[k]));
        return values;
    }
};

}  // namespace dmp::models
