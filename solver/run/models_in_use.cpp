// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/run/models_in_use.hpp"

#include <tuple>
#include <utility>

#include "base/nearest_name.hpp"
#include "base/number_text.hpp"
#include "models/sph/viscous_laws.hpp"
#include "scene/read_scene.hpp"
#include "solver/contact/surface_contact.hpp"
#include "solver/elastic/body_parts.hpp"
#include "solver/forcing/driven.hpp"
#include "solver/forcing/driving_models.hpp"
#include "solver/run/starting_state.hpp"
#include "solver/uses.hpp"

namespace dmp::solver {

namespace {

std::string three_digits(double value) { return number_text(value, 3); }

std::string on_the_lattice(const LatticeViscosity& viscosity) {
    return "on the lattice " + three_digits(viscosity.shear) + " of the viscosity in shear, " +
           three_digits(viscosity.longitudinal) + " along";
}

/// Where the viscous law is from, and what it gives on the lattice.
std::string viscous_source(const Scene& scene, const PairSettings& settings, const ViscousScales& scales) {
    const Part& fluid = *scene.parts_of(PartKind::fluid).front();
    const bool harmonic = settings.viscosity.unlike && settings.viscosity.mean == ViscosityMean::harmonic;
    return settings.viscosity.law.visit([&]<class Law>() {
        const Law law(scales);
        return std::string(Law::facts.citation) + law.detail(fluid.viscosity / fluid.density, settings.sound_speed) +
               (harmonic ? ", harmonic mean between fluids (Cleary & Monaghan 1999)" : "") + "; " +
               on_the_lattice(law.on_lattice(scales));
    });
}

/// What binds, with which probability, when.
std::string solidify_rule_text(const Solidify& rule) {
    std::string text;
    switch (*rule.rule) {
        case SolidifyRule::per_pair:
            text = "each pair of seed and liquid";
            break;
        case SolidifyRule::per_candidate:
            text = "each liquid particle near a seed";
            break;
        case SolidifyRule::mutually_closest:
            text = "mutually closest pairs, as LAMMPS' fix bond/create";
    }
    text += " within " + three_digits(rule.reach) + " m, with probability " + three_digits(rule.probability) +
            " every " + three_digits(rule.interval) + " s";
    if (*rule.until > 0) text += " until " + three_digits(rule.until) + " s";
    if (*rule.active == SeedActivity::once) text += "; a seed acts once";
    if (*rule.active == SeedActivity::one_in) text += "; a seed acts once in " + std::to_string(*rule.one_in);
    return text + (rule.spreads ? "" : "; what turned solid is no seed");
}

std::string position_of(const Part& part) { return "part '" + part.name.value + "' at " + part.name.location.text(); }

/// What bodies of one origin (body_names) have besides bonds of one stiffness.
struct OtherSprings {
    double stiffness = 0;  ///< of the first bond [N/m]
    bool bonds = false, hinges = false, dihedrals = false;
    bool cells = false;
};

/// By number of the origin.
std::vector<OtherSprings> other_springs(const SpringBodies& springs, std::size_t origins) {
    std::vector<OtherSprings> of_origin(origins);
    for (const auto& body : springs.bodies()) {
        const BodyParts all = body->parts();
        if (body->consists_of_cells()) of_origin.at(static_cast<std::size_t>(body->origin(0))).cells = true;
        // An angle is of what its nodes are of.
        const auto of_angle = [&](const auto& angle) -> OtherSprings& {
            return of_origin.at(static_cast<std::size_t>(body->origin(static_cast<std::size_t>(angle.node[0]))));
        };
        for (const auto& bond : all.bonds) {
            OtherSprings& of = of_origin.at(static_cast<std::size_t>(bond.origin));
            if (of.stiffness == 0) of.stiffness = bond.stiffness;
            of.bonds = of.bonds || bond.stiffness != of.stiffness;
        }
        for (const auto& hinge : all.hinges) of_angle(hinge).hinges = true;
        for (const auto& four : all.dihedrals) of_angle(four).dihedrals = true;
    }
    return of_origin;
}

/// The list as it is made.
class Models {
  public:
    explicit Models(const Scene& scene) : scene_(scene) {}

    void add_fluid(const PairSettings& settings, const PairSweeps& sweeps);
    void add_what_drives();
    void add_walls();
    void add_elastic(const SpringBodies& springs);
    void add_species();
    void add_breaking(const Breaking& rule);
    void add_solidifying_and_breaking();
    void add_contact(const SurfaceContact* contact);
    void add_what_is_shown();

    [[nodiscard]] std::vector<ModelUse> list() && { return std::move(list_); }

  private:
    template <class T>
    [[nodiscard]] std::string because(const Value<T>& value, const std::string& key) const {
        return value.given() ? key + " at " + value.location.text() : key + " (" + default_origin(scene_, key) + ")";
    }
    void add(std::string model, std::string source, std::string reason) {
        list_.push_back({std::move(model), std::move(source), std::move(reason)});
    }

    const Scene& scene_;
    std::vector<ModelUse> list_;
};

void Models::add_fluid(const PairSettings& settings, const PairSweeps& sweeps) {
    const auto fluids = scene_.parts_of(PartKind::fluid);
    if (fluids.empty()) return;
    const auto& numerics = scene_.numerics;
    const std::string fluid = position_of(*fluids.front());
    const LawFacts& state = numerics.equation_of_state->facts();
    add("equation of state", std::string(state.meaning) + ": " + std::string(state.citation),
        numerics.equation_of_state.given() ? because(numerics.equation_of_state, "numerics.equation_of_state") : fluid);
    if (*numerics.background_pressure != 0)
        add("background pressure", "added to the equation of state",
            because(numerics.background_pressure, "numerics.background_pressure"));
    if (settings.density.by_summation) {
        add("summation density", "Monaghan 1992, eq. 2.9", because(numerics.density, "numerics.density"));
    } else {
        add("continuity", "Monaghan 1994, in volume form", fluid);
    }
    add("pressure force", "Bonet & Lok 1999", fluid);
    if (settings.corrected)
        add("velocity gradient", "corrected to first order: Bonet & Lok 1999, eq. 29; gives the density rate",
            because(numerics.scheme, "numerics.scheme"));
    if (settings.subtracts_level)
        add("pressure level", "mean and hydrostatic slope, subtracted in the forces",
            because(numerics.scheme, "numerics.scheme"));
    add("viscous force", viscous_source(scene_, settings, sweeps.viscous_scales()),
        numerics.viscous_law.given() ? because(numerics.viscous_law, "numerics.viscous_law")
                                     : because(fluids.front()->viscosity, "viscosity"));
    if (settings.viscosity.implicit)
        add("implicit viscosity", "backward Euler, conjugate gradients; after Weiler et al. 2018",
            because(numerics.viscosity_stepping, "numerics.viscosity_stepping"));
    if (settings.gradient_correction)
        add("gradient correction", "Bonet & Lok 1999, in antisymmetric form",
            because(numerics.gradient_correction, "numerics.gradient_correction"));
    if (settings.density.diffusion > 0)
        add("density diffusion",
            settings.corrected     ? "Antuono et al. 2010: less what a smooth density has"
            : settings.hydrostatic ? "Molteni & Colagrossi 2009, less what is hydrostatic: Fourtakas et al. 2019"
                                   : "Molteni & Colagrossi 2009",
            because(numerics.density_diffusion, "numerics.density_diffusion"));
    if (settings.shifting > 0)
        add("particle shifting",
            settings.corrected && !settings.free_surface
                ? "after Sun et al. 2017, by the speed of sound; velocity and density follow by their gradients"
            : settings.hydrostatic ? "after Sun et al. 2017; not across a free surface: Mokos et al. 2017"
                                   : "after Sun et al. 2017",
            because(numerics.shifting, "numerics.shifting"));
    if (settings.transport_velocity)
        add("transport velocity", "Adami, Hu & Adams 2013",
            because(numerics.transport_velocity, "numerics.transport_velocity"));
}

void Models::add_what_drives() {
    const auto& flow = scene_.flow;
    if (has_starting_state(scene_))
        add("starting state", "density by the inverse equation of state",
            flow.initial_velocity.given() ? because(flow.initial_velocity, "flow.initial_velocity")
                                          : because(flow.initial_pressure, "flow.initial_pressure"));
    add_driving_models(list_, scene_);
}

void Models::add_walls() {
    if (!scene_.parts_of(PartKind::rigid).empty()) {
        const std::string reason = because(scene_.numerics.walls, "numerics.walls");
        switch (*scene_.numerics.walls) {
            case WallModel::extrapolated:
                add("extrapolated walls", "Morris, Fox & Zhu 1997; Adami, Hu & Adams 2012", reason);
                break;
            case WallModel::plain:
                add("plain walls", "Monaghan 1994", reason);
                break;
        }
    }
    for (const Part* part : scene_.parts_of(PartKind::rigid)) {
        const std::string name = "'" + *part->name + "'";
        if (part->slides())
            add("sliding surface of " + name, "velocity of the wall in the viscous force",
                because(part->surface_velocity, "surface_velocity"));
        if (*part->slip) add("slip at " + name, "velocity mirrored about the surface", because(part->slip, "slip"));
        if (part->moves())
            add("prescribed motion of " + name, "integrated from its velocity and spin",
                part->velocity.given() ? because(part->velocity, "velocity") : because(part->spin, "spin"));
    }
    for (const BoxSide side : *scene_.flow.symmetry)
        add("plane of symmetry at " + to_string(side), "mirror images of all particles",
            because(scene_.flow.symmetry, "flow.symmetry"));
}

void Models::add_elastic(const SpringBodies& springs) {
    const auto parts = scene_.parts_of(PartKind::elastic);
    const std::vector<OtherSprings> others = other_springs(springs, body_names(scene_).size());
    for (std::size_t number = 0; number < parts.size(); ++number) {
        const Part& part = *parts[number];
        const std::string where = position_of(part);
        if (others[number].cells) {
            add("elastic cells", "one-point finite elements: Belytschko & Bindeman 1993, Puso 2000",
                because(part.model, "model"));
            add(to_string(*part.elastic_law), std::string(part.elastic_law->facts().citation),
                because(part.elastic_law, "elastic_law"));
        } else {
            add("bonds with dashpots", "U = k_b (r - r0)^2", where);
        }
        if (part.cross_bonds || (part.shear_stiffness.given() && others[number].bonds))
            add("cross bonds with dashpots", "U = k_c (r - r0)^2",
                part.cross_bonds ? because(part.cross_bonds, "cross_bonds")
                                 : because(part.shear_stiffness, "shear_stiffness"));
        if (others[number].hinges) add("hinges", "U = k_a (theta - theta0)^2", where);
        if (others[number].dihedrals) add("dihedrals", "U = k_d (phi - phi0)^2; Blondel & Karplus 1996", where);
        if (part.drag > 0) add("lab-frame drag", "F = -k_v v", because(part.drag, "drag"));
        if (part.mass_damping > 0)
            add("mass-proportional damping", "F = -alpha m v", because(part.mass_damping, "mass_damping"));
    }
    for (const Join* join : scene_.joins_of_enabled())
        add("bonds of '" + *join->name + "'",
            "U = k_b (r - r0)^2 between '" + (*join->parts)[0] + "' and '" + (*join->parts)[1] + "'",
            "join '" + *join->name + "' at " + join->name.location.text());
    if (scene_.may_have_elastic())
        add(springs.implicit() ? "implicit springs" : "sub-cycled springs",
            springs.implicit() ? "implicit midpoint, with the fluid's kicks: Stern & Grinspun 2009"
                               : "drift-kick-drift, many in a step of the fluid",
            because(scene_.numerics.spring_stepping, "numerics.spring_stepping"));
}

void Models::add_species() {
    for (const Species& species : scene_.species) {
        add("diffusion of '" + *species.name + "'", "Cleary & Monaghan 1999, harmonic mean where diffusivities meet",
            "species at " + species.name.location.text());
        const auto takers = scene_.takers_of(species);
        if (!takers.empty())
            add("uptake of '" + *species.name + "'", "first order, exponential Euler: Cox & Matthews 2002",
                "species." + *species.name + ".uptake at " + species.uptake_in(*takers.front())->location.text());
    }
    if (!scene_.species.empty() && *scene_.numerics.species_stepping == SpeciesStepping::implicitly)
        add("implicit diffusion", "backward Euler, conjugate gradients",
            because(scene_.numerics.species_stepping, "numerics.species_stepping"));
}

void Models::add_breaking(const Breaking& rule) {
    const Part* part = scene_.part_named(*rule.part);
    const bool of_cells = part != nullptr && scene_.is_of_cells(*part);
    const std::string limit = rule.force_above > 0    ? "2 k_b (r - r0) > " + three_digits(rule.force_above) + " N"
                              : rule.stress_above > 0 ? "principal tension > " + three_digits(rule.stress_above) + " Pa"
                                                      : (of_cells ? "principal strain > " : "(r - r0) / r0 > ") +
                                                            three_digits(rule.strain_above);
    add((of_cells ? "breaking faces of '" : "breaking bonds of '") + *rule.part + "'", limit,
        "break '" + *rule.name + "' at " + rule.name.location.text());
}

void Models::add_solidifying_and_breaking() {
    for (const Solidify& rule : scene_.solidify) {
        add("liquid turning solid as '" + *rule.name + "'", solidify_rule_text(rule),
            "solidify '" + *rule.name + "' at " + rule.name.location.text());
        add("bonds of '" + *rule.name + "'",
            "U = k_b (r - r0)^2, r0 " + (*rule.rest_length > 0 ? three_digits(rule.rest_length) + " m"
                                                               : std::string("the distance when a bond is made")),
            because(rule.bond_stiffness, "bond_stiffness"));
    }
    for (const Breaking& rule : scene_.breaking) add_breaking(rule);
}

void Models::add_contact(const SurfaceContact* contact) {
    if (*scene_.contact.range == 0) return;
    const bool has_solids = !scene_.parts_of(PartKind::rigid).empty() || scene_.may_have_elastic();
    const bool has_fluid = !scene_.parts_of(PartKind::fluid).empty();
    if (has_solids && (contact == nullptr || has_fluid))
        add("short-range repulsion",
            std::string("Monaghan 1994, cut at r*") + (contact != nullptr          ? "; of liquid and solids"
                                                       : scene_.may_have_elastic() ? "; of a body with itself, too"
                                                                                   : ""),
            because(scene_.contact.range, "contact.range"));
    if (contact == nullptr) return;
    std::string stiffness;
    for (const auto& [part, value] : contact->stiffness_of_parts())
        stiffness += (stiffness.empty() ? "" : ", ") + three_digits(value) + " Pa/m of '" + part + "'";
    add("contact of surfaces",
        "p = k depth at Gauss points of both, " + stiffness +
            (*scene_.contact.friction > 0 ? "; friction " + three_digits(scene_.contact.friction) : ""),
        because(scene_.contact.between, "contact.between"));
}

void Models::add_what_is_shown() {
    if (scene_.asks_for(FluidField::residence_time) && !scene_.regions.empty())
        add("residence times", "time in each region",
            "'residence_time' asked for, or waited for by a solidify; region '" + *scene_.regions.front().name +
                "' at " + scene_.regions.front().name.location.text());
    if (scene_.asks_for(SolidField::mean_displacement) && !scene_.parts_of(PartKind::elastic).empty())
        add("mean displacement", "average over time", because(scene_.output.average_from, "output.average_from"));
}

}  // namespace

std::vector<ModelUse> models_in_use(const Scene& scene, const PairSettings& settings, const PairSweeps& sweeps,
                                    const SpringBodies& springs, const SurfaceContact* contact) {
    Models models(scene);
    if (is_at_rest(scene)) {
        models.add_species();
        models.add_what_is_shown();
        return std::move(models).list();
    }
    models.add_fluid(settings, sweeps);
    models.add_what_drives();
    models.add_walls();
    models.add_elastic(springs);
    models.add_species();
    models.add_contact(contact);
    models.add_solidifying_and_breaking();
    models.add_what_is_shown();
    return std::move(models).list();
}

}  // namespace dmp::solver
