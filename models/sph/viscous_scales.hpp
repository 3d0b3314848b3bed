// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "models/sph/lattice_viscosity.hpp"

namespace dmp::models {

/// Quantities that determine the constants of viscous laws.
struct ViscousScales {
    int dimension = 2;
    double support = 0;  ///< R [m]
    /// Ratio of effective to specified viscosity of Morris' and Monaghan's laws on the undisturbed lattice with this
    /// kernel [-].
    LatticeViscosity morris_on_lattice{1, 1}, monaghan_on_lattice{1, 3};
};

/// The scales of a lattice of this spacing [m]. `slope(r)` is the kernel's (1/r) dW/dr [1/m^(D+2)].
template <class Slope>
ViscousScales viscous_scales(int dimension, double spacing, double support, const Slope& slope) {
    return {dimension, support, lattice_viscosity_of_morris(dimension, spacing, support, slope),
            lattice_viscosity_of_monaghan(dimension, spacing, support, slope)};
}

}  // namespace dmp::models
