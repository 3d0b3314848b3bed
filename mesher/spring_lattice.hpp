// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/geometry.hpp"
#include "mesher/uses.hpp"
#include "scene/scene.hpp"

namespace dmp::mesher {

/// Spring constants of a ladder: n rows of nodes `across` apart (b), columns `along` apart (a), a bond along each row
/// cell and from each row to the next (a rung), and in each cell hinges at its four corners, or in two rows bonds along
/// its two diagonals, or both. Energies without 1/2 (k_b (r - r0)^2, k_a (theta - theta0)^2). Exact for long waves, by
/// equating the energy of a uniform stretch, curvature and shear (docs/elastic.md). Two rows, k_r that of rungs:
///   EA = 4 k_b a + 4 k_c k_r a^3 / (2 k_c b^2 + k_r (a^2 + b^2)),   EI = k_b b^2 a + 2 k_a a,
///   GA_s = 8 k_a / a + 4 k_c a b^2 / (a^2 + b^2)
/// With k_c = k_r = k_b and a = b that is EA = 5 k_b a, EI = k_b a^3, GA_s = 2 k_b a (and hinges' share). n rows:
///   EA = 2 n k_b a,   EI = k_b b^2 a n (n^2 - 1) / 6 + 2 (n - 1) k_a a,   GA_s = 8 (n - 1) k_a / a
struct LadderConstants {
    double bond_stiffness = 0;   ///< k_b [N/m]
    double hinge_stiffness = 0;  ///< k_a [J]
    double cross_stiffness = 0;  ///< k_c [N/m]; 0: no diagonals
    double rung_stiffness = 0;   ///< k_r [N/m]
    double along = 0;            ///< a [m]
    double across = 0;           ///< b [m]
    int rows = 2;                ///< n

    [[nodiscard]] double axial_stiffness() const {
        const double by_rows = 2 * rows * bond_stiffness * along, a2 = along * along, b2 = across * across;
        if (cross_stiffness == 0) return by_rows;
        return by_rows + 4 * cross_stiffness * rung_stiffness * a2 * along /
                             (2 * cross_stiffness * b2 + rung_stiffness * (a2 + b2));
    }
    [[nodiscard]] double bending_stiffness() const {
        return bond_stiffness * across * across * along * (rows * (rows * rows - 1) / 6) +
               2 * (rows - 1) * hinge_stiffness * along;
    }
    [[nodiscard]] double shear_stiffness() const {
        return 8 * (rows - 1) * hinge_stiffness / along +
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

/// How the particles of a strip stand across it.
struct StripRows {
    int count = 2;
    double apart = 0;  ///< [m]

    /// From the outer side of one outer row to that of the other [m].
    [[nodiscard]] double thickness() const { return count * apart; }
};
/// Two rows a spacing apart. In liquid a strip with a `thickness` of more than two spacings has as many rows as
/// spacings, in the middles of equal slices; not with diagonals (cross_bonds, shear_stiffness).
StripRows strip_rows(const Part& part, const Scene& scene);

/// The constants that give the part's EI and EA, and GA where it asks for one. With GA there are hinges and diagonals,
/// and rungs are as stiff as the rows; EI and GA leave a range to EA, from hinges alone to diagonals alone, whose
/// nearer end is taken where the part asks for another. Without, a ladder with hinges has EI >= EA b^2 (n^2 - 1) / 12;
/// where the part asks for more EA than that, EA is lowered until its share of EI is one half, with more than two rows
/// 1 - 1 / n^2, the share in a strip n b thick of one material, in which hinges give GA_s = EA b^2 / (3 a^2). A ladder
/// with cross bonds has EI <= EA b^2 / 4, with little shear stiffness near the limit; there EA is raised until the
/// diagonals are as stiff as the rows. If the part does not allow either, InputError where the lattice would be
/// impossible.
LadderConstants ladder_constants(const Part& part, double along, double across, int rows = 2);

/// Nodes of a ladder along an open curve: column k at arc length k * along, its `rows` nodes from the left of the curve
/// to its right.
struct Ladder {
    std::vector<Vec> nodes;
    double along = 0;
    int rows = 2;

    [[nodiscard]] int columns() const { return static_cast<int>(nodes.size()) / rows; }
};

/// Columns `spacing` apart, or slightly more or less so that they end where the curve ends.
Ladder ladder_along(const Polyline& curve, double spacing, const StripRows& rows);

}  // namespace dmp::mesher
