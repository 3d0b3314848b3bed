// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/run/setup.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <omp.h>

#include "base/errors.hpp"
#include "base/unlisted_value.hpp"
#include "models/contact/repulsion.hpp"
#include "scene/checks.hpp"
#include "solver/elastic/node_mass.hpp"
#include "solver/forcing/drive_time.hpp"
#include "solver/forcing/driven.hpp"
#include "solver/run/closed_chambers.hpp"
#include "solver/run/free_surface.hpp"
#include "solver/run/sound_speed.hpp"
#include "solver/run/starting_state.hpp"

namespace dmp::solver {

namespace {

/// Harmonic means are worked out only where they differ from the sum.
bool has_unlike_viscosities(const Scene& scene) {
    const auto fluids = scene.parts_of(PartKind::fluid);
    return std::any_of(fluids.begin(), fluids.end(),
                       [&](const Part* part) { return *part->viscosity != *fluids.front()->viscosity; });
}

bool are_alike(const Part& a, const Part& b) { return *a.viscosity == *b.viscosity && *a.density == *b.density; }

bool has_unlike_fluids(const Scene& scene) {
    const auto fluids = scene.parts_of(PartKind::fluid);
    return std::ranges::any_of(fluids, [&](const Part* part) { return !are_alike(*part, *fluids.front()); });
}

/// By part: the number of the first fluid part that is alike.
std::vector<double> fluid_numbers(const Scene& scene, const ParticleSet& set) {
    std::vector<double> numbers;
    for (const auto& part : set.parts) {
        double number = 0;
        if (part.kind == PartKind::fluid)
            for (const Part* fluid : scene.parts_of(PartKind::fluid)) {
                if (are_alike(*fluid, scene.part_of_particles(part.name))) break;
                ++number;
            }
        numbers.push_back(number);
    }
    return numbers;
}

/// Least mass of a free elastic node over that of the liquid in its place, at most 1.
double lightest_solid(const Scene& scene, const ParticleSet& set, const PairSettings& settings) {
    const std::vector<double> mass = node_masses(scene, set, liquid_in_leaflets(settings));
    double least = 1;
    for (std::size_t i = 0; i < set.size(); ++i)
        if (set.kind(i) == PartKind::elastic && !set.fixed[i])
            least = std::min(least, mass[i] / (settings.density.largest * set.volume[i]));
    return least;
}

double largest_density(const Scene& scene) {
    double largest = 0;
    for (const Part* part : scene.parts_of(PartKind::fluid)) largest = std::max(largest, part->density.value);
    return largest;
}

double density_ratio(const Scene& scene) {
    return scene.parts_of(PartKind::fluid).empty() ? 1 : largest_density(scene) / lightest_density(scene);
}

/// Nothing moves that can change the fluid's volume. A solid that borders on nothing can give way, and the liquid of a
/// closed chamber with it; through a periodic side liquid goes on, and its mean pressure is the scene's.
bool keeps_volume(const Scene& scene, const PairSettings& settings) {
    const bool is_open = std::ranges::count(settings.periodic, true) > 0;
    return !settings.walls.moving && scene.moving_shapes.empty() && (!settings.dry_bodies || is_open);
}

bool is_by_summation(DensityModel density) {
    switch (density) {
        case DensityModel::continuity:
            return false;
        case DensityModel::summation:
            return true;
    }
    unlisted_value(density);
}

bool is_implicit(ViscosityStepping stepping) {
    switch (stepping) {
        case ViscosityStepping::explicitly:
            return false;
        case ViscosityStepping::implicitly:
            return true;
    }
    unlisted_value(stepping);
}

}  // namespace

double sound_speed(const Scene& scene) {
    return scene.numerics.sound_speed > 0 ? scene.numerics.sound_speed.value
                                          : scene.flow.largest_speed / scene.numerics.mach_number;
}

PairSettings pair_settings(const Scene& scene, const Resources& resources) {
    PairSettings settings;
    settings.kernel = scene.numerics.kernel;
    settings.walls.model = scene.numerics.walls;
    settings.corrected = *scene.numerics.scheme == FluidScheme::corrected;
    settings.several_fluids = has_unlike_fluids(scene);
    settings.viscosity.law = scene.numerics.viscous_law;
    settings.viscosity.mean = scene.numerics.viscosity_mean;
    settings.viscosity.unlike = has_unlike_viscosities(scene);
    settings.spacing = scene.particles.spacing;
    settings.support = scene.numerics.support * scene.particles.spacing;
    settings.sound_speed = sound_speed(scene);
    settings.background_pressure = scene.numerics.background_pressure;
    settings.density.by_summation = is_by_summation(scene.numerics.density);
    settings.gradient_correction = scene.numerics.gradient_correction;
    settings.transport_velocity = scene.numerics.transport_velocity;
    settings.density.diffusion = settings.density.by_summation ? 0 : scene.numerics.density_diffusion.value;
    settings.shifting = settings.transport_velocity ? 0 : scene.numerics.shifting.value;
    settings.density.largest = largest_density(scene);
    for (const Part* part : scene.parts_of(PartKind::fluid))
        settings.viscosity.largest = std::max(settings.viscosity.largest, part->viscosity.value);
    if (scene.contact.range > 0) {
        const double range = scene.contact.range * scene.particles.spacing;
        // Automatic strength: a small part of the fluid's energy rho c0^2 r*^3, in 2-D rho c0^2 r*^2 on 1 m of
        // depth. At 0.9 r* it then pushes like a pressure of 0.003 rho c0^2, which a Mach number of 0.1 does not
        // exceed, and at touch it does not rule the step.
        const double depth = *scene.dimension == 3 ? range : 1;
        settings.repulsion_strength = scene.contact.strength > 0
                                          ? scene.contact.strength.value
                                          : 0.002 * settings.density.largest * settings.sound_speed *
                                                settings.sound_speed * range * range * depth;
    }
    settings.viscosity.implicit = is_implicit(scene.numerics.viscosity_stepping) && settings.viscosity.largest > 0;
    for (std::size_t axis = 0; axis < 3; ++axis) settings.periodic[axis] = scene.flow.periodic[axis];
    for (const Part* part : scene.parts_of(PartKind::rigid)) {
        settings.walls.slip = settings.walls.slip || part->slip;
        settings.walls.moving = settings.walls.moving || part->moves();
        settings.walls.sliding = settings.walls.sliding || part->slides();
    }
    settings.threads = resources.threads > 0 ? resources.threads : omp_get_num_procs();
    settings.vector_unit = resources.vector_unit;
    return settings;
}

/// Whether bodies and walls touch as their surfaces, which particles of unknown origin have not.
bool touches_as_surfaces(const Scene& scene, const ParticleSet& set) {
    if (!scene.has_surface_contact()) return false;
    const auto& contact = scene.contact;
    const bool wants_surfaces =
        contact.between.given() || contact.friction > 0 || contact.damping > 0 || contact.stiffness > 0;
    if (wants_surfaces && set.contact_pieces.empty())
        throw InputError(first_known(scene, {&contact.between.location, &contact.friction.location,
                                             &contact.damping.location, &contact.stiffness.location}),
                         "contact is to be between surfaces, and the particles come without them",
                         "mesh them from a geometry, or write between = \"particles\"");
    return !set.contact_pieces.empty();
}

PairSettings pair_settings(const Scene& scene, const ParticleSet& set, const Resources& resources) {
    PairSettings settings = pair_settings(scene, resources);
    for (int axis = 0; axis < set.dimension; ++axis) {
        const Expression& g = scene.flow.acceleration[axis];
        if (!set.periodic[axis] && !set.is_mirrored(axis) && !g.is_zero()) settings.hydrostatic = true;
    }
    if (settings.corrected || !settings.hydrostatic) settings.free_surface = has_free_surface(set, settings.threads);
    settings.hydrostatic = settings.hydrostatic || settings.free_surface;
    settings.subtracts_level = settings.corrected && !settings.free_surface;
    // A solid that is wet on one side holds the whole pressure, not what is left of it.
    settings.dry_bodies = settings.subtracts_level && !dry_bodies(set, settings.threads).empty();
    settings.keeps_volume = settings.subtracts_level && keeps_volume(scene, settings);
    settings.surface_contact = touches_as_surfaces(scene, set);
    settings.chambers = settings.keeps_volume && may_have_chambers(scene, set);
    return settings;
}

std::vector<LiquidState> equations_of_state(const Scene& scene, const ParticleSpace& space) {
    const auto fluids = scene.parts_of(PartKind::fluid);
    const double first_density = fluids.empty() ? 1 : fluids.front()->density.value;
    std::vector<LiquidState> equations;
    for (const auto& part : space.parts) {
        const bool is_fluid = part.kind == PartKind::fluid;
        equations.push_back({sound_speed(scene),
                             is_fluid ? scene.part_of_particles(part.name).density.value : first_density,
                             scene.numerics.background_pressure, scene.numerics.equation_of_state});
    }
    return equations;
}

std::vector<double> rest_densities(const Scene& scene, const ParticleSet& set) {
    std::vector<double> densities;
    for (const LiquidState& state : equations_of_state(scene, set)) densities.push_back(state.rest_density);
    return densities;
}

void fill_by_part(const Scene& scene, ParticleStore& particles) {
    std::vector<double> viscosities, slips, slides;
    for (const auto& part : particles.space().parts) {
        const bool is_wall = part.kind == PartKind::rigid;
        slips.push_back(is_wall && scene.part_of_particles(part.name).slip ? 1 : 0);
        slides.push_back(is_wall && scene.part_of_particles(part.name).slides() ? 1 : slips.back());
        viscosities.push_back(part.kind == PartKind::fluid ? scene.part_of_particles(part.name).viscosity.value : 0);
    }
    for (ParticleGroup& group : particles.groups()) {
        const auto fill = [&](Field field, const std::vector<double>& by_part) {
            for (std::size_t i = 0; group.has(field) && i < group.owned(); ++i)
                group.data(field)[i] = by_part[group.tags()[i].part];
        };
        fill(Field::viscosity, viscosities);
        fill(Field::wall_slip, slips);
        fill(Field::wall_sliding, slides);
    }
}

void fill_store(const Scene& scene, const ParticleSet& set, ParticleStore& particles) {
    const std::vector<double> densities = rest_densities(scene, set);
    const std::vector<double> fluids = fluid_numbers(scene, set);
    const double range = scene.contact.range * scene.particles.spacing;
    for (ParticleGroup& group : particles.groups()) {
        const auto fill = [&](Field field, int axis, const auto& value_of) {
            if (!group.has(field)) return;
            for (std::size_t i = 0; i < group.owned(); ++i)
                group.data(field, axis)[i] =
                    value_of(group.tags()[i].part, static_cast<std::size_t>(group.tags()[i].id));
        };
        fill(Field::density, 0, [&](std::size_t part, std::size_t) { return densities[part]; });
        fill(Field::fluid_number, 0, [&](std::size_t part, std::size_t) { return fluids[part]; });
        fill(Field::mean_correction, 0, [](std::size_t, std::size_t) { return 1.0; });
        fill(Field::contact_range, 0, [&](std::size_t, std::size_t) { return range; });
        fill(Field::wall_contact_range, 0, [&](std::size_t, std::size_t id) { return set.seated[id] ? 0 : range; });
        fill(Field::wall_distance, 0, [&](std::size_t, std::size_t id) { return set.surface(id).depth; });
        fill(Field::opposite_distance, 0, [&](std::size_t, std::size_t id) { return set.surface(id).opposite; });
        for (int axis = 0; axis < set.dimension; ++axis) {
            for (const Field normal : {Field::wall_normal, Field::initial_normal})
                fill(normal, axis, [&](std::size_t, std::size_t id) { return set.wall_normal[id][axis]; });
            fill(Field::initial_position, axis, [&](std::size_t, std::size_t id) { return set.position[id][axis]; });
        }
    }
    fill_by_part(scene, particles);
    fill_starting_density(scene, set, equations_of_state(scene, set), particles);
}

StepScales step_scales(const Scene& scene, const ParticleSet& set, const PairSettings& settings, double viscous_limit) {
    StepScales scales;
    scales.support = settings.support;
    scales.sound_speed = settings.sound_speed;
    scales.density_ratio = density_ratio(scene);
    scales.viscous_limit = viscous_limit;
    scales.step_factor = scene.numerics.step_factor;
    scales.shifting = settings.corrected ? 0 : settings.shifting;  // never beyond its limit
    scales.density_diffusion = settings.density.diffusion;
    const auto& numerics = scene.numerics;
    scales.factors = {.viscous = numerics.viscous_step_factor,
                      .species = numerics.species_step_factor,
                      .contact = numerics.contact_step_factor,
                      .light_solid = numerics.light_solid_step_factor,
                      .density_diffusion = numerics.density_diffusion_step_factor,
                      .shifting = numerics.shifting_step_factor};
    scales.drive_time = drive_time(scene, set);
    scales.at_rest = is_at_rest(scene);
    for (std::size_t i = 0; i < set.size(); ++i)
        scales.elastic_solids = scales.elastic_solids || (set.kind(i) == PartKind::elastic && set.fixed[i] == 0);
    if (settings.corrected) scales.lightest_solid = lightest_solid(scene, set, settings);
    scales.implicit_viscosity = settings.viscosity.implicit;
    for (const Part* part : scene.parts_of(PartKind::fluid))
        scales.kinematic_viscosity = std::max(scales.kinematic_viscosity, part->viscosity / part->density);
    scales.implicit_species = *scene.numerics.species_stepping == SpeciesStepping::implicitly;
    for (const Species& species : scene.species)
        for (const Part& part : scene.parts)
            if (const Value<double>* diffusivity = species.diffusivity_in(part);
                diffusivity != nullptr && *part.enabled)
                scales.diffusivity = std::max(scales.diffusivity, **diffusivity);
    const bool particles_repel = !settings.surface_contact || !scene.parts_of(PartKind::fluid).empty();
    if (settings.repulsion_strength > 0 && particles_repel && set.size() > 0) {
        const std::vector<double> mass = node_masses(scene, set, liquid_in_leaflets(settings));
        double lightest = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < set.size(); ++i)  // without a fluid walls have no mass; what is held does not swing
            if (set.kind(i) != PartKind::rigid && !set.fixed[i]) lightest = std::min(lightest, mass[i]);
        const double range = scene.contact.range * scene.particles.spacing;
        if (std::isfinite(lightest))
            scales.contact_limit = Repulsion{settings.repulsion_strength}.step_limit(range, lightest);
    }
    return scales;
}

double new_bond_limit(const Scene& scene, const Solidify& rule) {
    const double mass =
        scene.part_of_particles(rule.liquid).density * std::pow(scene.particles.spacing, scene.dimension);
    return 2 / std::sqrt(2 * rule.bond_stiffness / (mass / 2));
}

}  // namespace dmp::solver
