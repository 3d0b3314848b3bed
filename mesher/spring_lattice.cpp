// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "mesher/spring_lattice.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace dmp {

namespace {

/// Largest share of EI that the rows' stretching may have: the rest is the hinges', which alone resist shear.
constexpr double largest_axial_share = 0.5;

}  // namespace

LadderConstants ladder_constants(const Part& part, double along, double across) {
    const double bending = part.bending_stiffness;
    double axial = part.axial_stiffness;
    const double axial_share = axial * across * across / 4 / bending;
    if (axial_share > largest_axial_share && part.lower_axial_stiffness) axial *= largest_axial_share / axial_share;

    LadderConstants constants;
    constants.along = along;
    constants.across = across;
    constants.bond_stiffness = axial / (4 * along);
    constants.hinge_stiffness = (bending - axial * across * across / 4) / (2 * along);
    if (constants.hinge_stiffness < 0) {
        std::ostringstream problem, what_to_do;
        problem << "the hinges of '" << part.name.value << "' would need a negative stiffness, "
                << constants.hinge_stiffness << " J: two rows " << across << " m apart with axial_stiffness "
                << part.axial_stiffness.value << " N alone bend with EI = " << axial * across * across / 4
                << " N*m^2, more than bending_stiffness " << bending << " N*m^2";
        what_to_do << "lower axial_stiffness to at most " << 4 * bending / (across * across)
                   << " N, refine particles.spacing, or set lower_axial_stiffness = true";
        throw InputError(part.axial_stiffness.place, problem.str(), what_to_do.str());
    }
    return constants;
}

Ladder ladder_along(const Polyline& curve, double spacing) {
    const double length = curve.length();
    const int cells = std::max(1, static_cast<int>(std::lround(length / spacing)));
    Ladder ladder;
    ladder.along = length / cells;
    for (int column = 0; column <= cells; ++column) {
        const auto [point, tangent] = curve.at(std::min(length, column * ladder.along));
        const Vec left(-tangent[1], tangent[0], 0);
        ladder.nodes.emplace_back(point + 0.5 * spacing * left);
        ladder.nodes.emplace_back(point - 0.5 * spacing * left);
    }
    return ladder;
}

}  // namespace dmp
