// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "mesher/spring_lattice.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace dmp {

namespace {

/// Largest share of EI that the rows' stretching may have: the rest is the hinges', which alone resist shear.
constexpr double largest_axial_share = 0.5;

/// Where the part's stiffness is written: of EA, else of E.
const Place& place_of_stiffness(const Part& part) {
    return part.axial_stiffness.given() ? part.axial_stiffness.place : part.youngs_modulus.place;
}

LadderConstants hinged_ladder(const Part& part, const StripStiffness& strip, double along, double across) {
    const double bending = strip.bending;
    double axial = strip.axial;
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
                << strip.axial << " N alone bend with EI = " << axial * across * across / 4
                << " N*m^2, more than bending_stiffness " << bending << " N*m^2";
        what_to_do << "lower axial_stiffness to at most " << 4 * bending / (across * across)
                   << " N, refine particles.spacing, or set lower_axial_stiffness = true";
        throw InputError(place_of_stiffness(part), problem.str(), what_to_do.str());
    }
    return constants;
}

LadderConstants crossed_ladder(const Part& part, const StripStiffness& strip, double along, double across) {
    LadderConstants constants;
    constants.along = along;
    constants.across = across;
    constants.bond_stiffness = strip.bending / (across * across * along);
    const double by_rows = constants.axial_stiffness(), a2 = along * along, b2 = across * across;
    constants.cross_stiffness = (strip.axial - by_rows) * (a2 + 3 * b2) / (4 * a2 * along);
    if (part.lower_axial_stiffness)
        constants.cross_stiffness = std::max(constants.cross_stiffness, constants.bond_stiffness);
    if (constants.cross_stiffness <= 0) {
        std::ostringstream problem, what_to_do;
        problem << "the cross bonds of '" << part.name.value << "' would need a stiffness of "
                << constants.cross_stiffness << " N/m: two rows " << across
                << " m apart that bend with EI = " << strip.bending << " N*m^2 alone have EA = " << by_rows
                << " N, more than axial_stiffness " << strip.axial << " N";
        what_to_do << "set cross_bonds = false, or lower_axial_stiffness = true, which here raises EA";
        throw InputError(place_of_stiffness(part), problem.str(), what_to_do.str());
    }
    return constants;
}

}  // namespace

StripStiffness strip_stiffness(const Part& part) {
    if (part.youngs_modulus == 0) return {part.bending_stiffness, part.axial_stiffness};
    const double axial = part.youngs_modulus * part.thickness / (1 - part.poisson_ratio * part.poisson_ratio);
    return {axial * part.thickness * part.thickness / 12, axial};
}

LadderConstants ladder_constants(const Part& part, double along, double across) {
    const StripStiffness strip = strip_stiffness(part);
    return part.cross_bonds ? crossed_ladder(part, strip, along, across) : hinged_ladder(part, strip, along, across);
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
