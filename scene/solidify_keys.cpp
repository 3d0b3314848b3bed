// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/solidify_keys.hpp"

namespace dmp::scene {

// Columns as in schema.cpp.
// clang-format off

std::vector<Key<Solidify>> solidify_keys() {
    return {
        {"name", &Solidify::name, name(), required, "Name of the resulting solid, used by measures and [[break]]."},
        {"liquid", &Solidify::liquid, name(), required, "Fluid part whose particles solidify."},
        {"seed_part", &Solidify::seed_part, name(), not_given,
         "Rigid or elastic part whose particles are the first seeds; or give another seed key."},
        {"seed_region", &Solidify::seed_region, name(), not_given,
         "Region whose fluid particles become seeds, once, at the first event. With seed_stress_above or "
         "seed_residence_above, only those that exceed these values, at every event."},
        {"seed_stress_above", &Solidify::seed_stress_above, quantity("2 Pa", positive), not_given,
         "Fluid particles whose shear stress exceeds this become seeds, at every event."},
        {"seed_residence_above", &Solidify::seed_residence_above, quantity("1 s", positive), not_given,
         "Fluid particles that have spent more time than this in seed_region become seeds, at every event."},
        {"region", &Solidify::region, name(), not_given,
         "Only fluid particles in this region may solidify near a seed."},
        {"stress_above", &Solidify::stress_above, quantity("2 Pa", positive), not_given,
         "Only fluid particles whose shear stress exceeds this may solidify near a seed."},
        {"residence_above", &Solidify::residence_above, quantity("1 s", positive), not_given,
         "Only fluid particles that have spent more time than this in region may solidify near a seed."},
        {"rule", &Solidify::rule, one_of<SolidifyRule>(), "per_candidate",
         "Random trials of an event: one for each pair of a seed and a fluid particle within reach, one for each "
         "fluid particle within reach of a seed, or one for each seed and fluid particle that are each other's "
         "nearest."},
        {"reach", &Solidify::reach, quantity("0.12 mm", positive), required,
         "R_max, the distance from a seed within which a fluid particle may solidify; nearest neighbours are about "
         "one spacing apart."},
        {"probability", &Solidify::probability, number(fraction), required,
         "Probability that a random trial succeeds and makes a bond."},
        {"from", &Solidify::from, quantity("0.5 s", not_negative), "0 s", "Time of the first event."},
        {"until", &Solidify::until, quantity("2 s", positive), not_given,
         "Time from which on there are no events: what is solid stays so and grows no more."},
        {"interval", &Solidify::interval, quantity("10 ms", positive), required, "Time between events."},
        {"active", &Solidify::active, one_of<SeedActivity>(), "always",
         "Events in which a seed is active: \"always\", only its first one (\"once\"), or its first one and every "
         "N-th after it (\"one_in\")."},
        {"one_in", &Solidify::one_in, integer(at_least(1)), not_given, "N for active = \"one_in\"."},
        {"spreads", &Solidify::spreads, boolean(), "true",
         "Whether solidified particles become seeds from the next event on."},
        {"most_bonds", &Solidify::most_bonds, integer(at_least(1)), not_given,
         "Largest number of bonds that one particle gets; no limit by default."},
        {"bond_stiffness", &Solidify::bond_stiffness, quantity("10 N/m", positive), required,
         "Stiffness k_b of a new bond, whose energy is k_b (r - r0)^2."},
        {"rest_length", &Solidify::rest_length, quantity_or_auto("0.1 mm"), "auto",
         "Rest length r0 of a new bond; \"auto\" is the distance at its creation."},
        {"bond_damping", &Solidify::bond_damping, number(between(0, 1)), "0.01",
         "Dashpot of a new bond, as a fraction of critical damping."},
        {"bond_to", &Solidify::bond_to, one_of<BondTo>(), "seed",
         "Bonds of a solidifying particle: to its \"seed\", or to all \"neighbours\": its seed and all particles of "
         "the aggregate within reach."},
        {"seed", &Solidify::seed, integer(not_negative), "1", "Seed of the random numbers."},
    };
}

std::vector<Key<Breaking>> breaking_keys() {
    return {
        {"name", &Breaking::name, name(), required, "Name of the rule."},
        {"part", &Breaking::part, name(), required, "Elastic part, [[solidify]] or [[join]] that may break."},
        {"force_above", &Breaking::force_above, quantity("1 mN", positive), not_given,
         "Tension 2 k_b (r - r0) above which a bond breaks; or give strain_above."},
        {"stress_above", &Breaking::stress_above, quantity("1 MPa", positive), not_given,
         "Solids of cells: principal tension above which the face between two cells breaks; or give strain_above."},
        {"strain_above", &Breaking::strain_above, number(positive), not_given,
         "Strain above which a bond breaks, (r - r0) / r0, or, in a solid of cells, a face: the principal one."},
        {"interval", &Breaking::interval, quantity("1 ms", positive), not_given,
         "Time between checks of the bonds or faces; every time step by default."},
    };
}
// clang-format on

}  // namespace dmp::scene
