// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "mesher/spring_lattice.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "mesher/whole_cells.hpp"

namespace dmp::mesher {

namespace {

/// Largest share of EI that the rows' stretching may have: the rest is the hinges', which alone resist shear.
double largest_axial_share(int rows) { return rows == 2 ? 0.5 : 1 - 1.0 / (rows * rows); }

/// Where the part's stiffness is written: of EA, else of E.
const SourceLocation& location_of_stiffness(const Part& part) {
    return part.axial_stiffness.given() ? part.axial_stiffness.location : part.youngs_modulus.location;
}

LadderConstants hinged_ladder(const Part& part, const StripStiffness& strip, double along, double across, int rows) {
    const double bending = strip.bending;
    double axial = strip.axial;
    const double spread = (rows * rows - 1) / 12.0;  // mean square of the rows' places across [b^2]
    const double axial_share = axial * across * across * spread / bending, largest = largest_axial_share(rows);
    if (axial_share > largest && part.lower_axial_stiffness) axial *= largest / axial_share;

    LadderConstants constants;
    constants.along = along;
    constants.across = across;
    constants.rows = rows;
    constants.bond_stiffness = constants.rung_stiffness = axial / (2 * rows * along);
    constants.hinge_stiffness = (bending - axial * across * across * spread) / (2 * (rows - 1) * along);
    if (constants.hinge_stiffness < 0) {
        std::ostringstream problem, what_to_do;
        problem << "the hinges of '" << part.name.value << "' would need a negative stiffness, "
                << constants.hinge_stiffness << " J: " << (rows == 2 ? "two" : std::to_string(rows)) << " rows "
                << across << " m apart with axial_stiffness " << strip.axial
                << " N alone bend with EI = " << axial * across * across * spread
                << " N*m^2, more than bending_stiffness " << bending << " N*m^2";
        what_to_do << "lower axial_stiffness to at most " << bending / (across * across * spread)
                   << " N, refine particles.spacing, or set lower_axial_stiffness = true";
        throw InputError(location_of_stiffness(part), problem.str(), what_to_do.str());
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
        throw InputError(location_of_stiffness(part), problem.str(), what_to_do.str());
    }
    constants.rung_stiffness = constants.cross_stiffness;
    return constants;
}

/// With hinges and diagonals: of these EI and GA, by the stiffness of the diagonals. EA grows with it.
LadderConstants braced_ladder(const StripStiffness& strip, double along, double across, double cross_stiffness) {
    LadderConstants constants;
    constants.along = along;
    constants.across = across;
    constants.cross_stiffness = cross_stiffness;
    constants.hinge_stiffness = std::max(0.0, (strip.shear - constants.shear_stiffness()) * along / 8);
    constants.bond_stiffness = constants.rung_stiffness =
        std::max(0.0, (strip.bending - 2 * constants.hinge_stiffness * along) / (across * across * along));
    return constants;
}

LadderConstants braced_ladder(const Part& part, const StripStiffness& strip, double along, double across) {
    const double a2 = along * along, b2 = across * across;
    const double shear_of_diagonals = 4 * along * b2 / (a2 + b2);  // over k_c
    // From no diagonals, or rows that give nothing, to no hinges.
    double fewest = std::max(0.0, (strip.shear - 4 * strip.bending / a2) / shear_of_diagonals);
    double most = strip.shear / shear_of_diagonals;
    const auto axial = [&](double cross_stiffness) {
        return braced_ladder(strip, along, across, cross_stiffness).axial_stiffness();
    };
    if (strip.axial < axial(fewest) || strip.axial > axial(most)) {
        if (part.lower_axial_stiffness)
            return braced_ladder(strip, along, across, strip.axial < axial(fewest) ? fewest : most);
        std::ostringstream problem;
        problem << "part '" << part.name.value << "': two rows " << across << " m apart with EI = " << strip.bending
                << " N*m^2 and GA = " << strip.shear << " N have EA = " << axial(fewest) << " to " << axial(most)
                << " N, and it asks for " << strip.axial << " N";
        throw InputError(part.shear_stiffness.location, problem.str(),
                         "give an EA in that range, another particles.spacing, or lower_axial_stiffness = true");
    }
    constexpr int halvings = 100;
    for (int k = 0; k < halvings; ++k) {
        const double middle = 0.5 * (fewest + most);
        (axial(middle) < strip.axial ? fewest : most) = middle;
    }
    return braced_ladder(strip, along, across, 0.5 * (fewest + most));
}

}  // namespace

StripStiffness strip_stiffness(const Part& part) {
    if (part.youngs_modulus == 0) return {part.bending_stiffness, part.axial_stiffness, part.shear_stiffness};
    const double axial = part.youngs_modulus * part.thickness / (1 - part.poisson_ratio * part.poisson_ratio);
    return {axial * part.thickness * part.thickness / 12, axial, part.shear_stiffness};
}

StripRows strip_rows(const Part& part, const Scene& scene) {
    const double spacing = scene.particles.spacing;
    const bool is_dry = scene.parts_of(PartKind::fluid).empty();
    const bool has_diagonals = part.cross_bonds || part.shear_stiffness.given();
    if (is_dry || has_diagonals || !(part.thickness > (1 + 1e-9) * 2 * spacing)) return {2, spacing};
    const int count = std::max(2, static_cast<int>(std::lround(part.thickness / spacing)));
    return {count, part.thickness / count};
}

LadderConstants ladder_constants(const Part& part, double along, double across, int rows) {
    const StripStiffness strip = strip_stiffness(part);
    if (strip.shear > 0) return braced_ladder(part, strip, along, across);
    return part.cross_bonds ? crossed_ladder(part, strip, along, across)
                            : hinged_ladder(part, strip, along, across, rows);
}

Ladder ladder_along(const Polyline& curve, double spacing, const StripRows& rows) {
    const double length = curve.length();
    const int cells = static_cast<int>(whole_cells(length / spacing));
    Ladder ladder;
    ladder.along = length / cells;
    ladder.rows = rows.count;
    for (int column = 0; column <= cells; ++column) {
        const auto [point, tangent] = curve.at(std::min(length, column * ladder.along));
        const Vec left(-tangent[1], tangent[0], 0);
        for (int row = 0; row < rows.count; ++row)
            ladder.nodes.emplace_back(point + (0.5 * (rows.count - 1) - row) * rows.apart * left);
    }
    return ladder;
}

}  // namespace dmp::mesher
