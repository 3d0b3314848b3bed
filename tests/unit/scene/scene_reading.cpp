// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numbers>

#include <gmock/gmock.h>

#include "tests/modules.hpp"
#include "tests/unit/scene/scene_text.hpp"

namespace dmp::tests::scene_reading_tests {
namespace {

using testing::ElementsAre;

const std::string cases = std::string(DMP_SOURCE_DIR) + "/cases";

TEST(ReadScene, vein_valve_whole) {
    const Scene scene = read_scene(cases + "/vein_valve/scene.toml");
    EXPECT_EQ(scene.file, cases + "/vein_valve/scene.toml");
    EXPECT_EQ(scene.directory, cases + "/vein_valve");
    EXPECT_EQ(*scene.schema, 1);
    EXPECT_EQ(*scene.title, "Deep vein valve, oscillating flow");
    EXPECT_EQ(*scene.dimension, 2);
    EXPECT_EQ(*scene.geometry.file, "vein_valve.geo");
    EXPECT_EQ(*scene.geometry.unit, 1);
    ASSERT_EQ(scene.geometry.parameters.size(), 1U);
    EXPECT_EQ(*scene.geometry.parameters.at("leaflet_length"), 0.0175);
    EXPECT_EQ(*scene.particles.spacing, 0.0002);

    ASSERT_EQ(scene.parts.size(), 3U);
    EXPECT_EQ(*scene.parts[0].name, "blood");
    EXPECT_EQ(*scene.parts[0].kind, PartKind::fluid);
    EXPECT_EQ(*scene.parts[0].density, 1056);
    EXPECT_EQ(*scene.parts[0].viscosity, 0.0035);
    EXPECT_EQ(*scene.parts[1].name, "wall");
    EXPECT_EQ(*scene.parts[1].kind, PartKind::rigid);
    EXPECT_EQ(*scene.parts[1].layers, 3);
    EXPECT_EQ(*scene.parts[2].name, "leaflets");
    EXPECT_EQ(*scene.parts[2].kind, PartKind::elastic);
    EXPECT_EQ(*scene.parts[2].layers, 2);
    EXPECT_EQ(*scene.parts[2].bending_stiffness, 3e-6);
    EXPECT_EQ(*scene.parts[2].axial_stiffness, 100);
    EXPECT_EQ(*scene.parts[2].mass_per_length, 0.42);
    EXPECT_EQ(*scene.parts[2].anchor, "leaflet_roots");

    const auto& drive = *scene.flow.pressure_gradient;
    EXPECT_DOUBLE_EQ(drive[0](0.7), -77.09 * std::sin(2 * std::numbers::pi * 0.7 / 4));
    EXPECT_EQ(drive[1](0.7), 0);
    EXPECT_EQ(drive[2](0.7), 0);
    EXPECT_EQ(scene.flow.acceleration[0](0.7), 0);
    EXPECT_TRUE(scene.flow.periodic[0]);
    EXPECT_FALSE(scene.flow.periodic[1]);
    EXPECT_FALSE(scene.flow.periodic[2]);
    EXPECT_EQ(*scene.flow.largest_speed, 0.1);
    EXPECT_EQ(*scene.numerics.sound_speed, 3);
    EXPECT_EQ(*scene.run.duration, 4);
    EXPECT_EQ(*scene.output.every, 0.04);
    EXPECT_EQ(*scene.output.measure_every, 0.01);
    EXPECT_THAT(scene.output.fields, ElementsAre(FluidField::velocity, FluidField::pressure, FluidField::shear_stress));

    ASSERT_EQ(scene.measures.size(), 5U);
    EXPECT_EQ(*scene.measures[0].name, "inlet_flux");
    EXPECT_EQ(*scene.measures[0].kind, MeasureKind::flux);
    EXPECT_EQ(*scene.measures[0].from, Vec(-0.04, -0.004, 0));
    EXPECT_EQ(*scene.measures[0].to, Vec(-0.04, 0.004, 0));
    EXPECT_EQ(*scene.measures[1].name, "inlet_velocity");
    EXPECT_EQ(*scene.measures[1].kind, MeasureKind::probe);
    EXPECT_EQ(*scene.measures[1].point, Vec(-0.04, 0, 0));
    EXPECT_EQ(*scene.measures[1].field, FluidField::velocity);
    EXPECT_EQ(*scene.measures[2].name, "tip_gap");
    EXPECT_EQ(*scene.measures[2].kind, MeasureKind::gap);
    EXPECT_EQ(*scene.measures[2].part, "leaflets");
    EXPECT_EQ(*scene.measures[3].kind, MeasureKind::largest_speed);
    EXPECT_EQ(*scene.measures[4].kind, MeasureKind::density);
}

TEST(ReadScene, poiseuille_whole) {
    const Scene scene = read_scene(cases + "/verification/poiseuille");
    EXPECT_EQ(scene.file, cases + "/verification/poiseuille/scene.toml");
    EXPECT_EQ(*scene.title, "Plane Poiseuille flow from rest");
    EXPECT_EQ(*scene.geometry.file, "channel.geo");
    EXPECT_EQ(*scene.geometry.parameters.at("width"), 0.001);
    EXPECT_EQ(*scene.geometry.parameters.at("length"), 0.0004);
    EXPECT_EQ(*scene.particles.spacing, 0.00005);
    ASSERT_EQ(scene.parts.size(), 2U);
    EXPECT_EQ(*scene.parts[0].name, "water");
    EXPECT_EQ(*scene.parts[0].density, 1000);
    EXPECT_EQ(*scene.parts[0].viscosity, 0.001);
    EXPECT_EQ(*scene.parts[1].layers, 3);
    EXPECT_EQ((*scene.flow.pressure_gradient)[0](3), -0.1);
    EXPECT_FALSE((*scene.flow.pressure_gradient)[0].depends_on_time());
    EXPECT_TRUE(scene.flow.periodic[0]);
    EXPECT_EQ(*scene.flow.largest_speed, 1.25e-5);
    EXPECT_EQ(*scene.run.duration, 1);
    EXPECT_EQ(*scene.output.every, 0.1);
    ASSERT_EQ(scene.measures.size(), 1U);
    EXPECT_EQ(*scene.measures[0].point, Vec(0.0002, 0.0005, 0));
}

TEST(ReadScene, every_default) {
    const Scene scene = read_text(good_scene);
    const Scene fresh;  // what the structs say: table and structs must agree
    EXPECT_EQ(*scene.dimension, 2);
    EXPECT_EQ(*scene.dimension, *fresh.dimension);
    EXPECT_EQ(*scene.geometry.unit, 1);
    EXPECT_EQ(*scene.geometry.unit, *fresh.geometry.unit);
    EXPECT_TRUE(scene.geometry.parameters.empty());
    EXPECT_EQ(*scene.particles.arrangement, Arrangement::square);
    EXPECT_EQ(*scene.particles.arrangement, *fresh.particles.arrangement);
    EXPECT_EQ(*scene.particles.disorder, 0);
    EXPECT_EQ(*scene.particles.disorder, *fresh.particles.disorder);
    EXPECT_EQ(*scene.particles.seed, 1);
    EXPECT_EQ(*scene.particles.seed, *fresh.particles.seed);

    const Part fresh_part;
    for (const auto& part : scene.parts) EXPECT_EQ(*part.enabled, true);
    EXPECT_EQ(*scene.parts[1].layers, 3);
    const Part& leaflets = scene.parts[2];
    EXPECT_EQ(*leaflets.layers, 2);
    EXPECT_EQ(*leaflets.lower_axial_stiffness, true);
    EXPECT_EQ(*leaflets.lower_axial_stiffness, *fresh_part.lower_axial_stiffness);
    EXPECT_EQ(*leaflets.poisson_ratio, 0);
    EXPECT_EQ(*leaflets.cross_bonds, false);
    EXPECT_EQ(*leaflets.cross_bonds, *fresh_part.cross_bonds);
    EXPECT_EQ(*leaflets.anchor, "");
    EXPECT_EQ(*leaflets.bond_damping, 0.01);
    EXPECT_EQ(*leaflets.bond_damping, *fresh_part.bond_damping);
    EXPECT_EQ(*leaflets.drag, 0);
    EXPECT_EQ(*leaflets.drag, *fresh_part.drag);

    for (const auto& component : scene.flow.acceleration) EXPECT_EQ(component(1, 2, 3, 4), 0);
    for (const auto& component : *scene.flow.pressure_gradient) EXPECT_EQ(component(1, 2, 3, 4), 0);
    for (const auto& axis : scene.flow.periodic) EXPECT_FALSE(axis);
    for (const auto& component : *scene.flow.initial_velocity) EXPECT_EQ(component(0, 2, 3, 4), 0);
    EXPECT_EQ((*scene.flow.initial_pressure)(0, 2, 3, 4), 0);
    EXPECT_EQ(*scene.contact.range, 0.7);
    EXPECT_EQ(*scene.contact.range, *fresh.contact.range);
    EXPECT_EQ(*scene.contact.strength, 0) << "auto";
    EXPECT_EQ(*scene.contact.strength, *fresh.contact.strength);
    EXPECT_EQ(*scene.numerics.kernel, KernelKind::wendland_c2);
    EXPECT_EQ(*scene.numerics.kernel, *fresh.numerics.kernel);
    EXPECT_EQ(*scene.numerics.support, 3);
    EXPECT_EQ(*scene.numerics.support, *fresh.numerics.support);
    EXPECT_EQ(*scene.numerics.sound_speed, 0) << "auto";
    EXPECT_EQ(*scene.numerics.sound_speed, *fresh.numerics.sound_speed);
    EXPECT_EQ(*scene.quality, Quality::standard);
    EXPECT_EQ(*scene.quality, *fresh.quality);
    EXPECT_EQ(*scene.numerics.mach_number, 0.1);
    EXPECT_EQ(*scene.numerics.mach_number, *fresh.numerics.mach_number);
    EXPECT_THAT(scene.output.solid_fields,
                ElementsAre(SolidField::velocity, SolidField::displacement, SolidField::stress, SolidField::von_mises,
                            SolidField::strain, SolidField::force));
    EXPECT_EQ(scene.output.solid_fields, fresh.output.solid_fields);
    EXPECT_EQ(*scene.output.average_from, 0);
    EXPECT_EQ(*scene.output.average_from, *fresh.output.average_from);
    EXPECT_EQ(*scene.numerics.walls, WallModel::extrapolated);
    EXPECT_EQ(*scene.numerics.walls, *fresh.numerics.walls);
    EXPECT_EQ(*scene.flow.largest_pressure, 0) << "not given";
    EXPECT_EQ(*scene.numerics.equation_of_state, EquationOfState::of<TaitEquation>());
    EXPECT_EQ(*scene.numerics.equation_of_state, *fresh.numerics.equation_of_state);
    EXPECT_EQ(*scene.numerics.background_pressure, 0);
    EXPECT_EQ(*scene.numerics.background_pressure, *fresh.numerics.background_pressure);
    EXPECT_EQ(*scene.numerics.density, DensityModel::continuity);
    EXPECT_EQ(*scene.numerics.density, *fresh.numerics.density);
    EXPECT_FALSE(*scene.numerics.gradient_correction);
    EXPECT_EQ(*scene.numerics.gradient_correction, *fresh.numerics.gradient_correction);
    EXPECT_EQ(*scene.numerics.scheme, FluidScheme::corrected);
    EXPECT_EQ(*scene.numerics.scheme, *fresh.numerics.scheme);
    EXPECT_EQ(*scene.numerics.viscous_law, ViscousLaw::of<NewtonianViscosity>());
    EXPECT_EQ(*scene.numerics.viscous_law, *fresh.numerics.viscous_law);
    EXPECT_EQ(*scene.numerics.viscosity_mean, ViscosityMean::harmonic);
    EXPECT_EQ(*scene.numerics.viscosity_mean, *fresh.numerics.viscosity_mean);
    EXPECT_FALSE(*scene.numerics.transport_velocity);
    EXPECT_EQ(*scene.numerics.transport_velocity, *fresh.numerics.transport_velocity);
    EXPECT_EQ(*scene.numerics.density_diffusion, 0.1);
    EXPECT_EQ(*scene.numerics.density_diffusion, *fresh.numerics.density_diffusion);
    EXPECT_EQ(*scene.numerics.shifting, 0.2);
    EXPECT_EQ(*scene.numerics.shifting, *fresh.numerics.shifting);
    EXPECT_EQ(*scene.numerics.step_factor, 0.5);
    EXPECT_EQ(*scene.numerics.step_factor, *fresh.numerics.step_factor);
    EXPECT_EQ(*scene.numerics.viscosity_stepping, ViscosityStepping::explicitly);
    EXPECT_EQ(*scene.numerics.viscosity_stepping, *fresh.numerics.viscosity_stepping);
    EXPECT_EQ(*scene.numerics.viscosity_tolerance, 1e-6);
    EXPECT_EQ(*scene.numerics.viscosity_tolerance, *fresh.numerics.viscosity_tolerance);
    EXPECT_EQ(*scene.numerics.spring_stepping, SpringStepping::implicit);
    EXPECT_EQ(*scene.numerics.spring_stepping, *fresh.numerics.spring_stepping);
    EXPECT_EQ(*scene.numerics.spring_step_factor, 0.5);
    EXPECT_EQ(*scene.numerics.spring_step_factor, *fresh.numerics.spring_step_factor);
    EXPECT_EQ(*scene.run.threads, 0);
    EXPECT_EQ(*scene.run.threads, *fresh.run.threads);
    EXPECT_THAT(scene.output.fields, ElementsAre(FluidField::velocity, FluidField::pressure, FluidField::shear_stress));
    EXPECT_EQ(*scene.output.measure_every, 0) << "auto";
    EXPECT_EQ(*scene.output.measure_every, *fresh.output.measure_every);
    EXPECT_EQ(*scene.output.pictures, true);
    EXPECT_EQ(*scene.output.pictures, *fresh.output.pictures);
    EXPECT_EQ(*scene.output.picture_field, FluidField::velocity);
    EXPECT_EQ(*scene.output.picture_field, *fresh.output.picture_field);
    EXPECT_FALSE(scene.numerics.support.given()) << "a default has no place";
}

TEST(ReadScene, every_key_given_another_value) {
    const Scene scene = read_text(R"(schema = 1
dimension = 2
geometry.file = "a.step"
geometry.unit = "1 mm"
[geometry.parameters]
width = "2 mm"
slope = "180 deg"
count = 3
ratio = 0.25
quoted = "0.5"
[particles]
spacing = "100 um"
arrangement = "hexagonal"
[[part]]
name = "blood"
kind = "fluid"
density = "1.056 g/cm^3"
viscosity = 0
[[part]]
name = "wall"
kind = "rigid"
enabled = false
layers = 5
[[part]]
name = "Leaf_2"
kind = "elastic"
bending_stiffness = "3e-6 N*m^2"
axial_stiffness = "100 N"
mass_per_length = "0.42 kg/m"
lower_axial_stiffness = false
bond_damping = 0.5
drag = "1 mg/s"
[flow]
acceleration = ["1 m/s^2"]
periodic = ["y", "x"]
[contact]
range = 1.5
strength = "2 uJ"
[numerics]
scheme = "plain"
kernel = "lucy"
support = 2
sound_speed = "2 m/s"
mach_number = 0.2
walls = "plain"
density_diffusion = 0
shifting = 0
step_factor = 0.25
viscosity_tolerance = 1e-7
spring_stepping = "subcycled"
spring_step_factor = 1
[run]
duration = "1 min"
threads = 4
[output]
every = "1 s"
fields = ["density", "residence_time"]
solid_fields = ["stress", "mean_displacement"]
average_from = "2 s"
measure_every = "1 ms"
pictures = false
picture_field = "pressure"
[[region]]
name = "sinus"
from = ["2 mm", 0]
to = [0, "1 mm"]
[[measure]]
name = "p"
kind = "probe"
point = [0, "1 mm", 0]
field = "pressure"
)");
    EXPECT_EQ(*scene.geometry.unit, 0.001);
    EXPECT_DOUBLE_EQ(scene.geometry.parameters.at("width"), 2);
    EXPECT_DOUBLE_EQ(scene.geometry.parameters.at("slope"), std::numbers::pi);
    EXPECT_EQ(*scene.geometry.parameters.at("count"), 3);
    EXPECT_EQ(*scene.geometry.parameters.at("ratio"), 0.25);
    EXPECT_EQ(*scene.geometry.parameters.at("quoted"), 0.5);
    EXPECT_EQ(scene.geometry.parameters.at("count").location.text(), "scene.toml:8:9");
    EXPECT_EQ(*scene.particles.arrangement, Arrangement::hexagonal);
    EXPECT_EQ(*scene.parts[0].density, 1056);
    EXPECT_EQ(*scene.parts[0].viscosity, 0);
    EXPECT_FALSE(*scene.parts[1].enabled);
    EXPECT_EQ(*scene.parts[1].layers, 5);
    EXPECT_FALSE(*scene.parts[2].lower_axial_stiffness);
    EXPECT_EQ(*scene.parts[2].bond_damping, 0.5);
    EXPECT_EQ(*scene.parts[2].drag, 1e-6);
    EXPECT_EQ(scene.flow.acceleration[0](0), 1);
    EXPECT_TRUE(scene.flow.periodic[0]);
    EXPECT_TRUE(scene.flow.periodic[1]);
    EXPECT_EQ(*scene.contact.range, 1.5);
    EXPECT_EQ(*scene.contact.strength, 2e-6);
    EXPECT_EQ(*scene.numerics.scheme, FluidScheme::plain);
    EXPECT_EQ(*scene.numerics.kernel, KernelKind::lucy);
    EXPECT_EQ(*scene.numerics.support, 2);
    EXPECT_EQ(*scene.numerics.sound_speed, 2);
    EXPECT_EQ(*scene.numerics.mach_number, 0.2);
    EXPECT_EQ(*scene.numerics.walls, WallModel::plain);
    EXPECT_EQ(*scene.numerics.density_diffusion, 0);
    EXPECT_EQ(*scene.numerics.shifting, 0);
    EXPECT_EQ(*scene.numerics.step_factor, 0.25);
    EXPECT_EQ(*scene.numerics.viscosity_tolerance, 1e-7);
    EXPECT_EQ(*scene.numerics.spring_stepping, SpringStepping::subcycled);
    EXPECT_EQ(*scene.numerics.spring_step_factor, 1);
    EXPECT_EQ(*scene.run.duration, 60);
    EXPECT_EQ(*scene.run.threads, 4);
    EXPECT_THAT(scene.output.fields, ElementsAre(FluidField::density, FluidField::residence_time));
    EXPECT_TRUE(scene.asks_for(FluidField::residence_time));
    EXPECT_TRUE(scene.asks_for(FluidField::pressure)) << "of the probe";
    EXPECT_FALSE(scene.asks_for(FluidField::velocity));
    EXPECT_THAT(scene.output.solid_fields, ElementsAre(SolidField::stress, SolidField::mean_displacement));
    EXPECT_EQ(*scene.output.average_from, 2);
    ASSERT_EQ(scene.regions.size(), 1U);
    EXPECT_EQ(*scene.regions[0].name, "sinus");
    EXPECT_EQ(*scene.regions[0].from, Vec(0.002, 0, 0));
    EXPECT_EQ(*scene.regions[0].to, Vec(0, 0.001, 0));
    EXPECT_EQ(*scene.output.measure_every, 0.001);
    EXPECT_FALSE(*scene.output.pictures);
    EXPECT_EQ(*scene.output.picture_field, FluidField::pressure);
    EXPECT_EQ(*scene.measures[0].field, FluidField::pressure);
    EXPECT_EQ(*scene.measures[0].point, Vec(0, 0.001, 0));
}

TEST(ReadScene, fluid_terms_that_are_off_by_default) {
    const Scene scene =
        read_text(good_scene, {"numerics.scheme=plain", "flow.largest_pressure=2 kPa", "numerics.kernel=quintic_spline",
                               "numerics.equation_of_state=linear", "numerics.background_pressure=3 Pa",
                               "numerics.density=summation", "numerics.gradient_correction=true",
                               "numerics.viscous_law=monaghan_approaching", "numerics.viscosity_mean=arithmetic",
                               "numerics.transport_velocity=true"});
    EXPECT_EQ(*scene.flow.largest_pressure, 2000);
    EXPECT_EQ(*scene.numerics.kernel, KernelKind::quintic_spline);
    EXPECT_EQ(*scene.numerics.equation_of_state, EquationOfState::of<LinearEquation>());
    EXPECT_EQ(*scene.numerics.background_pressure, 3);
    EXPECT_EQ(*scene.numerics.density, DensityModel::summation);
    EXPECT_TRUE(*scene.numerics.gradient_correction);
    EXPECT_EQ(*scene.numerics.viscous_law, ViscousLaw::of<ApproachingMonaghanViscosity>());
    EXPECT_EQ(*scene.numerics.viscosity_mean, ViscosityMean::arithmetic);
    EXPECT_TRUE(*scene.numerics.transport_velocity);
    EXPECT_EQ(*scene.numerics.density_diffusion, 0) << "gives way to the summed density";
    EXPECT_EQ(*scene.numerics.shifting, 0) << "gives way to the transport velocity";
    EXPECT_EQ(resolved_scene(read_text(resolved_scene(scene))), resolved_scene(scene));
}

TEST(ReadScene, each_scheme_has_defaults_of_its_own) {
    const Scene plain = read_text(good_scene, {"numerics.scheme=plain"});
    EXPECT_EQ(*plain.numerics.viscous_law, ViscousLaw::of<MorrisViscosity>());
    EXPECT_EQ(*plain.numerics.step_factor, 0.3);
    EXPECT_EQ(*plain.contact.range, 1);
    EXPECT_EQ(*plain.numerics.shifting, 4);
    EXPECT_EQ(default_origin(plain, "contact.range"), "numerics.scheme = \"plain\" at --set numerics.scheme=plain");
    EXPECT_EQ(default_origin(plain, "numerics.walls"), "default");
    const Scene draft = read_text(good_scene, {"quality=draft"});
    EXPECT_EQ(*draft.numerics.kernel, KernelKind::wendland_c2);
    EXPECT_EQ(*draft.numerics.support, 3);
    EXPECT_EQ(*draft.numerics.step_factor, 0.5);
    const Scene given =
        read_text(good_scene, {"numerics.viscous_law=morris", "numerics.step_factor=0.2", "contact.range=0.5"});
    EXPECT_EQ(*given.numerics.viscous_law, ViscousLaw::of<MorrisViscosity>());
    EXPECT_EQ(*given.numerics.step_factor, 0.2);
    EXPECT_EQ(*given.contact.range, 0.5);
    for (const Scene* scene : {&plain, &draft, &given})
        EXPECT_EQ(resolved_scene(read_text(resolved_scene(*scene))), resolved_scene(*scene));
}

TEST(ReadScene, values_keep_their_places) {
    const Scene scene = read_text(good_scene);
    EXPECT_EQ(scene.particles.spacing.location.text(), "scene.toml:8:11");
    EXPECT_EQ(scene.parts[0].density.location.text(), "scene.toml:13:11");
    EXPECT_EQ(scene.measures[0].from.location.text(), "scene.toml:39:8");
    EXPECT_EQ(scene.directory, ".");
    const Scene periodic = read_text(scene_with("[run]", "periodic = [\"x\", \"y\"]\n[run]"));
    EXPECT_EQ(periodic.flow.periodic[1].location.text(), "scene.toml:30:18");
}

TEST(ReadScene, a_byte_order_mark_and_windows_lines_do_no_harm) {
    std::string text = "\xEF\xBB\xBF";
    for (const char c : good_scene) text += c == '\n' ? std::string("\r\n") : std::string(1, c);
    EXPECT_EQ(read_text(text).hash, read_text(good_scene).hash);
    EXPECT_EQ(read_text(text).particles.spacing.location.text(), "scene.toml:8:11");
}

TEST(PartsOf, enabled_parts_of_one_kind_in_order) {
    const Scene scene = read_text(good_scene +
                                  "[[part]]\nname = \"plate\"\nkind = \"rigid\"\nenabled = false\n"
                                  "[[part]]\nname = \"floor\"\nkind = \"rigid\"\n");
    const auto rigid = scene.parts_of(PartKind::rigid);
    ASSERT_EQ(rigid.size(), 2U);
    EXPECT_EQ(*rigid[0]->name, "wall");
    EXPECT_EQ(*rigid[1]->name, "floor");
    EXPECT_EQ(scene.parts.size(), 5U);
}

TEST(Words, are_those_of_a_scene) {
    EXPECT_EQ(to_string(PartKind::elastic), "elastic");
    EXPECT_EQ(to_string(FluidField::shear_stress), "shear_stress");
    EXPECT_EQ(to_string(SolidField::von_mises), "von_mises");
    EXPECT_EQ(to_string(Quality::fine), "fine");
    EXPECT_EQ(to_string(KernelKind::wendland_c2), "wendland_c2");
    EXPECT_EQ(to_string(MeasureKind::largest_speed), "largest_speed");
    EXPECT_EQ(to_string(Arrangement::hexagonal), "hexagonal");
    EXPECT_EQ(to_string(WallModel::plain), "plain");
    EXPECT_EQ(to_string(SpringStepping::subcycled), "subcycled");
    EXPECT_EQ(to_string(ViscosityStepping::implicitly), "implicit");
    EXPECT_EQ(to_string(KernelKind::cubic_spline), "cubic_spline");
    EXPECT_EQ(to_string(EquationOfState::of<LinearEquation>()), "linear");
    EXPECT_EQ(to_string(DensityModel::summation), "summation");
    EXPECT_EQ(to_string(ViscousLaw::of<ApproachingMonaghanViscosity>()), "monaghan_approaching");
    EXPECT_EQ(to_string(ViscosityMean::arithmetic), "arithmetic");
}

TEST(ReadScene, walls_that_move_and_planes_of_symmetry) {
    const Scene scene = read_text(scene_with("kind = \"rigid\"",
                                             "kind = \"rigid\"\nvelocity = [\"0.1 m/s * cos(2*pi*t/1 s)\", 0]\n"
                                             "spin = \"120 deg/s\"\ncentre = [\"1 mm\", \"-2 mm\"]\nslip = true"),
                                  {"flow.symmetry=[\"y_low\", \"x_high\"]"});
    const Part& wall = scene.parts[1];
    EXPECT_DOUBLE_EQ(wall.velocity.value[0](0.5), -0.1);
    EXPECT_EQ(wall.velocity.value[1](0.5), 0);
    EXPECT_DOUBLE_EQ((*wall.spin)(0), 2 * std::numbers::pi / 3);
    EXPECT_EQ(wall.centre.value, Vec(1e-3, -2e-3, 0));
    EXPECT_TRUE(wall.slip);
    EXPECT_TRUE(wall.moves());
    EXPECT_FALSE(wall.slides());
    EXPECT_EQ(scene.flow.symmetry.value, (std::vector<BoxSide>{BoxSide::y_low, BoxSide::x_high}));
    const Part still = read_text(good_scene).parts[1];
    EXPECT_FALSE(still.moves() || still.slides() || still.slip);
}

}  // namespace
}  // namespace dmp::tests::scene_reading_tests
