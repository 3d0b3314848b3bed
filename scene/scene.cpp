// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/scene.hpp"

#include <algorithm>
#include <stdexcept>

#include "base/unlisted_value.hpp"
#include "scene/measure_subject.hpp"

namespace dmp::scene {

bool Part::slides() const { return !std::ranges::all_of(surface_velocity.value, &Expression::is_zero); }

bool Part::moves() const { return !spin->is_zero() || !std::ranges::all_of(velocity.value, &Expression::is_zero); }

std::string Species::amount_unit() const {
    return *unit == SpeciesUnit::mass ? "kg" : *unit == SpeciesUnit::moles ? "mol" : "m^3";
}

std::string Species::concentration_unit() const { return to_string(*unit); }

const Value<double>* Species::diffusivity_in(const Part& part) const {
    // A single diffusivity applies to all fluids; solids conduct only if they are named.
    if (*part.kind != PartKind::fluid && !diffusivity.parts.contains(*part.name)) return nullptr;
    return diffusivity.of(*part.name);
}

const Value<double>* Species::uptake_in(const Part& part) const {
    const Value<double>* rate = diffusivity_in(part) != nullptr ? uptake.of(*part.name) : nullptr;
    return rate != nullptr && **rate > 0 ? rate : nullptr;
}

std::size_t Scene::species_of(const Measure& measure) const {
    if (measure.species->empty() && species.size() == 1) return 0;
    for (std::size_t s = 0; s < species.size(); ++s)
        if (*species[s].name == *measure.species) return s;
    throw std::out_of_range("no species '" + *measure.species + "'");
}

std::vector<const Part*> Scene::takers_of(const Species& of) const {
    std::vector<const Part*> found;
    for (const Part& part : parts)
        if (*part.enabled && of.uptake_in(part) != nullptr) found.push_back(&part);
    return found;
}

std::vector<const Join*> Scene::joins_of_enabled() const {
    const auto is_enabled = [this](const std::string& name) {
        const Part* part = part_named(name);
        return part != nullptr && *part->enabled;
    };
    std::vector<const Join*> found;
    for (const Join& join : joins)
        if (std::ranges::all_of(*join.parts, is_enabled)) found.push_back(&join);
    return found;
}

bool Scene::is_of_cells(const Part& part) const {
    if (*part.kind != PartKind::elastic) return false;
    switch (*part.model) {
        case ElasticModel::springs:
            return false;
        case ElasticModel::cells:
            return !part.bonds_within.given() && (dimension == 2 ? part.density.given() : !part.thickness.given());
    }
    unlisted_value(*part.model);
}

const Part* Scene::part_named(const std::string& name) const {
    const auto found = std::ranges::find_if(parts, [&](const Part& part) { return *part.name == name; });
    return found == parts.end() ? nullptr : &*found;
}

const Part& Scene::part_of_particles(const std::string& name) const {
    if (const Part* part = part_named(name)) return *part;
    throw InputError("the particles have a part '" + name + "' that is not in the scene", "mesh the scene again");
}

std::vector<const Part*> Scene::parts_of(PartKind kind) const {
    std::vector<const Part*> found;
    for (const auto& part : parts) {
        if (*part.kind == kind && *part.enabled) found.push_back(&part);
    }
    return found;
}

std::vector<std::string> Scene::names_of_parts(PartKind kind) const {
    const std::vector<const Part*> found = parts_of(kind);
    std::vector<std::string> names;
    names.reserve(found.size());
    for (const Part* part : found) names.push_back(part->name);
    return names;
}

const ContactPair* Scene::contact_between(const std::string& a, const std::string& b) const {
    const ContactPair* best = nullptr;
    int best_rank = -1;
    const auto rank = [&](const std::string& first, const std::string& second) {
        const auto fits = [](const std::string& named, const std::string& part) {
            return named == part ? 1 : named == "any" ? 0 : -3;
        };
        return fits(first, a) + fits(second, b);
    };
    for (const ContactPair& pair : contact_pairs) {
        const auto& [first, second] = *pair.parts;
        const int found = std::max(rank(first, second), rank(second, first));
        if (found >= 0 && found >= best_rank) {
            best = &pair;
            best_rank = found;
        }
    }
    return best;
}

bool Scene::asks_for(FluidField field) const {
    const auto probes_it = [&](const Measure& measure) {
        return reads_a_field(measure.kind) && *measure.field == field;
    };
    const auto waits_for_it = [&](const Solidify& rule) {
        return field == FluidField::residence_time && (*rule.seed_residence_above > 0 || *rule.residence_above > 0);
    };
    return std::find(output.fields.begin(), output.fields.end(), field) != output.fields.end() ||
           std::any_of(measures.begin(), measures.end(), probes_it) ||
           std::any_of(solidify.begin(), solidify.end(), waits_for_it);
}

bool Scene::asks_for(SolidField field) const {
    const auto measures_it = [&](const Measure& measure) {
        return *measure.kind == MeasureKind::solid_field && *measure.solid_field == field;
    };
    return std::ranges::find(output.solid_fields, field) != output.solid_fields.end() ||
           std::ranges::any_of(measures, measures_it);
}

}  // namespace dmp::scene
