// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "study/limit_dial_list.hpp"

#include <algorithm>
#include <utility>

#include "base/number_text.hpp"
#include "scene/quantity.hpp"
#include "scene/toml_node.hpp"

namespace dmp::study {

namespace {

using Keys = std::vector<DialKey>;
using Found = std::vector<Keys>;
using Numerics = decltype(Scene::numerics);

const std::vector<DialSide> up{DialSide::up}, down{DialSide::down}, both{DialSide::up, DialSide::down};

std::string with_unit(const std::string& number, const std::string& unit) {
    return unit.empty() ? number : toml_quoted(number + " " + unit);
}

DialKey key_of(std::string key, double own, std::string unit = "") {
    DialKey made{std::move(key), own, std::move(unit), "", {}};
    made.own_toml = with_unit(exact_text(own), made.unit);
    made.toml = [own, unit = made.unit](double factor) {
        return with_unit(number_text(own * factor, rung_digits), unit);
    };
    return made;
}

/// Of a key that is "auto" in the scene.
DialKey auto_key(std::string key, double value, std::string unit) {
    DialKey made = key_of(std::move(key), value, std::move(unit));
    made.own_toml = toml_quoted("auto");
    return made;
}

Found one_if(bool has_it, DialKey key) {
    if (!has_it) return {};
    return {Keys{std::move(key)}};
}

bool has_flow(const DialScene& of) { return !of.facts.at_rest && !of.scene.parts_of(PartKind::fluid).empty(); }
bool has_spheres(const DialScene& of) { return !of.scene.parts_of(PartKind::spheres).empty(); }
bool has_auto_sound(const DialScene& of) { return has_flow(of) && !(*of.scene.numerics.sound_speed > 0); }

std::string key_of_part(const Part& part, const char* key) { return "part." + *part.name + "." + key; }

/// A dial for each enabled part of a kind: of those of its keys that have a value.
Found of_parts(const DialScene& of, PartKind kind,
               const std::vector<std::tuple<const char*, Value<double> Part::*, const char*>>& keys) {
    Found all;
    for (const Part* part : of.scene.parts_of(kind)) {
        Keys its;
        for (const auto& [key, member, unit] : keys)
            if (const double value = part->*member; value > 0)
                its.push_back(key_of(key_of_part(*part, key), value, unit));
        if (!its.empty()) all.push_back(std::move(its));
    }
    return all;
}

/// Of a key that sets steps.
std::function<std::optional<StatedLimit>(const DialScene&)> stated_of(const char* key) {
    return [key](const DialScene& of) {
        const std::vector<StepMargin> margins = step_margins(of.scene);
        const auto found = std::ranges::find(margins, key, &StepMargin::key);
        return found == margins.end() ? std::nullopt : std::optional(found->stated);
    };
}

/// A key that sets the limit of one model: a dial where that limit rules the step, as nothing else is changed by it.
DialRow of_ruling_limit(const char* what, const char* model, const char* key, Value<double> Numerics::*member,
                        bool has_stated = true) {
    const auto found = [model, key, member](const DialScene& of) {
        const bool rules = std::ranges::any_of(of.facts.step_limits, [&](const auto& limit) {
            return limit.first.starts_with(model) && limit.second <= of.facts.dt * (1 + 1e-9);
        });
        return one_if(rules && !has_spheres(of), key_of(key, of.scene.numerics.*member));
    };
    DialRow row{what, up, false, found, {{model, 1}}, true};
    if (has_stated) row.stated = stated_of(key);
    return row;
}

/// The species' diffusivities, all by the same factor.
DialKey diffusivities_of(const Species& species) {
    const ByPart<double>& given = species.diffusivity;
    if (given.all) return key_of("species." + *species.name + ".diffusivity", **given.all, "m^2/s");
    const auto text = [parts = given.parts](const std::function<std::string(double)>& number) {
        std::string items;
        for (const auto& [part, value] : parts)
            items += (items.empty() ? "" : ", ") + toml_quoted(part) + " = " + with_unit(number(*value), "m^2/s");
        return "{" + items + "}";
    };
    double largest = 0;
    for (const auto& [part, value] : given.parts) largest = std::max(largest, *value);
    DialKey made{"species." + *species.name + ".diffusivity", largest, "m^2/s", text(exact_text), {}};
    made.toml = [text](double factor) {
        return text([factor](double own) { return number_text(own * factor, rung_digits); });
    };
    return made;
}

Found diffusivities(const DialScene& of) {
    Found all;
    for (const Species& species : of.scene.species)
        if (DialKey key = diffusivities_of(species); key.own > 0) all.push_back({std::move(key)});
    return all;
}

Found contact_strength(const DialScene& of) {
    const Value<double>& given = of.scene.contact.strength;
    if (!(of.facts.contact_strength > 0) || !of.scene.may_have_elastic()) return {};
    return {{*given > 0 ? key_of("contact.strength", *given, "J")
                        : auto_key("contact.strength", of.facts.contact_strength, "J")}};
}

std::vector<DialRow> rows() {
    return {
        {"time step of the fluid, in multiples of R / (c0 + U)",
         up,
         false,
         [](const DialScene& of) {
             return one_if(has_flow(of), key_of("numerics.step_factor", of.scene.numerics.step_factor));
         },
         {{"sound", 1}},
         true,
         stated_of("numerics.step_factor")},
        {"Mach number, which sets the speed of sound",
         up,
         false,
         [](const DialScene& of) {
             return one_if(has_auto_sound(of), key_of("numerics.mach_number", of.scene.numerics.mach_number));
         },
         {{"sound", 1}}},
        {"speed of sound",
         down,
         false,
         [](const DialScene& of) {
             return one_if(has_flow(of) && !has_auto_sound(of),
                           key_of("numerics.sound_speed", of.scene.numerics.sound_speed, "m/s"));
         },
         {{"sound", -1}}},
        {"support of the kernel, in spacings",
         both,
         false,
         [](const DialScene& of) {
             return one_if(!of.scene.parts_of(PartKind::fluid).empty(),
                           key_of("numerics.support", of.scene.numerics.support));
         },
         {{"sound", 1}, {"viscosity", 2}, {"species", 2}}},
        {"distance between particles",
         up,
         false,
         [](const DialScene& of) {
             return one_if(of.scene.particles.spacing.given(),
                           key_of("particles.spacing", of.scene.particles.spacing, "m"));
         },
         {{"sound", 1}, {"viscosity", 2}, {"species", 2}}},
        {"strength of shifting; with the corrected scheme held at s c0 dt / R = 0.1",
         both,
         false,
         [](const DialScene& of) {
             return one_if(has_flow(of) && *of.scene.numerics.shifting > 0,
                           key_of("numerics.shifting", of.scene.numerics.shifting));
         },
         {{"shifting", -1}}},
        {"strength of density diffusion; beyond 0.12 over the step factor, steps become shorter",
         both,
         false,
         [](const DialScene& of) {
             return one_if(has_flow(of) && *of.scene.numerics.density_diffusion > 0,
                           key_of("numerics.density_diffusion", of.scene.numerics.density_diffusion));
         },
         {{"density diffusion", -1}}},
        {"time step of elastic solids, as a part of the largest stable one",
         up,
         false,
         [](const DialScene& of) {
             return one_if(
                 of.scene.may_have_elastic() && *of.scene.numerics.spring_stepping == SpringStepping::subcycled,
                 key_of("numerics.spring_step_factor", of.scene.numerics.spring_step_factor));
         },
         {},
         false,
         stated_of("numerics.spring_step_factor")},
        of_ruling_limit("time step of explicit viscosity, as a part of the kernel's linear limit", "viscosity",
                        "numerics.viscous_step_factor", &Numerics::viscous_step_factor),
        of_ruling_limit("time step of explicit diffusion, as a part of the kernel's linear limit", "species",
                        "numerics.species_step_factor", &Numerics::species_step_factor),
        of_ruling_limit("time step of the repulsion, as a part of 2 / omega", "contact", "numerics.contact_step_factor",
                        &Numerics::contact_step_factor),
        of_ruling_limit("time step of light solids, in multiples of sqrt(m / m_liquid) R / (c0 + U)", "light solids",
                        "numerics.light_solid_step_factor", &Numerics::light_solid_step_factor),
        of_ruling_limit("largest density diffusion in a step, delta (c0 + U) dt / R", "density diffusion",
                        "numerics.density_diffusion_step_factor", &Numerics::density_diffusion_step_factor),
        of_ruling_limit("largest shifting in a step, s c0 dt / R", "shifting", "numerics.shifting_step_factor",
                        &Numerics::shifting_step_factor, false),
        {"range of the repulsion, in spacings", both, false,
         [](const DialScene& of) {
             return one_if(of.facts.contact_strength > 0 && of.scene.may_have_elastic(),
                           key_of("contact.range", of.scene.contact.range));
         }},
        {"strength of the repulsion", both, false, contact_strength, {{"contact", -0.5}}},
        {"steps in the shortest impact of spheres",
         down,
         false,
         [](const DialScene& of) {
             return one_if(has_spheres(of) && *of.scene.numerics.contact_step == 0,
                           key_of("numerics.steps_per_contact", of.scene.numerics.steps_per_contact));
         },
         {{"contact of", -1}, {"adhesion of", -1}, {"Rayleigh", -1}},
         true,
         stated_of("numerics.steps_per_contact")},
        {"time step of spheres",
         up,
         false,
         [](const DialScene& of) {
             return one_if(has_spheres(of) && *of.scene.numerics.contact_step > 0,
                           key_of("numerics.contact_step", of.scene.numerics.contact_step, "s"));
         },
         {{"contact_step", 1}}},
        {"viscosity of a liquid",
         both,
         true,
         [](const DialScene& of) {
             return has_flow(of) ? of_parts(of, PartKind::fluid, {{"viscosity", &Part::viscosity, "Pa*s"}}) : Found{};
         },
         {{"viscosity", -1}}},
        {"density of one of several liquids", both, true,
         [](const DialScene& of) {
             return has_flow(of) && of.scene.parts_of(PartKind::fluid).size() > 1
                        ? of_parts(of, PartKind::fluid, {{"density", &Part::density, "kg/m^3"}})
                        : Found{};
         }},
        {"stiffness of an elastic solid",
         both,
         true,
         [](const DialScene& of) {
             return of_parts(of, PartKind::elastic,
                             {{"youngs_modulus", &Part::youngs_modulus, "Pa"},
                              {"bending_stiffness", &Part::bending_stiffness, "N*m^2"},
                              {"axial_stiffness", &Part::axial_stiffness, "N"},
                              {"shear_stiffness", &Part::shear_stiffness, "N"}});
         },
         {{"elastic", -0.5}}},
        {"mass of an elastic solid",
         both,
         true,
         [](const DialScene& of) {
             return of_parts(
                 of, PartKind::elastic,
                 {{"mass_per_length", &Part::mass_per_length, "kg/m"}, {"density", &Part::density, "kg/m^3"}});
         },
         {{"elastic", 0.5}, {"light solids", 0.5}, {"viscosity at elastic solids", 1}}},
        {"stiffness of spheres",
         both,
         true,
         [](const DialScene& of) {
             return of_parts(of, PartKind::spheres, {{"youngs_modulus", &Part::youngs_modulus, "Pa"}});
         },
         {{"contact of", -0.4}, {"adhesion of", -0.5}, {"Rayleigh", -0.5}}},
        {"mass of spheres",
         both,
         true,
         [](const DialScene& of) {
             return of_parts(of, PartKind::spheres,
                             {{"density", &Part::density, "kg/m^3"}, {"mass", &Part::mass, "kg"}});
         },
         {{"contact of", 0.4}, {"adhesion of", 0.5}, {"Rayleigh", 0.5}}},
        {"diffusivity of a species", both, true, diffusivities, {{"species", -1}}},
    };
}

}  // namespace

const std::vector<DialRow>& dial_list() {
    static const std::vector<DialRow> list = rows();
    return list;
}

}  // namespace dmp::study
