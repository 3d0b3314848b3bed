// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/contact_keys.hpp"

namespace dmp::scene {

// Columns as in schema.cpp.
// clang-format off

std::vector<Key<Contact>> contact_keys() {
    return {
        {"between", &Contact::between, one_of<ContactBetween>(), unwritten("auto"),
         "What elastic bodies and walls touch with: their drawn \"surfaces\", or \"particles\" that repel each other, "
         "as in the published studies. \"auto\": surfaces in scenes without [[solidify]]."},
        {"stiffness", &Contact::stiffness, quantity_or_auto("1e9 Pa/m"), unwritten("auto"),
         "Contact of surfaces: pressure over the depth to which they pass into each other; \"auto\": from the stiffness of "
         "the material, or what the time step allows (docs/elastic.md)."},
        {"friction", &Contact::friction, number(not_negative), unwritten("0"),
         "Contact of surfaces: coefficient of friction (Coulomb's)."},
        {"damping", &Contact::damping, number(between(0, 1)), unwritten("0"),
         "Contact of surfaces: dashpot along the normal, as a fraction of the critical one."},
        {"range", &Contact::range, number(not_negative), ByScheme{"0.7", "1.0"},
         "Cut-off distance of the short-range repulsion between particles of elastic bodies and all others, in "
         "spacings; of liquid alone where surfaces touch. 0 turns all contact off."},
        {"strength", &Contact::strength, quantity_or_auto("1e-6 J"), "auto",
         "Strength K of the short-range repulsion; \"auto\" chooses it."},
    };
}
// clang-format on

}  // namespace dmp::scene
