// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "cli/chosen.hpp"
#include "cli/terminal.hpp"
#include "cli/text.hpp"
#include "cli/uses.hpp"
#include "models/dem/contact_laws.hpp"
#include "scene/read_scene.hpp"

namespace dmp::cli {

namespace {

/// Where a pair's value comes from; pairs have no levels of quality.
template <class T>
std::string origin_text(const Value<T>& value) {
    return value.given() ? value.location.text() : "default";
}

std::string damping_text(const ContactPair& pair) {
    const std::string damping = pair.restitution.given() ? fmt::format("restitution {:.4g}", *pair.restitution)
                                                         : fmt::format("dampings {:.4g} and {:.4g} 1/(m s)",
                                                                       *pair.normal_damping, *pair.tangential_damping);
    return fmt::format("{}; the dashpot {} pull ({})", damping, pair.dashpot_may_pull ? "may" : "may not",
                       origin_text(pair.dashpot_may_pull));
}

std::string adhesion_text(const ContactPair& pair) {
    if (!ContactModel{pair.normal, pair.tangential, pair.rolling, pair.adhesion}.is_adhesive())
        return "none (" + origin_text(pair.adhesion) + ")";
    const std::string law = pair.adhesion->is<NoAdhesion>() ? to_string(*pair.normal) : to_string(*pair.adhesion);
    std::string text = law + ", " +
                       (pair.pull_off_force.given() ? quantity_text(*pair.pull_off_force, "N")
                                                    : quantity_text(*pair.work_of_adhesion, "J/m^2"));
    if (pair.adhesion->visit([]<class Law>() { return Law::has_range; }))
        text += fmt::format(
            ", z0 {}, cut off at {} ({})", quantity_text(*pair.equilibrium_distance, "m"),
            quantity_text(pair.adhesion_cutoff.given() ? *pair.adhesion_cutoff : 50 * *pair.equilibrium_distance, "m"),
            origin_text(pair.adhesion_cutoff));
    return text;
}

void add_pair(Listing& list, const ContactPair& pair) {
    const std::string parts = fmt::format("'{}' and '{}': ", (*pair.parts)[0], (*pair.parts)[1]);
    if (!*pair.enabled) {
        list.add("contact", fmt::format("{}none ({})", parts, origin_text(pair.enabled)));
        return;
    }
    list.add("contact",
             fmt::format("{}normal {} ({}), tangential {} ({})", parts, to_string(*pair.normal),
                         origin_text(pair.normal), to_string(*pair.tangential), origin_text(pair.tangential)));
    if (*pair.normal_stiffness_factor != 1 || *pair.tangential_stiffness_factor != 1)
        list.add("", fmt::format("stiffness times {:.4g} and {:.4g}", *pair.normal_stiffness_factor,
                                 *pair.tangential_stiffness_factor));
    list.add("", fmt::format("{}; friction {:.4g}", damping_text(pair), *pair.friction));
    if (*pair.rolling_friction > 0)
        list.add("", fmt::format("rolling friction {:.4g}, {} ({})", *pair.rolling_friction, to_string(*pair.rolling),
                                 origin_text(pair.rolling)));
    list.add("", "adhesion " + adhesion_text(pair));
}

}  // namespace

Listing chosen_values_of_spheres(const Scene& scene, const Plan& plan, const Origin& origin) {
    const auto& numerics = scene.numerics;
    Listing list;
    list.add("quality", fmt::format("{} ({})", to_string(*scene.quality),
                                    scene.quality.given() ? scene.quality.location.text() : "default"));
    for (const ContactPair& pair : scene.contact_pairs) add_pair(list, pair);
    for (const PartKind kind : {PartKind::plane, PartKind::surface})
        for (const Part* wall : scene.parts_of(kind))
            list.add("wall " + *wall->name, wall->youngs_modulus.given()
                                                ? quantity_text(*wall->youngs_modulus, "Pa")
                                                : std::string("does not yield (no youngs_modulus)"));
    list.add(
        "step",
        *numerics.contact_step > 0
            ? fmt::format("{} ({})", quantity_text(*numerics.contact_step, "s"), numerics.contact_step.location.text())
            : fmt::format("{:.4g} in an impact ({})", *numerics.steps_per_contact,
                          numerics.steps_per_contact.given() ? numerics.steps_per_contact.location.text()
                                                             : default_origin(scene, "numerics.steps_per_contact")));
    list.add("time step", fmt::format("{}, ruled by {}; about {} steps", quantity_text(plan.dt, "s"), plan.ruling_limit,
                                      count_text(static_cast<std::size_t>(plan.steps))));
    for (const auto& note : origin.notes) list.add("note", note);
    return list;
}

}  // namespace dmp::cli
