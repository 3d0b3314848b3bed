// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/geometry.hpp"
#include "scene/scene.hpp"

namespace dmp {

/// Spring constants of a ladder: two rows of nodes `across` apart, columns `along` apart, a bond along each row cell
/// and across each column, hinges at the four corners of each cell. Energies without 1/2 (k_b (r - r0)^2, k_a (theta -
/// theta0)^2). Exact for long waves, by equating the energy of a uniform stretch, curvature and shear:
///   EA = 4 k_b along,   EI = k_b across^2 along + 2 k_a along,   GA_s = 8 k_a / along
struct LadderConstants {
    double bond_stiffness = 0;   ///< k_b [N/m]
    double hinge_stiffness = 0;  ///< k_a [J]
    double along = 0;            ///< [m]
    double across = 0;           ///< [m]

    [[nodiscard]] double axial_stiffness() const { return 4 * bond_stiffness * along; }
    [[nodiscard]] double bending_stiffness() const {
        return bond_stiffness * across * across * along + 2 * hinge_stiffness * along;
    }
    [[nodiscard]] double shear_stiffness() const { return 8 * hinge_stiffness / along; }
};

/// The constants that give the part's EI and EA. A ladder has EI >= EA across^2 / 4; where the part asks for more EA
/// than that, EA is lowered until its share of EI is one half, if the part allows it, else InputError.
LadderConstants ladder_constants(const Part& part, double along, double across);

/// Nodes of a ladder along an open curve: column k at arc length k * along; even nodes on the left of the curve, odd on
/// its right, half of `across` away.
struct Ladder {
    std::vector<Vec> nodes;
    double along = 0;

    [[nodiscard]] int columns() const { return static_cast<int>(nodes.size() / 2); }
};

/// Columns `spacing` apart, or slightly more or less so that they end where the curve ends.
Ladder ladder_along(const Polyline& curve, double spacing);

}  // namespace dmp
