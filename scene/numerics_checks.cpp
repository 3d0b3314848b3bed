// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/numerics_checks.hpp"

#include <algorithm>
#include <string>

#include "base/errors.hpp"
#include "base/unlisted_value.hpp"
#include "models/sph/viscous_laws.hpp"
#include "scene/checks.hpp"
#include "scene/corrected_kernels.hpp"
#include "scene/law_lists.hpp"
#include "scene/quantity.hpp"

namespace dmp::scene {

namespace {

/// Implicit viscosity solves one linear, symmetric system for the fluid and its elastic solids.
void need_what_implicit_viscosity_solves(const Scene& scene) {
    const auto& numerics = scene.numerics;
    if (*numerics.viscosity_stepping != ViscosityStepping::implicitly) return;
    if (!numerics.viscous_law->visit([]<class Law>() { return Law::linear; })) {
        const bool has_gradient = *numerics.scheme == FluidScheme::corrected;
        const std::string linear = laws_with<ViscousLaw>(
            [&]<class Law>() { return Law::linear && (has_gradient || !models::needs_gradient<Law>()); });
        throw InputError(first_known(scene, {&numerics.viscous_law.location}),
                         "numerics.viscosity_stepping = \"implicit\" needs a force that is linear in the velocities; "
                         "numerics.viscous_law = \"" +
                             to_string(*numerics.viscous_law) + "\" is not",
                         "write viscous_law = " + linear);
    }
    if (*numerics.spring_stepping == SpringStepping::subcycled && scene.may_have_elastic())
        throw InputError(
            first_known(scene, {&numerics.spring_stepping.location, &numerics.viscosity_stepping.location}),
            "numerics.viscosity_stepping = \"implicit\" solves for fluid and elastic solids together; "
            "numerics.spring_stepping = \"subcycled\" integrates the solids separately",
            "write spring_stepping = \"implicit\"");
}

/// Beyond a ratio of 10 the lighter fluid is thrown about by the smallest compressions of the heavier one.
void need_fluids_of_like_density(const Scene& scene) {
    constexpr double largest_ratio = 10;
    const auto fluids = scene.parts_of(PartKind::fluid);
    if (fluids.empty()) return;
    const auto [light, heavy] = std::ranges::minmax(fluids, {}, [](const Part* fluid) { return *fluid->density; });
    if (*heavy->density <= largest_ratio * *light->density) return;
    throw InputError(light->density.location,
                     "'" + *heavy->name + "' is more than 10 times as dense as '" + *light->name +
                         "': numerics.scheme = \"corrected\" is unstable there",
                     "give it a density within ten times of the other's");
}

/// What only one of the fluid's schemes can do.
void need_what_the_scheme_supports(const Scene& scene) {
    const auto& numerics = scene.numerics;
    const auto refuse = [&](const SourceLocation& location, const std::string& key) {
        const std::string scheme = to_string(*numerics.scheme);
        throw InputError(
            first_known(scene, {&location, &numerics.scheme.location}),
            "numerics.scheme = \"" + scheme + "\" does not support numerics." + key,
            "leave it out, or write scheme = \"" +
                to_string(*numerics.scheme == FluidScheme::corrected ? FluidScheme::plain : FluidScheme::corrected) +
                "\"");
    };
    const bool needs_gradient = numerics.viscous_law->visit([]<class Law>() { return models::needs_gradient<Law>(); });
    switch (*numerics.scheme) {
        case FluidScheme::corrected:
            need_fluids_of_like_density(scene);
            if (*numerics.density == DensityModel::summation)
                refuse(numerics.density.location, "density = \"summation\"");
            if (*numerics.transport_velocity) refuse(numerics.transport_velocity.location, "transport_velocity = true");
            if (*numerics.gradient_correction)
                refuse(numerics.gradient_correction.location, "gradient_correction = true");
            if (*numerics.walls == WallModel::plain) refuse(numerics.walls.location, "walls = \"plain\"");
            if (!has_corrected_scheme(numerics.kernel))
                refuse(numerics.kernel.location, "kernel = \"" + to_string(*numerics.kernel) + "\"");
            if (numerics.support.given() && *numerics.support < 2.8)
                refuse(numerics.support.location, "support = " + exact_text(numerics.support) + ", below 2.8");
            if (scene.contact.range.given() && *scene.contact.range > 0.8 &&
                !scene.parts_of(PartKind::elastic).empty() && !scene.parts_of(PartKind::fluid).empty())
                throw InputError(
                    first_known(scene, {&scene.contact.range.location, &numerics.scheme.location}),
                    "contact.range = " + exact_text(scene.contact.range) +
                        " is within reach of the fluid that numerics.scheme = \"corrected\" keeps evenly "
                        "spread: shifting would press it into the repulsion of elastic solids, step by step",
                    "leave range out: it is then 0.7");
            return;
        case FluidScheme::plain:
            if (numerics.viscous_law.given() && needs_gradient)
                refuse(numerics.viscous_law.location, "viscous_law = \"" + to_string(*numerics.viscous_law) + "\"");
            return;
    }
}

/// Terms that exclude each other: an error if both are given; a default is turned off instead.
void need_terms_that_go_together(const Scene& scene) {
    const auto& numerics = scene.numerics;
    const bool summation = *numerics.density == DensityModel::summation;
    if (summation && numerics.density_diffusion.given() && *numerics.density_diffusion > 0)
        throw InputError(numerics.density_diffusion.location,
                         "numerics.density_diffusion smooths an integrated density; numerics.density = "
                         "\"summation\" does not integrate it",
                         "leave density_diffusion out, or write density = \"continuity\"");
    if (*numerics.transport_velocity && numerics.shifting.given() && *numerics.shifting > 0)
        throw InputError(numerics.shifting.location,
                         "numerics.shifting and numerics.transport_velocity both spread the particles",
                         "leave one of them out");
    if (*numerics.gradient_correction)
        for (const Part* wall : scene.parts_of(PartKind::rigid))
            if (wall->slip || wall->moves())
                throw InputError(
                    first_known(scene, {&numerics.gradient_correction.location}),
                    "numerics.gradient_correction does not support walls that move or let the fluid slip, such as '" +
                        *wall->name + "'",
                    "leave out gradient_correction");
    if (*numerics.walls != WallModel::plain || (!summation && !*numerics.gradient_correction)) return;
    const std::string term = summation ? "density = \"summation\"" : "gradient_correction = true";
    throw InputError(numerics.walls.location,
                     "numerics.walls = \"plain\" integrates the density of wall particles, which numerics." + term +
                         " does not support",
                     "leave walls out, or " + (summation ? std::string("density") : "gradient_correction"));
}

/// In place of "auto".
ContactBetween chosen_contact(const Scene& scene) {
    switch (*scene.contact.between) {
        case ContactBetween::automatic:
            return scene.solidify.empty() ? ContactBetween::surfaces : ContactBetween::particles;
        case ContactBetween::surfaces:
        case ContactBetween::particles:
            return scene.contact.between;
    }
    unlisted_value(*scene.contact.between);
}

/// Friction, damping, stiffness and measures of contact are of surfaces.
void need_surfaces_for_what_they_have(const Scene& scene) {
    const auto& contact = scene.contact;
    if (chosen_contact(scene) == ContactBetween::surfaces) {
        const SourceLocation& location = contact.between.location;
        if (contact.friction > 0)
            for (const Part* wall : scene.parts_of(PartKind::rigid))
                if (wall->slides())
                    throw InputError(contact.friction.location,
                                     "contact.friction does not know how the surface of '" + *wall->name + "' slides",
                                     "leave friction out, or move the wall with velocity");
        if (!scene.solidify.empty())
            throw InputError(location, "contact.between = \"surfaces\": what a [[solidify]] makes has no drawn surface",
                             "leave it out");
        return;
    }
    for (const Measure& measure : scene.measures)
        if (*measure.kind == MeasureKind::contact)
            throw InputError(
                measure.kind.location,
                "measure '" + *measure.name + "' is of contact between surfaces, and here particles repel each other",
                "leave it out; surfaces touch in scenes without [[solidify]]");
    const auto refuse = [](const Value<double>& value, const std::string& key) {
        if (value.given() && value > 0)
            throw InputError(value.location, "contact." + key + " is of surfaces, and here particles repel each other",
                             "leave it out; surfaces touch in scenes without [[solidify]]");
    };
    refuse(contact.friction, "friction");
    refuse(contact.damping, "damping");
    refuse(contact.stiffness, "stiffness");
}

}  // namespace

void check_numerics(const Scene& scene) {
    need_surfaces_for_what_they_have(scene);
    need_what_implicit_viscosity_solves(scene);
    need_what_the_scheme_supports(scene);
    need_terms_that_go_together(scene);
}

void set_dependent_defaults(Scene& scene) {
    scene.contact.between.value = chosen_contact(scene);
    if (*scene.numerics.density == DensityModel::summation) scene.numerics.density_diffusion.value = 0;
    if (*scene.numerics.transport_velocity) scene.numerics.shifting.value = 0;
}

}  // namespace dmp::scene
