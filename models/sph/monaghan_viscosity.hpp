// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sstream>
#include <string>

#include "models/registry.hpp"
#include "models/sph/central_viscosity.hpp"
#include "models/sph/viscous_scales.hpp"

namespace dmp::models {

/// Viscous force along the line between the particles (Monaghan & Gingold 1983; Monaghan 1992), whose strength alpha
/// corresponds to a real viscosity (Monaghan 2005, eq. 8.8):
///   F_i = SUM_j V_i V_j rho alpha h c0 (v_ij . x_ij) / (r^2 + 0.01 h^2) grad_i W_ij   [N],   h = support / 2
///   nu = alpha h c0 / (2 (D + 2)): alpha h c0 / 8 in 2-D, / 10 in 3-D
/// so that rho alpha h c0 = 2 (D + 2) mu_ij, with the mean mu_ij of both viscosities, if every pair contributes. On a
/// lattice, the effective shear and longitudinal viscosities differ from this (LatticeViscosity). Reads volume,
/// velocity and dynamic viscosity. Largest stable explicit step: Morris' divided by 2.5, the largest ratio of the two
/// symbols over all waves and kernels (2.48, compression waves).
struct MonaghanViscosity : CentralViscosity {
    static constexpr LawFacts facts{"monaghan", "Monaghan & Gingold 1983, all pairs",
                                    "Monaghan's form, along the line of each pair"};
    static constexpr bool linear = true;

    explicit MonaghanViscosity(const ViscousScales& scales)
        : MonaghanViscosity(scales, scales.dimension + 2.0, false) {}

    static double step_share() { return 0.4; }
    static LatticeViscosity on_lattice(const ViscousScales& scales) { return scales.monaghan_on_lattice; }
    [[nodiscard]] std::string detail(double nu, double c0) const {
        std::ostringstream text;
        text.precision(3);
        text << ", alpha = " << alpha(nu, c0);
        return text.str();
    }
    /// alpha for a fluid of kinematic viscosity nu [m^2/s]; c0 [m/s].
    [[nodiscard]] double alpha(double nu, double c0) const { return 2 * strength * nu / (0.5 * support_ * c0); }

  protected:
    MonaghanViscosity(const ViscousScales& scales, double strength_of_pairs, bool approaching_only)
        : CentralViscosity(strength_of_pairs, scales.support, approaching_only), support_(scales.support) {}

  private:
    double support_;
};

/// Monaghan's law for approaching pairs only, as in the shock capturing from which the term originates. In a shear
/// flow half of the pairs do not contribute, and the same viscosity requires twice the alpha. The pairs also repel
/// each other, with a pressure of about mu times the shear rate, which compresses a fluid whose stiffness is low in
/// comparison. Step limit: half of Monaghan's.
struct ApproachingMonaghanViscosity : MonaghanViscosity {
    static constexpr LawFacts facts{"monaghan_approaching", "Monaghan & Gingold 1983, approaching pairs only",
                                    "the same for approaching pairs only"};
    static constexpr bool linear = false;

    explicit ApproachingMonaghanViscosity(const ViscousScales& scales)
        : MonaghanViscosity(scales, (scales.dimension + 2) * 2.0, true) {}

    static double step_share() { return 0.2; }
};

}  // namespace dmp::models
