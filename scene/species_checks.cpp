// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/species_checks.hpp"

#include <algorithm>

#include "base/nearest_name.hpp"
#include "scene/measure_subject.hpp"

namespace dmp::scene {

namespace {

SourceLocation location_in(const Scene& scene, const SourceLocation& location) {
    return location.known() ? location : SourceLocation{scene.file, 0, 0};
}

std::string named(const Species& species) { return "species '" + *species.name + "'"; }

/// The part of a table's entry, enabled or not; throws InputError if there is none.
const Part& known_part(const Scene& scene, const std::string& table, const std::string& name,
                       const SourceLocation& location) {
    if (const Part* part = scene.part_named(name)) return *part;
    std::vector<std::string> names;
    for (const Part& part : scene.parts) names.push_back(*part.name);
    const std::string nearest = nearest_name(name, names);
    throw InputError(location, table + ": the scene has no part '" + name + "'",
                     nearest.empty() ? "its parts are " + quoted_list(names) : "did you mean '" + nearest + "'?");
}

void need_no_time(const std::string& key, const Value<Expression>& formula) {
    if (!formula->depends_on_time()) return;
    throw InputError(formula.location, key + " depends on t: \"" + formula->text() + "\"",
                     "write a formula of x, y and z: initial values do not depend on time");
}

void check_diffusivity(const Scene& scene, const Species& species) {
    const std::string table = named(species) + ", diffusivity";
    for (const auto& [name, value] : species.diffusivity.parts) (void)known_part(scene, table, name, value.location);
    for (const Part* fluid : scene.parts_of(PartKind::fluid))
        if (species.diffusivity.of(*fluid->name) == nullptr)
            throw InputError(species.name.location, table + ": the fluid '" + *fluid->name + "' is missing",
                             "add its diffusivity; 0 if the species only moves with the fluid");
}

/// Throws InputError if a part of a table does not carry the species.
void need_carrier(const Scene& scene, const Species& species, const std::string& table, const std::string& name,
                  const SourceLocation& location) {
    const Part& part = known_part(scene, table, name, location);
    if (species.diffusivity_in(part) != nullptr) return;
    throw InputError(location,
                     table + ": the part '" + name + "' of kind '" + to_string(*part.kind) +
                         "' does not carry the species, because it has no diffusivity",
                     "add it to the species' diffusivity, or leave it out here");
}

void check_start(const Scene& scene, const Species& species) {
    const std::string table = named(species) + ", concentration";
    if (species.concentration.all) need_no_time(table, *species.concentration.all);
    for (const auto& [name, value] : species.concentration.parts) {
        need_no_time(table, value);
        need_carrier(scene, species, table, name, value.location);
    }
}

void check_uptake(const Scene& scene, const Species& species) {
    for (const auto& [name, value] : species.uptake.parts)
        need_carrier(scene, species, named(species) + ", uptake", name, value.location);
}

/// Surfaces with a fixed concentration or flux must be named, of one of these kinds and not conducting.
void check_surfaces(const Scene& scene, const Species& species, const ByPart<Expression>& surfaces,
                    const std::string& key, const std::vector<PartKind>& kinds) {
    const std::string table = named(species) + ", " + key;
    std::string words, quoted;
    for (const PartKind kind : kinds) {
        words += (words.empty() ? "" : " or ") + to_string(kind);
        quoted += (quoted.empty() ? "'" : " or '") + to_string(kind) + "'";
    }
    if (surfaces.all)
        throw InputError(surfaces.all->location, table + ": one value for all parts is not allowed",
                         "write a table of " + words + " parts, " + key + " = { wall = ... }");
    for (const auto& [name, value] : surfaces.parts) {
        const Part& part = known_part(scene, table, name, value.location);
        if (std::ranges::find(kinds, *part.kind) == kinds.end())
            throw InputError(value.location,
                             table + ": '" + name + "' is of kind '" + to_string(*part.kind) + "', expected " + quoted,
                             "name " + words + " parts only");
        if (species.diffusivity_in(part) != nullptr)
            throw InputError(value.location,
                             table + ": '" + name + "' conducts the species, because it has a diffusivity",
                             "leave it out of one of the two");
    }
}

void check_one(const Scene& scene, const Species& species) {
    if (scene.parts_of(PartKind::fluid).empty())
        throw InputError(species.name.location, named(species) + ": there is no fluid to dissolve it",
                         "add a [[part]] with kind = \"fluid\", or leave the species out");
    check_diffusivity(scene, species);
    check_start(scene, species);
    check_uptake(scene, species);
    check_surfaces(scene, species, species.wall_concentration, "wall_concentration",
                   {PartKind::rigid, PartKind::elastic});
    check_surfaces(scene, species, species.wall_flux, "wall_flux", {PartKind::rigid});
    for (const auto& [name, value] : species.wall_flux.parts)
        if (species.wall_concentration.parts.contains(name))
            throw InputError(value.location,
                             named(species) + ": '" + name + "' has a wall_concentration and a wall_flux",
                             "leave out one of them");
}

std::vector<std::string> names_of(const std::vector<Species>& all) {
    std::vector<std::string> names;
    for (const Species& species : all) names.push_back(*species.name);
    return names;
}

void need_species(const Scene& scene, const Measure& measure) {
    const std::string what = "measure '" + *measure.name + "'";
    const auto names = names_of(scene.species);
    if (names.empty())
        throw InputError(measure.kind.location, what + " is about a species, and the scene has none",
                         "add a [[species]], or leave the measure out");
    if (measure.species->empty() && names.size() > 1)
        throw InputError(measure.name.location, what + " does not name its species",
                         "write species = one of " + quoted_list(names));
    if (measure.species->empty() || std::ranges::find(names, *measure.species) != names.end()) return;
    const std::string nearest = nearest_name(*measure.species, names);
    throw InputError(measure.species.location, what + ": the scene has no species '" + *measure.species + "'",
                     nearest.empty() ? "it has " + quoted_list(names) : "did you mean '" + nearest + "'?");
}

void check_box(const Scene& scene, const Measure& measure) {
    if (measure.from.given() != measure.to.given())
        throw InputError(measure.from.given() ? measure.from.location : measure.to.location,
                         "measure '" + *measure.name + "' has one corner of a box",
                         "give both from and to, or neither");
    if (!measure.from.given()) return;
    for (int axis = 0; axis < scene.dimension; ++axis)
        if ((*measure.from)[axis] == (*measure.to)[axis])
            throw InputError(measure.to.location,
                             "the corners of measure '" + *measure.name + "' have the same " + "xyz"[axis] +
                                 ": there is nothing between them",
                             "give two opposite corners of a box");
}

void check_wall_flux(const Scene& scene, const Measure& measure) {
    const Species& species = scene.species[scene.species_of(measure)];
    if (!species.wall_concentration.parts.contains(*measure.part)) {
        std::vector<std::string> held;
        for (const auto& [name, value] : species.wall_concentration.parts) held.push_back(name);
        throw InputError(
            measure.part.location,
            "measure '" + *measure.name + "': '" + *measure.part + "' is not a part at which " + named(species) +
                " has a fixed concentration",
            held.empty() ? "add the part to the species' wall_concentration" : "such parts are " + quoted_list(held));
    }
    if (measure.length.given() != measure.area.given())
        throw InputError(measure.length.given() ? measure.length.location : measure.area.location,
                         "measure '" + *measure.name + "': a Sherwood number needs a length and an area",
                         "give both, or neither");
}

void check_uptake_measure(const Scene& scene, const Measure& measure) {
    const Species& species = scene.species[scene.species_of(measure)];
    std::vector<std::string> takers;
    for (const Part* part : scene.takers_of(species)) takers.push_back(*part->name);
    const std::string what = "measure '" + *measure.name + "': ";
    if (takers.empty())
        throw InputError(measure.kind.location, what + "nothing takes up " + named(species),
                         "give the species an uptake, or leave the measure out");
    if (measure.part->empty() || std::ranges::find(takers, *measure.part) != takers.end()) return;
    throw InputError(measure.part.location, what + "'" + *measure.part + "' does not take up " + named(species),
                     "what does is " + quoted_list(takers) + "; leave part out for all of it");
}

void check_species_measure(const Scene& scene, const Measure& measure) {
    using enum MeasureKind;
    if (reads_a_field(measure.kind) && *measure.field == FluidField::concentration && scene.species.empty())
        throw InputError(measure.field.location,
                         "the " + to_string(*measure.kind) + " '" + *measure.name +
                             "' reads a concentration, and the scene has no species",
                         "add a [[species]], or read another field");
    if (*measure.kind == field && *measure.field == FluidField::concentration) need_species(scene, measure);
    if (!is_of_species(*measure.kind)) return;
    need_species(scene, measure);
    if (*measure.kind == wall_flux) check_wall_flux(scene, measure);
    if (*measure.kind == uptake) check_uptake_measure(scene, measure);
    check_box(scene, measure);
    if (scene.dimension == 2 && *measure.axis == Axis::z)
        throw InputError(measure.axis.location, "measure '" + *measure.name + "': a scene in 2-D has no axis 'z'",
                         "take x or y");
}

void check_output(const Scene& scene) {
    const bool pictured = *scene.output.picture_field == FluidField::concentration;
    if (pictured && scene.species.size() > 1)
        throw InputError(location_in(scene, scene.output.picture_field.location),
                         "output.picture_field = \"concentration\": there are several species, each with its own field",
                         "keep only one [[species]], or choose another field");
    const bool listed = std::ranges::find(scene.output.fields, FluidField::concentration) != scene.output.fields.end();
    if (scene.species.empty() && (pictured || listed))
        throw InputError(location_in(scene, scene.output.picture_field.location),
                         "'concentration' needs a species, and the scene has none",
                         "add a [[species]], or leave the field out");
}

}  // namespace

void check_species(const Scene& scene) {
    for (const Species& species : scene.species) check_one(scene, species);
    for (const Measure& measure : scene.measures) check_species_measure(scene, measure);
    check_output(scene);
}

}  // namespace dmp::scene
