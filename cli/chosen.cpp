// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/chosen.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "cli/terminal.hpp"
#include "cli/text.hpp"
#include "cli/uses.hpp"
#include "scene/read_scene.hpp"

namespace dmp::cli {

namespace {

/// Where values come from, by their keys.
class Origins {
  public:
    explicit Origins(const Scene& scene) : scene_(scene) {}
    template <class T>
    std::string operator()(const Value<T>& value, const char* key) const {
        return fmt::format("{}, {}", key, value.given() ? value.location.text() : default_origin(scene_, key));
    }

  private:
    const Scene& scene_;
};

std::string sound_speed_text(const Scene& scene, const Plan& plan) {
    const Origins origin_text(scene);
    const std::string c0 = quantity_text(plan.sound_speed, "m/s");
    const auto by_pressure = [&](const std::string& source) {
        return fmt::format(
            "{}   (sqrt(p / rho) / Mach {:.3g} of the largest pressure expected, {}, {}; "
            "numerics.sound_speed = \"auto\")",
            c0, *scene.numerics.mach_number, quantity_text(plan.sound.largest_pressure, "Pa"), source);
    };
    switch (plan.sound.origin) {
        case SoundSpeed::Origin::scene:
            return fmt::format("{}   ({})", c0, origin_text(scene.numerics.sound_speed, "numerics.sound_speed"));
        case SoundSpeed::Origin::largest_speed:
            return fmt::format(
                "{}   (the largest speed expected, {}, over Mach {:.3g}; numerics.sound_speed = \"auto\"; {})", c0,
                quantity_text(plan.largest_speed, "m/s"), *scene.numerics.mach_number,
                origin_text(scene.numerics.mach_number, "numerics.mach_number"));
        case SoundSpeed::Origin::given_pressure:
            return by_pressure(origin_text(scene.flow.largest_pressure, "flow.largest_pressure"));
        case SoundSpeed::Origin::column_pressure:
            return by_pressure("by the body forces over the fluid's extent");
        case SoundSpeed::Origin::viscous_pressure:
            return by_pressure("by the viscosity at the largest speed over 4 spacings");
    }
    return "";
}

std::string contact_text(const Scene& scene) {
    const auto& contact = scene.contact;
    const Origins origin_text(scene);
    if (*contact.range == 0) return "none (" + origin_text(contact.range, "contact.range") + ")";
    if (scene.has_surface_contact()) {
        const std::string stiffness = *contact.stiffness == 0 ? "auto" : quantity_text(*contact.stiffness, "Pa/m");
        return fmt::format("between surfaces ({}), stiffness {} ({}), friction {:.3g} ({})",
                           origin_text(contact.between, "contact.between"), stiffness,
                           origin_text(contact.stiffness, "contact.stiffness"), *contact.friction,
                           origin_text(contact.friction, "contact.friction"));
    }
    const std::string strength = *contact.strength == 0 ? "auto" : quantity_text(*contact.strength, "J");
    return fmt::format("repulsion within {:.3g} x the spacing ({}), strength {} ({})", *contact.range,
                       origin_text(contact.range, "contact.range"), strength,
                       origin_text(contact.strength, "contact.strength"));
}

void add_kernel_and_walls(Listing& list, const Scene& scene) {
    const auto& numerics = scene.numerics;
    const Origins origin_text(scene);
    list.add("kernel", fmt::format("{} ({}), support {:.4g} spacings ({})", to_string(*numerics.kernel),
                                   origin_text(numerics.kernel, "numerics.kernel"), *numerics.support,
                                   origin_text(numerics.support, "numerics.support")));
    list.add("walls",
             fmt::format("{} ({})", to_string(*numerics.walls), origin_text(numerics.walls, "numerics.walls")));
}

void add_fluid_models(Listing& list, const Scene& scene) {
    const auto& numerics = scene.numerics;
    const Origins origin_text(scene);
    list.add("liquid",
             fmt::format("{} equation of state ({}), density by {} ({})", to_string(*numerics.equation_of_state),
                         origin_text(numerics.equation_of_state, "numerics.equation_of_state"),
                         to_string(*numerics.density), origin_text(numerics.density, "numerics.density")));
    list.add("viscosity",
             fmt::format("{} ({}), {} mean between fluids ({})", to_string(*numerics.viscous_law),
                         origin_text(numerics.viscous_law, "numerics.viscous_law"), to_string(*numerics.viscosity_mean),
                         origin_text(numerics.viscosity_mean, "numerics.viscosity_mean")));
    list.add("diffusion", fmt::format("density {:.4g} ({}), shifting {:.4g} ({})", *numerics.density_diffusion,
                                      origin_text(numerics.density_diffusion, "numerics.density_diffusion"),
                                      *numerics.shifting, origin_text(numerics.shifting, "numerics.shifting")));
    if (*numerics.viscosity_stepping == ViscosityStepping::implicitly)
        list.add("stepped", fmt::format("implicitly ({}), solved to {:.3g} ({})",
                                        origin_text(numerics.viscosity_stepping, "numerics.viscosity_stepping"),
                                        *numerics.viscosity_tolerance,
                                        origin_text(numerics.viscosity_tolerance, "numerics.viscosity_tolerance")));
}

/// "; taken up at 0.1 1/s in gel"; empty where nothing takes it up.
std::string uptake_text(const Scene& scene, const Species& species) {
    std::string text;
    for (const Part* part : scene.takers_of(species))
        text += fmt::format("{}{} in {}", text.empty() ? "; taken up at " : ", ",
                            quantity_text(**species.uptake_in(*part), "1/s"), *part->name);
    return text;
}

}  // namespace

Listing chosen_values(const Scene& scene, const Plan& plan, const Origin& origin) {
    if (!scene.parts_of(PartKind::spheres).empty()) return chosen_values_of_spheres(scene, plan, origin);
    const auto& numerics = scene.numerics;
    const Origins origin_text(scene);
    const bool has_fluid = !scene.parts_of(PartKind::fluid).empty();
    Listing list;
    list.add("quality", fmt::format("{} ({})", to_string(*scene.quality), origin_text(scene.quality, "quality")));
    if (plan.at_rest) list.add("flow", "none: nothing drives it, and only species are stepped");
    if (!plan.at_rest) list.add("sound speed", sound_speed_text(scene, plan));
    if (has_fluid) add_kernel_and_walls(list, scene);
    for (const Part* part : scene.parts_of(PartKind::rigid)) {
        const std::string key = "part." + *part->name + ".layers";
        list.add("rows " + *part->name, fmt::format("{} ({})", *part->layers, origin_text(part->layers, key.c_str())));
    }
    if (has_fluid && !plan.at_rest) add_fluid_models(list, scene);
    for (const Species& species : scene.species)
        list.add("species " + *species.name,
                 fmt::format("in {}, diffusion stepped {}ly ({}){}", species.concentration_unit(),
                             to_string(*numerics.species_stepping),
                             origin_text(numerics.species_stepping, "numerics.species_stepping"),
                             uptake_text(scene, species)));
    if (!plan.at_rest)
        list.add("step factor", fmt::format("{:.4g} ({})", *numerics.step_factor,
                                            origin_text(numerics.step_factor, "numerics.step_factor")));
    list.add("time step", fmt::format("{}, ruled by {}; about {} steps", quantity_text(plan.dt, "s"), plan.ruling_limit,
                                      count_text(static_cast<std::size_t>(plan.steps))));
    for (const auto& [what, constants] : origin.springs) list.add(what, constants);
    for (const Part* part : scene.parts_of(PartKind::elastic)) {
        const std::string own =
            part->damping_ratio.given()
                ? fmt::format("cells {:.3g} of critical at {}", *part->damping_ratio,
                              quantity_text(*part->damping_frequency, "Hz"))
                : fmt::format("{} {:.3g} of critical ({})", scene.is_of_cells(*part) ? "cells" : "bonds",
                              *part->bond_damping, origin_text(part->bond_damping, "bond_damping"));
        list.add("damping " + *part->name,
                 fmt::format("{}, drag {:.3g} kg/s ({}), mass damping {:.3g} 1/s ({})", own, *part->drag,
                             origin_text(part->drag, "drag"), *part->mass_damping,
                             origin_text(part->mass_damping, "mass_damping")));
    }
    if (plan.spring_substeps > 0) {
        list.add("spring steps",
                 fmt::format("{} ({}), {} in each time step", to_string(*numerics.spring_stepping),
                             origin_text(numerics.spring_stepping, "numerics.spring_stepping"), plan.spring_substeps));
        if (*numerics.spring_stepping == SpringStepping::subcycled)
            list.add("", fmt::format("{:.4g} of the largest stable one ({})", *numerics.spring_step_factor,
                                     origin_text(numerics.spring_step_factor, "numerics.spring_step_factor")));
    }
    for (const Solidify& rule : scene.solidify)
        list.add("solidify " + *rule.name, fmt::format("{} ({}), seeds active {} ({}), bonds to {} ({})",
                                                       to_string(*rule.rule), origin_text(rule.rule, "rule"),
                                                       to_string(*rule.active), origin_text(rule.active, "active"),
                                                       *rule.bond_to == BondTo::seed ? "the seed" : "neighbours",
                                                       origin_text(rule.bond_to, "bond_to")));
    if (!plan.at_rest) list.add("contact", contact_text(scene));
    for (const auto& note : origin.notes) list.add("note", note);
    return list;
}

std::string chosen_text(const Listing& values) {
    return Style(Stream::output).strong("What will run") + "\n" + values.text();
}

std::string limits_text(const Plan& plan) {
    Listing list;
    for (const auto& limit : plan.limits) {
        const bool rules = limit.model == plan.ruling_limit;
        list.add(limit.model, fmt::format("{:<14} {}{}", quantity_text(limit.dt, "s"), limit.formula,
                                          rules ? "   <- rules the time step" : ""));
    }
    Listing margins;
    for (const Margin& margin : plan.margins)
        margins.add(margin.key, fmt::format("{:.4g}, stated limit {:.3g} ({}): {:.3g} times{}", margin.own,
                                            margin.stated, margin.formula, margin.times,
                                            margin.is_by_other ? ", as other limits keep the steps shorter" : ""));
    const Style style(Stream::output);
    return style.strong("Largest time steps") + "\n" + list.text() +
           (plan.margins.empty() ? "" : style.strong("Margins of what sets the steps") + "\n" + margins.text());
}

}  // namespace dmp::cli
