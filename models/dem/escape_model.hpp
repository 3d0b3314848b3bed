// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <limits>
#include <numbers>

namespace dmp::models {

/// Detachment of small particles from a carrier that hits a rigid wall (the simple model of Ariane, Sommerfeld &
/// Alexiadis 2018, Powder Technology; docs/escape.md). All in SI units; the defaults are those of the paper.
///
/// The carrier arrives with speed v at the angle theta from the wall; the impact stops its normal velocity u = v
/// sin(theta). A particle detaches if its kinetic energy in the carrier's frame exceeds the work of adhesion, less
/// the elastic energy stored in its contact, plus the work of friction while it slides by xi:
///   south of the equator, at the polar angle phi from the south pole, away from the surface:
///     a m u^2 >= W - E_n + mu F_c xi(phi)
///   north of it, at the latitude phi, along the surface, with the component u cos(phi):
///     1/2 m u^2 cos(phi)^2 >= W - E_n + mu F_c sqrt(2 R_1 d)
/// with F_c = k_n sqrt(R*) d^(3/2), E_n = 2/5 F_c d. The detached fraction is that of the surface, for an even
/// coverage.
struct EscapeModel {
    /// As printed: a = 1/8, W = F_c (d + z_cut), xi = d tan(phi), north (1 - cos(phi)) / 2.
    /// Corrected: a = 1/2 (the largest relative velocity is u), W = F_c (d + 16/7 z0) (the integral of Bradley's force
    /// from -d), xi = R_1 (phi - asin((1 - d/R_1) sin(phi))), which stays finite at the equator, north sin(phi) / 2
    /// (the zone between the equator and the latitude phi).
    enum class Form { printed, corrected };

    Form form = Form::printed;
    double carrier_radius = 50e-6;        ///< R_1 [m]
    double particle_radius = 2.5e-6;      ///< [m]
    double particle_mass = 8.44e-14;      ///< m [kg]
    double pull_off_force = 2.58e-7;      ///< F_c [N]
    double friction = 0.3;                ///< mu, above 0 [-]
    double normal_stiffness = 0;          ///< k_n: 4/3 E* of Hertz, or a substitute for it [Pa]
    double cutoff = 1e-9;                 ///< z_cut, of the printed form [m]
    double equilibrium_distance = 4e-10;  ///< z0, of the corrected form [m]

    /// 4/3 E*, 1/E* = (1 - nu_1^2)/E_1 + (1 - nu_2^2)/E_2 [Pa].
    static double hertz_stiffness(double young_1, double poisson_1, double young_2, double poisson_2) {
        return 4.0 / 3 / ((1 - poisson_1 * poisson_1) / young_1 + (1 - poisson_2 * poisson_2) / young_2);
    }
    /// 2 E / ((1 + nu) (1 - nu)), equation (7.5) of the thesis: three times Hertz' constant for equal spheres [Pa].
    static double thesis_stiffness(double young, double poisson) { return 2 * young / ((1 + poisson) * (1 - poisson)); }

    /// R* [m].
    [[nodiscard]] double effective_radius() const {
        return carrier_radius * particle_radius / (carrier_radius + particle_radius);
    }
    /// The overlap d at which Hertz' force balances adhesion [m].
    [[nodiscard]] double rest_overlap() const {
        return std::pow(pull_off_force / (std::sqrt(effective_radius()) * normal_stiffness), 2.0 / 3);
    }
    /// W - E_n: the work to lift a particle off, without friction [J].
    [[nodiscard]] double work_to_lift() const {
        const double d = rest_overlap();
        const double range = form == Form::printed ? cutoff : 16.0 / 7 * equilibrium_distance;
        return pull_off_force * (d + range) - 0.4 * pull_off_force * d;
    }
    /// mu F_c xi north of the equator [J].
    [[nodiscard]] double northern_friction() const {
        return friction * pull_off_force * std::sqrt(2 * carrier_radius * rest_overlap());
    }

    /// The particles detached in one impact.
    struct Escape {
        double south_angle = 0;       ///< largest polar angle from the south pole; negative (printed form): none [rad]
        double north_latitude = 0;    ///< largest latitude; not a number: none [rad]
        double south = 0, north = 0;  ///< fractions of all particles [-]
        double north_zone = 0;        ///< area fraction of the zone from the equator to that latitude, sin(phi) / 2 [-]

        [[nodiscard]] double fraction() const { return south + north; }
    };

    /// For an impact with the normal velocity u = v sin(theta) [m/s].
    [[nodiscard]] Escape escape(double normal_velocity) const {
        Escape found;
        const double energy = particle_mass * normal_velocity * normal_velocity;
        found.south_angle = form == Form::printed ? printed_south(energy / 8) : corrected_south(energy / 2);
        found.south = found.south_angle > 0 ? 0.5 * (1 - std::cos(found.south_angle)) : 0;
        const double cosine_squared = (work_to_lift() + northern_friction()) / (energy / 2);
        found.north_latitude = std::numeric_limits<double>::quiet_NaN();
        if (!(cosine_squared <= 1)) return found;
        found.north_latitude = std::acos(std::sqrt(cosine_squared));
        found.north_zone = 0.5 * std::sin(found.north_latitude);
        found.north = form == Form::printed ? 0.5 * (1 - std::cos(found.north_latitude)) : found.north_zone;
        return found;
    }

    /// The normal velocity at which the first particle, the one at the south pole, detaches [m/s].
    [[nodiscard]] double first_escape() const {
        return std::sqrt((form == Form::printed ? 8 : 2) * work_to_lift() / particle_mass);
    }

  private:
    /// From equation (7.26); may be negative.
    [[nodiscard]] double printed_south(double energy) const {
        return std::atan((energy - work_to_lift()) / (friction * pull_off_force * rest_overlap()));
    }
    /// xi grows with phi: bisection finds the phi at which the energy is used up; 0: nowhere, pi / 2: energy remains
    /// at the equator.
    [[nodiscard]] double corrected_south(double energy) const {
        const double left = energy - work_to_lift(), inner = 1 - rest_overlap() / carrier_radius;
        const auto friction_to = [&](double phi) {
            return friction * pull_off_force * carrier_radius * (phi - std::asin(inner * std::sin(phi)));
        };
        double low = 0, high = 0.5 * std::numbers::pi;
        if (left <= 0) return 0;
        if (friction_to(high) <= left) return high;
        for (int halving = 0; halving < 60; ++halving) {
            const double middle = 0.5 * (low + high);
            (friction_to(middle) <= left ? low : high) = middle;
        }
        return low;
    }
};

}  // namespace dmp::models
