// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/schema.hpp"

#include <algorithm>

#include "scene/driving_keys.hpp"
#include "scene/join_keys.hpp"
#include "scene/measure_keys.hpp"
#include "scene/solidify_keys.hpp"
#include "scene/sphere_keys.hpp"

namespace dmp::scene {

namespace {

using Geometry = decltype(Scene::geometry);
using Particles = decltype(Scene::particles);
using Flow = decltype(Scene::flow);
using Contact = decltype(Scene::contact);
using Numerics = decltype(Scene::numerics);
using Run = decltype(Scene::run);
using Output = decltype(Scene::output);
using SceneBox = decltype(Scene::box);

// One key a row. Columns: key, the kinds it is for (parts and measures), member, type with unit and range, default,
// meaning.
// clang-format off

std::vector<Key<Scene>> top_keys() {
    return {
        {"schema", &Scene::schema, integer(exactly(1, "this dmp reads schema = 1")), required,
         "Version of the scene's keys."},
        {"title", &Scene::title, text(), not_given, "What the scene shows; stands on the report and the pictures."},
        {"dimension", &Scene::dimension, integer(Range{2, 3, false, {}}), "2",
         "Dimensions of space; a 2-D scene is 1 m deep."},
        {"quality", &Scene::quality, one_of<Quality>(), "standard",
         "Sets what trades accuracy for speed together, where the scene does not give it (docs/accuracy.md)."},
    };
}

std::vector<Key<Geometry>> geometry_keys() {
    return {
        {"file", &Geometry::file, text_not_empty(), not_given,
         "The geometry, beside the scene file or with its full path; scenes of spheres and their walls have none."},
        {"unit", &Geometry::unit, quantity("1 mm", positive), "1 m",
         "Length of one unit of the geometry. STL, OBJ, PLY, OFF and BREP files do not say it: the scene must; STEP and IGES "
         "files do, and it is left out."},
        {"parameters", {}, &Geometry::parameters, [](const Geometry& geometry) { return parameters(geometry.unit); },
         parameters(1).description, "{}",
         "Values for the geometry's DefineConstant names; lengths are turned into the geometry's unit, angles into radians."},
        {"repair", &Geometry::repair, one_of<RepairKind>(), "wrap",
         "How far the repair of a fluid's surface that is not closed may go; each step has those before it "
         "(docs/repair.md)."},
        {"largest_hole", &Geometry::largest_hole, number(not_negative), "8",
         "Perimeter in spacings of the largest hole that repair = \"fill\" closes."},
    };
}

ValueType<double> angle_type() {
    ValueType<double> type = quantity("30 deg", Range{0, 3.15, true, {}});
    type.description = "an angle such as \"30 deg\", more than 0";
    type.write = [](const double& angle) { return toml_quoted(exact_text(angle) + " rad"); };
    return type;
}

std::vector<Key<Selection>> select_keys() {
    return {
        {"name", &Selection::name, name(), required, "What the selected faces are called, for a part of this name."},
        {"of", &Selection::of, name(), required, "The volume or surface of the geometry whose faces they are; in 2-D the area or curve of which they are curves."},
        {"x", &Selection::x, quantity("2 mm"), not_given, "Faces that lie in the plane of this x."},
        {"y", &Selection::y, quantity("2 mm"), not_given, "Faces that lie in the plane of this y."},
        {"z", &Selection::z, quantity("2 mm"), not_given, "Faces that lie in the plane of this z."},
        {"from", &Selection::from, point(), not_given, "One corner of a box along the axes that the faces lie in."},
        {"to", &Selection::to, point(), not_given, "The opposite corner."},
        {"normal", &Selection::normal, direction(), not_given, "Faces that face this way, out of the body or area."},
        {"angle", &Selection::angle, angle_type(), "10 deg",
         "How far from the normal they may face."},
        {"except", &Selection::except, names(), not_given, "Faces that are in none of these selections, surfaces or curves; with nothing else: all the others."},
    };
}

std::vector<Key<Particles>> particles_keys() {
    return {
        {"spacing", &Particles::spacing, quantity("0.1 mm", positive), not_given,
         "Distance between neighbouring particles; needed for all but spheres."},
        {"arrangement", &Particles::arrangement, one_of<Arrangement>(), "square",
         "Lattice on which the fluid starts; in 3-D \"square\" is cubic, \"hexagonal\" is close-packed, and there is "
         "face-centred cubic, \"fcc\"."},
        {"fill", &Particles::fill, one_of<FillKind>(), "lattice",
         "\"relaxed\" moves particles off the lattice until they follow the curves or surfaces of the geometry, those of walls "
         "too, with particles at corners and edges; arrangement is then where they start from, and \"square\" a good start. "
         "\"sampled\" does the same from places at random that keep their distance, without a lattice's directions."},
        {"disorder", &Particles::disorder, number(between(0, 0.4)), "0",
         "Largest random displacement of fluid particles from the lattice along each axis, in spacings."},
        {"seed", &Particles::seed, integer(not_negative), "1", "Chooses among the random displacements, the sampled places, and the places of spheres."},
    };
}

std::vector<Key<Part>> part_keys() {
    const Kinds all, fluid = {"fluid"}, rigid = {"rigid"}, springs = {"elastic"};
    return {
        {"name", all, &Part::name, name(), required, "The part's physical group, solid or curve in the geometry, if it is drawn."},
        {"kind", all, &Part::kind, one_of<PartKind>(), required,
         "What the part is made of: a fluid, a rigid wall, a flexible solid of masses and springs, spheres that touch, or a "
         "wall for spheres: a plane or a surface of triangles."},
        {"enabled", all, &Part::enabled, boolean(), "true", "false leaves the part out; its name stays known."},
        {"density", fluid, &Part::density, quantity("1000 kg/m^3", positive), required, "Density at rest."},
        {"viscosity", fluid, &Part::viscosity, quantity("1 mPa*s", not_negative), required, "Dynamic viscosity."},
        {"layers", rigid, &Part::layers, integer(at_least(1)), ByQuality{"3", "3", "4"},
         "Rows of wall particles; the wall must be as thick as the kernel's support."},
        {"surface_velocity", rigid, &Part::surface_velocity, formulas("1 m/s"), "[0, 0]",
         "How fast the wall's surface slides in itself, as a lid or a belt does, by formulas of t, x, y."},
        {"slip", rigid, &Part::slip, boolean(), "false",
         "Whether the fluid slides along the wall without shear stress; false: it sticks."},
        {"velocity", rigid, &Part::velocity, formulas("0.1 m/s"), "[0, 0]",
         "How fast the part moves as a whole, by formulas of t."},
        {"spin", rigid, &Part::spin, formula("2 rad/s"), "0",
         "How fast the part turns about its centre, counter-clockwise, by a formula of t."},
        {"centre", rigid, &Part::centre, point(), "[0, 0]",
         "What the part turns about, as drawn; it moves with the part's velocity."},
        {"layers", springs, &Part::layers,
         integer(exactly(2, "elastic solids have two rows of particles for now: write layers = 2")), "2",
         "Rows of particles across the solid's thickness."},
        {"density", springs, &Part::density, quantity("1100 kg/m^3", positive), not_given,
         "Of the material, in 3-D and of an area in 2-D; of a strip mass_per_length says it."},
        {"bending_stiffness", springs, &Part::bending_stiffness, quantity("3e-6 N*m^2", positive), not_given,
         "EI of a strip 1 m deep; with axial_stiffness, or youngs_modulus and thickness in their place."},
        {"axial_stiffness", springs, &Part::axial_stiffness, quantity("100 N", positive), not_given,
         "EA of a strip 1 m deep."},
        {"shear_stiffness", springs, &Part::shear_stiffness, quantity("40 N", positive), not_given,
         "GA of a strip 1 m deep, shear correction and all; without it what the lattice has for its EI and EA."},
        {"youngs_modulus", springs, &Part::youngs_modulus, quantity("2 MPa", positive), not_given,
         "E of the material. Of a strip 1 m deep the thickness h gives EA = E h / (1 - nu^2), EI = E h^3 / (12 (1 - nu^2)); of a shell in 3-D E h and D = E h^3 / (12 (1 - nu^2))."},
        {"thickness", springs, &Part::thickness, quantity("0.3 mm", positive), not_given,
         "Thickness h that goes with youngs_modulus, of a strip, or of a surface in 3-D, which becomes a shell."},
        {"poisson_ratio", springs, &Part::poisson_ratio, number(between(0, 0.5)), not_given,
         "nu that goes with youngs_modulus, of a strip held in its depth; without it, or 0, the strip is free to change it. Of a solid 0 to 0.25, and 0.25 is the fastest."},
        {"lower_axial_stiffness", springs, &Part::lower_axial_stiffness, boolean(), "true",
         "Lower EA, or a shell's E h (with cross_bonds: raise it), where the lattice cannot also hold EI, or D, at this spacing; false makes that an error."},
        {"cross_bonds", springs, &Part::cross_bonds, boolean(), "false",
         "Bonds along both diagonals of each cell in place of hinges at its corners; for EA of 5 EI / spacing^2 and more."},
        {"bonds_within", springs, &Part::bonds_within, quantity("0.15 mm", positive), not_given,
         "Of a solid: bonds between all its particles no further apart, of a Poisson ratio of 0.25, in place of the springs of lattice cells; for every arrangement and fill."},
        {"mass_per_length", springs, &Part::mass_per_length, quantity("0.4 kg/m", positive), not_given,
         "Mass of a strip 1 m deep along its length; needed in 2-D for a curve."},
        {"anchor", springs, &Part::anchor, text_not_empty(), not_given,
         "Named points of the geometry where the part is clamped, or a curve, on which its ends are; of an area all nodes next to them; in 3-D a surface or volume: all nodes next to it are. Without it the part is free."},
        {"bond_damping", springs, &Part::bond_damping, number(between(0, 1)), "0.01",
         "Dashpot along each bond and at each hinge, as a fraction of critical damping."},
        {"drag", springs, &Part::drag, quantity("1e-6 kg/s", not_negative), "0",
         "Linear drag in the lab frame: force = -drag * velocity on each particle."},
    };
}

std::vector<Key<SceneBox>> box_keys() {
    return {
        {"from", &SceneBox::from, point(), not_given,
         "One corner of the box that repeats itself along flow.periodic, in scenes of spheres, which have no geometry."},
        {"to", &SceneBox::to, point(), not_given, "The opposite corner."},
    };
}

std::vector<Key<Flow>> flow_keys() {
    return {
        {"acceleration", &Flow::acceleration, formulas("0.1 m/s^2"), "[0, 0]",
         "Body acceleration of fluid and spheres along x and y, as formulas of t, x, y."},
        {"periodic", &Flow::periodic, axes(), "[]", "Axes along which the scene repeats itself."},
        {"symmetry", &Flow::symmetry, list_of<BoxSide>(), "[]",
         "Sides of the box around the fluid on which the whole scene is mirrored."},
        {"largest_speed", &Flow::largest_speed, quantity("0.2 m/s", positive), not_given,
         "Largest speed expected; needed where numerics.sound_speed is \"auto\"."},
        {"largest_pressure", &Flow::largest_pressure, quantity("2 kPa", positive), not_given,
         "Largest pressure expected; without it the fluid's extent times density and body acceleration."},
        {"initial_velocity", &Flow::initial_velocity, formulas("0.1 m/s"), "[0, 0]",
         "Velocity with which the fluid starts, along x and y, as formulas of x, y."},
        {"initial_pressure", &Flow::initial_pressure, formula("100 Pa"), "0",
         "Pressure with which the fluid starts, as a formula of x, y; density follows from the equation of state."},
    };
}

std::vector<Key<Contact>> contact_keys() {
    return {
        {"range", &Contact::range, number(not_negative), "1.0",
         "Cut-off of the short-range repulsion in spacings; 0 switches it off."},
        {"strength", &Contact::strength, quantity_or_auto("1e-6 J"), "auto",
         "Strength K of the short-range repulsion."},
    };
}

std::vector<Key<Numerics>> numerics_keys() {
    return {
        {"kernel", &Numerics::kernel, one_of<KernelKind>(), ByQuality{"lucy", "wendland_c2", "wendland_c2"},
         "Smoothing kernel."},
        {"support", &Numerics::support, number(between(2, 6)), ByQuality{"3.0", "3.0", "4.0"},
         "Radius of the kernel's support in spacings."},
        {"sound_speed", &Numerics::sound_speed, quantity_or_auto("2 m/s"), "auto",
         "Speed of sound of the fluid; \"auto\" follows from numerics.mach_number, flow.largest_speed and the largest "
         "pressure."},
        {"mach_number", &Numerics::mach_number, number(Range{0.01, 0.3, false, {}}), ByQuality{"0.15", "0.1", "0.1"},
         "Largest speed over the speed of sound where that is \"auto\"; density varies by about its square."},
        {"walls", &Numerics::walls, one_of<WallModel>(), "extrapolated",
         "What wall particles carry: pressure and velocity extrapolated from the fluid, or plain resting fluid."},
        {"equation_of_state", &Numerics::equation_of_state, one_of<EquationOfState>(), "tait",
         "Pressure from density: Tait's equation with exponent 7, or a straight line."},
        {"background_pressure", &Numerics::background_pressure, quantity("200 Pa", not_negative), "0",
         "Pressure added to the equation of state, for fluids that are confined or periodic."},
        {"density", &Numerics::density, one_of<DensityModel>(), "continuity",
         "Density from its rate, or anew each step as a sum over neighbours."},
        {"gradient_correction", &Numerics::gradient_correction, boolean(), "false",
         "Whether the kernel's gradient is corrected, so that linear fields have exact gradients."},
        {"viscous_law", &Numerics::viscous_law, one_of<ViscousLaw>(), "morris",
         "Viscous force: " + meanings<ViscousLaw>() + "."},
        {"viscosity_mean", &Numerics::viscosity_mean, one_of<ViscosityMean>(), "harmonic",
         "Mean of two viscosities where fluids of unlike viscosity meet."},
        {"density_diffusion", &Numerics::density_diffusion, number(between(0, 1)), "0.1",
         "Strength delta of the density diffusion; 0 switches it off, as density = \"summation\" does."},
        {"shifting", &Numerics::shifting, number(not_negative), ByQuality{"3.0", "4.0", "6.0"},
         "Strength of the particle shifting; 0 switches it off, as transport_velocity = true does."},
        {"transport_velocity", &Numerics::transport_velocity, boolean(), "false",
         "Whether particles move with a transport velocity that spreads them evenly, instead of shifting."},
        {"step_factor", &Numerics::step_factor, number(fraction), ByQuality{"0.4", "0.3", "0.15"},
         "Fluid step: speed of sound * step / support radius."},
        {"viscosity_stepping", &Numerics::viscosity_stepping, one_of<ViscosityStepping>(), "explicit",
         "Viscous forces of velocities as they were, which limits the step, or as they will be, solved for in each step."},
        {"viscosity_tolerance", &Numerics::viscosity_tolerance, number(between(1e-14, 0.01)), "1e-6",
         "Implicit viscosity: when a solve ends, as the velocities' error by its residual over the velocities."},
        {"spring_stepping", &Numerics::spring_stepping, one_of<SpringStepping>(), "implicit",
         "How springs keep up with the fluid: one implicit step with it, or many small explicit ones."},
        {"spring_step_factor", &Numerics::spring_step_factor, number(fraction), "0.5",
         "Explicit spring step as a fraction of the largest stable one."},
        {"species_stepping", &Numerics::species_stepping, one_of<SpeciesStepping>(), "explicit",
         "Diffusion of species by concentrations as they were, which limits the step, or as they will be, solved for in each step."},
        {"species_tolerance", &Numerics::species_tolerance, number(between(1e-14, 0.01)), "1e-8",
         "Implicit diffusion: when a solve ends, as the concentrations' error by its residual over the concentrations."},
        {"steps_per_contact", &Numerics::steps_per_contact, number(at_least(5)), ByQuality{"10", "20", "50"},
         "Spheres: time steps in the shortest elastic impact, where contact_step is \"auto\"."},
        {"contact_step", &Numerics::contact_step, quantity_or_auto("1 ns"), "auto", "Spheres: the time step."},
    };
}

std::vector<Key<Run>> run_keys() {
    return {
        {"duration", &Run::duration, quantity("4 s", positive), required, "Simulated time."},
        {"threads", &Run::threads, integer(not_negative), "0", "Threads to run on; 0 takes all the machine has."},
        {"until_steady", &Run::until_steady, quantity("10 us", not_negative), "0 s",
         "Spheres: end the run once nothing has changed for this time, no contact and hardly the kinetic energy; 0: do not."},
    };
}

std::vector<Key<Output>> output_keys() {
    return {
        {"every", &Output::every, quantity("20 ms", positive), required, "Time between frames."},
        {"fields", &Output::fields, list_of<FluidField>(), "['velocity', 'pressure', 'shear_stress']",
         "Fields of each particle in the frames."},
        {"measure_every", &Output::measure_every, quantity_or_auto("5 ms"), "auto",
         "Time between rows of measures.csv; \"auto\" is a quarter of output.every."},
        {"pictures", &Output::pictures, boolean(), "true", "Whether pictures are drawn."},
        {"picture_field", &Output::picture_field, one_of<FluidField>(), "velocity", "Field the pictures show."},
        {"solid_fields", &Output::solid_fields, list_of<SolidField>(),
         "['velocity', 'displacement', 'strain', 'force']",
         "Fields of spring bodies in the frames; strain and force are of each bond."},
        {"average_from", &Output::average_from, quantity("1 s", not_negative), "0 s",
         "When time averages (mean_displacement) begin."},
    };
}
// clang-format on

/// Adds the keys of one table of the scene.
template <class Section>
void add_section(std::vector<Key<Scene>>& keys, const std::string& name, Section Scene::*member,
                 std::vector<Key<Section>> rows) {
    for (auto& row : rows) {
        row.facts.path = name + "." + row.facts.path;
        keys.emplace_back(
            std::move(row.facts),
            [member, read = std::move(row.read)](Scene& scene, const TomlNode& node, const std::string& path) {
                read(scene.*member, node, path);
            },
            [member, write = std::move(row.write)](const Scene& scene) { return write(scene.*member); });
    }
}

template <class Item>
std::vector<Key<Item>> each_item(const std::string& name, std::vector<Key<Item>> rows) {
    for (auto& row : rows) row.facts.path = name + ".*." + row.facts.path;
    return rows;
}

Schema whole_schema() {
    Schema schema;
    schema.scene = top_keys();
    add_section(schema.scene, "geometry", &Scene::geometry, geometry_keys());
    add_section(schema.scene, "particles", &Scene::particles, particles_keys());
    add_section(schema.scene, "box", &Scene::box, box_keys());
    add_section(schema.scene, "flow", &Scene::flow, flow_keys());
    add_section(schema.scene, "contact", &Scene::contact, contact_keys());
    add_section(schema.scene, "numerics", &Scene::numerics, numerics_keys());
    add_section(schema.scene, "run", &Scene::run, run_keys());
    add_section(schema.scene, "output", &Scene::output, output_keys());
    auto parts = part_keys();
    for (auto& row : sphere_part_keys()) parts.push_back(std::move(row));
    schema.select = each_item("select", select_keys());
    schema.part = each_item("part", std::move(parts));
    schema.join = each_item("join", join_keys());
    schema.species = each_item("species", species_keys());
    schema.contact_pair = each_item("contact_pair", contact_pair_keys());
    schema.force = each_item("force", force_keys());
    schema.moving_shape = each_item("moving_shape", moving_shape_keys());
    schema.region = each_item("region", region_keys());
    schema.measure = each_item("measure", measure_keys());
    schema.solidify = each_item("solidify", solidify_keys());
    schema.breaking = each_item("break", breaking_keys());
    return schema;
}

}  // namespace

const Schema& schema() {
    static const Schema whole = whole_schema();
    return whole;
}

const std::vector<std::string>& item_lists() {
    static const std::vector<std::string> names{"select",       "part",     "join",         "species",
                                                "contact_pair", "force",    "moving_shape", "region",
                                                "measure",      "solidify", "break"};
    return names;
}

std::vector<KeyFacts> Schema::facts() const {
    std::vector<KeyFacts> facts;
    const auto section_of = [&](const std::string& path) { return path.substr(0, path.find('.')); };
    for (const auto& key : scene) {
        if (section_of(key.facts.path) == "particles" && section_of(facts.back().path) == "geometry")
            for (const auto& select_key : select) facts.push_back(select_key.facts);
        if (section_of(key.facts.path) == "box" && section_of(facts.back().path) == "particles") {
            for (const auto& part_key : part)
                facts.push_back(part_key.facts);  // after [particles], as scenes are written
            for (const auto& join_key : join) facts.push_back(join_key.facts);
            for (const auto& pair_key : contact_pair) facts.push_back(pair_key.facts);
        }
        facts.push_back(key.facts);
    }
    for (const auto& key : species) facts.push_back(key.facts);
    for (const auto& key : force) facts.push_back(key.facts);
    for (const auto& key : moving_shape) facts.push_back(key.facts);
    for (const auto& key : region) facts.push_back(key.facts);
    for (const auto& key : measure) facts.push_back(key.facts);
    for (const auto& key : solidify) facts.push_back(key.facts);
    for (const auto& key : breaking) facts.push_back(key.facts);
    return facts;
}

}  // namespace dmp::scene
