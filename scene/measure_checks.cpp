// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/measure_checks.hpp"

#include <algorithm>
#include <vector>

#include "base/nearest_name.hpp"
#include "base/unlisted_value.hpp"
#include "scene/checks.hpp"
#include "scene/measure_subject.hpp"
#include "scene/solidify_checks.hpp"
#include "scene/sphere_checks.hpp"

namespace dmp::scene {

namespace {

void need_plane_point(const Value<Vec>& point) {
    if ((*point)[2] == 0) return;
    throw InputError(point.location, "the third coordinate of a point in a 2-D scene is not 0",
                     "leave it out, or write 0");
}

void check_region(const Scene& scene, const ResidenceRegion& region) {
    for (const auto* point : {&region.from, &region.to}) {
        if (scene.dimension == 2) need_plane_point(*point);
    }
    for (int axis = 0; axis < scene.dimension; ++axis) {
        if ((*region.from)[axis] != (*region.to)[axis]) continue;
        throw InputError(region.to.location,
                         "the corners of region '" + *region.name + "' have the same " + "xyz"[axis] +
                             ": there is nothing between them",
                         "give two opposite corners of a box");
    }
}

/// Residence times need a region.
void need_regions(const Scene& scene, const TomlNode& document) {
    const bool pictured = *scene.output.picture_field == FluidField::residence_time;
    if (pictured && scene.regions.size() > 1) {
        throw InputError(first_known(scene, {&scene.output.picture_field.location}),
                         "output.picture_field = \"residence_time\": there are several regions, each with its own "
                         "field",
                         "keep only one [[region]], or choose another field");
    }
    if (!scene.regions.empty() || !(pictured || scene.asks_for(FluidField::residence_time))) return;
    const SourceLocation* of_probe = nullptr;
    for (const Measure& measure : scene.measures) {
        if (reads_a_field(measure.kind) && *measure.field == FluidField::residence_time)
            of_probe = &measure.field.location;
    }
    throw InputError(
        first_known(scene, {of_probe, document.location_of("output.fields"), &scene.output.picture_field.location}),
        "'residence_time' needs a region, and the scene has none",
        "add a [[region]] with a name and the corners from and to");
}

/// A mode repeats with the periodic axes.
void check_waves(const Scene& scene, const Measure& measure) {
    for (std::size_t axis = 0; axis < 3; ++axis)
        if ((*measure.waves)[axis] != 0 && !*scene.flow.periodic[axis])
            throw InputError(
                measure.waves.location,
                "measure '" + *measure.name + "' has waves along " + "xyz"[axis] + ", which is not periodic",
                std::string("write 0 there, or add \"") + "xyz"[axis] + "\" to flow.periodic");
}

/// A field over a region has one number a particle.
void check_field(const Scene& scene, const Measure& measure) {
    const std::string whose = "measure '" + *measure.name + "'";
    need_region(scene, measure.region, "region of " + whose);
    if (*measure.field == FluidField::stress)
        throw InputError(measure.field.location,
                         whose + " of kind 'field': 'stress' has several components, which have no largest one",
                         "measure 'von_mises', 'shear_stress' or 'pressure'");
    if (measure.species.given() && *measure.field != FluidField::concentration)
        throw InputError(measure.species.location,
                         whose + " has a species, and '" + to_string(*measure.field) + "' is of the fluid",
                         "write field = \"concentration\", or leave species out");
    if (*measure.field == FluidField::residence_time && scene.regions.size() > 1 && measure.region->empty())
        throw InputError(measure.field.location,
                         whose + ": there are several regions, each with its own residence_time",
                         "add region, the name of one of them");
}

void check_solid_field(const Scene& scene, const Measure& measure) {
    const auto refuse = [&](const std::string& why, const std::string& advice) {
        throw InputError(
            measure.solid_field.location,
            "measure '" + *measure.name + "' of kind 'solid_field': '" + to_string(*measure.solid_field) + "' " + why,
            advice);
    };
    switch (*measure.solid_field) {
        case SolidField::stress:
            refuse("has several components, which have no largest one", "measure 'von_mises' or 'surface_stress'");
            return;
        case SolidField::principal_stretches:
            refuse("is two numbers a particle",
                   "a measure of kind 'body' has stretches; or add it to output.solid_fields");
            return;
        case SolidField::mean_displacement:
            refuse("is itself a mean over time",
                   "measure 'displacement', whose mean over time a study takes; or add it to output.solid_fields");
            return;
        case SolidField::strain:
        case SolidField::force:
            if (const Part* part = scene.part_named(measure.part); part != nullptr && scene.is_of_cells(*part))
                refuse("is of bonds, and '" + *measure.part + "' consists of cells",
                       "measure 'von_mises', or a 'body', which has stretches");
            return;
        case SolidField::traction:
            if (scene.parts_of(PartKind::fluid).empty())
                refuse("is what the fluid does to a solid, and no part is a fluid", "leave the measure out");
            return;
        case SolidField::velocity:
        case SolidField::displacement:
        case SolidField::von_mises:
        case SolidField::surface_stress:
            return;
    }
    unlisted_value(*measure.solid_field);
}

void check_contact(const Scene& scene, const Measure& measure) {
    if (measure.against->empty()) return;
    std::vector<std::string> solids;
    for (const Part& part : scene.parts)
        if (*part.kind == PartKind::elastic || *part.kind == PartKind::rigid) solids.push_back(part.name);
    if (std::ranges::find(solids, *measure.against) != solids.end()) return;
    const auto nearest = nearest_name(*measure.against, solids);
    throw InputError(
        measure.against.location,
        "measure '" + *measure.name + "': the scene has no elastic or rigid part '" + *measure.against + "'",
        nearest.empty() ? "its solids are " + quoted_list(solids) : "did you mean '" + nearest + "'?");
}

void check_measure(const Scene& scene, const Measure& measure) {
    for (const auto* point : {&measure.from, &measure.to, &measure.point}) {
        if (scene.dimension == 2) need_plane_point(*point);
    }
    if ((*measure.kind == MeasureKind::flux || *measure.kind == MeasureKind::line) && *measure.from == *measure.to) {
        throw InputError(measure.to.location,
                         "the line of measure '" + *measure.name + "' starts and ends at the same point",
                         "give two different points");
    }
    if (*measure.kind == MeasureKind::mode) check_waves(scene, measure);
    if (*measure.kind == MeasureKind::field) check_field(scene, measure);
    if (*measure.kind == MeasureKind::solid_field) check_solid_field(scene, measure);
    if (*measure.kind == MeasureKind::contact) check_contact(scene, measure);
    check_sphere_measure(scene, measure);
    if (*measure.kind == MeasureKind::aggregate) need_solid(scene, measure.part, "measure", *measure.name);
    if (!is_of_elastic_part(measure.kind)) return;
    std::vector<std::string> springs;
    for (const auto& part : scene.parts) {
        if (*part.kind == PartKind::elastic) springs.push_back(part.name);
    }
    if (*measure.kind == MeasureKind::body)
        for (const Solidify& rule : scene.solidify) springs.push_back(rule.name);
    if (std::find(springs.begin(), springs.end(), *measure.part) != springs.end()) return;
    const auto is_it = [&](const Solidify& rule) { return *rule.name == *measure.part; };
    if (std::ranges::any_of(scene.solidify, is_it))
        throw InputError(measure.part.location,
                         "'" + *measure.part + "' is a [[solidify]], and " + to_string(*measure.kind) +
                             " is measured of elastic parts",
                         "measure an 'aggregate' or a 'body', which may be of what has turned solid");
    const auto nearest = nearest_name(*measure.part, springs);
    const Part* other = scene.part_named(measure.part);
    const std::string what = other == nullptr ? "the scene has no part '" + *measure.part + "'"
                                              : "part '" + *measure.part + "' is of kind '" + to_string(*other->kind) +
                                                    "', expected 'elastic'";
    throw InputError(measure.part.location, what,
                     nearest.empty() ? to_string(*measure.kind) + " is measured of elastic solids; the scene has " +
                                           quoted_list(springs)
                                     : "did you mean '" + nearest + "'?");
}

}  // namespace

void need_region(const Scene& scene, const Value<std::string>& region, const std::string& what) {
    if (region->empty()) return;
    std::vector<std::string> names;
    for (const ResidenceRegion& each : scene.regions) names.push_back(*each.name);
    if (std::ranges::find(names, *region) != names.end()) return;
    const auto nearest = nearest_name(*region, names);
    throw InputError(region.location, what + ": the scene has no region '" + *region + "'",
                     names.empty()     ? "add a [[region]] with that name and the corners from and to"
                     : nearest.empty() ? "its regions are " + quoted_list(names)
                                       : "did you mean '" + nearest + "'?");
}

void check_regions(const Scene& scene, const TomlNode& document) {
    need_regions(scene, document);
    for (const ResidenceRegion& region : scene.regions) check_region(scene, region);
}

void check_measures(const Scene& scene) {
    for (const Measure& measure : scene.measures) check_measure(scene, measure);
}

}  // namespace dmp::scene
