// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>

#include "base/vec.hpp"

namespace dmp::models {

/// Contact of two surfaces at a point, by a penalty on the gap g between them (negative: how deep one is behind the
/// other), Coulomb's friction, and a dashpot along the normal (Wriggers 2006, chapters 5 and 6):
///   p = max(0, -k g - c dg/dt) for g < 0, 0 beyond   [Pa]
///   t = -k_t s, |t| <= mu p, k_t = 0.7 k             [Pa]
/// s is the slip that has built up since the surfaces met, cut back where they slide. Without friction and dashpot the
/// energy is U = k g^2 / 2 [J/m^2].
struct SurfaceContactLaw {
    double friction = 0;  ///< mu [-]
    double damping = 0;   ///< fraction of critical, c = 2 zeta (k m)^1/2 with m the mass per area that meets [-]

    static constexpr double tangential_stiffness = 0.7;  ///< k_t / k

    /// @param stiffness k [Pa/m]  @param gap g [m]  @param gap_rate dg/dt [m/s]
    /// @param mass_per_area m [kg/m^2]
    [[nodiscard]] double pressure(double stiffness, double gap, double gap_rate, double mass_per_area) const {
        if (!(gap < 0)) return 0;
        return std::max(0.0, -stiffness * gap - dashpot(stiffness, mass_per_area) * gap_rate);
    }

    /// c [Pa s/m]
    [[nodiscard]] double dashpot(double stiffness, double mass_per_area) const {
        return damping > 0 ? 2 * damping * std::sqrt(stiffness * mass_per_area) : 0;
    }

    /// The traction by friction [Pa]; cuts the slip back to what it holds.
    [[nodiscard]] Vec traction(double stiffness, double pressure, Vec& slip) const {
        const double k = tangential_stiffness * stiffness, most = friction * pressure, length = slip.norm();
        if (k * length > most) slip *= most / (k * length);
        return -k * slip;
    }

    /// [J/m^2]
    static double energy(double stiffness, double gap) { return gap < 0 ? 0.5 * stiffness * gap * gap : 0; }

    /// As how much stiffer a contact counts for the largest stable step, because of friction and of the dashpot, with
    /// which it is 2 / omega ((1 + zeta^2)^1/2 - zeta).
    [[nodiscard]] double stiffening() const {
        const double shorter = std::sqrt(1 + damping * damping) - damping;
        return (friction > 0 ? 1 + tangential_stiffness : 1) / (shorter * shorter);
    }
};

}  // namespace dmp::models
