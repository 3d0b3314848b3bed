// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sstream>
#include <string>

#include "models/registry.hpp"
#include "models/sph/central_viscosity.hpp"
#include "models/sph/viscous_scales.hpp"

namespace dmp::models {

/// Viscous force along the line between the particles with a calibrated strength (Cleary 1998; Cleary & Monaghan
/// 1999):
///   F_i = SUM_j V_i V_j xi (2 mu_ij) (v_ij . x_ij) / (r^2 + 0.01 h^2) grad_i W_ij   [N],   h = support / 2
/// Cleary measured xi = 4.96333 in Couette flow for his kernel and resolution. Here xi = (D + 2) / s, where s is the
/// ratio of effective to specified shear viscosity of Monaghan's law (xi = D + 2) on the undisturbed lattice with the
/// kernel in use: shear is exact there. In contrast to Morris' law, angular momentum is conserved. Reads volume,
/// velocity and dynamic viscosity. Largest stable explicit step: s times Monaghan's.
struct ClearyViscosity : CentralViscosity {
    static constexpr LawFacts facts{"cleary", "Cleary 1998, strength calibrated on the lattice",
                                    "Cleary's form, along the line of each pair with a calibrated strength"};
    static constexpr bool linear = true;

    explicit ClearyViscosity(const ViscousScales& scales)
        : CentralViscosity((scales.dimension + 2) / scales.monaghan_on_lattice.shear, scales.support, false),
          shear_(scales.monaghan_on_lattice.shear) {}

    [[nodiscard]] double step_share() const { return 0.4 * shear_; }
    static LatticeViscosity on_lattice(const ViscousScales& scales) {
        return {1, scales.monaghan_on_lattice.longitudinal / scales.monaghan_on_lattice.shear};
    }
    [[nodiscard]] std::string detail(double /*nu*/, double /*c0*/) const {
        std::ostringstream text;
        text.precision(3);
        text << ", xi = " << strength;
        return text.str();
    }

  private:
    double shear_;
};

}  // namespace dmp::models
