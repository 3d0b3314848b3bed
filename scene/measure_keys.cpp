// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/measure_keys.hpp"

#include "scene/measure_subject.hpp"

namespace dmp::scene {

namespace {

ValueType<double> diffusivity_type() {
    ValueType<double> type = quantity("1e-9 m^2/s", not_negative);
    type.description = "a diffusivity such as \"1e-9 m^2/s\", at least 0";
    return type;
}

ValueType<double> rate_type() {
    ValueType<double> type = quantity("0.1 1/s", not_negative);
    type.description = "a rate such as \"0.1 1/s\", at least 0";
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
        {"name", &Species::name, name(), required, "Name of the species."},
        {"unit", &Species::unit, one_of<SpeciesUnit>(), "kg/m^3", "Unit of the concentrations of the species."},
        {"diffusivity", &Species::diffusivity, by_part(diffusivity_type()), required,
         "Diffusivity in all fluids, or a table by part. Solids in the table conduct the species, all others are "
         "closed to it."},
        {"concentration", {}, &Species::concentration, concentrations, concentration, not_given,
         "Initial concentration, as a formula of x, y, z, or a table by part; 0 by default."},
        {"wall_concentration", {}, &Species::wall_concentration, concentrations, concentration, not_given,
         "Concentration at the surface of rigid and elastic parts: a table by part of formulas of t, x, y, z. All others "
         "are closed."},
        {"wall_flux", {}, &Species::wall_flux, fluxes, by_part(flux_formula(SpeciesUnit::mass)).description, not_given,
         "Flux out of rigid parts into the fluid, per area and time: a table by part of formulas of t, x, y, z."},
        {"uptake", &Species::uptake, by_part(rate_type()), not_given,
         "Rate k of first-order uptake, dc/dt = -k c, in all that carries the species, or a table by part; none by "
         "default."},
    };
}

std::vector<Key<ResidenceRegion>> region_keys() {
    return {
        {"name", &ResidenceRegion::name, name(), required,
         "Name of the region; residence_time is the time that fluid spends in it."},
        {"from", &ResidenceRegion::from, point(), required, "One corner of the region, a box along the axes."},
        {"to", &ResidenceRegion::to, point(), required, "The opposite corner."},
    };
}

std::vector<Key<Measure>> measure_keys() {
    const Kinds all, lines = {"flux", "line"}, fields = {"probe", "line", "mode", "field"}, probe = {"probe"}, line = {"line"};
    const Kinds of_part = {"gap", "velocity", "spin", "detached"};
    const Kinds detached = {"detached"}, wall_flux = {"wall_flux"}, aggregate = {"aggregate"}, displacement = {"displacement"}, body = {"body"};
    const Kinds field = {"field"}, solid_field = {"solid_field"};
    const Kinds boxes = {"mean_concentration", "profile", "spread"}, along = {"profile", "spread"};
    Kinds of_species = measures_of(MeasureSubject::species);
    of_species.emplace_back("field");
    return {
        {"name", all, &Measure::name, name(), required, "The measure's column in measures.csv."},
        {"kind", all, &Measure::kind, one_of<MeasureKind>(), required,
         "Quantity to measure: flux through a line, gap between the pieces of a part, largest speed, density, "
         "kinetic energy, field at a probe, along a line, its Fourier mode, or its mean and extremes in a region; of a species "
         "its amount, mean concentration, profile, spread, flux into a wall, uptake, Peclet number; of spheres their velocity, spin, force on the walls, number "
         "detached from a sphere; size, pieces and bonds of an aggregate; displacement of an elastic solid; its place, speed, angle, "
         "length and stretches as a body; mean and extremes of its fields; force, area and pressure of its contact."},
        {"from", lines, &Measure::from, point(), required, "Start of the line."},
        {"to", lines, &Measure::to, point(), required, "End of the line."},
        {"points", line, &Measure::points, integer(Range{2, 1000, false, {}}), "20",
         "Number of points along the line, evenly spaced from its start to its end; the field at each is a column."},
        {"point", probe, &Measure::point, point(), required, "Position of the probe."},
        {"field", fields, &Measure::field, one_of<FluidField>(), "velocity",
         "Field to measure. field: vectors by their magnitude, no tensors."},
        {"region", field, &Measure::region, name(), not_given,
         "The [[region]] in which the fluid is measured, also whose residence_time; all of the fluid by default. The columns are "
         "NAME_mean (by volume), NAME_low, NAME_high, and NAME_high_x, NAME_high_y, where the highest is."},
        {"field", solid_field, &Measure::solid_field, one_of<SolidField>(), "displacement",
         "Field to measure, vectors by their magnitude: velocity, displacement, von_mises, surface_stress or traction of its "
         "particles, strain or force of its bonds. Columns as of kind field."},
        {"waves", {"mode"}, &Measure::waves, wave_numbers(), required,
         "Number n of waves in the period along x, y and z, 0 along axes that are not periodic. The columns NAME_cos and "
         "NAME_sin are the factors of cos and sin(2 pi n . (x - x_0) / L) in the field, x_0 the low corner of the period."},
        {"part", of_part, &Measure::part, name(), required,
         "gap: the elastic solid between whose pieces the smallest distance is measured. velocity, spin: the part "
         "of spheres over which the mean is taken. detached: the part of the one sphere from which others may "
         "detach."},
        {"between", {"gap"}, &Measure::between, one_of<GapBetween>(), unwritten("surfaces"),
         "Between what of two pieces the gap is measured: \"surfaces\" of the material, \"middles\" between their two "
         "sides (of a strip or shell its curve or surface), or \"particles\"."},
        {"direction", detached, &Measure::direction, direction(), "[0, 0, 1]",
         "Initial direction to the half of the sphere that counts as the upper one."},
        {"species", of_species, &Measure::species, name(), not_given,
         "Species to measure; may be left out if there is only one."},
        {"from", boxes, &Measure::from, point(), not_given,
         "One corner of a box along the axes in which the fluid is measured; all of the fluid by default."},
        {"to", boxes, &Measure::to, point(), not_given, "The opposite corner."},
        {"axis", along, &Measure::axis, one_of<Axis>(), required, "Axis of the profile or spread."},
        {"bins", {"profile"}, &Measure::bins, integer(Range{1, 1000, false, {}}), "20",
         "Number of equal parts of the box along the axis; the mean of each is a column."},
        {"about", {"spread"}, &Measure::about, quantity("1 mm"), not_given,
         "Coordinate about which the variance is taken; the mean one by default."},
        {"part", wall_flux, &Measure::part, name(), required,
         "Rigid or elastic part into which the flux is measured."},
        {"part", {"uptake"}, &Measure::part, name(), not_given,
         "Part whose uptake is measured; all that take up the species by default."},
        {"length", {"peclet"}, &Measure::length, quantity("1 mm", positive), required,
         "Length L of the Peclet number U L / D, with the fluid's largest speed U."},
        {"length", wall_flux, &Measure::length, quantity("1 mm", positive), not_given,
         "Length L of the Sherwood number J L / (area D dc), which adds a column; dc is the fluid's mean "
         "concentration minus that of the wall."},
        {"area", wall_flux, &Measure::area, quantity("1 mm^2", positive), not_given,
         "Area of the wall, for the Sherwood number; in 2-D the wall is 1 m deep."},
        {"part", aggregate, &Measure::part, name(), required,
         "[[solidify]] or elastic part whose number of particles, mass, pieces, largest piece and bonds are "
         "measured."},
        {"part", displacement, &Measure::part, name(), required,
         "Elastic solid whose displacement from its initial position is measured: that of its centre of mass, or of a point."},
        {"part", body, &Measure::part, name(), required,
         "Elastic solid or [[solidify]] whose centre of mass, velocity, angle, length, and least and largest stretch are measured, "
         "as of one body (docs/results.md)."},
        {"part", solid_field, &Measure::part, name(), required, "Elastic solid whose field is measured."},
        {"part", {"contact"}, &Measure::part, name(), required,
         "Elastic solid whose contact is measured, where surfaces touch (contact.between). The columns are NAME_force_x and "
         "NAME_force_y, on this solid, NAME_area, in which it touches, and NAME_pressure, the largest there; 1 m deep."},
        {"against", {"contact"}, &Measure::against, name(), not_given,
         "The elastic or rigid part that it touches, which may be the same one; all by default."},
        {"point", displacement, &Measure::point, point(), not_given,
         "Initial position of the particle whose displacement is measured: the nearest one is taken."},
    };
}
// clang-format on

}  // namespace dmp::scene
