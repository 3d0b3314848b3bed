// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/measure_keys.hpp"

namespace dmp::scene {

namespace {

ValueType<double> diffusivity_type() {
    ValueType<double> type = quantity("1e-9 m^2/s", not_negative);
    type.description = "a diffusivity such as \"1e-9 m^2/s\", at least 0";
    return type;
}

}  // namespace

// Columns as in schema.cpp.
// clang-format off

std::vector<Key<Species>> species_keys() {
    const auto concentrations = [](const Species& species) { return by_part(concentration_formula(species.unit)); };
    const auto fluxes = [](const Species& species) { return by_part(flux_formula(species.unit)); };
    const std::string concentration = by_part(concentration_formula(SpeciesUnit::mass)).description;
    return {
        {"name", &Species::name, name(), required, "What the species is called."},
        {"unit", &Species::unit, one_of<SpeciesUnit>(), "kg/m^3", "Unit of its concentrations."},
        {"diffusivity", &Species::diffusivity, by_part(diffusivity_type()), required,
         "Diffusivity in all fluids, or by part; solids in the table conduct, others are closed to the species."},
        {"concentration", {}, &Species::concentration, concentrations, concentration, not_given,
         "Concentration at the start, as a formula of x, y, or by part; where none is given it is 0."},
        {"wall_concentration", {}, &Species::wall_concentration, concentrations, concentration, not_given,
         "Concentration that the surfaces of rigid parts are held at, by formulas of t, x, y; other walls let nothing through."},
        {"wall_flux", {}, &Species::wall_flux, fluxes, by_part(flux_formula(SpeciesUnit::mass)).description, not_given,
         "What comes out of rigid parts into the fluid, per area and time, by formulas of t, x, y."},
    };
}

std::vector<Key<ResidenceRegion>> region_keys() {
    return {
        {"name", &ResidenceRegion::name, name(), required, "What the region is called; residence_time is of fluid in it."},
        {"from", &ResidenceRegion::from, point(), required, "One corner of a box along the axes."},
        {"to", &ResidenceRegion::to, point(), required, "The opposite corner."},
    };
}

std::vector<Key<Measure>> measure_keys() {
    const Kinds all, flux = {"flux"}, of_part = {"gap", "velocity", "spin", "detached"}, probe = {"probe"};
    const Kinds detached = {"detached"}, wall_flux = {"wall_flux"}, aggregate = {"aggregate"};
    const Kinds boxes = {"mean_concentration", "profile", "spread"}, along = {"profile", "spread"};
    const Kinds of_species = {"amount", "mean_concentration", "profile", "spread", "wall_flux", "peclet"};
    return {
        {"name", all, &Measure::name, name(), required, "The measure's column in measures.csv."},
        {"kind", all, &Measure::kind, one_of<MeasureKind>(), required,
         "What is followed: flux through a line, gap between a part's pieces, largest speed, density, kinetic energy, "
         "a probe's field; of a species its amount, mean concentration, profile, spread, flux into a wall, Peclet number; "
         "of spheres velocity, spin, the walls' force, or how many are detached from one; or size, pieces and bonds of an aggregate."},
        {"from", flux, &Measure::from, point(), required, "Where the line starts."},
        {"to", flux, &Measure::to, point(), required, "Where the line ends."},
        {"point", probe, &Measure::point, point(), required, "Where the probe stands."},
        {"field", probe, &Measure::field, one_of<FluidField>(), "velocity", "What the probe reads."},
        {"part", of_part, &Measure::part, name(), required,
         "The elastic solid whose pieces' smallest distance is followed; of spheres the part whose mean velocity or spin it is, or the one sphere that others may detach from."},
        {"direction", detached, &Measure::direction, direction(), "[0, 0, 1]",
         "Points to the half of the sphere that is counted as the upper one, as drawn."},
        {"species", of_species, &Measure::species, name(), not_given, "Which species; not needed where there is one."},
        {"from", boxes, &Measure::from, point(), not_given, "One corner of a box along the axes; without it all the fluid counts."},
        {"to", boxes, &Measure::to, point(), not_given, "The opposite corner."},
        {"axis", along, &Measure::axis, one_of<Axis>(), required, "Along which axis."},
        {"bins", {"profile"}, &Measure::bins, integer(Range{1, 1000, false, {}}), "20",
         "Equal parts of the box along the axis, each with a column for its mean."},
        {"about", {"spread"}, &Measure::about, quantity("1 mm"), not_given,
         "Place that the variance is taken about; without it the mean place."},
        {"part", wall_flux, &Measure::part, name(), required, "The rigid part whose uptake is followed."},
        {"length", {"peclet"}, &Measure::length, quantity("1 mm", positive), required,
         "L of the Peclet number U L / D, U the fluid's largest speed."},
        {"length", wall_flux, &Measure::length, quantity("1 mm", positive), not_given,
         "L of a column with the Sherwood number J L / (area D dc), dc the fluid's mean concentration less the wall's."},
        {"area", wall_flux, &Measure::area, quantity("1 mm^2", positive), not_given, "The wall's, for the Sherwood number; 1 m deep in 2-D."},
        {"part", aggregate, &Measure::part, name(), required,
         "The [[solidify]] or elastic solid whose particles, mass, pieces, largest piece and bonds are followed."},
    };
}
// clang-format on

}  // namespace dmp::scene
