// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/join_keys.hpp"

#include "base/nearest_name.hpp"

namespace dmp::scene {

// Columns as in schema.cpp.
// clang-format off

std::vector<Key<Join>> join_keys() {
    return {
        {"name", &Join::name, name(), required, "Name of the join, also used by [[break]]."},
        {"parts", &Join::parts, two_names(), required,
         "Parts whose particles are bonded to each other: two elastic solids, an elastic solid and a rigid part at "
         "rest, or one elastic solid, named twice."},
        {"within", &Join::within, quantity("0.15 mm", positive), not_given,
         "Length of the longest bond; 1.5 spacings by default. No bond is made across a gap, where a particle of "
         "another part lies near its midpoint."},
        {"stiffness", &Join::stiffness, quantity_or_auto("10 N/m"), "auto",
         "Stiffness k_b of each bond, whose energy is k_b (r - r0)^2, with the initial distance r0. \"auto\": half "
         "a bond of each part in series."},
        {"damping", &Join::damping, number(between(0, 1)), "0.01",
         "Dashpot of each bond, as a fraction of critical damping."},
    };
}
// clang-format on

namespace {

/// The part called `name`; throws InputError unless bonds can join it.
const Part& joined_part(const Scene& scene, const Join& join, const std::string& name) {
    const std::string whose = "join '" + *join.name + "': ";
    const Part* part = scene.part_named(name);
    if (part == nullptr) {
        std::vector<std::string> names;
        for (const Part& each : scene.parts) names.push_back(*each.name);
        const auto nearest = nearest_name(name, names);
        throw InputError(join.parts.location, whose + "the scene has no part '" + name + "'",
                         nearest.empty() ? "its parts are " + quoted_list(names) : "did you mean '" + nearest + "'?");
    }
    if (*part->kind != PartKind::elastic && *part->kind != PartKind::rigid)
        throw InputError(join.parts.location,
                         whose + "part '" + name + "' is of kind '" + to_string(*part->kind) +
                             "'; bonds join elastic solids, or an elastic solid and a rigid part",
                         "name elastic solids, or an elastic solid and a rigid part");
    if (part->moves())
        throw InputError(join.parts.location,
                         whose + "part '" + name + "' moves; a rigid part with bonds must be at rest",
                         "name a part at rest, or make it an elastic solid");
    return *part;
}

}  // namespace

void check_joins(const Scene& scene) {
    for (const Join& join : scene.joins) {
        const Part& one = joined_part(scene, join, (*join.parts)[0]);
        const Part& other = joined_part(scene, join, (*join.parts)[1]);
        if (*one.kind == PartKind::rigid && *other.kind == PartKind::rigid)
            throw InputError(join.parts.location, "join '" + *join.name + "' joins two rigid parts, which do not move",
                             "name at least one elastic solid");
        if (const Part* same = scene.part_named(join.name))
            throw InputError(join.name.location,
                             "there is already a part called '" + *join.name + "', at " + same->name.location.text(),
                             "give the join a name of its own");
        for (const Solidify& rule : scene.solidify)
            if (*rule.name == *join.name)
                throw InputError(
                    join.name.location,
                    "there is already a [[solidify]] called '" + *join.name + "', at " + rule.name.location.text(),
                    "give the join a name of its own");
    }
}

}  // namespace dmp::scene
