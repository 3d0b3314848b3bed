// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/sphere_keys.hpp"

#include "models/dem/contact_laws.hpp"
#include "scene/law_lists.hpp"

namespace dmp::scene {

// Columns as in schema.cpp.
// clang-format off

std::vector<Key<Part>> sphere_part_keys() {
    const Kinds spheres = {"spheres"}, plane = {"plane"}, surface = {"surface"}, walls = {"plane", "surface"};
    return {
        {"radius", spheres, &Part::radius, quantity_or_list("1 mm", positive), not_given,
         "Radius of all spheres of the part, or a list with one for each of centres; left out if the positions file "
         "has them."},
        {"density", spheres, &Part::density, quantity("2500 kg/m^3", positive), not_given,
         "Density of the spheres; or give mass."},
        {"mass", spheres, &Part::mass, quantity("1 ug", positive), not_given,
         "Mass of each sphere; or give density."},
        {"youngs_modulus", spheres, &Part::youngs_modulus, quantity("60 GPa", positive), required,
         "Young's modulus of the spheres' material."},
        {"poisson_ratio", spheres, &Part::poisson_ratio, number(between(0, 0.5)), required,
         "Poisson's ratio of the spheres' material."},
        {"centres", spheres, &Part::centres, points(), not_given,
         "Positions of the centres; or give positions, around, or fill_from and fill_to."},
        {"positions", spheres, &Part::positions, text_not_empty(), not_given,
         "CSV file of the positions: columns x, y, z and optionally radius, vx, vy, vz, wx, wy, wz, with their "
         "units in the header (docs/spheres.md)."},
        {"around", spheres, &Part::around, name(), not_given,
         "Part of one sphere, on whose surface these spheres are spread evenly; give count or coverage too."},
        {"fill_from", spheres, &Part::fill_from, point(), not_given,
         "One corner of a box that the spheres fill at random without touching each other; give count or "
         "volume_fraction too."},
        {"fill_to", spheres, &Part::fill_to, point(), not_given, "The opposite corner."},
        {"count", spheres, &Part::count, integer(at_least(1)), not_given,
         "Number of spheres around the sphere or in the box."},
        {"coverage", spheres, &Part::coverage, number(Range{0, 1, true, {}}), not_given,
         "Fraction of the sphere's surface that the spheres around it cover: N r^2 / (4 (R + r)^2) for N spheres of "
         "radius r on one of radius R."},
        {"volume_fraction", spheres, &Part::volume_fraction, number(Range{0, 0.6, true,
         "random filling reaches volume fractions up to about 0.35"}), not_given,
         "Fraction of the box's volume that the spheres fill."},
        {"initial_velocity", spheres, &Part::initial_velocity, formulas("1 m/s"), not_given,
         "Initial velocity of the spheres, as formulas of x, y, z; spheres around another one take its motion by "
         "default."},
        {"initial_spin", spheres, &Part::initial_spin, formulas("100 rad/s"), not_given,
         "Initial angular velocity of the spheres, as formulas of x, y, z."},
        {"fixed", spheres, &Part::fixed, boolean(), "false", "Whether the spheres neither move nor rotate."},
        {"point", plane, &Part::point, point(), required, "A point on the plane, in its initial position."},
        {"normal", plane, &Part::normal, direction(), required,
         "Normal of the plane; it points to the side of the spheres."},
        {"file", surface, &Part::file, text_not_empty(), required,
         "STL file (text or binary) with the wall's triangles, relative to the scene's folder or absolute."},
        {"unit", surface, &Part::unit, quantity("1 mm", positive), required, "Length of one unit of the STL file."},
        {"velocity", walls, &Part::velocity, formulas("0.1 m/s"), "[0, 0]",
         "Velocity of the wall, as formulas of t."},
        {"youngs_modulus", walls, &Part::youngs_modulus, quantity("60 GPa", positive), not_given,
         "Young's modulus of the wall; by default the wall is rigid."},
        {"poisson_ratio", walls, &Part::poisson_ratio, number(between(0, 0.5)), not_given,
         "Poisson's ratio of the wall; give it with youngs_modulus."},
    };
}

std::vector<Key<ContactPair>> contact_pair_keys() {
    return {
        {"name", &ContactPair::name, name(), not_given,
         "Name of the pair, for --set contact_pair.NAME.friction=0.1."},
        {"parts", &ContactPair::parts, two_names(), required,
         "The two parts in contact. One part named twice: its spheres with each other. \"any\": every part that no "
         "other pair names."},
        {"enabled", &ContactPair::enabled, boolean(), "true", "false lets the two pass through each other."},
        {"normal", &ContactPair::normal, one_of<NormalLaw>(), "hertz", "Normal force: " + meanings<NormalLaw>() + "."},
        {"tangential", &ContactPair::tangential, one_of<TangentialLaw>(), "mindlin",
         "Tangential force: " + meanings<TangentialLaw>() + " (docs/contact.md)."},
        {"normal_stiffness_factor", &ContactPair::normal_stiffness_factor, number(positive), "1",
         "Factor of the normal stiffness 4/3 E*."},
        {"tangential_stiffness_factor", &ContactPair::tangential_stiffness_factor, number(positive), "1",
         "Factor of the tangential stiffness 8 G*."},
        {"restitution", &ContactPair::restitution, number(fraction), not_given,
         "Coefficient of restitution: normal velocity after an impact divided by that before. Or give the damping "
         "coefficients."},
        {"normal_damping", &ContactPair::normal_damping, quantity("0.3 1/m/s", not_negative), not_given,
         "Coefficient gamma_n of the normal damping force; or give restitution."},
        {"tangential_damping", &ContactPair::tangential_damping, quantity("0.15 1/m/s", not_negative), not_given,
         "Coefficient gamma_t of the tangential damping force, with normal_damping."},
        {"dashpot_may_pull", &ContactPair::dashpot_may_pull, boolean(), "true",
         "Whether the damping force may pull the two together just before they separate. The restitution is the "
         "same either way."},
        {"friction", &ContactPair::friction, number(not_negative), not_given,
         "Coulomb's coefficient of friction; 0: no tangential force."},
        {"rolling_friction", &ContactPair::rolling_friction, number(not_negative), "0",
         "Coefficient of rolling friction: largest rolling torque divided by normal force and effective radius."},
        {"rolling", &ContactPair::rolling, one_of<RollingLaw>(), "constant",
         "Rolling friction, if rolling_friction is more than 0: " + meanings<RollingLaw>() + "."},
        {"rolling_damping", &ContactPair::rolling_damping, number(between(0, 1)), "0.3",
         "Damping of the rolling spring, as a fraction of critical damping."},
        {"adhesion", &ContactPair::adhesion, one_of<AdhesionLaw>(), "none",
         "Attraction in addition to the normal force: " + meanings<AdhesionLaw>() +
          "; not with normal = " + adhesive_laws<NormalLaw>() + ", which is adhesive itself."},
        {"work_of_adhesion", &ContactPair::work_of_adhesion, quantity("0.0172 J/m^2", positive), not_given,
         "Work of adhesion per area of the two surfaces, for equal materials twice the surface energy; or give "
         "pull_off_force."},
        {"pull_off_force", &ContactPair::pull_off_force, quantity("258 nN", positive), not_given,
         "Pull-off force of the two, whatever their radii; or give work_of_adhesion."},
        {"equilibrium_distance", &ContactPair::equilibrium_distance, quantity("0.4 nm", positive), not_given,
         "Distance z0 at which contact begins and Bradley's law for separated surfaces ends."},
        {"adhesion_cutoff", &ContactPair::adhesion_cutoff, quantity("20 nm", positive), not_given,
         "Gap beyond which Bradley's attraction is cut off; 50 equilibrium distances by default."},
    };
}
// clang-format on

}  // namespace dmp::scene
