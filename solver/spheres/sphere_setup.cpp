// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/spheres/sphere_setup.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/number_text.hpp"
#include "models/dem/contact_material.hpp"
#include "models/dem/contact_steps.hpp"
#include "solver/forcing/drive_time.hpp"
#include "solver/forcing/driving_models.hpp"

namespace dmp::solver {

namespace {

/// Parts of a Rayleigh time, and of the largest stable step of an adhesive force, that a step of `standard` takes.
constexpr double rayleigh_part = 0.2, adhesion_part = 0.1;

struct Sizes {
    double smallest = std::numeric_limits<double>::infinity(), largest = 0;   ///< radii [m]
    double lightest = std::numeric_limits<double>::infinity(), heaviest = 0;  ///< [kg]
    std::size_t count = 0;
};

std::vector<Sizes> sizes_by_part(const ParticleSet& set) {
    std::vector<Sizes> sizes(set.parts.size());
    for (std::size_t i = 0; i < set.size(); ++i) {
        if (set.kind(i) != PartKind::spheres) continue;
        Sizes& of = sizes[static_cast<std::size_t>(set.part[i])];
        of.smallest = std::min(of.smallest, set.radius[i]);
        of.largest = std::max(of.largest, set.radius[i]);
        of.lightest = std::min(of.lightest, set.mass[i]);
        of.heaviest = std::max(of.heaviest, set.mass[i]);
        ++of.count;
    }
    return sizes;
}

ContactMaterial material_of(const Part& part) {
    if (!part.youngs_modulus.given()) return {std::numeric_limits<double>::infinity(), 0};
    return {part.youngs_modulus, part.poisson_ratio};
}

double reduced(double a, double b) { return a * b / (a + b); }

/// The work of adhesion, also of a pull-off force that is given in its place [J/m^2].
double adhesion_energy(const ContactPair& asked, const SpherePair& pair) {
    if (!asked.pull_off_force.given()) return asked.work_of_adhesion;
    if (pair.largest_radius > pair.radius * (1 + 1e-9))
        throw InputError(asked.pull_off_force.location,
                         "pull_off_force between " + pair.parts + ", whose spheres differ in radius",
                         "give work_of_adhesion, from which each contact's pull-off force follows");
    return visit_adhesive_law(*asked.normal, *asked.adhesion, 0.0,
                              [&]<class Law>() { return Law::adhesion_energy(*asked.pull_off_force, pair.radius); });
}

SpherePair pair_of(const Part& a, const Part& b, const ContactPair& asked, SpherePair pair) {
    pair.parts = "'" + *a.name + "' and '" + *b.name + "'";
    pair.asked = &asked;
    pair.model = {asked.normal, asked.tangential,
                  *asked.rolling_friction > 0 ? *asked.rolling : RollingLaw::of<NoRolling>(), asked.adhesion};
    ContactSettings settings;
    settings.normal_stiffness_factor = asked.normal_stiffness_factor;
    settings.tangential_stiffness_factor = asked.tangential_stiffness_factor;
    if (asked.restitution.given()) {
        settings.restitution = asked.restitution;
        settings.damping = asked.dashpot_may_pull ? ContactDamping::restitution : ContactDamping::restitution_no_pull;
    } else {
        settings.damping = ContactDamping::coefficients;
        settings.normal_rate = asked.normal_damping;
        settings.tangential_rate = asked.tangential_damping;
    }
    settings.friction = asked.friction;
    settings.rolling_friction = asked.rolling_friction;
    settings.rolling_damping = asked.rolling_damping;
    if (pair.model.is_adhesive()) {
        settings.adhesion_energy = adhesion_energy(asked, pair);
        if (asked.equilibrium_distance.given()) {
            settings.adhesion_distance = asked.equilibrium_distance;
            settings.adhesion_range =
                asked.adhesion_cutoff.given() ? asked.adhesion_cutoff.value : 50 * asked.equilibrium_distance;
        }
    }
    pair.constants = contact_constants(material_of(a), material_of(b), settings);
    if (!asked.restitution.given() && !asked.dashpot_may_pull) pair.constants.least_normal = 0;
    return pair;
}

/// Null: they pass through each other.
const ContactPair* law_between(const Scene& scene, const Part& a, const Part& b) {
    const ContactPair* asked = scene.contact_between(a.name, b.name);
    return asked == nullptr || !*asked->enabled ? nullptr : asked;
}

void check_periods(const ParticleSet& set, double reach) {
    for (int axis = 0; axis < 3; ++axis)
        if (const double period = set.box.high[axis] - set.box.low[axis];
            set.periodic[static_cast<std::size_t>(axis)] && period <= 2 * reach)
            throw InputError(std::string("the box is too short along ") + "xyz"[axis] +
                                 ", a periodic axis: a sphere could touch another one on both sides",
                             "make a period longer than twice the largest sphere's diameter");
}

}  // namespace

SphereSetup sphere_setup(const Scene& scene, const ParticleSet& set) {
    const std::vector<Sizes> sizes = sizes_by_part(set);
    SphereSetup setup;
    setup.kinds = PairKinds(set.parts.size());
    setup.walls.assign(set.parts.size(), std::vector<std::optional<WallPair>>(set.parts.size()));
    setup.smallest_radius = std::numeric_limits<double>::infinity();
    double radii = 0;
    std::size_t count = 0;
    for (std::size_t a = 0; a < set.parts.size(); ++a) {
        const Part& part = scene.part_of_particles(set.parts[a].name);
        setup.wall_velocity.push_back(part.velocity);
        setup.smallest_by_part.push_back(sizes[a].count > 0 ? sizes[a].smallest : 0);
        setup.lightest_by_part.push_back(sizes[a].count > 0 ? sizes[a].lightest : 0);
        if (sizes[a].count == 0) continue;
        setup.smallest_radius = std::min(setup.smallest_radius, sizes[a].smallest);
        setup.largest_radius = std::max(setup.largest_radius, sizes[a].largest);
        for (std::size_t b = 0; b < set.parts.size(); ++b) {
            const Part& other = scene.part_of_particles(set.parts[b].name);
            const ContactPair* asked = law_between(scene, part, other);
            if (asked == nullptr) continue;
            if (other.is_wall_for_spheres()) {
                setup.wall_pairs.push_back(pair_of(
                    part, other, *asked,
                    {{}, {}, {}, sizes[a].smallest, sizes[a].lightest, sizes[a].largest, sizes[a].heaviest, nullptr}));
                setup.walls[a][b] = WallPair{setup.wall_pairs.back().model, setup.wall_pairs.back().constants};
            } else if (b >= a && sizes[b].count > (a == b ? 1U : 0U)) {  // a sphere alone never meets itself
                setup.kinds.set(a, b, static_cast<std::int16_t>(setup.pairs.size()));
                setup.pairs.push_back(pair_of(part, other, *asked,
                                              {{},
                                               {},
                                               {},
                                               reduced(sizes[a].smallest, sizes[b].smallest),
                                               reduced(sizes[a].lightest, sizes[b].lightest),
                                               reduced(sizes[a].largest, sizes[b].largest),
                                               reduced(sizes[a].heaviest, sizes[b].heaviest),
                                               nullptr}));
            }
        }
    }
    for (std::size_t i = 0; i < set.size(); ++i)
        if (set.kind(i) == PartKind::spheres) {
            radii += set.radius[i];
            ++count;
        }
    setup.mean_radius = radii / static_cast<double>(std::max<std::size_t>(1, count));
    for (const auto* pairs : {&setup.pairs, &setup.wall_pairs})
        for (const SpherePair& pair : *pairs)
            setup.reach = std::max(setup.reach, contact_reach(pair.model, pair.constants, pair.largest_radius));
    for (const SpherePair& pair : setup.pairs)
        setup.history_width = std::max(setup.history_width, static_cast<std::size_t>(history_values(pair.model)));
    setup.drive_time = drive_time(scene, set);
    check_periods(set, 2 * setup.largest_radius + setup.reach);
    return setup;
}

std::vector<StepLimit> contact_step_limits(const SphereSetup& setup, double speed, double steps) {
    std::vector<StepLimit> limits;
    const double part = StepsPerContact::standard / steps * adhesion_part;
    for (const auto* pairs : {&setup.pairs, &setup.wall_pairs})
        for (const SpherePair& pair : *pairs) {
            if (speed > 0)
                limits.push_back({"contact of " + pair.parts,
                                  ContactTimes::impact(pair.radius, pair.mass, speed, pair.constants) / steps,
                                  "impact at " + number_text(speed) + " m/s in " + number_text(steps) + " steps"});
            const double stiffness =
                pair.model.adhesion.visit([&]<class Law>() { return Law::stiffness(pair.radius, pair.constants); });
            if (stiffness > 0)
                limits.push_back({"adhesion of " + pair.parts, part * ContactTimes::stable(stiffness, pair.mass),
                                  number_text(part) + " of 2 sqrt(m* / largest slope of the force)"});
        }
    return limits;
}

std::vector<StepLimit> sphere_step_limits(const Scene& scene, const SphereSetup& setup, const ParticleSpace& space,
                                          double speed) {
    const double steps = scene.numerics.steps_per_contact, finer = StepsPerContact::standard / steps;
    std::vector<StepLimit> limits =
        contact_step_limits(setup, std::max<double>(speed, scene.flow.largest_speed), steps);
    for (std::size_t k = 0; k < space.parts.size(); ++k) {
        const double radius = setup.smallest_by_part[k];
        if (radius == 0) continue;
        const Part& part = scene.part_of_particles(space.parts[k].name);
        const double density = setup.lightest_by_part[k] / (4 * std::numbers::pi / 3 * radius * radius * radius);
        limits.push_back(
            {"Rayleigh wave in '" + *part.name + "'",
             finer * rayleigh_part * ContactTimes::rayleigh(radius, density, part.youngs_modulus, part.poisson_ratio),
             number_text(finer * rayleigh_part) + " of its way around half a sphere (Ning & Ghadiri 2006)"});
    }
    return limits;
}

std::vector<ModelUse> sphere_models(const Scene& scene, const SphereSetup& setup, const ParticleSpace& space) {
    std::vector<ModelUse> models{{"spheres",
                                  "velocity Verlet with rotation; friction's direction at half steps: Vyas et al. 2025",
                                  "part '" + *scene.parts_of(PartKind::spheres).front()->name + "'"}};
    for (const auto* pairs : {&setup.pairs, &setup.wall_pairs})
        for (const SpherePair& pair : *pairs) {
            const std::string where = "[[contact_pair]] at " + pair.asked->parts.location.text();
            const auto add = [&](const std::string& what, const LawFacts& facts) {
                if (!facts.citation.empty())
                    models.push_back({what + " of " + pair.parts, std::string(facts.citation), where});
            };
            const LawFacts &normal = pair.model.normal.facts(), &tangential = pair.model.tangential.facts();
            const ContactPair& asked = *pair.asked;
            std::string source = std::string(normal.citation) + ", " + std::string(tangential.citation);
            if (*asked.normal_stiffness_factor != 1 || *asked.tangential_stiffness_factor != 1)
                source += ", stiffness times " + number_text(asked.normal_stiffness_factor) + " and " +
                          number_text(asked.tangential_stiffness_factor);
            models.push_back({"contact of " + pair.parts, source, where});
            add("rolling friction", pair.model.rolling.facts());
            add("adhesion", pair.model.adhesion.facts());
        }
    if (!space.wall_planes.empty() || !space.wall_triangles.empty())
        models.push_back({"walls",
                          std::to_string(space.wall_planes.size()) + " planes and " +
                              std::to_string(space.wall_triangles.size()) +
                              " triangles; touched where the distance is least",
                          "parts of kind 'plane' and 'surface'"});
    add_driving_models(models, scene);
    return models;
}

}  // namespace dmp::solver
