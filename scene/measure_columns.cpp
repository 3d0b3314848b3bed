// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/measure_columns.hpp"

#include <numeric>
#include <utility>

#include "base/errors.hpp"
#include "base/nearest_name.hpp"
#include "base/unlisted_value.hpp"

namespace dmp::scene {

namespace {

using Columns = std::vector<MeasureColumn>;

std::string field_unit(const Scene& scene, FluidField field, std::size_t column) {
    switch (field) {
        case FluidField::velocity:
            return "m/s";
        case FluidField::density:
            return "kg/m^3";
        case FluidField::vorticity:
            return "1/s";
        case FluidField::residence_time:
            return "s";
        case FluidField::concentration:  // each species has its own
            return scene.species[column].concentration_unit();
        case FluidField::pressure:
        case FluidField::shear_stress:
        case FluidField::stress:
        case FluidField::von_mises:
            return "Pa";
    }
    unlisted_value(field);
}

/// Endings of the names of a field's columns; one that is empty where there is one column.
std::vector<std::string> field_endings(const Scene& scene, FluidField field) {
    std::vector<std::string> endings;
    const int dimension = scene.dimension;
    const bool vector = field == FluidField::velocity || (field == FluidField::vorticity && dimension == 3);
    if (vector)
        for (const std::size_t c : probed_components(3, dimension))
            endings.push_back("_" + std::string(vector_components.at(c)));
    if (field == FluidField::stress)
        for (const std::size_t c : probed_components(6, dimension))
            endings.push_back("_" + std::string(tensor_components.at(c)));
    if (field == FluidField::residence_time && scene.regions.size() > 1)
        for (const ResidenceRegion& region : scene.regions) endings.push_back("_" + *region.name);
    if (field == FluidField::concentration && scene.species.size() > 1)
        for (const Species& species : scene.species) endings.push_back("_" + *species.name);
    if (endings.empty()) endings.emplace_back();
    return endings;
}

/// Of a field at one point.
Columns field_columns(const Scene& scene, FluidField field, const std::string& name) {
    Columns columns;
    for (const std::string& ending : field_endings(scene, field))
        columns.push_back({name + ending, field_unit(scene, field, columns.size())});
    return columns;
}

Columns three(const std::string& name, const char* unit) {
    Columns columns;
    for (const char* component : vector_components) columns.push_back({name + "_" + component, unit});
    return columns;
}

const Species& species_of(const Scene& scene, const Measure& measure) {
    return scene.species[scene.species_of(measure)];
}

std::string fluid_field_unit(const Scene& scene, const Measure& measure) {
    return *measure.field == FluidField::concentration ? species_of(scene, measure).concentration_unit()
                                                       : field_unit(scene, measure.field, 0);
}

std::string unit_of(SolidField field) {
    switch (field) {
        case SolidField::velocity:
            return "m/s";
        case SolidField::displacement:
        case SolidField::mean_displacement:
            return "m";
        case SolidField::stress:
        case SolidField::von_mises:
        case SolidField::surface_stress:
        case SolidField::traction:
            return "Pa";
        case SolidField::force:
            return "N";
        case SolidField::strain:
        case SolidField::principal_stretches:
            return "1";
    }
    unlisted_value(field);
}

/// Of a field in a region or a solid, with the place of the highest value.
Columns mean_and_extremes(const Scene& scene, const std::string& name, const std::string& unit) {
    Columns columns{{name + "_mean", unit}, {name + "_low", unit}, {name + "_high", unit}};
    for (const std::size_t c : probed_components(3, *scene.dimension))
        columns.push_back({name + "_high_" + std::string(vector_components.at(c)), "m"});
    return columns;
}

/// What was taken by now, over time and in all.
Columns rate_and_total(const Scene& scene, const Measure& measure) {
    const std::string &name = measure.name, unit = species_of(scene, measure).amount_unit();
    return {{name, unit + "/s"}, {name + "_total", unit}};
}

}  // namespace

std::vector<std::size_t> probed_components(int components, int dimension) {
    if (components == 3 && dimension == 2) return {0, 1};
    if (components == 6 && dimension == 2) return {0, 1, 2, 3};
    std::vector<std::size_t> all(static_cast<std::size_t>(components));
    std::iota(all.begin(), all.end(), std::size_t{0});
    return all;
}

const Measure& measure_called(const Scene& scene, const Value<std::string>& name) {
    std::vector<std::string> names;
    for (const Measure& measure : scene.measures) {
        if (*measure.name == *name) return measure;
        names.push_back(*measure.name);
    }
    const std::string nearest = nearest_name(*name, names);
    throw InputError(name.location, "the scene has no measure '" + *name + "'",
                     names.empty()     ? "it has none at all: add [[measure]] to " + scene.file
                     : nearest.empty() ? "its measures are " + quoted_list(names)
                                       : "did you mean '" + nearest + "'?");
}

std::vector<MeasureColumn> measure_columns(const Scene& scene, const Measure& measure) {
    const std::string& name = measure.name;
    Columns columns;
    switch (*measure.kind) {
        case MeasureKind::flux:
            return {{name, "m^3/s"}};
        case MeasureKind::gap:
            return {{name, "m"}};
        case MeasureKind::largest_speed:
            return {{name, "m/s"}};
        case MeasureKind::kinetic_energy:
            return {{name, "J"}};
        case MeasureKind::density:
            return {{name + "_low", "1"}, {name + "_high", "1"}};
        case MeasureKind::probe:
            return field_columns(scene, measure.field, name);
        case MeasureKind::line:
            for (int k = 1; k <= *measure.points; ++k)
                for (MeasureColumn& each : field_columns(scene, measure.field, name + "_" + std::to_string(k)))
                    columns.push_back(std::move(each));
            return columns;
        case MeasureKind::mode:
            for (const MeasureColumn& each : field_columns(scene, measure.field, name))
                for (const char* factor : {"_cos", "_sin"}) columns.push_back({each.name + factor, each.unit});
            return columns;
        case MeasureKind::amount:
            return {{name, species_of(scene, measure).amount_unit()}};
        case MeasureKind::mean_concentration:
            return {{name, species_of(scene, measure).concentration_unit()}};
        case MeasureKind::profile:
            for (int bin = 1; bin <= *measure.bins; ++bin)
                columns.push_back({name + "_" + std::to_string(bin), species_of(scene, measure).concentration_unit()});
            return columns;
        case MeasureKind::spread:
            return {{name, "m^2"}, {name + "_diffusivity", "m^2/s"}, {name + "_sherwood", "1"}};
        case MeasureKind::wall_flux:
            columns = rate_and_total(scene, measure);
            if (measure.length.given()) columns.push_back({name + "_sherwood", "1"});
            return columns;
        case MeasureKind::uptake:
            return rate_and_total(scene, measure);
        case MeasureKind::peclet:
            return {{name, "1"}};
        case MeasureKind::displacement:
            for (const std::size_t c : probed_components(3, *scene.dimension))
                columns.push_back({name + "_" + std::string(vector_components.at(c)), "m"});
            return columns;
        case MeasureKind::body:
            for (const auto& [what, unit] : {std::pair("", "m"), std::pair("_velocity", "m/s")})
                for (const std::size_t c : probed_components(3, *scene.dimension))
                    columns.push_back({name + what + "_" + std::string(vector_components.at(c)), unit});
            columns.push_back({name + "_angle", "rad"});
            columns.push_back({name + "_length", "m"});
            columns.push_back({name + "_least_stretch", "1"});
            columns.push_back({name + "_largest_stretch", "1"});
            return columns;
        case MeasureKind::field:
            return mean_and_extremes(scene, name, fluid_field_unit(scene, measure));
        case MeasureKind::solid_field:
            return mean_and_extremes(scene, name, unit_of(*measure.solid_field));
        case MeasureKind::contact:
            for (const std::size_t c : probed_components(3, *scene.dimension))
                columns.push_back({name + "_force_" + std::string(vector_components.at(c)), "N"});
            columns.push_back({name + "_area", "m^2"});
            columns.push_back({name + "_pressure", "Pa"});
            return columns;
        case MeasureKind::velocity:
            return three(name, "m/s");
        case MeasureKind::spin:
            return three(name, "rad/s");
        case MeasureKind::wall_force:
            return three(name, "N");
        case MeasureKind::detached:
            return {{name, "1"}, {name + "_upper", "1"}, {name + "_lower", "1"}};
        case MeasureKind::aggregate:
            return {{name + "_particles", "1"}, {name + "_mass", "kg"},      {name + "_pieces", "1"},
                    {name + "_largest", "1"},   {name + "_bonds_made", "1"}, {name + "_bonds_broken", "1"}};
    }
    unlisted_value(*measure.kind);
}

}  // namespace dmp::scene
