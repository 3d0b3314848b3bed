// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/schema.hpp"

#include <algorithm>

#include "scene/contact_keys.hpp"
#include "scene/driving_keys.hpp"
#include "scene/join_keys.hpp"
#include "scene/measure_keys.hpp"
#include "scene/reference_keys.hpp"
#include "scene/solidify_keys.hpp"
#include "scene/sphere_keys.hpp"
#include "scene/step_margins.hpp"

namespace dmp::scene {

namespace {

using Geometry = decltype(Scene::geometry);
using Particles = decltype(Scene::particles);
using Flow = decltype(Scene::flow);
using Numerics = decltype(Scene::numerics);
using Run = decltype(Scene::run);
using Output = decltype(Scene::output);
using SceneBox = decltype(Scene::box);

// One row per key. Columns: key, kinds of parts or measures that have it, member, type with unit and range, default,
// meaning.
// clang-format off

std::vector<Key<Scene>> top_keys() {
    return {
        {"schema", &Scene::schema, integer(exactly(1, "this dmp reads schema = 1")), required,
         "Version of the scene's keys."},
        {"title", &Scene::title, text(), not_given, "What the scene shows; a title in reports and pictures."},
        {"dimension", &Scene::dimension, integer(Range{2, 3, false, {}}), "2",
         "Number of dimensions, 2 or 3; a 2-D scene is 1 m deep."},
        {"quality", &Scene::quality, one_of<Quality>(), "standard",
         "Trades accuracy for speed: sets the default of several keys together (docs/accuracy.md)."},
    };
}

std::vector<Key<Geometry>> geometry_keys() {
    return {
        {"file", &Geometry::file, text_not_empty(), not_given,
         "CAD file, relative to the scene's folder or absolute. Scenes of spheres have none."},
        {"unit", &Geometry::unit, quantity("1 mm", positive), "1 m",
         "Length of one unit of the CAD file. Required for STL, OBJ, PLY, OFF and BREP files, which do not state "
         "their unit; not allowed for STEP and IGES files, which do."},
        {"parameters", {}, &Geometry::parameters, [](const Geometry& geometry) { return parameters(geometry.unit); },
         parameters(1).description, "{}",
         "Values for the DefineConstant names of the CAD file. Lengths are converted to the file's unit, angles to "
         "radians."},
        {"repair", &Geometry::repair, one_of<RepairKind>(), "wrap",
         "Largest repair allowed for a fluid's surface that is not closed; each level includes the previous ones "
         "(docs/repair.md)."},
        {"largest_hole", &Geometry::largest_hole, number(not_negative), "8",
         "Perimeter of the largest hole that repair = \"fill\" closes, in particle spacings."},
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
        {"name", &Selection::name, name(), required,
         "Name of the surface that the selected faces form; a part of this name consists of it."},
        {"of", &Selection::of, name(), required,
         "Volume or surface of the geometry whose faces are selected; in 2-D the area or curve whose pieces are "
         "selected."},
        {"x", &Selection::x, quantity("2 mm"), not_given, "Selects faces in the plane of this x."},
        {"y", &Selection::y, quantity("2 mm"), not_given, "Selects faces in the plane of this y."},
        {"z", &Selection::z, quantity("2 mm"), not_given, "Selects faces in the plane of this z."},
        {"from", &Selection::from, point(), not_given,
         "Selects faces inside a box along the axes: one of its corners."},
        {"to", &Selection::to, point(), not_given, "The opposite corner."},
        {"normal", &Selection::normal, direction(), not_given,
         "Selects faces whose outward normal has this direction, to within angle."},
        {"angle", &Selection::angle, angle_type(), "10 deg",
         "Largest angle between normal and the outward normal of a selected face."},
        {"except", &Selection::except, names(), not_given,
         "Selects faces that are in none of these earlier selections, surfaces or curves. Without other criteria, "
         "all remaining faces are selected."},
    };
}

std::vector<Key<Particles>> particles_keys() {
    return {
        {"spacing", &Particles::spacing, quantity("0.1 mm", positive), not_given,
         "Distance between neighbouring particles; required except in scenes of spheres."},
        {"arrangement", &Particles::arrangement, one_of<Arrangement>(), "square",
         "Lattice of the initial fluid particles: \"square\" (cubic in 3-D), \"hexagonal\" (close-packed in 3-D) "
         "or, in 3-D only, face-centred cubic \"fcc\"."},
        {"fill", &Particles::fill, one_of<FillKind>(), "lattice",
         "\"lattice\" leaves particles on the lattice. \"relaxed\" starts on it and moves fluid and wall particles "
         "until they follow the curves or surfaces of the geometry, with particles at corners and edges; use it "
         "with the \"square\" arrangement. \"sampled\" does the same from random fluid positions that keep a "
         "distance from each other, so that no lattice direction remains (docs/meshing.md)."},
        {"disorder", &Particles::disorder, number(between(0, 0.4)), "0",
         "Largest initial random displacement of fluid particles from the lattice along each axis, in spacings."},
        {"seed", &Particles::seed, integer(not_negative), "1",
         "Seed of the random numbers for disorder, sampled positions and positions of spheres."},
    };
}

std::vector<Key<Part>> part_keys() {
    const Kinds all, fluid = {"fluid"}, rigid = {"rigid"}, springs = {"elastic"};
    return {
        {"name", all, &Part::name, name(), required,
         "Name of the part: its physical group, solid, surface or curve in the geometry, if it has one there."},
        {"kind", all, &Part::kind, one_of<PartKind>(), required,
         "Kind of part: a fluid, a rigid wall, an elastic solid, spheres in contact, or a wall "
         "for spheres (a plane or a surface of triangles)."},
        {"enabled", all, &Part::enabled, boolean(), "true",
         "false leaves the part out of the simulation; the geometry may still contain it."},
        {"density", fluid, &Part::density, quantity("1000 kg/m^3", positive), required, "Density at rest."},
        {"viscosity", fluid, &Part::viscosity, quantity("1 mPa*s", not_negative), required, "Dynamic viscosity."},
        {"layers", rigid, &Part::layers, integer(at_least(1)), ByQuality{"3", "3", "4"},
         "Rows of wall particles; the wall must be as thick as the kernel's support."},
        {"surface_velocity", rigid, &Part::surface_velocity, formulas("1 m/s"), "[0, 0]",
         "Velocity of the wall's surface along itself, as of a lid or a belt, as formulas of t and of the place x, y, z "
         "on the surface."},
        {"slip", rigid, &Part::slip, boolean(), "false",
         "true: the fluid slips along the wall without shear stress; false: no slip."},
        {"velocity", rigid, &Part::velocity, formulas("0.1 m/s"), "[0, 0]",
         "Velocity of the part, as formulas of t."},
        {"spin", rigid, &Part::spin, formula("2 rad/s"), "0",
         "Angular velocity of the part about its centre, anticlockwise, as a formula of t."},
        {"centre", rigid, &Part::centre, point(), "[0, 0]",
         "Initial position of the centre of rotation; it moves with the part's velocity."},
        {"layers", springs, &Part::layers,
         integer(exactly(2, "the rows of an elastic solid follow from its thickness: leave layers out, or write 2")), "2",
         "Rows of particles of strips and shells; thicker strips have more, by their thickness. May be left out."},
        {"density", springs, &Part::density, quantity("1100 kg/m^3", positive), not_given,
         "Density of the material, in 3-D and for an area in 2-D; a strip (a curve in 2-D) takes mass_per_length "
         "instead."},
        {"model", springs, &Part::model, one_of<ElasticModel>(), not_given,
         "What an area in 2-D, or a volume in 3-D, of an elastic solid is made of: \"cells\" (without this key), finite "
         "elements that have any Poisson's ratio below 0.5 and bend right with two particles across, or \"springs\" "
         "between its particles, which bonds of [[join]] and [[solidify]] need."},
        {"elastic_law", springs, &Part::elastic_law, one_of<ElasticLaw>(), not_given,
         "Law of a solid of cells; without this key that of Saint Venant and Kirchhoff."},
        {"bending_stiffness", springs, &Part::bending_stiffness, quantity("3e-6 N*m^2", positive), not_given,
         "Bending stiffness EI of a strip 1 m deep. Give it with axial_stiffness, or give youngs_modulus and "
         "thickness instead."},
        {"axial_stiffness", springs, &Part::axial_stiffness, quantity("100 N", positive), not_given,
         "Axial stiffness EA of a strip 1 m deep."},
        {"shear_stiffness", springs, &Part::shear_stiffness, quantity("40 N", positive), not_given,
         "Shear stiffness GA of a strip 1 m deep, including the shear correction factor. Without it, GA follows "
         "from EI and EA and the lattice."},
        {"youngs_modulus", springs, &Part::youngs_modulus, quantity("2 MPa", positive), not_given,
         "Young's modulus E of the material. A strip 1 m deep of thickness h has EA = E h / (1 - nu^2) and EI = E "
         "h^3 / (12 (1 - nu^2)); a shell in 3-D has E h and D = E h^3 / (12 (1 - nu^2))."},
        {"thickness", springs, &Part::thickness, quantity("0.3 mm", positive), not_given,
         "Thickness h of a strip, with youngs_modulus, or of a surface in 3-D, which becomes a shell. Liquid flows past "
         "surfaces half of it from the middle. A strip with bending_stiffness and axial_stiffness has, without it, the "
         "thickness that its mass_per_length has at the liquid's density."},
        {"poisson_ratio", springs, &Part::poisson_ratio, number(between(0, 0.5)), not_given,
         "Poisson's ratio nu, with youngs_modulus. A strip with nu is in plane strain (its depth is held); without "
         "nu, or with 0, its depth is free to change. A solid of springs takes 0 to 0.25, and 0.25 is fastest; one of cells "
         "takes 0 to less than 0.5."},
        {"lower_axial_stiffness", springs, &Part::lower_axial_stiffness, boolean(), "true",
         "Whether EA (of a shell: E h) may be lowered, or raised with cross_bonds, where the lattice cannot provide "
         "it together with EI (of a shell: D) at this spacing. false makes this an error."},
        {"cross_bonds", springs, &Part::cross_bonds, boolean(), "false",
         "Bonds along both diagonals of each cell instead of hinges at its corners; for EA of at least 5 EI / "
         "spacing^2."},
        {"bonds_within", springs, &Part::bonds_within, quantity("0.15 mm", positive), not_given,
         "For a solid: bonds between all its particles within this distance, with a Poisson's ratio of 0.25, "
         "instead of springs on lattice cells. Works with every arrangement and fill."},
        {"mass_per_length", springs, &Part::mass_per_length, quantity("0.4 kg/m", positive), not_given,
         "Mass per length of a strip 1 m deep; required for a curve in 2-D."},
        {"anchor", springs, &Part::anchor, text_not_empty(), not_given,
         "What the part is clamped to: points or a curve in 2-D, a surface or volume in 3-D. A strip is clamped at "
         "the points, or where its ends lie on the curve; an area or solid at all nodes next to it; a shell along "
         "the edge that touches it. Without anchor the part is free."},
        {"bond_damping", springs, &Part::bond_damping, number(between(0, 1)), "0.01",
         "Dashpot of each bond and hinge, as a fraction of critical damping; of cells the same fraction at the highest "
         "frequency of the lattice."},
        {"damping_ratio", springs, &Part::damping_ratio, number(between(0, 1)), not_given,
         "Of a solid of cells, instead of bond_damping: damping of a mode with the frequency damping_frequency, as a "
         "fraction of critical. It grows with the frequency: viscous over elastic moduli are damping_ratio / (pi "
         "damping_frequency) (docs/elastic.md)."},
        {"damping_frequency", springs, &Part::damping_frequency, quantity("1.1 Hz", positive), not_given,
         "Frequency at which damping_ratio holds."},
        {"drag", springs, &Part::drag, quantity("1e-6 kg/s", not_negative), "0",
         "Linear drag in the lab frame; the force on each particle is -drag * velocity, so that the drag of the whole "
         "part depends on the spacing."},
        {"mass_damping", springs, &Part::mass_damping, quantity("10 1/s", not_negative), "0",
         "Damping proportional to mass, in the lab frame: the force on each particle is -mass_damping * mass * velocity, "
         "whatever the spacing."},
        {"initial_velocity", springs, &Part::initial_velocity, formulas("1 m/s"), not_given,
         "Initial velocity of the solid, as formulas of x, y, z; what is clamped stays at rest."},
    };
}

std::vector<Key<SceneBox>> box_keys() {
    return {
        {"from", &SceneBox::from, point(), not_given,
         "One corner of the box that repeats along flow.periodic, for scenes of spheres, which have no geometry."},
        {"to", &SceneBox::to, point(), not_given, "The opposite corner."},
    };
}

std::vector<Key<Flow>> flow_keys() {
    return {
        {"acceleration", &Flow::acceleration, formulas("0.1 m/s^2"), "[0, 0]",
         "Body acceleration, as formulas of t, x, y, z: gravity, or an accelerated frame. It acts on the mass of all that "
         "moves: fluid, elastic solids and spheres."},
        {"pressure_gradient", &Flow::pressure_gradient, formulas("-100 Pa/m"), "[0, 0]",
         "Mean gradient of the pressure along periodic axes, as formulas of t: dp/dx, so less than 0 drives the fluid "
         "towards x. It acts on the volume of the fluid and of elastic solids in it, not on walls (docs/driving.md)."},
        {"periodic", &Flow::periodic, axes(), "[]", "Axes along which the scene is periodic."},
        {"symmetry", &Flow::symmetry, list_of<BoxSide>(), "[]",
         "Sides of the fluid's box that are planes of symmetry."},
        {"largest_speed", &Flow::largest_speed, quantity("0.2 m/s", positive), not_given,
         "Largest speed expected; required if numerics.sound_speed is \"auto\"."},
        {"largest_pressure", &Flow::largest_pressure, quantity("2 kPa", positive), not_given,
         "Largest pressure expected; by default that of the fluid's weight or drive (along periodic axes: where solids "
         "stand in the way), or viscosity times flow.largest_speed over four spacings if that is more (corrected "
         "scheme, explicit viscosity)."},
        {"initial_velocity", &Flow::initial_velocity, formulas("0.1 m/s"), "[0, 0]",
         "Initial velocity of the fluid, as formulas of x, y, z."},
        {"initial_pressure", &Flow::initial_pressure, formula("100 Pa"), "0",
         "Initial pressure of the fluid, as a formula of x, y, z; the density follows from the equation of state."},
    };
}

std::vector<Key<Numerics>> numerics_keys() {
    return {
        {"scheme", &Numerics::scheme, one_of<FluidScheme>(), "corrected",
         "Scheme of the fluid: \"corrected\", whose answer depends neither on the speed of sound nor on the level of the "
         "pressure (docs/scheme.md), or \"plain\", that of the published studies. Several defaults depend on it."},
        {"kernel", &Numerics::kernel, one_of<KernelKind>(),
         ByScheme{"wendland_c2", {"lucy", "wendland_c2", "wendland_c2"}},
         "Smoothing kernel."},
        {"support", &Numerics::support, number(between(2, 6)), ByScheme{"3.0", {"3.0", "3.0", "4.0"}},
         "Support radius of the kernel, in spacings."},
        {"sound_speed", &Numerics::sound_speed, quantity_or_auto("2 m/s"), "auto",
         "Speed of sound of the fluid. \"auto\" derives it from numerics.mach_number, flow.largest_speed and the "
         "largest pressure."},
        {"mach_number", &Numerics::mach_number, number(Range{0.01, 0.3, false, {}}),
         ByScheme{{"0.3", "0.1", "0.05"}, {"0.15", "0.1", "0.1"}},
         "Largest speed divided by the speed of sound, if that is \"auto\"; the density varies by about its square."},
        {"walls", &Numerics::walls, one_of<WallModel>(), "extrapolated",
         "Wall particles: \"extrapolated\" takes their pressure and velocity from the fluid, \"plain\" treats them "
         "as fluid at rest."},
        {"equation_of_state", &Numerics::equation_of_state, one_of<EquationOfState>(), "tait",
         "Equation of state: " + meanings<EquationOfState>() + "."},
        {"background_pressure", &Numerics::background_pressure, quantity("200 Pa", not_negative), "0",
         "Constant pressure added to the equation of state, for confined or periodic fluids."},
        {"density", &Numerics::density, one_of<DensityModel>(), "continuity",
         "Density: integrated from its rate (\"continuity\"), or computed in each step as a sum over neighbours "
         "(\"summation\")."},
        {"gradient_correction", &Numerics::gradient_correction, boolean(), "false",
         "Whether kernel gradients are corrected, so that gradients of linear fields are exact."},
        {"viscous_law", &Numerics::viscous_law, one_of<ViscousLaw>(), ByScheme{"newtonian", "morris"},
         "Viscous force: " + meanings<ViscousLaw>() + "."},
        {"viscosity_mean", &Numerics::viscosity_mean, one_of<ViscosityMean>(), "harmonic",
         "Mean of the two viscosities where fluids of different viscosity meet."},
        {"density_diffusion", &Numerics::density_diffusion, number(between(0, 1)), "0.1",
         "Coefficient delta of the density diffusion; 0 turns it off. It is off with density = \"summation\"."},
        {"shifting", &Numerics::shifting, number(not_negative), ByScheme{"0.2", {"3.0", "4.0", "6.0"}},
         "Coefficient s of particle shifting, which moves particles by s u dt R times a sum over neighbours; u is the "
         "speed of sound, s c0 dt / R being at most 0.1, the limit of what is stable, or, with scheme = \"plain\", the "
         "speed of the flow. 0 turns it off. It is off with transport_velocity = true."},
        {"transport_velocity", &Numerics::transport_velocity, boolean(), "false",
         "Whether particles move with a transport velocity, which keeps them evenly spread, instead of shifting."},
        {"step_factor", &Numerics::step_factor, number(fraction), ByScheme{"0.5", {"0.4", "0.3", "0.15"}},
         "Time step of the fluid, times the speed of sound, divided by the support radius. The default is lowered, to "
         "0.275, where elastic solids are sub-cycled (docs/limits.md)."},
        {"viscosity_stepping", &Numerics::viscosity_stepping, one_of<ViscosityStepping>(), "explicit",
         "Integration of viscous forces: \"explicit\", which limits the time step, or \"implicit\", which solves a "
         "linear system in each step."},
        {"viscosity_tolerance", &Numerics::viscosity_tolerance, number(between(1e-14, 0.01)), "1e-6",
         "Implicit viscosity: the iteration ends when the residual's estimate of the velocity error, divided by the "
         "velocities, is below this."},
        {"spring_stepping", &Numerics::spring_stepping, one_of<SpringStepping>(), "implicit",
         "Integration of elastic solids: \"implicit\", one step with each fluid step, or \"subcycled\", many small "
         "explicit steps."},
        {"spring_step_factor", &Numerics::spring_step_factor, number(fraction), "0.5",
         "Subcycled elastic solids: their time step as a fraction of the largest stable one."},
        {"viscous_step_factor", &Numerics::viscous_step_factor, number(positive), unwritten("0.5"),
         "Explicit viscosity: time step as a fraction of the largest stable one by the linear theory of the kernel."},
        {"species_step_factor", &Numerics::species_step_factor, number(positive), unwritten("0.5"),
         "Explicit diffusion of species: time step as a fraction of the largest stable one by the linear theory of the "
         "kernel."},
        {"contact_step_factor", &Numerics::contact_step_factor, number(positive), unwritten("0.5"),
         "Repulsion of solids: time step as a fraction of 2 / omega of the stiffest contact."},
        {"light_solid_step_factor", &Numerics::light_solid_step_factor, number(positive), unwritten("0.4"),
         "Elastic solids lighter than the liquid: time step, in multiples of sqrt(m / m_liquid) R / (c0 + U) of the "
         "lightest node."},
        {"density_diffusion_step_factor", &Numerics::density_diffusion_step_factor, number(positive),
         unwritten("0.12"),
         "Largest density_diffusion times c0 dt / R; where step_factor would exceed it, steps are shorter."},
        {"shifting_step_factor", &Numerics::shifting_step_factor, number(positive), unwritten("1.2"),
         "With scheme = \"plain\": largest shifting times c0 dt / R; where step_factor would exceed it, steps are "
         "shorter."},
        {"species_stepping", &Numerics::species_stepping, one_of<SpeciesStepping>(), "explicit",
         "Integration of the diffusion of species: \"explicit\", which limits the time step, or \"implicit\", which "
         "solves a linear system in each step."},
        {"species_tolerance", &Numerics::species_tolerance, number(between(1e-14, 0.01)), "1e-8",
         "Implicit diffusion: the iteration ends when the residual's estimate of the concentration error, divided "
         "by the concentrations, is below this."},
        {"steps_per_contact", &Numerics::steps_per_contact, number(at_least(least_steps_per_contact)), ByQuality{"15", "30", "75"},
         "Spheres: number of time steps in the shortest elastic impact, if contact_step is \"auto\"."},
        {"contact_step", &Numerics::contact_step, quantity_or_auto("1 ns"), "auto",
         "Spheres: time step, at most a fifth of the shortest impact; \"auto\" derives it from steps_per_contact."},
    };
}

std::vector<Key<Run>> run_keys() {
    return {
        {"duration", &Run::duration, quantity("4 s", positive), required, "Simulated time."},
        {"threads", &Run::threads, integer(not_negative), "0", "Number of threads; 0 uses all that the machine has."},
        {"until_steady", &Run::until_steady, quantity("10 us", not_negative), "0 s",
         "Spheres: ends the run once the state has been steady for this time: no contact has begun or ended, and "
         "the kinetic energy has hardly changed. 0: never."},
    };
}

std::vector<Key<Output>> output_keys() {
    return {
        {"every", &Output::every, quantity("20 ms", positive), required, "Time between frames; the end of a run has one, too."},
        {"fields", &Output::fields, list_of<FluidField>(), "['velocity', 'pressure', 'shear_stress']",
         "Fields of the fluid particles in the frames (docs/results.md)."},
        {"measure_every", &Output::measure_every, quantity_or_auto("5 ms"), "auto",
         "Time between rows of measures.csv; the end of a run has one, too. \"auto\" is a quarter of output.every."},
        {"pictures", &Output::pictures, boolean(), "true", "Whether pictures are made."},
        {"picture_field", &Output::picture_field, one_of<FluidField>(), "velocity", "Field shown in the pictures."},
        {"solid_fields", &Output::solid_fields, list_of<SolidField>(),
         "['velocity', 'displacement', 'stress', 'von_mises', 'strain', 'force']",
         "Fields of elastic solids in the frames; strain and force are per bond, surface_stress is the largest von Mises stress "
         "at the surface of a cell, traction that of the fluid on each face (docs/results.md)."},
        {"average_from", &Output::average_from, quantity("1 s", not_negative), "0 s",
         "Time at which time averages (mean_displacement) begin."},
    };
}
// clang-format on

/// Appends the keys of one table of the scene to `keys`.
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
    schema.reference = each_item("reference", reference_keys());
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
    static const std::vector<std::string> names{"select",       "part",      "join",         "species",
                                                "contact_pair", "force",     "moving_shape", "region",
                                                "measure",      "reference", "solidify",     "break"};
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
    for (const auto& key : reference) facts.push_back(key.facts);
    for (const auto& key : solidify) facts.push_back(key.facts);
    for (const auto& key : breaking) facts.push_back(key.facts);
    return facts;
}

}  // namespace dmp::scene
