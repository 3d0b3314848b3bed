// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/solidify_checks.hpp"

#include <algorithm>

#include "base/nearest_name.hpp"
#include "scene/measure_checks.hpp"

namespace dmp::scene {

namespace {

bool is_one_of(const std::string& name, const std::vector<std::string>& names) {
    return std::ranges::find(names, name) != names.end();
}

/// Throws the error for a name of a missing, disabled or wrong part.
[[noreturn]] void refuse_name(const Scene& scene, const Value<std::string>& name, const std::string& key,
                              const std::string& whose, const std::string& expected,
                              const std::vector<std::string>& names) {
    const Part* part = scene.part_named(name);
    std::string problem = key + " of " + whose + ": ";
    if (part == nullptr)
        problem += "the scene has no '" + *name + "'";
    else if (!*part->enabled)
        problem += "part '" + *name + "' is not enabled";
    else
        problem += "part '" + *name + "' is of kind '" + to_string(*part->kind) + "', expected " + expected;
    const auto nearest = nearest_name(*name, names);
    throw InputError(name.location, problem,
                     names.empty()     ? "add one"
                     : nearest.empty() ? "the scene has " + quoted_list(names)
                                       : "did you mean '" + nearest + "'?");
}

std::string named(const Solidify& rule) { return "solidify '" + *rule.name + "'"; }

void check_liquid(const Scene& scene, const Solidify& rule) {
    const auto liquids = scene.names_of_parts(PartKind::fluid);
    if (!is_one_of(*rule.liquid, liquids))
        refuse_name(scene, rule.liquid, "liquid", named(rule), "a fluid part", liquids);
    if (const Part* same = scene.part_named(rule.name))
        throw InputError(rule.name.location,
                         "there is already a part called '" + *rule.name + "', at " + same->name.location.text(),
                         "give the [[solidify]] a name of its own");
}

void check_region_name(const Scene& scene, const Solidify& rule, const Value<std::string>& region,
                       const std::string& key, const Value<double>& residence, const std::string& residence_key) {
    if (residence.given() && !region.given())
        throw InputError(residence.location,
                         residence_key + " of " + named(rule) + " is a time in a region, and there is no " + key,
                         "add " + key + ", the name of a [[region]]");
    need_region(scene, region, key + " of " + named(rule));
}

void check_seeds(const Scene& scene, const Solidify& rule) {
    const bool of_liquid =
        rule.seed_region.given() || rule.seed_stress_above.given() || rule.seed_residence_above.given();
    if (!rule.seed_part.given()) {
        if (of_liquid) return;
        throw InputError(rule.name.location, named(rule) + " has no seeds: nothing would solidify",
                         "add seed_part, seed_region or seed_stress_above");
    }
    if (of_liquid)
        throw InputError(rule.seed_part.location, named(rule) + " has both a seed_part and fluid seeds",
                         "leave out seed_part, or write a [[solidify]] for each");
    auto solids = scene.names_of_parts(PartKind::rigid);
    for (const auto& name : scene.names_of_parts(PartKind::elastic)) solids.push_back(name);
    if (!is_one_of(*rule.seed_part, solids))
        refuse_name(scene, rule.seed_part, "seed_part", named(rule), "a rigid or elastic solid", solids);
    for (const Part* wall : scene.parts_of(PartKind::rigid))
        if (*wall->name == *rule.seed_part && wall->moves())
            throw InputError(rule.seed_part.location,
                             "seed_part of " + named(rule) + ": part '" + *wall->name +
                                 "' moves; a rigid part with bonds must be at rest",
                             "name a part at rest, or an elastic solid");
}

void check_activity(const Solidify& rule) {
    const bool one_in = *rule.active == SeedActivity::one_in;
    if (one_in && !rule.one_in.given())
        throw InputError(rule.active.location, named(rule) + ": active = \"one_in\" needs the number one_in",
                         "add one_in = 10, for example");
    if (!one_in && rule.one_in.given())
        throw InputError(
            rule.one_in.location,
            named(rule) + ": one_in needs active = \"one_in\", and active is \"" + to_string(*rule.active) + "\"",
            "write active = \"one_in\", or leave one_in out");
}

void check_times(const Solidify& rule) {
    if (*rule.until > 0 && !(*rule.until > *rule.from))
        throw InputError(rule.until.location,
                         named(rule) + ": until is not after from, its first event: nothing would turn solid",
                         "end later, or leave until out");
}

void check_breaking(const Scene& scene, const Breaking& rule) {
    const auto is_it = [&](const Join& join) { return *join.name == *rule.part; };
    if (std::ranges::none_of(scene.joins, is_it)) need_solid(scene, rule.part, "break", *rule.name);
    const std::string named = "break '" + *rule.name + "'";
    const Part* part = scene.part_named(*rule.part);
    const bool of_cells = part != nullptr && scene.is_of_cells(*part);
    const Value<double>&fits = of_cells ? rule.stress_above : rule.force_above,
          &does_not = of_cells ? rule.force_above : rule.stress_above;
    const std::string limits = of_cells ? "stress_above or strain_above" : "force_above or strain_above";
    if (does_not.given())
        throw InputError(
            does_not.location,
            named + (of_cells ? ": force_above is for bonds, and '" + *rule.part + "' consists of cells"
                              : ": stress_above is for solids of cells, and '" + *rule.part + "' consists of bonds"),
            "give " + limits);
    if (fits.given() == rule.strain_above.given())
        throw InputError(fits.given() ? rule.strain_above.location : rule.name.location,
                         named + " has " + (fits.given() ? "two limits" : "no limit: nothing would ever break"),
                         "give " + limits);
}

}  // namespace

void need_solid(const Scene& scene, const Value<std::string>& name, const std::string& what, const std::string& whose) {
    auto solids = scene.names_of_parts(PartKind::elastic);
    for (const Solidify& rule : scene.solidify) solids.push_back(*rule.name);
    if (!is_one_of(*name, solids))
        refuse_name(scene, name, "part", what + " '" + whose + "'", "an elastic solid or a [[solidify]]", solids);
}

void check_solidify(const Scene& scene) {
    for (const Solidify& rule : scene.solidify) {
        check_liquid(scene, rule);
        check_seeds(scene, rule);
        check_region_name(scene, rule, rule.seed_region, "seed_region", rule.seed_residence_above,
                          "seed_residence_above");
        check_region_name(scene, rule, rule.region, "region", rule.residence_above, "residence_above");
        check_activity(rule);
        check_times(rule);
        if (!scene.flow.symmetry->empty())
            throw InputError(rule.name.location, named(rule) + ": solids cannot be mirrored at planes of symmetry",
                             "leave out flow.symmetry, and model both sides");
    }
    if (!scene.solidify.empty() && !scene.species.empty())
        throw InputError(scene.solidify.front().name.location,
                         named(scene.solidify.front()) +
                             ": the scene has [[species]], which would be lost from fluid that solidifies",
                         "species in aggregates are not supported yet: leave out [[solidify]] or [[species]]");
    for (const Breaking& rule : scene.breaking) check_breaking(scene, rule);
    if (!scene.changes_bodies()) return;
    for (const SolidField field : {SolidField::mean_displacement, SolidField::traction})
        if (scene.asks_for(field))
            throw InputError(
                scene.solidify.empty() ? scene.breaking.front().name.location : scene.solidify.front().name.location,
                "output.solid_fields or a measure asks for " + to_string(field) +
                    ", which is not available with [[solidify]] or [[break]]",
                "leave " + to_string(field) + " out");
}

}  // namespace dmp::scene
