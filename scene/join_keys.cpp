// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/join_keys.hpp"

#include "base/nearest_name.hpp"

namespace dmp::scene {

// Columns as in schema.cpp.
// clang-format off

std::vector<Key<Join>> join_keys() {
    return {
        {"name", &Join::name, name(), required, "What the join is called, in [[break]] too."},
        {"parts", &Join::parts, two_names(), required,
         "Which particles are bonded to which: those of two elastic solids, of an elastic solid and a rigid one that rests, or of one elastic solid, named twice."},
        {"within", &Join::within, quantity("0.15 mm", positive), not_given,
         "Longest bond; without it 1.5 spacings. None is made across a gap: where a particle of another part stands in its middle."},
        {"stiffness", &Join::stiffness, quantity_or_auto("10 N/m"), "auto",
         "k_b of each bond, of energy k_b (r - r0)^2, with r0 the distance as drawn; \"auto\": of half a bond of each part, one behind the other."},
        {"damping", &Join::damping, number(between(0, 1)), "0.01",
         "Dashpot along each bond, as a fraction of critical damping."},
    };
}
// clang-format on

namespace {

/// The part, which must be one that bonds can hold on to.
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
                             "', and bonds join springs, or springs and a wall",
                         "name elastic solids, or an elastic solid and a rigid one");
    if (part->moves())
        throw InputError(join.parts.location,
                         whose + "part '" + name + "' moves, and bonds to walls hold at places that stay",
                         "take a part that rests, or make it of springs");
    return *part;
}

}  // namespace

void check_joins(const Scene& scene) {
    for (const Join& join : scene.joins) {
        const Part& one = joined_part(scene, join, (*join.parts)[0]);
        const Part& other = joined_part(scene, join, (*join.parts)[1]);
        if (*one.kind == PartKind::rigid && *other.kind == PartKind::rigid)
            throw InputError(join.parts.location,
                             "join '" + *join.name + "' is of two rigid parts, and neither of them moves",
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
