// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/solidify_keys.hpp"

namespace dmp::scene {

// Columns as in schema.cpp.
// clang-format off

std::vector<Key<Solidify>> solidify_keys() {
    return {
        {"name", &Solidify::name, name(), required, "What the solid is called that comes into being."},
        {"liquid", &Solidify::liquid, name(), required, "The fluid part whose particles turn solid."},
        {"seed_part", &Solidify::seed_part, name(), not_given,
         "A rigid or elastic solid, whose particles are the first seeds; or give one of the other seed keys."},
        {"seed_region", &Solidify::seed_region, name(), not_given,
         "A region, in which liquid turns into seeds: once, at the first event, or whenever the next two keys say so."},
        {"seed_stress_above", &Solidify::seed_stress_above, quantity("2 Pa", positive), not_given,
         "Liquid under more shear stress turns into a seed, at every event."},
        {"seed_residence_above", &Solidify::seed_residence_above, quantity("1 s", positive), not_given,
         "Liquid that has been in seed_region for longer turns into a seed, at every event."},
        {"region", &Solidify::region, name(), not_given, "A region; only liquid in it turns solid near a seed."},
        {"stress_above", &Solidify::stress_above, quantity("2 Pa", positive), not_given,
         "Only liquid under more shear stress turns solid near a seed."},
        {"residence_above", &Solidify::residence_above, quantity("1 s", positive), not_given,
         "Only liquid that has been in the region for longer turns solid near a seed."},
        {"rule", &Solidify::rule, one_of<SolidifyRule>(), "per_candidate",
         "What a random trial is made for: each pair of a seed and liquid within reach, each liquid particle within reach of "
         "a seed, or pairs that are each other's nearest."},
        {"reach", &Solidify::reach, quantity("0.12 mm", positive), required,
         "R_max, distance from a seed within which liquid may turn solid; neighbours are about a spacing away."},
        {"probability", &Solidify::probability, number(fraction), required, "With which the rule binds, in one event."},
        {"from", &Solidify::from, quantity("0.5 s", not_negative), "0 s", "When the first event is."},
        {"interval", &Solidify::interval, quantity("10 ms", positive), required, "Time between events."},
        {"active", &Solidify::active, one_of<SeedActivity>(), "always",
         "When a seed acts: in every event, in its first one only, or in one of one_in events."},
        {"one_in", &Solidify::one_in, integer(at_least(1)), not_given, "N, with active = \"one_in\"."},
        {"spreads", &Solidify::spreads, boolean(), "true", "Whether what turned solid is a seed from the next event on."},
        {"most_bonds", &Solidify::most_bonds, integer(at_least(1)), not_given,
         "Bonds that one particle may be given; without it, any number."},
        {"bond_stiffness", &Solidify::bond_stiffness, quantity("10 N/m", positive), required,
         "k_b of a new bond, of energy k_b (r - r0)^2."},
        {"rest_length", &Solidify::rest_length, quantity_or_auto("0.1 mm"), "auto",
         "r0 of a new bond; \"auto\" is the distance when it is made."},
        {"bond_damping", &Solidify::bond_damping, number(between(0, 1)), "0.01",
         "Dashpot along a new bond, as a fraction of critical damping."},
        {"bond_to", &Solidify::bond_to, one_of<BondTo>(), "seed",
         "What a particle that turns solid is bonded to: its seed, or also all of the aggregate within reach."},
        {"seed", &Solidify::seed, integer(not_negative), "1", "Chooses among the random numbers."},
    };
}

std::vector<Key<Breaking>> breaking_keys() {
    return {
        {"name", &Breaking::name, name(), required, "What the rule is called."},
        {"part", &Breaking::part, name(), required, "The elastic solid, [[solidify]] or [[join]] whose bonds may break."},
        {"force_above", &Breaking::force_above, quantity("1 mN", positive), not_given,
         "Tension 2 k_b (r - r0) beyond which a bond breaks; or give strain_above."},
        {"strain_above", &Breaking::strain_above, number(positive), not_given,
         "Strain (r - r0) / r0 beyond which a bond breaks."},
        {"interval", &Breaking::interval, quantity("1 ms", positive), not_given,
         "Time between looks at the bonds; without it they are looked at in every step."},
    };
}
// clang-format on

}  // namespace dmp::scene
