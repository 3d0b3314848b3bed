// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <numbers>

#include "models/dem/contact_constants.hpp"

namespace dmp::models {

/// Number of steps per contact: the defaults, and the least that is accepted. Measured over angles, frictions and
/// restitutions (docs/contact.md): with 3 steps an elastic impact may end with five times its energy, with 4 with 7 %
/// more, with 5 with 3.5 %.
struct StepsPerContact {
    static constexpr double draft = 15, standard = 30, fine = 75;
    static constexpr double least = 5;

    /// About the largest error of the spin after an impact, as the surface's speed over that of the impact, with the
    /// default laws: of second order. That of the speed is a third of it.
    static double error(double steps) { return 5.0 / (steps * steps); }
};

/// Reference times for the time step of contact laws, in SI units.
struct ContactTimes {
    /// Largest overlap of an elastic impact at `speed`: (5 m* v^2 / (4 k_n sqrt(R*)))^(2/5) [m].
    static double largest_overlap(double radius, double mass, double speed, const ContactConstants<>& pair) {
        return std::pow(1.25 * mass * speed * speed / (pair.normal_stiffness * std::sqrt(radius)), 0.4);
    }
    /// Duration of that impact: 4/5 B(2/5, 1/2) d_max / v = 2.9433 d_max / v [s] (Hertz 1882).
    static double impact(double radius, double mass, double speed, const ContactConstants<>& pair) {
        return 0.8 * std::beta(0.4, 0.5) * largest_overlap(radius, mass, speed, pair) / speed;
    }
    /// Half a period of small oscillations about an overlap, as for spheres at rest: pi sqrt(m* / (3/2 k_n a)) [s].
    static double at_rest(double overlap, double radius, double mass, const ContactConstants<>& pair) {
        return std::numbers::pi * std::sqrt(mass / (1.5 * pair.normal_stiffness * std::sqrt(radius * overlap)));
    }
    /// Travel time of a shear wave around half a sphere (Ning & Ghadiri 2006): pi R sqrt(rho / G) / (0.1631 nu +
    /// 0.8766) [s].
    static double rayleigh(double radius, double density, double young_modulus, double poisson_ratio) {
        const double shear_modulus = young_modulus / (2 * (1 + poisson_ratio));
        return std::numbers::pi * radius * std::sqrt(density / shear_modulus) / (0.1631 * poisson_ratio + 0.8766);
    }
    /// Largest stable step for a force with this slope, for example Bradley's: 2 sqrt(m / k) [s].
    static double stable(double stiffness, double mass) { return 2 * std::sqrt(mass / stiffness); }
};

}  // namespace dmp::models
