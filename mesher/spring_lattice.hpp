// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/geometry.hpp"
#include "mesher/uses.hpp"
#include "scene/scene.hpp"

namespace dmp::mesher {

/// Spring constants of a ladder: two rows of nodes `across` apart (b), columns `along` apart (a), a bond along each row
/// cell and across each column (a rung), and in each cell hinges at its four corners, bonds along its two diagonals, or
/// both. Energies without 1/2 (k_b (r - r0)^2, k_a (theta - theta0)^2). Exact for long waves, by equating the energy of
/// a uniform stretch, curvature and shear (docs/elastic.md), k_r that of rungs:
///   EA = 4 k_b a + 4 k_c k_r a^3 / (2 k_c b^2 + k_r (a^2 + b^2)),   EI = k_b b^2 a + 2 k_a a,
///   GA_s = 8 k_a / a + 4 k_c a b^2 / (a^2 + b^2)
/// With k_c = k_r = k_b and a = b that is EA = 5 k_b a, EI = k_b a^3, GA_s = 2 k_b a (and hinges' share).
struct LadderConstants {
    double bond_stiffness = 0;   ///< k_b [N/m]
    double hinge_stiffness = 0;  ///< k_a [J]
    double cross_stiffness = 0;  ///< k_c [N/m]; 0: no diagonals
    double rung_stiffness = 0;   ///< k_r [N/m]
    double along = 0;            ///< a [m]
    double across = 0;           ///< b [m]

    [[nodiscard]] double axial_stiffness() const {
        const double by_rows = 4 * bond_stiffness * along, a2 = along * along, b2 = across * across;
        if (cross_stiffness == 0) return by_rows;
        return by_rows + 4 * cross_stiffness * rung_stiffness * a2 * along /
                             (2 * cross_stiffness * b2 + rung_stiffness * (a2 + b2));
    }
    [[nodiscard]] double bending_stiffness() const {
        return bond_stiffness * across * across * along + 2 * hinge_stiffness * along;
    }
    [[nodiscard]] double shear_stiffness() const {
        return 8 * hinge_stiffness / along +
               4 * cross_stiffness * along * across * across / (along * along + across * across);
    }
};

/// EI and EA that the part asks for, as such or by its modulus and thickness (plane strain where it has a Poisson
/// ratio): EA = E h / (1 - nu^2), EI = EA h^2 / 12; and its GA.
struct StripStiffness {
    double bending;    ///< EI [N m^2]
    double axial;      ///< EA [N]
    double shear = 0;  ///< GA_s [N]; 0: as the lattice gives
};
StripStiffness strip_stiffness(const Part& part);

/// The constants that give the part's EI and EA, and GA where it asks for one. With GA there are hinges and diagonals,
/// and rungs are as stiff as the rows; EI and GA leave a range to EA, from hinges alone to diagonals alone, whose
/// nearer end is taken where the part asks for another. Without, a ladder with hinges has EI >= EA across^2 / 4; where
/// the part asks for more EA than that, EA is lowered until its share of EI is one half. One with cross bonds has EI <=
/// EA across^2 / 4, with little shear stiffness near the limit; there EA is raised until the diagonals are as stiff as
/// the rows. If the part does not allow either, InputError where the lattice would be impossible.
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

}  // namespace dmp::mesher
