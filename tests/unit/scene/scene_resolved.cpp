// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// What overrides and levels of quality make of a scene, and how it is written down.
#include <gmock/gmock.h>

#include "tests/modules.hpp"
#include "tests/unit/scene/scene_text.hpp"

namespace dmp::tests::scene_resolved_tests {
namespace {

const std::string cases = std::string(DMP_SOURCE_DIR) + "/cases";

TEST(Quality, sets_what_is_not_given) {
    const auto with = [](const std::string& quality, const std::string& scheme = "corrected") {
        return read_text(good_scene, {"quality=" + quality, "numerics.scheme=" + scheme});
    };
    const Scene usual = read_text(good_scene), draft = with("draft"), standard = with("standard"), fine = with("fine");
    EXPECT_EQ(resolved_scene(standard), resolved_scene(usual));
    EXPECT_GT(*draft.numerics.mach_number, *standard.numerics.mach_number);
    EXPECT_LT(*fine.numerics.mach_number, *standard.numerics.mach_number);
    const Scene plain_draft = with("draft", "plain"), plain = with("standard", "plain"),
                plain_fine = with("fine", "plain");
    EXPECT_EQ(*plain_draft.numerics.kernel, KernelKind::lucy);
    EXPECT_GT(*plain_draft.numerics.step_factor, *plain.numerics.step_factor);
    EXPECT_GT(*plain_fine.numerics.support, *plain.numerics.support);
    EXPECT_GE(*plain_fine.parts[1].layers, *plain_fine.numerics.support);
    EXPECT_NE(draft.hash, standard.hash);
    EXPECT_NE(fine.hash, standard.hash);
    for (const Scene* scene : {&draft, &fine}) {
        EXPECT_FALSE(scene->numerics.kernel.given()) << "a default has no place";
        const std::string resolved = resolved_scene(*scene);
        EXPECT_EQ(resolved_scene(read_text(resolved)), resolved);
    }
}

TEST(Quality, leaves_alone_what_is_given) {
    const Scene scene =
        read_text(good_scene, {"quality=draft", "numerics.step_factor=0.1", "numerics.mach_number=0.1"});
    EXPECT_EQ(*scene.numerics.step_factor, 0.1);
    EXPECT_EQ(*scene.numerics.mach_number, 0.1);
}

TEST(Quality, is_where_defaults_come_from) {
    const Scene scene = read_text("quality = \"draft\"\n" + good_scene);
    EXPECT_EQ(default_origin(scene, "numerics.mach_number"), "quality = \"draft\" at scene.toml:1:11");
    EXPECT_EQ(default_origin(scene, "part.wall.layers"), "quality = \"draft\" at scene.toml:1:11");
    EXPECT_EQ(default_origin(scene, "numerics.walls"), "default") << "the same at every level";
    EXPECT_EQ(default_origin(read_text(good_scene), "numerics.mach_number"), "default");
}

TEST(Override, reaches_every_kind_of_key) {
    const Scene scene = read_text(
        good_scene, {"particles.spacing=\"0.2 mm\"", "geometry.parameters.leaflet_length=\"25.6 mm\"",
                     "geometry.parameters.count = 3", "part.leaflets.enabled=false", "measure.tip_gap.part=leaflets",
                     "measure.flux_in.to=[\"0 mm\", \"5 mm\"]", "numerics.support=3.5", "part.wall.layers=4",
                     "title=A = B", "flow.acceleration=[\"0.15 m/s^2 * cos(2*pi*t/4 s)\", 0]"});
    EXPECT_EQ(*scene.particles.spacing, 0.0002);
    EXPECT_EQ(*scene.geometry.parameters.at("leaflet_length"), 0.0256);
    EXPECT_EQ(*scene.geometry.parameters.at("count"), 3);
    EXPECT_FALSE(*scene.parts[2].enabled);
    EXPECT_EQ(*scene.measures[1].part, "leaflets");
    EXPECT_EQ(*scene.measures[0].to, Vec(0, 0.005, 0));
    EXPECT_EQ(*scene.numerics.support, 3.5) << "a table the file does not have";
    EXPECT_EQ(*scene.title, "A = B");
    EXPECT_EQ(scene.flow.acceleration[0](0), 0.15);
    const std::string region = "[[region]]\nname = \"sinus\"\nfrom = [0, 0]\nto = [\"1 mm\", \"2 mm\"]\n";
    EXPECT_EQ(*read_text(good_scene + region, {"region.sinus.from=[\"3 mm\", 0]"}).regions[0].from, Vec(0.003, 0, 0));
    EXPECT_EQ(scene.particles.spacing.location.file, "--set particles.spacing=\"0.2 mm\"");
    EXPECT_EQ(scene.particles.spacing.location.line, 0);
}

TEST(Override, of_a_kind_adds_a_measure) {
    const Scene scene = read_text(good_scene, {"measure.energy.kind=kinetic_energy"});
    ASSERT_EQ(scene.measures.size(), read_text(good_scene).measures.size() + 1);
    EXPECT_EQ(*scene.measures.back().name, "energy");
    EXPECT_EQ(*scene.measures.back().kind, MeasureKind::kinetic_energy);
    const std::string without = good_scene.substr(0, good_scene.find("[[measure]]"));
    EXPECT_EQ(read_text(without, {"measure.energy.kind=kinetic_energy"}).measures.size(), 1U);
    EXPECT_THROW(static_cast<void>(read_text(good_scene, {"measure.flux_im.kind=flux"})), InputError) << "flux_in";
    EXPECT_THROW(static_cast<void>(read_text(good_scene, {"measure.energy.part=leaflets"})), InputError);
}

TEST(Override, needs_no_quotes_and_the_last_one_wins) {
    const Scene scene = read_text(good_scene, {"particles.spacing=0.3 mm", "particles.spacing= 0.4 mm ",
                                               "numerics.density=continuity", "numerics.walls=extrapolated"});
    EXPECT_EQ(*scene.particles.spacing, 0.0004);
    EXPECT_EQ(*scene.numerics.walls, WallModel::extrapolated);
}

TEST(ResolvedScene, reads_back_as_the_same_scene) {
    for (const std::string file : {"/vein_valve", "/verification/poiseuille"}) {
        const Scene scene = read_scene(cases + file);
        const std::string resolved = resolved_scene(scene);
        const Scene again = read_text(resolved);
        EXPECT_EQ(resolved_scene(again), resolved);
        EXPECT_EQ(again.hash, scene.hash);
        EXPECT_EQ(*again.particles.spacing, *scene.particles.spacing);
        EXPECT_EQ((*again.flow.pressure_gradient)[0](0.7), (*scene.flow.pressure_gradient)[0](0.7)) << "bit for bit";
    }
}

TEST(ResolvedScene, writes_defaults_in_si_units) {
    const std::string resolved =
        resolved_scene(read_text(good_scene, {"geometry.unit=1 mm", "geometry.parameters={w=\"2 mm\", \"odd name\"=1}",
                                              "title=a \"quoted\" \\ title"}));
    EXPECT_EQ(resolved, R"(schema = 1
title = "a \"quoted\" \\ title"
dimension = 2
quality = "standard"

[geometry]
file = "channel.geo"
unit = "0.001 m"
parameters = { "odd name" = 1, w = 2 }
repair = "wrap"
largest_hole = 8

[particles]
spacing = "1e-04 m"
arrangement = "square"
fill = "lattice"
disorder = 0
seed = 1

[flow]
acceleration = ["0", "0", "0"]
pressure_gradient = ["0", "0", "0"]
periodic = []
symmetry = []
largest_speed = "0.2 m/s"
initial_velocity = ["0", "0", "0"]
initial_pressure = "0"

[contact]
range = 0.7
strength = "auto"

[numerics]
scheme = "corrected"
kernel = "wendland_c2"
support = 3
sound_speed = "auto"
mach_number = 0.1
walls = "extrapolated"
equation_of_state = "tait"
background_pressure = "0 Pa"
density = "continuity"
gradient_correction = false
viscous_law = "newtonian"
viscosity_mean = "harmonic"
density_diffusion = 0.1
shifting = 0.2
transport_velocity = false
step_factor = 0.5
viscosity_stepping = "explicit"
viscosity_tolerance = 1e-06
spring_stepping = "implicit"
spring_step_factor = 0.5
species_stepping = "explicit"
species_tolerance = 1e-08
steps_per_contact = 30
contact_step = "auto"

[run]
duration = "4 s"
threads = 0
until_steady = "0 s"

[output]
every = "0.02 s"
fields = ["velocity", "pressure", "shear_stress"]
measure_every = "auto"
pictures = true
picture_field = "velocity"
solid_fields = ["velocity", "displacement", "stress", "von_mises", "strain", "force"]
average_from = "0 s"

[[part]]
name = "blood"
kind = "fluid"
enabled = true
density = "1056 kg/m^3"
viscosity = "0.0035 Pa*s"

[[part]]
name = "wall"
kind = "rigid"
enabled = true
layers = 3
surface_velocity = ["0", "0", "0"]
slip = false
velocity = ["0", "0", "0"]
spin = "0"
centre = ["0 m", "0 m", "0 m"]

[[part]]
name = "leaflets"
kind = "elastic"
enabled = true
layers = 2
bending_stiffness = "3e-06 N*m^2"
axial_stiffness = "100 N"
lower_axial_stiffness = true
cross_bonds = false
mass_per_length = "0.42 kg/m"
bond_damping = 0.01
drag = "0 kg/s"
mass_damping = "0 s^-1"

[[measure]]
name = "flux_in"
kind = "flux"
from = ["0 m", "-0.004 m", "0 m"]
to = ["0 m", "0.004 m", "0 m"]

[[measure]]
name = "tip_gap"
kind = "gap"
part = "leaflets"
)");
    EXPECT_EQ(resolved_scene(read_text(resolved)), resolved);
}

TEST(SceneHash, is_fnv1a_of_the_resolved_scene) {
    const Scene scene = read_text(good_scene);
    std::uint64_t hash = 14695981039346656037ULL;
    for (const char c : resolved_scene(scene)) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211ULL;
    std::array<char, 17> digits{};
    std::snprintf(digits.data(), digits.size(), "%016llx", static_cast<unsigned long long>(hash));
    EXPECT_EQ(scene.hash, digits.data());
}

TEST(SceneHash, sees_values_and_not_how_they_are_written) {
    const std::string hash = read_text(good_scene).hash;
    EXPECT_EQ(read_text(scene_with("\"0.1 mm\"", "'100 um'  # the same")).hash, hash);
    EXPECT_EQ(read_text(scene_with("[run]", "[numerics]\nsupport = 3\n[run]")).hash, hash);
    EXPECT_NE(read_text(scene_with("\"0.1 mm\"", "\"0.11 mm\"")).hash, hash);
}

}  // namespace
}  // namespace dmp::tests::scene_resolved_tests
