// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/run/models_in_use.hpp"

#include <iomanip>
#include <sstream>
#include <tuple>
#include <utility>

#include "base/nearest_name.hpp"
#include "models/sph/lattice_viscosity.hpp"
#include "models/sph/monaghan_viscosity.hpp"
#include "scene/read_scene.hpp"
#include "solver/elastic/body_parts.hpp"
#include "solver/forcing/driving_models.hpp"
#include "solver/run/starting_state.hpp"
#include "solver/uses.hpp"

namespace dmp::solver {

namespace {

std::string three_digits(double value) {
    std::ostringstream text;
    text << std::setprecision(3) << value;
    return text.str();
}

std::string on_the_lattice(const LatticeViscosity& viscosity) {
    return "on the lattice " + three_digits(viscosity.shear) + " of the viscosity in shear, " +
           three_digits(viscosity.longitudinal) + " along";
}

/// Where the viscous law is from, and what it really gives.
std::string viscous_source(const Scene& scene, const PairSettings& settings, const PairSweeps& sweeps) {
    const auto slope = [&](double r) { return sweeps.kernel_slope(r); };
    const int dimension = scene.dimension;
    if (settings.viscous_force != ViscousForce::monaghan)
        return std::string("Morris, Fox & Zhu 1997, eq. 22") +
               (settings.viscous_force == ViscousForce::morris_harmonic
                    ? ", harmonic mean between fluids (Cleary & Monaghan 1999); "
                    : "; ") +
               on_the_lattice(lattice_viscosity_of_morris(dimension, settings.spacing, settings.support, slope));
    const Part& fluid = *scene.parts_of(PartKind::fluid).front();
    const double alpha =
        MonaghanViscosity<2>(settings.support, settings.approaching_pairs_only, settings.arithmetic_viscosity)
            .alpha(fluid.viscosity / fluid.density, settings.support, settings.sound_speed) *
        (dimension + 2) / 4;
    return std::string("Monaghan & Gingold 1983, ") +
           (settings.approaching_pairs_only ? "approaching pairs only" : "all pairs") +
           ", alpha = " + three_digits(alpha) + "; " +
           on_the_lattice(lattice_viscosity_of_monaghan(dimension, settings.spacing, settings.support, slope));
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
    if (*rule.active == SeedActivity::once) text += "; a seed acts once";
    if (*rule.active == SeedActivity::one_in) text += "; a seed acts once in " + std::to_string(*rule.one_in);
    return text + (rule.spreads ? "" : "; what turned solid is no seed");
}

std::string place_of(const Part& part) { return "part '" + part.name.value + "' at " + part.name.place.text(); }

/// What the springs of one origin (body_names) are besides bonds of one stiffness.
struct OtherSprings {
    double stiffness = 0;  ///< of the first bond [N/m]
    bool bonds = false, hinges = false, dihedrals = false;
};

/// By number of the origin.
std::vector<OtherSprings> other_springs(const SpringBodies& springs, std::size_t origins) {
    std::vector<OtherSprings> of_origin(origins);
    for (const auto& body : springs.bodies()) {
        const BodyParts all = body->parts();
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
    void add_springs(const SpringBodies& springs);
    void add_species();
    void add_solidifying_and_breaking();
    void add_what_is_shown();

    [[nodiscard]] std::vector<ModelUse> list() && { return std::move(list_); }

  private:
    template <class T>
    [[nodiscard]] std::string because(const Value<T>& value, const std::string& key) const {
        return value.given() ? key + " at " + value.place.text() : key + " (" + default_origin(scene_, key) + ")";
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
    const auto& accuracy = scene_.accuracy;
    const std::string fluid = place_of(*fluids.front());
    const bool tait = *accuracy.equation_of_state == EquationOfState::tait;
    add(tait ? "Tait equation of state" : "linear equation of state",
        tait ? "Monaghan 1994" : "Morris, Fox & Zhu 1997, eq. 8",
        accuracy.equation_of_state.given() ? because(accuracy.equation_of_state, "accuracy.equation_of_state") : fluid);
    if (*accuracy.background_pressure != 0)
        add("background pressure", "added to the equation of state",
            because(accuracy.background_pressure, "accuracy.background_pressure"));
    if (settings.density_by_summation) {
        add("summation density", "Monaghan 1992, eq. 2.9", because(accuracy.density, "accuracy.density"));
    } else {
        add("continuity", "Monaghan 1994, in volume form", fluid);
    }
    add("pressure force", "Bonet & Lok 1999", fluid);
    add("viscous force", viscous_source(scene_, settings, sweeps),
        settings.viscous_force == ViscousForce::monaghan ? because(accuracy.viscous_law, "accuracy.viscous_law")
                                                         : because(fluids.front()->viscosity, "viscosity"));
    if (settings.implicit_viscosity)
        add("implicit viscosity", "backward Euler, conjugate gradients; after Weiler et al. 2018",
            because(accuracy.viscosity_stepping, "accuracy.viscosity_stepping"));
    if (settings.gradient_correction)
        add("gradient correction", "Bonet & Lok 1999, in antisymmetric form",
            because(accuracy.gradient_correction, "accuracy.gradient_correction"));
    if (settings.density_diffusion > 0)
        add("density diffusion",
            settings.stratified ? "Molteni & Colagrossi 2009, less what is hydrostatic: Fourtakas et al. 2019"
                                : "Molteni & Colagrossi 2009",
            because(accuracy.density_diffusion, "accuracy.density_diffusion"));
    if (settings.shifting > 0)
        add("particle shifting",
            settings.stratified ? "after Sun et al. 2017; not across a free surface: Mokos et al. 2017"
                                : "after Sun et al. 2017",
            because(accuracy.shifting, "accuracy.shifting"));
    if (settings.transport_velocity)
        add("transport velocity", "Adami, Hu & Adams 2013",
            because(accuracy.transport_velocity, "accuracy.transport_velocity"));
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
    const bool plain = *scene_.accuracy.walls == WallModel::plain;
    if (!scene_.parts_of(PartKind::rigid).empty())
        add(plain ? "plain walls" : "extrapolated no-slip walls",
            plain ? "Monaghan 1994" : "Morris, Fox & Zhu 1997; Adami, Hu & Adams 2012",
            because(scene_.accuracy.walls, "accuracy.walls"));
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
        add("plane of symmetry at " + word(side), "mirror images of all particles",
            because(scene_.flow.symmetry, "flow.symmetry"));
}

void Models::add_springs(const SpringBodies& springs) {
    const auto parts = scene_.parts_of(PartKind::springs);
    const std::vector<OtherSprings> others = other_springs(springs, body_names(scene_).size());
    for (std::size_t number = 0; number < parts.size(); ++number) {
        const Part& part = *parts[number];
        const std::string where = place_of(part);
        add("bonds with dashpots", "U = k_b (r - r0)^2", where);
        if (part.cross_bonds || (part.shear_stiffness.given() && others[number].bonds))
            add("cross bonds with dashpots", "U = k_c (r - r0)^2",
                part.cross_bonds ? because(part.cross_bonds, "cross_bonds")
                                 : because(part.shear_stiffness, "shear_stiffness"));
        if (others[number].hinges) add("hinges", "U = k_a (theta - theta0)^2", where);
        if (others[number].dihedrals) add("dihedrals", "U = k_d (phi - phi0)^2; Blondel & Karplus 1996", where);
        if (part.drag > 0) add("lab-frame drag", "F = -k_v v", because(part.drag, "drag"));
    }
    for (const Join* join : scene_.joins_of_enabled())
        add("bonds of '" + *join->name + "'",
            "U = k_b (r - r0)^2 between '" + (*join->parts)[0] + "' and '" + (*join->parts)[1] + "'",
            "join '" + *join->name + "' at " + join->name.place.text());
    if (scene_.may_have_springs())
        add(springs.implicit() ? "implicit springs" : "sub-cycled springs",
            springs.implicit() ? "implicit midpoint, with the fluid's kicks: Stern & Grinspun 2009"
                               : "drift-kick-drift, many in a step of the fluid",
            because(scene_.accuracy.spring_stepping, "accuracy.spring_stepping"));
}

void Models::add_species() {
    for (const Species& species : scene_.species)
        add("diffusion of '" + *species.name + "'", "Cleary & Monaghan 1999, harmonic mean where diffusivities meet",
            "species at " + species.name.place.text());
    if (!scene_.species.empty() && *scene_.accuracy.species_stepping == SpeciesStepping::implicitly)
        add("implicit diffusion", "backward Euler, conjugate gradients",
            because(scene_.accuracy.species_stepping, "accuracy.species_stepping"));
}

void Models::add_solidifying_and_breaking() {
    for (const Solidify& rule : scene_.solidify) {
        add("liquid turning solid as '" + *rule.name + "'", solidify_rule_text(rule),
            "solidify '" + *rule.name + "' at " + rule.name.place.text());
        add("bonds of '" + *rule.name + "'",
            "U = k_b (r - r0)^2, r0 " + (*rule.rest_length > 0 ? three_digits(rule.rest_length) + " m"
                                                               : std::string("the distance when a bond is made")),
            because(rule.bond_stiffness, "bond_stiffness"));
    }
    for (const Breaking& rule : scene_.breaking)
        add("breaking bonds of '" + *rule.part + "'",
            rule.force_above > 0 ? "2 k_b (r - r0) > " + three_digits(rule.force_above) + " N"
                                 : "(r - r0) / r0 > " + three_digits(rule.strain_above),
            "break '" + *rule.name + "' at " + rule.name.place.text());
    const bool has_solids = !scene_.parts_of(PartKind::rigid).empty() || scene_.may_have_springs();
    if (scene_.contact.range > 0 && has_solids)
        add("short-range repulsion",
            std::string("Monaghan 1994, cut at r*") + (scene_.may_have_springs() ? "; of a body with itself, too" : ""),
            because(scene_.contact.range, "contact.range"));
}

void Models::add_what_is_shown() {
    if (scene_.asks_for(FluidField::residence_time) && !scene_.regions.empty())
        add("residence times", "time in each region",
            "'residence_time' asked for, or waited for by a solidify; region '" + *scene_.regions.front().name +
                "' at " + scene_.regions.front().name.place.text());
    if (scene_.asks_for(SolidField::mean_displacement) && !scene_.parts_of(PartKind::springs).empty())
        add("mean displacement", "average over time", because(scene_.output.average_from, "output.average_from"));
}

}  // namespace

std::vector<ModelUse> models_in_use(const Scene& scene, const PairSettings& settings, const PairSweeps& sweeps,
                                    const SpringBodies& springs) {
    Models models(scene);
    models.add_fluid(settings, sweeps);
    models.add_what_drives();
    models.add_walls();
    models.add_springs(springs);
    models.add_species();
    models.add_solidifying_and_breaking();
    models.add_what_is_shown();
    return std::move(models).list();
}

}  // namespace dmp::solver
