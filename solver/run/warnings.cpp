// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/run/warnings.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/length_text.hpp"
#include "base/number_text.hpp"
#include "scene/measure_subject.hpp"
#include "scene/step_margins.hpp"
#include "solver/forcing/driven.hpp"

namespace dmp::solver {

namespace {

class Warnings {
  public:
    Warnings(const Scene& scene, std::size_t bodies)
        : scene_(scene),
          bodies_(bodies),
          fluid_(!scene.parts_of(PartKind::fluid).empty()),
          walls_(!scene.parts_of(PartKind::rigid).empty()),
          springs_(scene.may_have_elastic()) {}

    std::vector<Warning> all() && {
        about_drive();
        about_contact();
        about_fluid_models();
        about_walls();
        about_elastic();
        about_species();
        about_solidify();
        about_joins();
        about_measures();
        about_output();
        if (fluid_ || springs_)
            has_no_effect("run.until_steady", scene_.run.until_steady, "it ends runs of spheres only");
        for (const IdleKey& idle : idle_step_keys(scene_))
            add(idle.key, idle.location, "has no effect: " + idle.reason, "leave it out");
        return std::move(found_);
    }

  private:
    void add(std::string key, const SourceLocation& location, std::string problem, std::string what_to_do) {
        found_.push_back({std::move(key), location, std::move(problem), std::move(what_to_do)});
    }
    /// About a value that the scene gives for nothing.
    template <class T>
    void has_no_effect(const std::string& key, const Value<T>& value, const std::string& reason) {
        if (value.given()) add(key, value.location, "has no effect: " + reason, "leave it out");
    }

    void about_drive() {
        if (is_driven(scene_) || !scene_.species.empty()) return;  // species diffuse at rest too
        add("flow.acceleration", {}, "is 0 and nothing else drives the scene: nothing will move",
            "give a body acceleration, or flow.pressure_gradient along a periodic axis");
    }

    void about_contact() {
        const auto& contact = scene_.contact;
        const bool meets = springs_ && (walls_ || bodies_ > 1);
        if (*contact.range == 0) {
            has_no_effect("contact.strength", contact.strength, "contact.range is 0");
            if (meets)
                add("contact.range", contact.range.location,
                    "is 0: " + std::string(bodies_ > 1 ? "spring bodies" : "spring bodies and walls") +
                        " that touch will pass through each other",
                    "give a range, 1.0 for example");
        } else if (!walls_ && !springs_) {
            has_no_effect("contact.range", contact.range, "no part is solid");
            has_no_effect("contact.strength", contact.strength, "no part is solid");
        } else if (scene_.has_surface_contact()) {
            if (!fluid_) has_no_effect("contact.strength", contact.strength, "bodies touch as their surfaces");
            if (!scene_.breaking.empty())
                add("contact.between", contact.between.location,
                    "is \"surfaces\", and what breaks has none where it broke: pieces of one body may pass into each "
                    "other there",
                    "write between = \"particles\", if pieces meet again");
        } else if (springs_ && !fluid_ && *contact.strength == 0) {
            add("contact.strength", contact.strength.location,
                "is \"auto\", which follows the fluid, and there is none: spring bodies that touch will pass through "
                "each other and themselves",
                "give it in J");
        }
    }

    void about_fluid_models() {
        const auto& numerics = scene_.numerics;
        if (fluid_ && *numerics.support < 2.9)
            add("numerics.support", numerics.support.location,
                "is below 2.9 spacings: particles hold on to their lattice, flows are slowed, and more particles do "
                "not cure it (docs/plain_scheme.md)",
                "take 3 or more");
        if (*numerics.scheme == FluidScheme::corrected)
            has_no_effect("numerics.shifting_step_factor", numerics.shifting_step_factor,
                          "with scheme = \"corrected\" shifting sets no limit of the step");
        if (fluid_) return about_shifting();
        const std::string reason = "no part is a fluid";
        if (*numerics.density_diffusion > 0)
            has_no_effect("numerics.density_diffusion", numerics.density_diffusion, reason);
        if (*numerics.shifting > 0) has_no_effect("numerics.shifting", numerics.shifting, reason);
        has_no_effect("numerics.kernel", numerics.kernel, reason);
        has_no_effect("numerics.walls", numerics.walls, reason);
    }

    /// Of the plain scheme; measured in docs/plain_scheme.md, "Shifting and the speed of sound". Implicit viscosity
    /// damps what it stirs up.
    void about_shifting() {
        constexpr double times_too_fast = 50;
        const auto& numerics = scene_.numerics;
        if (*numerics.scheme != FluidScheme::plain) return;
        if (*numerics.shifting == 0 || *numerics.transport_velocity || !numerics.sound_speed.given()) return;
        if (*numerics.viscosity_stepping == ViscosityStepping::implicitly || *scene_.flow.largest_speed == 0) return;
        if (*numerics.sound_speed < 0.999 * times_too_fast * *scene_.flow.largest_speed) return;
        add("numerics.sound_speed", numerics.sound_speed.location,
            "is 50 times flow.largest_speed or more: shifting then stirs the fluid and slows the flow "
            "(docs/plain_scheme.md)",
            "lower it to 25 times or less, or set numerics.shifting = 0");
    }

    void about_walls() {
        if (!fluid_) return;
        const auto& walls = scene_.numerics.walls;
        if (!walls_ && !springs_) has_no_effect("numerics.walls", walls, "no part is solid");
        if (!walls_ || *walls != WallModel::extrapolated) return;
        for (const Part* part : scene_.parts_of(PartKind::fluid))
            if (*part->viscosity == 0)
                add("part." + *part->name + ".viscosity", part->viscosity.location,
                    "is 0 between no-slip walls: they cannot hold the fluid back", "give the fluid a viscosity");
    }

    void about_elastic() {
        for (const Part* part : scene_.parts_of(PartKind::elastic)) {
            if (*part->drag == 0) has_no_effect("part." + *part->name + ".drag", part->drag, "it is 0");
            if (*part->mass_damping == 0)
                has_no_effect("part." + *part->name + ".mass_damping", part->mass_damping, "it is 0");
        }
        const auto& numerics = scene_.numerics;
        if (!springs_) has_no_effect("numerics.spring_stepping", numerics.spring_stepping, "no part is elastic");
        if (!springs_ || *numerics.spring_stepping == SpringStepping::implicit)
            has_no_effect("numerics.spring_step_factor", numerics.spring_step_factor,
                          springs_ ? "springs are stepped implicitly" : "no part is elastic");
    }

    void about_species() {
        const auto& numerics = scene_.numerics;
        if (scene_.species.empty()) {
            has_no_effect("numerics.species_stepping", numerics.species_stepping, "the scene has no [[species]]");
            has_no_effect("numerics.species_tolerance", numerics.species_tolerance, "the scene has no [[species]]");
        } else if (*numerics.species_stepping == SpeciesStepping::explicitly) {
            has_no_effect("numerics.species_tolerance", numerics.species_tolerance, "diffusion is stepped explicitly");
        }
        const bool measured =
            std::ranges::any_of(scene_.measures, [](const Measure& measure) { return is_of_species(*measure.kind); });
        for (const Species& species : scene_.species) {
            const std::string key = "species." + *species.name;
            if (!measured && !scene_.asks_for(FluidField::concentration))
                add(key, species.name.location,
                    "is not shown: 'concentration' is not among output.fields and no measure "
                    "asks for it",
                    "add it there");
            if (species.concentration.empty() && species.wall_concentration.empty() && species.wall_flux.empty())
                add(key, species.name.location, "is nowhere: it starts at 0 and no wall gives any of it",
                    "give a concentration at the start or at a wall");
            for (const Part* part : scene_.takers_of(species)) about_uptake(species, *part);
        }
    }

    /// Next to where the species comes from, its concentration falls over sqrt(D / k).
    void about_uptake(const Species& species, const Part& part) {
        const Value<double>& rate = *species.uptake_in(part);
        const double layer = std::sqrt(**species.diffusivity_in(part) / *rate), spacing = scene_.particles.spacing;
        if (layer == 0 || layer >= spacing) return;
        add("species." + *species.name + ".uptake", rate.location,
            "in '" + *part.name + "' makes layers of sqrt(D / k) = " + length_text(layer) +
                " next to where the species comes from, thinner than the spacing of the particles, " +
                length_text(spacing),
            "take a smaller particles.spacing if they matter");
    }

    void about_solidify() {
        for (const Solidify& rule : scene_.solidify) {
            const std::string key = "solidify." + *rule.name + ".";
            if (*rule.reach < *scene_.particles.spacing)
                add(key + "reach", rule.reach.location,
                    "is less than the spacing: only liquid that happens to be compressed is ever within reach",
                    "write 1.1 to 1.4 spacings, for the nearest neighbours");
            if (*rule.from >= *scene_.run.duration)
                add(key + "from", rule.from.location, "is not before run.duration: nothing will turn solid",
                    "lower it, or run for longer");
        }
    }

    void about_joins() {
        for (const Join& join : scene_.joins)
            for (const std::string& name : *join.parts)
                if (const Part* part = scene_.part_named(name); part != nullptr && !*part->enabled)
                    add("join." + *join.name + ".parts", join.parts.location,
                        "'" + name + "' is left out (enabled = false), and so is the join",
                        "leave the join out, or enable the part");
    }

    /// Of the fluid, where there is none.
    void about_measure_of_fluid(const Measure& measure) {
        const MeasureSubject subject = subject_of(measure.kind);
        if (subject != MeasureSubject::any && subject != MeasureSubject::flow) return;
        add("measure." + *measure.name + ".kind", measure.kind.location,
            "is of the fluid, and no part is a fluid: '" + *measure.name + "' says nothing",
            springs_ ? "measure the displacement of an elastic solid instead" : "leave the measure out");
    }

    void about_measures() {
        for (const Measure& measure : scene_.measures) {
            if (!fluid_) about_measure_of_fluid(measure);
            if (!is_of_elastic_part(measure.kind)) continue;
            const Part* part = scene_.part_named(measure.part);
            if (part != nullptr && !*part->enabled)
                add("measure." + *measure.name + ".part", measure.part.location,
                    "'" + *measure.part + "' is left out (enabled = false), so the measure has no column",
                    "leave the measure out, or enable the part");
        }
        if (scene_.measures.empty())
            has_no_effect("output.measure_every", scene_.output.measure_every, "the scene has no [[measure]]");
    }

    void about_output() {
        const auto& output = scene_.output;
        const auto is_named = [this](const ResidenceRegion& region) {
            const auto is_it = [&](const Value<std::string>& name) { return *name == *region.name; };
            return std::ranges::any_of(
                       scene_.solidify,
                       [&](const Solidify& rule) { return is_it(rule.seed_region) || is_it(rule.region); }) ||
                   std::ranges::any_of(scene_.measures, [&](const Measure& measure) { return is_it(measure.region); });
        };
        if (!scene_.asks_for(FluidField::residence_time))
            for (const ResidenceRegion& region : scene_.regions)
                if (!is_named(region))
                    has_no_effect(
                        "region." + *region.name, region.name,
                        "'residence_time' is not among output.fields and no measure reads it or names the region");
        const bool averages = springs_ && scene_.asks_for(SolidField::mean_displacement);
        if (!averages)
            has_no_effect("output.average_from", output.average_from,
                          "no elastic solid has 'mean_displacement' among output.solid_fields");
        if (averages && *output.average_from >= *scene_.run.duration)
            add("output.average_from", output.average_from.location, "is not before the run's end: nothing is averaged",
                "begin earlier");
        const bool shown = std::ranges::find(output.fields, *output.picture_field) != output.fields.end();
        if (*output.pictures && fluid_ && !shown)
            add("output.picture_field", output.picture_field.location,
                "'" + to_string(*output.picture_field) + "' is not among output.fields: pictures will show no colours",
                "add it there");
    }

    const Scene& scene_;
    std::size_t bodies_;
    bool fluid_, walls_, springs_;
    std::vector<Warning> found_;
};

}  // namespace

std::optional<Warning> viscosity_better_implicit(const Scene& scene, const std::vector<StepLimit>& limits) {
    constexpr double pays = 200;
    double viscous = std::numeric_limits<double>::infinity(), others = viscous;
    for (const StepLimit& limit : limits) {
        double& shortest = limit.model.starts_with("viscosity") ? viscous : others;
        shortest = std::min(shortest, limit.dt);
    }
    const auto& stepping = scene.numerics.viscosity_stepping;
    if (*stepping == ViscosityStepping::implicitly || !std::isfinite(others) || !(viscous * pays < others)) return {};
    return Warning{"numerics.viscosity_stepping", stepping.location,
                   "is \"explicit\", and viscosity keeps the steps " + number_text(others / viscous, 3) +
                       " times shorter than anything else",
                   "try \"implicit\": its steps cost 10 to 50 times as much (docs/speed.md)"};
}

std::optional<Warning> stirred_interface(const Scene& scene, double acceleration) {
    constexpr double damped = 3, plain_ratio = 10;
    const auto fluids = scene.parts_of(PartKind::fluid);
    if (fluids.size() < 2 || acceleration == 0) return {};
    const auto [light, heavy] = std::ranges::minmax(fluids, {}, [](const Part* fluid) { return *fluid->density; });
    if (*scene.numerics.scheme == FluidScheme::plain) {
        if (*heavy->density <= plain_ratio * *light->density) return {};
        return Warning{
            "part." + *light->name + ".density", light->density.location,
            "is less than a tenth of that of '" + *heavy->name +
                "': numerics.scheme = \"plain\" then stirs the interface, in a tank at rest by 0.04 sqrt(2 g H) "
                "at 20 times, 0.16 at 100 times and 0.9 at 1000 times",
            "give both densities within ten times of each other, or leave out the lighter liquid"};
    }
    double least = std::numeric_limits<double>::infinity();  // kinematic viscosity [m^2/s]
    for (const Part* fluid : fluids) least = std::min(least, fluid->viscosity / fluid->density);
    const double atwood = (*heavy->density - *light->density) / (*heavy->density + *light->density);
    const double number = std::sqrt(atwood * acceleration * std::pow(*scene.particles.spacing, 3)) / least;
    if (!(number > damped)) return {};
    return Warning{
        "part." + *light->name + ".density", light->density.location,
        "differs from that of '" + *heavy->name +
            "', and viscosity hardly damps flow at the scale of the spacing: sqrt(A g dx^3) / nu is " +
            number_text(number, 3) +
            "; above 3 the scheme itself stirs the interface, by 0.14 sqrt(g H) at 0.98 times the density and "
            "0.7 sqrt(g H) at half of it (docs/scheme.md)",
        "take a smaller particles.spacing, compare with numerics.scheme = \"plain\", or give both one density "
        "where gravity does not matter"};
}

std::vector<Warning> warnings_of(const Scene& scene, std::size_t bodies) { return Warnings(scene, bodies).all(); }

}  // namespace dmp::solver
