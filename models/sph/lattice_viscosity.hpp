// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

namespace dmp::models {

/// Ratio of the effective viscosity of a viscous law to the specified one on the undisturbed square or cubic lattice,
/// where sums replace integrals. `shear` is for v_x = y^2/2, `longitudinal` for v_x = x^2/2. In the continuum,
/// Morris' law has 1 and 1, Monaghan's 1 and 3.
struct LatticeViscosity {
    double shear = 0, longitudinal = 0;
};

/// Calls visit(x, y, r, V) for the points of a lattice within the support of one of them, except for that point
/// itself.
template <class Visit>
void for_each_lattice_point(int dimension, double spacing, double support, const Visit& visit) {
    const int reach = static_cast<int>(support / spacing) + 1, deep = dimension == 3 ? reach : 0;
    const double volume = std::pow(spacing, dimension);
    for (int i = -reach; i <= reach; ++i)
        for (int j = -reach; j <= reach; ++j)
            for (int k = -deep; k <= deep; ++k) {
                const double r = spacing * std::hypot(i, j, k);
                if (r > 0 && r < support) visit(spacing * i, spacing * j, r, volume);
            }
}

/// For Morris' law. `slope(r)` is (1/r) dW/dr; lengths in metres.
template <class Slope>
LatticeViscosity lattice_viscosity_of_morris(int dimension, double spacing, double support, const Slope& slope) {
    LatticeViscosity sum;
    for_each_lattice_point(dimension, spacing, support, [&](double x, double y, double r, double volume) {
        sum.shear -= volume * slope(r) * y * y;
        sum.longitudinal -= volume * slope(r) * x * x;
    });
    return sum;
}

/// For Monaghan's law, with its softening of the distance.
template <class Slope>
LatticeViscosity lattice_viscosity_of_monaghan(int dimension, double spacing, double support, const Slope& slope) {
    LatticeViscosity sum;
    const double softening = 0.01 * 0.25 * support * support;
    for_each_lattice_point(dimension, spacing, support, [&](double x, double y, double r, double volume) {
        const double weight = -(dimension + 2) * volume * slope(r) * x * x / (r * r + softening);
        sum.shear += weight * y * y;
        sum.longitudinal += weight * x * x;
    });
    return sum;
}

}  // namespace dmp::models
