// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/setup.hpp"

#include <algorithm>

#include <omp.h>

#include "scene/read_scene.hpp"
#include "solver/models/contact/repulsion.hpp"
#include "solver/starting_state.hpp"

namespace dmp {

namespace {

const Part& part_named(const Scene& scene, const std::string& name) {
    const auto part =
        std::find_if(scene.parts.begin(), scene.parts.end(), [&](const Part& p) { return p.name.value == name; });
    if (part == scene.parts.end())
        throw InputError("the particles have a part '" + name + "' that the scene does not know",
                         "mesh the scene again");
    return *part;
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
    settings.spacing = scene.particles.spacing;
    settings.support = scene.accuracy.support * scene.particles.spacing;
    settings.sound_speed = sound_speed(scene);
    settings.density_diffusion = scene.accuracy.density_diffusion;
    settings.shifting = scene.accuracy.shifting;
    settings.density = largest_density(scene);
    for (const Part* part : scene.parts_of(PartKind::fluid))
        settings.viscosity = std::max(settings.viscosity, part->viscosity.value);
    if (scene.contact.range > 0) {
        const double range = scene.contact.range * scene.particles.spacing;
        // Automatic strength: a small part of the fluid's energy rho c0^2 r*^2. At 0.9 r* it then pushes like a
        // pressure of 0.003 rho c0^2, which a Mach number of 0.1 does not exceed, and it never rules the step.
        settings.repulsion_strength = scene.contact.strength > 0 ? scene.contact.strength.value
                                                                 : 0.002 * settings.density * settings.sound_speed *
                                                                       settings.sound_speed * range * range;
    }
    settings.threads = resources.threads > 0 ? resources.threads : omp_get_num_procs();
    settings.vector_unit = resources.vector_unit;
    return settings;
}

std::vector<TaitEquation> equations_of_state(const Scene& scene, const ParticleSpace& space) {
    const auto fluids = scene.parts_of(PartKind::fluid);
    const double first_density = fluids.empty() ? 1 : fluids.front()->density.value;
    std::vector<TaitEquation> equations;
    for (const auto& part : space.parts) {
        const bool is_fluid = part.kind == ParticleKind::fluid;
        equations.push_back(
            {sound_speed(scene), is_fluid ? part_named(scene, part.name).density.value : first_density});
    }
    return equations;
}

std::vector<double> rest_densities(const Scene& scene, const ParticleSet& set) {
    std::vector<double> densities;
    for (const TaitEquation& state : equations_of_state(scene, set)) densities.push_back(state.rest_density);
    return densities;
}

void fill_store(const Scene& scene, const ParticleSet& set, ParticleStore& particles) {
    const std::vector<double> densities = rest_densities(scene, set);
    std::vector<double> viscosities;
    for (const auto& part : set.parts)
        viscosities.push_back(part.kind == ParticleKind::fluid ? part_named(scene, part.name).viscosity.value : 0);
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
        for (int axis = 0; axis < set.dimension; ++axis)
            fill(Field::wall_normal, axis, [&](std::size_t, std::size_t id) { return set.wall_normal[id][axis]; });
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
    for (const Part* part : scene.parts_of(PartKind::fluid))
        scales.kinematic_viscosity = std::max(scales.kinematic_viscosity, part->viscosity / part->density);
    if (settings.repulsion_strength > 0 && set.size() > 0) {
        const double lightest = *std::min_element(set.mass.begin(), set.mass.end());
        const double range = scene.contact.range * scene.particles.spacing;
        scales.contact_limit = Repulsion{settings.repulsion_strength}.step_limit(range, lightest);
    }
    return scales;
}

std::vector<ModelUse> models_in_use(const Scene& scene) {
    const auto because = [&](const auto& value, const std::string& key) {
        return value.given() ? key + " at " + value.place.text() : key + " (" + default_origin(scene, key) + ")";
    };
    std::vector<ModelUse> models;
    const auto fluids = scene.parts_of(PartKind::fluid);
    if (!fluids.empty()) {
        const std::string fluid = "part '" + fluids.front()->name.value + "' at " + fluids.front()->name.place.text();
        models.push_back({"Tait equation of state", "Monaghan 1994", fluid});
        models.push_back({"continuity", "Monaghan 1994, in volume form", fluid});
        models.push_back({"pressure force", "Bonet & Lok 1999", fluid});
        models.push_back(
            {"viscous force", "Morris, Fox & Zhu 1997, eq. 22", because(fluids.front()->viscosity, "viscosity")});
        if (scene.accuracy.density_diffusion > 0)
            models.push_back({"density diffusion", "Molteni & Colagrossi 2009",
                              because(scene.accuracy.density_diffusion, "accuracy.density_diffusion")});
        if (scene.accuracy.shifting > 0)
            models.push_back(
                {"particle shifting", "after Sun et al. 2017", because(scene.accuracy.shifting, "accuracy.shifting")});
    }
    if (has_starting_state(scene)) {
        const bool moves = scene.flow.initial_velocity.given();
        models.push_back({"starting state", "density by the inverse equation of state",
                          moves ? because(scene.flow.initial_velocity, "flow.initial_velocity")
                                : because(scene.flow.initial_pressure, "flow.initial_pressure")});
    }
    for (const Expression& axis : scene.flow.acceleration)
        if (axis.depends_on_time() || axis.depends_on_place() || axis(0) != 0) {
            models.push_back({"body acceleration", axis.text(), "flow.acceleration"});
        }
    if (!scene.parts_of(PartKind::rigid).empty())
        models.push_back({scene.accuracy.walls == WallModel::plain ? "plain walls" : "extrapolated no-slip walls",
                          scene.accuracy.walls == WallModel::plain ? "Monaghan 1994"
                                                                   : "Morris, Fox & Zhu 1997; Adami, Hu & Adams 2012",
                          because(scene.accuracy.walls, "accuracy.walls")});
    for (const Part* part : scene.parts_of(PartKind::rigid))
        if (Scene::any(part->surface_velocity))
            models.push_back({"sliding surface of '" + *part->name + "'", "velocity of the wall in the viscous force",
                              because(part->surface_velocity, "surface_velocity")});
    for (const Part* part : scene.parts_of(PartKind::springs)) {
        const std::string where = "part '" + part->name.value + "' at " + part->name.place.text();
        models.push_back({"bonds with dashpots", "U = k_b (r - r0)^2", where});
        models.push_back({"hinges", "U = k_a (theta - theta0)^2", where});
        if (part->drag > 0) models.push_back({"lab-frame drag", "F = -k_v v", because(part->drag, "drag")});
    }
    const bool has_solids = !scene.parts_of(PartKind::rigid).empty() || !scene.parts_of(PartKind::springs).empty();
    if (scene.contact.range > 0 && has_solids)
        models.push_back(
            {"short-range repulsion", "Monaghan 1994, cut at r*", because(scene.contact.range, "contact.range")});
    if (scene.asks_for(FluidField::residence_time) && !scene.regions.empty())
        models.push_back({"residence times", "time in each region",
                          "'residence_time' asked for, region '" + *scene.regions.front().name + "' at " +
                              scene.regions.front().name.place.text()});
    if (scene.asks_for(SolidField::mean_displacement) && !scene.parts_of(PartKind::springs).empty())
        models.push_back(
            {"mean displacement", "average over time", because(scene.output.average_from, "output.average_from")});
    return models;
}

}  // namespace dmp
