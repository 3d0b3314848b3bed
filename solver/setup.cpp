// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/setup.hpp"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>
#include <tuple>

#include <omp.h>

#include "base/nearest_name.hpp"
#include "scene/read_scene.hpp"
#include "solver/free_surface.hpp"
#include "solver/models/contact/repulsion.hpp"
#include "solver/models/sph/lattice_viscosity.hpp"
#include "solver/models/sph/monaghan_viscosity.hpp"
#include "solver/starting_state.hpp"

namespace dmp {

namespace {

/// Harmonic means are worked out only where they differ from the sum.
bool has_unlike_viscosities(const Scene& scene) {
    const auto fluids = scene.parts_of(PartKind::fluid);
    return std::any_of(fluids.begin(), fluids.end(),
                       [&](const Part* part) { return *part->viscosity != *fluids.front()->viscosity; });
}

ViscousForce viscous_force(const Scene& scene) {
    if (*scene.accuracy.viscous_law != ViscousLaw::morris) return ViscousForce::monaghan;
    const bool harmonic = *scene.accuracy.viscosity_mean == ViscosityMean::harmonic;
    return harmonic && has_unlike_viscosities(scene) ? ViscousForce::morris_harmonic : ViscousForce::morris;
}

template <class T>
std::string because(const Value<T>& value, const std::string& key) {
    return value.given() ? key + " at " + value.place.text() : key + " (default)";
}

std::string three_digits(double value) {
    std::ostringstream text;
    text << std::setprecision(3) << value;
    return text.str();
}

std::string on_the_lattice(const LatticeViscosity& viscosity) {
    return "on the lattice " + three_digits(viscosity.shear) + " of the viscosity in shear, " +
           three_digits(viscosity.longitudinal) + " along";
}

/// The viscous law with what it really gives.
ModelUse viscous_model(const Scene& scene, const PairSettings& settings, const PairSweeps& sweeps) {
    const Part& fluid = *scene.parts_of(PartKind::fluid).front();
    const auto slope = [&](double r) { return sweeps.kernel_slope(r); };
    const int dimension = scene.dimension;
    if (settings.viscous_force == ViscousForce::monaghan) {
        const LatticeViscosity found =
            lattice_viscosity_of_monaghan(dimension, settings.spacing, settings.support, slope);
        const double alpha =
            MonaghanViscosity<2>(settings.support, settings.approaching_pairs_only, settings.arithmetic_viscosity)
                .alpha(fluid.viscosity / fluid.density, settings.support, settings.sound_speed) *
            (dimension + 2) / 4;
        return {"viscous force",
                std::string("Monaghan & Gingold 1983, ") +
                    (settings.approaching_pairs_only ? "approaching pairs only" : "all pairs") +
                    ", alpha = " + three_digits(alpha) + "; " + on_the_lattice(found),
                because(scene.accuracy.viscous_law, "accuracy.viscous_law")};
    }
    const LatticeViscosity found = lattice_viscosity_of_morris(dimension, settings.spacing, settings.support, slope);
    const bool harmonic = settings.viscous_force == ViscousForce::morris_harmonic;
    return {"viscous force",
            std::string("Morris, Fox & Zhu 1997, eq. 22") +
                (harmonic ? ", harmonic mean between fluids (Cleary & Monaghan 1999); " : "; ") + on_the_lattice(found),
            because(fluid.viscosity, "viscosity")};
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

double largest_density(const Scene& scene) {
    double largest = 0;
    for (const Part* part : scene.parts_of(PartKind::fluid)) largest = std::max(largest, part->density.value);
    return largest;
}

}  // namespace

double sound_speed(const Scene& scene) {
    return scene.accuracy.sound_speed > 0 ? scene.accuracy.sound_speed.value
                                          : scene.flow.largest_speed / scene.accuracy.mach_number;
}

PairSettings pair_settings(const Scene& scene, const Resources& resources) {
    PairSettings settings;
    settings.kernel = scene.accuracy.kernel;
    settings.walls = scene.accuracy.walls;
    settings.viscous_force = viscous_force(scene);
    settings.approaching_pairs_only = *scene.accuracy.viscous_law == ViscousLaw::monaghan_approaching;
    settings.arithmetic_viscosity = *scene.accuracy.viscosity_mean == ViscosityMean::arithmetic;
    settings.spacing = scene.particles.spacing;
    settings.support = scene.accuracy.support * scene.particles.spacing;
    settings.sound_speed = sound_speed(scene);
    settings.background_pressure = scene.accuracy.background_pressure;
    settings.density_by_summation = *scene.accuracy.density == DensityModel::summation;
    settings.gradient_correction = scene.accuracy.gradient_correction;
    settings.transport_velocity = scene.accuracy.transport_velocity;
    settings.density_diffusion = settings.density_by_summation ? 0 : scene.accuracy.density_diffusion.value;
    settings.shifting = settings.transport_velocity ? 0 : scene.accuracy.shifting.value;
    settings.density = largest_density(scene);
    for (const Part* part : scene.parts_of(PartKind::fluid))
        settings.viscosity = std::max(settings.viscosity, part->viscosity.value);
    if (scene.contact.range > 0) {
        const double range = scene.contact.range * scene.particles.spacing;
        // Automatic strength: a small part of the fluid's energy rho c0^2 r*^3, in the plane rho c0^2 r*^2 on 1 m of
        // depth. At 0.9 r* it then pushes like a pressure of 0.003 rho c0^2, which a Mach number of 0.1 does not
        // exceed, and at touch it does not rule the step.
        const double depth = *scene.dimension == 3 ? range : 1;
        settings.repulsion_strength = scene.contact.strength > 0 ? scene.contact.strength.value
                                                                 : 0.002 * settings.density * settings.sound_speed *
                                                                       settings.sound_speed * range * range * depth;
    }
    settings.implicit_viscosity =
        *scene.accuracy.viscosity_stepping == ViscosityStepping::implicitly && settings.viscosity > 0;
    for (std::size_t axis = 0; axis < 3; ++axis) settings.periodic[axis] = scene.flow.periodic[axis];
    for (const Part* part : scene.parts_of(PartKind::rigid)) {
        settings.slip_walls = settings.slip_walls || part->slip;
        settings.moving_walls = settings.moving_walls || part->moves();
    }
    settings.threads = resources.threads > 0 ? resources.threads : omp_get_num_procs();
    settings.vector_unit = resources.vector_unit;
    return settings;
}

PairSettings pair_settings(const Scene& scene, const ParticleSet& set, const Resources& resources) {
    PairSettings settings = pair_settings(scene, resources);
    for (int axis = 0; axis < set.dimension; ++axis) {
        const Expression& g = scene.flow.acceleration[axis];
        if (!set.periodic[axis] && !set.is_mirrored(axis) && !g.is_zero()) settings.stratified = true;
    }
    if (!settings.stratified) settings.stratified = has_free_surface(set, settings.threads);
    return settings;
}

std::vector<LiquidState> equations_of_state(const Scene& scene, const ParticleSpace& space) {
    const auto fluids = scene.parts_of(PartKind::fluid);
    const double first_density = fluids.empty() ? 1 : fluids.front()->density.value;
    std::vector<LiquidState> equations;
    for (const auto& part : space.parts) {
        const bool is_fluid = part.kind == ParticleKind::fluid;
        equations.push_back({sound_speed(scene),
                             is_fluid ? scene.part_of_particles(part.name).density.value : first_density,
                             scene.accuracy.background_pressure, scene.accuracy.equation_of_state});
    }
    return equations;
}

std::vector<double> rest_densities(const Scene& scene, const ParticleSet& set) {
    std::vector<double> densities;
    for (const LiquidState& state : equations_of_state(scene, set)) densities.push_back(state.rest_density);
    return densities;
}

void fill_store(const Scene& scene, const ParticleSet& set, ParticleStore& particles) {
    const std::vector<double> densities = rest_densities(scene, set);
    std::vector<double> viscosities, slips;
    for (const auto& part : set.parts) {
        slips.push_back(part.kind == ParticleKind::rigid && scene.part_of_particles(part.name).slip ? 1 : 0);
        viscosities.push_back(part.kind == ParticleKind::fluid ? scene.part_of_particles(part.name).viscosity.value
                                                               : 0);
    }
    const double range = scene.contact.range * scene.particles.spacing;
    for (ParticleGroup& group : particles.groups()) {
        const auto fill = [&](Field field, int axis, const auto& value_of) {
            if (!group.has(field)) return;
            for (std::size_t i = 0; i < group.owned(); ++i)
                group.data(field, axis)[i] =
                    value_of(group.tags()[i].part, static_cast<std::size_t>(group.tags()[i].id));
        };
        fill(Field::density, 0, [&](std::size_t part, std::size_t) { return densities[part]; });
        fill(Field::viscosity, 0, [&](std::size_t part, std::size_t) { return viscosities[part]; });
        fill(Field::contact_range, 0, [&](std::size_t, std::size_t) { return range; });
        fill(Field::wall_contact_range, 0, [&](std::size_t, std::size_t id) { return set.seated[id] ? 0 : range; });
        fill(Field::wall_distance, 0, [&](std::size_t, std::size_t id) { return set.wall_distance[id]; });
        fill(Field::wall_slip, 0, [&](std::size_t part, std::size_t) { return slips[part]; });
        for (int axis = 0; axis < set.dimension; ++axis) {
            for (const Field normal : {Field::wall_normal, Field::drawn_normal})
                fill(normal, axis, [&](std::size_t, std::size_t id) { return set.wall_normal[id][axis]; });
            fill(Field::drawn_position, axis, [&](std::size_t, std::size_t id) { return set.position[id][axis]; });
        }
    }
    fill_starting_density(scene, set, equations_of_state(scene, set), particles);
}

StepScales step_scales(const Scene& scene, const ParticleSet& set, const PairSettings& settings, double viscous_limit) {
    StepScales scales;
    scales.support = settings.support;
    scales.sound_speed = settings.sound_speed;
    scales.viscous_limit = viscous_limit;
    scales.step_factor = scene.accuracy.step_factor;
    scales.shifting = settings.shifting;
    scales.implicit_viscosity = settings.implicit_viscosity;
    for (const Part* part : scene.parts_of(PartKind::fluid))
        scales.kinematic_viscosity = std::max(scales.kinematic_viscosity, part->viscosity / part->density);
    scales.implicit_species = *scene.accuracy.species_stepping == SpeciesStepping::implicitly;
    for (const Species& species : scene.species)
        for (const Part& part : scene.parts)
            if (const Value<double>* diffusivity = species.diffusivity_in(part);
                diffusivity != nullptr && *part.enabled)
                scales.diffusivity = std::max(scales.diffusivity, **diffusivity);
    if (settings.repulsion_strength > 0 && set.size() > 0) {
        const double lightest = *std::min_element(set.mass.begin(), set.mass.end());
        const double range = scene.contact.range * scene.particles.spacing;
        scales.contact_limit = Repulsion{settings.repulsion_strength}.step_limit(range, lightest);
    }
    return scales;
}

double new_bond_limit(const Scene& scene, const Solidify& rule) {
    const double mass =
        scene.part_of_particles(rule.liquid).density * std::pow(scene.particles.spacing, scene.dimension);
    return 2 / std::sqrt(2 * rule.bond_stiffness / (mass / 2));
}

void add_driving_models(std::vector<ModelUse>& models, const Scene& scene) {
    for (const ForceOnPart& force : scene.forces)
        models.push_back({"force on '" + *force.part + "'",
                          *force.amount == ForceAmount::total ? "total, spread evenly over its particles"
                                                              : "on each of its particles",
                          "force '" + *force.name + "' at " + force.name.place.text()});
    for (const MovingShape& shape : scene.moving_shapes)
        models.push_back({"moving " + word(*shape.kind),
                          "f = K (1 + cos(pi d / r*)), felt by " + quoted_list(*shape.parts),
                          "moving_shape '" + *shape.name + "' at " + shape.name.place.text()});
}

std::vector<ModelUse> models_in_use(const Scene& scene, const PairSettings& settings, const PairSweeps& sweeps) {
    const auto because = [&](const auto& value, const std::string& key) {
        return value.given() ? key + " at " + value.place.text() : key + " (" + default_origin(scene, key) + ")";
    };
    std::vector<ModelUse> models;
    const auto fluids = scene.parts_of(PartKind::fluid);
    if (!fluids.empty()) {
        const std::string fluid = "part '" + fluids.front()->name.value + "' at " + fluids.front()->name.place.text();
        const bool tait = *scene.accuracy.equation_of_state == EquationOfState::tait;
        models.push_back({tait ? "Tait equation of state" : "linear equation of state",
                          tait ? "Monaghan 1994" : "Morris, Fox & Zhu 1997, eq. 8",
                          scene.accuracy.equation_of_state.given()
                              ? because(scene.accuracy.equation_of_state, "accuracy.equation_of_state")
                              : fluid});
        if (*scene.accuracy.background_pressure != 0)
            models.push_back({"background pressure", "added to the equation of state",
                              because(scene.accuracy.background_pressure, "accuracy.background_pressure")});
        if (settings.density_by_summation)
            models.push_back(
                {"summation density", "Monaghan 1992, eq. 2.9", because(scene.accuracy.density, "accuracy.density")});
        else
            models.push_back({"continuity", "Monaghan 1994, in volume form", fluid});
        models.push_back({"pressure force", "Bonet & Lok 1999", fluid});
        models.push_back(viscous_model(scene, settings, sweeps));
        if (settings.implicit_viscosity)
            models.push_back({"implicit viscosity", "backward Euler, conjugate gradients; after Weiler et al. 2018",
                              because(scene.accuracy.viscosity_stepping, "accuracy.viscosity_stepping")});
        if (settings.gradient_correction)
            models.push_back({"gradient correction", "Bonet & Lok 1999, in antisymmetric form",
                              because(scene.accuracy.gradient_correction, "accuracy.gradient_correction")});
        if (settings.density_diffusion > 0)
            models.push_back({"density diffusion",
                              settings.stratified ? "Molteni & Colagrossi 2009, less what is hydrostatic: Fourtakas "
                                                    "et al. 2019"
                                                  : "Molteni & Colagrossi 2009",
                              because(scene.accuracy.density_diffusion, "accuracy.density_diffusion")});
        if (settings.shifting > 0)
            models.push_back({"particle shifting",
                              settings.stratified
                                  ? "after Sun et al. 2017; not across a free surface: Mokos et al. 2017"
                                  : "after Sun et al. 2017",
                              because(scene.accuracy.shifting, "accuracy.shifting")});
        if (settings.transport_velocity)
            models.push_back({"transport velocity", "Adami, Hu & Adams 2013",
                              because(scene.accuracy.transport_velocity, "accuracy.transport_velocity")});
    }
    if (has_starting_state(scene)) {
        const bool moves = scene.flow.initial_velocity.given();
        models.push_back({"starting state", "density by the inverse equation of state",
                          moves ? because(scene.flow.initial_velocity, "flow.initial_velocity")
                                : because(scene.flow.initial_pressure, "flow.initial_pressure")});
    }
    for (const Expression& axis : scene.flow.acceleration)
        if (!axis.is_zero()) {
            models.push_back({"body acceleration", axis.text(), "flow.acceleration"});
        }
    add_driving_models(models, scene);
    if (!scene.parts_of(PartKind::rigid).empty())
        models.push_back({scene.accuracy.walls == WallModel::plain ? "plain walls" : "extrapolated no-slip walls",
                          scene.accuracy.walls == WallModel::plain ? "Monaghan 1994"
                                                                   : "Morris, Fox & Zhu 1997; Adami, Hu & Adams 2012",
                          because(scene.accuracy.walls, "accuracy.walls")});
    for (const Part* part : scene.parts_of(PartKind::rigid))
        for (const auto& [used, model, source, reason] :
             {std::tuple{part->slides(), "sliding surface of '", "velocity of the wall in the viscous force",
                         because(part->surface_velocity, "surface_velocity")},
              std::tuple{part->slip.value, "slip at '", "velocity mirrored about the surface",
                         because(part->slip, "slip")},
              std::tuple{part->moves(), "prescribed motion of '", "integrated from its velocity and spin",
                         part->velocity.given() ? because(part->velocity, "velocity") : because(part->spin, "spin")}})
            if (used) models.push_back({model + *part->name + "'", source, reason});
    for (const BoxSide side : *scene.flow.symmetry)
        models.push_back({"plane of symmetry at " + word(side), "mirror images of all particles",
                          because(scene.flow.symmetry, "flow.symmetry")});
    for (const Part* part : scene.parts_of(PartKind::springs)) {
        const std::string where = "part '" + part->name.value + "' at " + part->name.place.text();
        models.push_back({"bonds with dashpots", "U = k_b (r - r0)^2", where});
        if (part->cross_bonds) {
            models.push_back(
                {"cross bonds with dashpots", "U = k_c (r - r0)^2", because(part->cross_bonds, "cross_bonds")});
        } else {
            models.push_back({"hinges", "U = k_a (theta - theta0)^2", where});
        }
        if (part->drag > 0) models.push_back({"lab-frame drag", "F = -k_v v", because(part->drag, "drag")});
    }
    for (const Species& species : scene.species)
        models.push_back({"diffusion of '" + *species.name + "'",
                          "Cleary & Monaghan 1999, harmonic mean where diffusivities meet",
                          "species at " + species.name.place.text()});
    if (!scene.species.empty() && *scene.accuracy.species_stepping == SpeciesStepping::implicitly)
        models.push_back({"implicit diffusion", "backward Euler, conjugate gradients",
                          because(scene.accuracy.species_stepping, "accuracy.species_stepping")});
    for (const Solidify& rule : scene.solidify) {
        models.push_back({"liquid turning solid as '" + *rule.name + "'", solidify_rule_text(rule),
                          "solidify '" + *rule.name + "' at " + rule.name.place.text()});
        models.push_back(
            {"bonds of '" + *rule.name + "'",
             "U = k_b (r - r0)^2, r0 " + (*rule.rest_length > 0 ? three_digits(rule.rest_length) + " m"
                                                                : std::string("the distance when a bond is made")),
             because(rule.bond_stiffness, "bond_stiffness")});
    }
    for (const Breaking& rule : scene.breaking)
        models.push_back({"breaking bonds of '" + *rule.part + "'",
                          rule.force_above > 0 ? "2 k_b (r - r0) > " + three_digits(rule.force_above) + " N"
                                               : "(r - r0) / r0 > " + three_digits(rule.strain_above),
                          "break '" + *rule.name + "' at " + rule.name.place.text()});
    const bool has_solids = !scene.parts_of(PartKind::rigid).empty() || scene.may_have_springs();
    if (scene.contact.range > 0 && has_solids)
        models.push_back(
            {"short-range repulsion", "Monaghan 1994, cut at r*", because(scene.contact.range, "contact.range")});
    if (scene.asks_for(FluidField::residence_time) && !scene.regions.empty())
        models.push_back({"residence times", "time in each region",
                          "'residence_time' asked for, or waited for by a solidify; region '" +
                              *scene.regions.front().name + "' at " + scene.regions.front().name.place.text()});
    if (scene.asks_for(SolidField::mean_displacement) && !scene.parts_of(PartKind::springs).empty())
        models.push_back(
            {"mean displacement", "average over time", because(scene.output.average_from, "output.average_from")});
    return models;
}

}  // namespace dmp
