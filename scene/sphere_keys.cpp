// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/sphere_keys.hpp"

namespace dmp::scene {

// Columns as in schema.cpp.
// clang-format off

std::vector<Key<Part>> sphere_part_keys() {
    const Kinds spheres = {"spheres"}, plane = {"plane"}, surface = {"surface"}, walls = {"plane", "surface"};
    return {
        {"radius", spheres, &Part::radius, quantity_or_list("1 mm", positive), not_given,
         "Radius of all the part's spheres, or of each of its centres; left out where positions has them."},
        {"density", spheres, &Part::density, quantity("2500 kg/m^3", positive), not_given,
         "Density of the spheres; or give their mass."},
        {"mass", spheres, &Part::mass, quantity("1 ug", positive), not_given, "Mass of each sphere, in place of density."},
        {"youngs_modulus", spheres, &Part::youngs_modulus, quantity("60 GPa", positive), required,
         "Young's modulus of the spheres' material."},
        {"poisson_ratio", spheres, &Part::poisson_ratio, number(between(0, 0.5)), required,
         "Poisson's ratio of the spheres' material."},
        {"centres", spheres, &Part::centres, points(), not_given,
         "Where the spheres are; or positions, around or fill_from and fill_to."},
        {"positions", spheres, &Part::positions, text_not_empty(), not_given,
         "A table (CSV) of where they are: columns x, y, z [m] and, if wanted, radius, vx, vy, vz, wx, wy, wz; units in its header (docs/spheres.md)."},
        {"around", spheres, &Part::around, name(), not_given,
         "A part of one sphere, on whose surface these sit, spread evenly; with count or coverage."},
        {"fill_from", spheres, &Part::fill_from, point(), not_given,
         "One corner of a box that they fill at random without touching each other; with count or volume_fraction."},
        {"fill_to", spheres, &Part::fill_to, point(), not_given, "The opposite corner."},
        {"count", spheres, &Part::count, integer(at_least(1)), not_given, "How many sit around the sphere or fill the box."},
        {"coverage", spheres, &Part::coverage, number(Range{0, 1, true, {}}), not_given,
         "Part of the sphere's surface that those around it hide: N r^2 / (4 (R + r)^2) of N spheres of radius r on one of radius R."},
        {"volume_fraction", spheres, &Part::volume_fraction, number(Range{0, 0.6, true, "spheres that are put in at random get as dense as about 0.35"}), not_given,
         "Part of the box that is filled with spheres."},
        {"initial_velocity", spheres, &Part::initial_velocity, formulas("1 m/s"), not_given,
         "Velocity with which they start, by formulas of x, y, z; spheres around another one start with that one's motion."},
        {"initial_spin", spheres, &Part::initial_spin, formulas("100 rad/s"), not_given,
         "Angular velocity with which they start, by formulas of x, y, z."},
        {"fixed", spheres, &Part::fixed, boolean(), "false", "Whether they never move nor turn."},
        {"point", plane, &Part::point, point(), required, "A point on the plane, at the start."},
        {"normal", plane, &Part::normal, direction(), required, "Points from the plane to the side where the spheres are."},
        {"file", surface, &Part::file, text_not_empty(), required,
         "Triangles of the wall (STL, text or binary), beside the scene file or with its full path."},
        {"unit", surface, &Part::unit, quantity("1 mm", positive), required, "Length of one unit of that file."},
        {"velocity", walls, &Part::velocity, formulas("0.1 m/s"), "[0, 0]", "How fast the wall moves, by formulas of t."},
        {"youngs_modulus", walls, &Part::youngs_modulus, quantity("60 GPa", positive), not_given,
         "Young's modulus of the wall; without it the wall does not yield."},
        {"poisson_ratio", walls, &Part::poisson_ratio, number(between(0, 0.5)), not_given,
         "Poisson's ratio of the wall; with youngs_modulus."},
    };
}

std::vector<Key<ContactPair>> contact_pair_keys() {
    return {
        {"name", &ContactPair::name, name(), not_given, "What the pair is called, for --set contact_pair.NAME.friction=0.1."},
        {"parts", &ContactPair::parts, two_names(), required,
         "The two parts that touch; one of them twice: its spheres touch each other; \"any\": every part that no other pair names."},
        {"enabled", &ContactPair::enabled, boolean(), "true", "false: they pass through each other."},
        {"normal", &ContactPair::normal, one_of<NormalLaw>(), "hertz", "Normal force: " + meanings<NormalLaw>() + "."},
        {"tangential", &ContactPair::tangential, one_of<TangentialLaw>(), "mindlin",
         "Tangential force: " + meanings<TangentialLaw>() + " (docs/contact.md)."},
        {"normal_stiffness_factor", &ContactPair::normal_stiffness_factor, number(positive), "1",
         "Factor of the normal stiffness 4/3 E*."},
        {"tangential_stiffness_factor", &ContactPair::tangential_stiffness_factor, number(positive), "1",
         "Factor of the tangential stiffness 8 G*."},
        {"restitution", &ContactPair::restitution, number(fraction), not_given,
         "Normal velocity after an impact over that before; or give the dampings."},
        {"normal_damping", &ContactPair::normal_damping, quantity("0.3 1/m/s", not_negative), not_given,
         "Damping coefficient gamma_n of the normal force, in place of restitution."},
        {"tangential_damping", &ContactPair::tangential_damping, quantity("0.15 1/m/s", not_negative), not_given,
         "Damping coefficient gamma_t of the tangential force; with normal_damping."},
        {"dashpot_may_pull", &ContactPair::dashpot_may_pull, boolean(), "true",
         "Whether damping may hold the two together just before they part; the restitution comes out either way."},
        {"friction", &ContactPair::friction, number(not_negative), not_given,
         "Coulomb's coefficient of friction; 0: none, and then no tangential force."},
        {"rolling_friction", &ContactPair::rolling_friction, number(not_negative), "0",
         "Coefficient of rolling friction: the torque against rolling over normal force and effective radius."},
        {"rolling", &ContactPair::rolling, one_of<RollingLaw>(), "constant",
         "Rolling friction, where rolling_friction is more than 0: " + meanings<RollingLaw>() + "."},
        {"rolling_damping", &ContactPair::rolling_damping, number(between(0, 1)), "0.3",
         "Damping of the rolling spring as a fraction of critical."},
        {"adhesion", &ContactPair::adhesion, one_of<AdhesionLaw>(), "none",
         "Attraction on top of the normal force: " + meanings<AdhesionLaw>() + ". Not with normal = \"jkr\", which adheres itself."},
        {"work_of_adhesion", &ContactPair::work_of_adhesion, quantity("0.0172 J/m^2", positive), not_given,
         "Work that parts unit area of the two surfaces, twice the surface energy of like ones; or pull_off_force."},
        {"pull_off_force", &ContactPair::pull_off_force, quantity("258 nN", positive), not_given,
         "Force that parts the two, whatever their radii; in place of work_of_adhesion."},
        {"equilibrium_distance", &ContactPair::equilibrium_distance, quantity("0.4 nm", positive), not_given,
         "Distance z0 at which Bradley's attraction ends and contact begins."},
        {"adhesion_cutoff", &ContactPair::adhesion_cutoff, quantity("20 nm", positive), not_given,
         "Gap beyond which Bradley's attraction is left out; without it 50 equilibrium distances."},
    };
}
// clang-format on

}  // namespace dmp::scene
