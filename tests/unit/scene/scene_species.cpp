// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Species in scenes: what is read, and what goes wrong.
#include <gmock/gmock.h>

#include "tests/modules.hpp"
#include "tests/unit/scene/fault.hpp"

namespace dmp::tests::scene_species_tests {
namespace {

// Begins at line 36 of the scene.
const std::string drug = R"toml([[species]]
name = "drug"
diffusivity = { blood = "1e-9 m^2/s", leaflets = "1e-10 m^2/s" }
concentration = "1 mg/ml * x / 1 mm"
wall_concentration = { wall = "0.5 kg/m^3 * exp(-t / 1 s)" }
[[measure]])toml";

std::string with_drug(const std::string& found = "drug", const std::string& replacement = "drug") {
    std::string text = drug;
    text.replace(text.find(found), found.size(), replacement);
    return scene_with("[[measure]]", text);
}

TEST(Species, are_read_with_their_units) {
    const Scene scene = read_text(with_drug());
    ASSERT_EQ(scene.species.size(), 1U);
    const Species& species = scene.species[0];
    EXPECT_EQ(*species.name, "drug");
    EXPECT_EQ(*species.unit, SpeciesUnit::mass);
    EXPECT_EQ(species.amount_unit(), "kg");
    EXPECT_EQ(**species.diffusivity_in(scene.parts[0]), 1e-9);
    EXPECT_EQ(species.diffusivity_in(scene.parts[1]), nullptr) << "the wall is closed";
    EXPECT_EQ(**species.diffusivity_in(scene.parts[2]), 1e-10);
    EXPECT_DOUBLE_EQ((**species.concentration.of("blood"))(0, 2e-3), 2);
    EXPECT_DOUBLE_EQ((**species.wall_concentration.of("wall"))(1), 0.5 * std::exp(-1.0));
    EXPECT_EQ(species.wall_flux.of("wall"), nullptr);
    EXPECT_EQ(*scene.numerics.species_stepping, SpeciesStepping::explicitly);

    const std::string resolved = resolved_scene(scene);
    EXPECT_EQ(resolved_scene(read_text(resolved)), resolved);
    EXPECT_THAT(resolved, testing::HasSubstr("diffusivity = { blood = \"1e-09 m^2/s\", leaflets = \"1e-10 m^2/s\" }"));
}

TEST(Species, are_taken_up_where_the_scene_says) {
    const Scene scene = read_text(with_drug("[[measure]]",
                                            "uptake = { leaflets = \"0.1 1/s\", blood = \"0 1/s\" }\n"
                                            "[[measure]]\nname = \"m\"\nkind = \"uptake\"\n[[measure]]"));
    const Species& species = scene.species[0];
    EXPECT_EQ(species.uptake_in(scene.parts[0]), nullptr) << "0 is none";
    EXPECT_EQ(species.uptake_in(scene.parts[1]), nullptr);
    EXPECT_DOUBLE_EQ(**species.uptake_in(scene.parts[2]), 0.1);
    ASSERT_EQ(scene.takers_of(species).size(), 1U);
    EXPECT_EQ(*scene.takers_of(species)[0]->name, "leaflets");
    const std::string resolved = resolved_scene(scene);
    EXPECT_EQ(resolved_scene(read_text(resolved)), resolved);
    EXPECT_THAT(resolved, testing::HasSubstr("uptake = { blood = \"0 s^-1\", leaflets = \"0.1 s^-1\" }"));

    const Scene everywhere = read_text(with_drug("[[measure]]", "uptake = \"2 1/s\"\n[[measure]]"));
    EXPECT_DOUBLE_EQ(**everywhere.species[0].uptake_in(everywhere.parts[0]), 2);
    EXPECT_EQ(everywhere.species[0].uptake_in(everywhere.parts[1]), nullptr) << "the wall carries nothing";
    EXPECT_DOUBLE_EQ(**everywhere.species[0].uptake_in(everywhere.parts[2]), 2) << "all that carries it takes it up";
}

TEST(Species, may_be_held_at_elastic_parts) {
    const Scene scene =
        read_text(with_drug("{ blood = \"1e-9 m^2/s\", leaflets = \"1e-10 m^2/s\" }\n"
                            "concentration = \"1 mg/ml * x / 1 mm\"\n"
                            "wall_concentration = { wall = \"0.5 kg/m^3 * exp(-t / 1 s)\" }",
                            "\"1e-9 m^2/s\"\nwall_concentration = { leaflets = \"2 kg/m^3\" }"));
    EXPECT_DOUBLE_EQ((**scene.species[0].wall_concentration.of("leaflets"))(0), 2);
}

TEST(Species, may_be_counted_in_moles_or_in_nothing) {
    std::string text =
        with_drug("concentration = \"1 mg/ml * x / 1 mm\"", "unit = \"mol/m^3\"\nconcentration = \"3 mM\"");
    EXPECT_EQ(fault_of(text),
              "scene.toml:40:20: unknown unit 'mM' after 3 in \"3 mM\"\n"
              "  did you mean 'mm'?");
    text = scene_with("[[measure]]", R"([[species]]
name = "oxygen"
unit = "mol/m^3"
diffusivity = "2e-9 m^2/s"
concentration = { blood = "3 mmol/l" }
wall_flux = { wall = "2 umol/m^2/s" }
[[species]]
name = "marker"
unit = "1"
diffusivity = "0 m^2/s"
concentration = 0.25
[[measure]])");
    const Scene scene = read_text(text);
    EXPECT_DOUBLE_EQ((**scene.species[0].concentration.of("blood"))(0), 3);
    EXPECT_DOUBLE_EQ((**scene.species[0].wall_flux.of("wall"))(0), 2e-6);
    EXPECT_EQ(scene.species[0].amount_unit(), "mol");
    EXPECT_EQ((**scene.species[1].concentration.of("blood"))(0), 0.25);
    EXPECT_EQ(scene.species[1].amount_unit(), "m^3");
    EXPECT_EQ(scene.species[1].diffusivity_in(scene.parts[2]), nullptr) << "one diffusivity is that of the liquids";
    const std::string resolved = resolved_scene(scene);
    EXPECT_EQ(resolved_scene(read_text(resolved)), resolved);
}

TEST(Species, can_be_set_from_the_command_line) {
    const Scene scene =
        read_text(with_drug(), {"species.drug.diffusivity=3e-9 m^2/s", "numerics.species_stepping=implicit"});
    EXPECT_EQ(**scene.species[0].diffusivity_in(scene.parts[0]), 3e-9);
    EXPECT_EQ(*scene.numerics.species_stepping, SpeciesStepping::implicitly);
}

class BadSpecies : public testing::TestWithParam<Fault> {};

TEST_P(BadSpecies, says_where_what_and_what_to_do) {
    EXPECT_EQ(fault_of(with_drug(GetParam().found, GetParam().replacement)), GetParam().message);
}

INSTANTIATE_TEST_SUITE_P(
    Scene, BadSpecies,
    testing::ValuesIn(std::vector<Fault>{
        Fault{"negative_diffusivity", "\"1e-9 m^2/s\"", "\"-1e-9 m^2/s\"",
              "scene.toml:38:25: species.drug.diffusivity.blood: found \"-1e-9 m^2/s\", expected at least 0\n"
              "  give a value that is at least 0"},
        Fault{"diffusivity_without_unit", "\"1e-9 m^2/s\"", "1e-9",
              "scene.toml:38:25: missing unit: blood = 1e-9, expected a kinematic viscosity such as \"1e-9 m^2/s\"\n"
              "  write blood = \"1e-9 m^2/s\", with the unit you mean"},
        Fault{"fluid_left_out", "blood = \"1e-9 m^2/s\", ", "",
              "scene.toml:37:8: species 'drug', diffusivity: the fluid 'blood' is missing\n"
              "  add its diffusivity; 0 if the species only moves with the fluid"},
        Fault{"unknown_part", "leaflets =", "leaflet =",
              "scene.toml:38:39: species 'drug', diffusivity: the scene has no part 'leaflet'\n"
              "  did you mean 'leaflets'?"},
        Fault{"start_in_time", "* x / 1 mm", "* t / 1 s",
              "scene.toml:39:17: species 'drug', concentration depends on t: \"1 mg/ml * t / 1 s\"\n"
              "  write a formula of x, y and z: initial values do not depend on time"},
        Fault{
            "start_of_another_dimension", "1 mg/ml", "1 mol/l",
            "scene.toml:39:18: species.drug.concentration: found \"1 mol/l * x / 1 mm\" (mol/m^3), expected a density "
            "such as \"1 kg/m^3\"\n"
            "  check the units of its factors: the whole formula must be a density"},
        Fault{"start_in_what_is_closed", "\"1 mg/ml * x / 1 mm\"", "{ wall = \"1 kg/m^3\" }",
              "scene.toml:39:19: species 'drug', concentration: the part 'wall' of kind 'rigid' does not carry "
              "the species, because it has no diffusivity\n"
              "  add it to the species' diffusivity, or leave it out here"},
        Fault{"walls_of_which_part", "{ wall = \"0.5 kg/m^3 * exp(-t / 1 s)\" }", "\"0.5 kg/m^3\"",
              "scene.toml:40:22: species 'drug', wall_concentration: one value for all parts is not allowed\n"
              "  write a table of rigid or elastic parts, wall_concentration = { wall = ... }"},
        Fault{"held_part_that_is_no_wall", "{ wall =", "{ blood =",
              "scene.toml:40:24: species 'drug', wall_concentration: 'blood' is of kind 'fluid', expected 'rigid' or "
              "'elastic'\n"
              "  name rigid or elastic parts only"},
        Fault{"held_body_that_conducts", "{ wall =", "{ leaflets =",
              "scene.toml:40:24: species 'drug', wall_concentration: 'leaflets' conducts the species, because it has "
              "a diffusivity\n"
              "  leave it out of one of the two"},
        Fault{"flux_out_of_a_body", "[[measure]]", "wall_flux = { leaflets = \"1 kg/m^2/s\" }\n[[measure]]",
              "scene.toml:41:15: species 'drug', wall_flux: 'leaflets' is of kind 'elastic', expected 'rigid'\n"
              "  name rigid parts only"},
        Fault{"negative_uptake", "[[measure]]", "uptake = { blood = \"-1 1/s\" }\n[[measure]]",
              "scene.toml:41:20: species.drug.uptake.blood: found \"-1 1/s\", expected at least 0\n"
              "  give a value that is at least 0"},
        Fault{"uptake_without_unit", "[[measure]]", "uptake = 0.1\n[[measure]]",
              "scene.toml:41:10: missing unit: uptake = 0.1, expected a frequency such as \"0.1 1/s\"\n"
              "  write uptake = \"0.1 1/s\", with the unit you mean"},
        Fault{"uptake_of_another_unit", "[[measure]]", "uptake = \"0.1 m/s\"\n[[measure]]",
              "scene.toml:41:10: species.drug.uptake: found \"0.1 m/s\" (speed), expected a frequency such as \"0.1 "
              "1/s\"\n"
              "  give a frequency for uptake"},
        Fault{"uptake_in_which_part", "[[measure]]", "uptake = { leaflet = \"1 1/s\" }\n[[measure]]",
              "scene.toml:41:12: species 'drug', uptake: the scene has no part 'leaflet'\n"
              "  did you mean 'leaflets'?"},
        Fault{"uptake_in_what_is_closed", "[[measure]]", "uptake = { wall = \"1 1/s\" }\n[[measure]]",
              "scene.toml:41:12: species 'drug', uptake: the part 'wall' of kind 'rigid' does not carry the species, "
              "because it has no diffusivity\n"
              "  add it to the species' diffusivity, or leave it out here"},
        Fault{"measure_of_no_uptake", "[[measure]]", "[[measure]]\nname = \"m\"\nkind = \"uptake\"\n[[measure]]",
              "scene.toml:43:8: measure 'm': nothing takes up species 'drug'\n"
              "  give the species an uptake, or leave the measure out"},
        Fault{"measure_of_no_uptake_there", "[[measure]]",
              "uptake = { leaflets = \"1 1/s\" }\n[[measure]]\nname = \"m\"\nkind = \"uptake\"\npart = "
              "\"blood\"\n[[measure]]",
              "scene.toml:45:8: measure 'm': 'blood' does not take up species 'drug'\n"
              "  what does is 'leaflets'; leave part out for all of it"},
        Fault{"held_wall_that_conducts", "leaflets =", "wall =",
              "scene.toml:40:24: species 'drug', wall_concentration: 'wall' conducts the species, because it has "
              "a diffusivity\n"
              "  leave it out of one of the two"},
        Fault{"wall_with_both", "[[measure]]", "wall_flux = { wall = \"1 kg/m^2/s\" }\n[[measure]]",
              "scene.toml:41:15: species 'drug': 'wall' has a wall_concentration and a wall_flux\n"
              "  leave out one of them"},
        Fault{"unit_of_its_own", "[[measure]]", "unit = \"percent\"\n[[measure]]",
              "scene.toml:41:8: species.drug.unit: found \"percent\", expected one of 'kg/m^3', 'mol/m^3' and '1'\n"
              "  write one of these names"},
        Fault{"misspelt_key", "diffusivity =", "diffusivty =",
              "scene.toml:38:1: unknown key 'diffusivty' in [[species]]\n"
              "  did you mean 'diffusivity' in [[species]]?"},
        Fault{"measure_of_another_species", "[[measure]]",
              "[[measure]]\nname = \"m\"\nkind = \"amount\"\nspecies = \"drag\"\n[[measure]]",
              "scene.toml:44:11: measure 'm': the scene has no species 'drag'\n"
              "  did you mean 'drug'?"},
        Fault{"half_a_box", "[[measure]]",
              "[[measure]]\nname = \"m\"\nkind = \"mean_concentration\"\nfrom = [0, 0]\n[[measure]]",
              "scene.toml:44:8: measure 'm' has one corner of a box\n"
              "  give both from and to, or neither"},
        Fault{"empty_box", "[[measure]]",
              "[[measure]]\nname = \"m\"\nkind = \"spread\"\naxis = \"x\"\nfrom = [0, 0]\nto = [0, \"1 "
              "mm\"]\n[[measure]]",
              "scene.toml:46:6: the corners of measure 'm' have the same x: there is nothing between them\n"
              "  give two opposite corners of a box"},
        Fault{"profile_out_of_the_plane", "[[measure]]",
              "[[measure]]\nname = \"m\"\nkind = \"profile\"\naxis = \"z\"\n[[measure]]",
              "scene.toml:44:8: measure 'm': a scene in 2-D has no axis 'z'\n"
              "  take x or y"},
        Fault{"no_bins", "[[measure]]",
              "[[measure]]\nname = \"m\"\nkind = \"profile\"\naxis = \"x\"\nbins = 0\n[[measure]]",
              "scene.toml:45:8: measure.m.bins: found 0, expected between 1 and 1000\n"
              "  give a value that is between 1 and 1000"},
        Fault{"flux_into_a_closed_wall", "[[measure]]",
              "[[measure]]\nname = \"m\"\nkind = \"wall_flux\"\npart = \"leaflets\"\n[[measure]]",
              "scene.toml:44:8: measure 'm': 'leaflets' is not a part at which species 'drug' has a fixed "
              "concentration\n"
              "  such parts are 'wall'"},
        Fault{"half_a_sherwood_number", "[[measure]]",
              "[[measure]]\nname = \"m\"\nkind = \"wall_flux\"\npart = \"wall\"\nlength = \"1 mm\"\n[[measure]]",
              "scene.toml:45:10: measure 'm': a Sherwood number needs a length and an area\n"
              "  give both, or neither"}}),
    name_of);

TEST(WrongScene, measures_and_pictures_of_no_species) {
    const auto measure = [](const std::string& keys) {
        return scene_with("[[measure]]", "[[measure]]\nname = \"m\"\n" + keys + "\n[[measure]]");
    };
    EXPECT_EQ(fault_of(measure("kind = \"amount\"")),
              "scene.toml:38:8: measure 'm' is about a species, and the scene has none\n"
              "  add a [[species]], or leave the measure out");
    EXPECT_EQ(fault_of(measure("kind = \"probe\"\npoint = [0, 0]\nfield = \"concentration\"")),
              "scene.toml:40:9: the probe 'm' reads a concentration, and the scene has no species\n"
              "  add a [[species]], or read another field");
    EXPECT_EQ(fault_of(good_scene, {"output.picture_field=concentration"}),
              "--set output.picture_field=concentration: 'concentration' needs a species, and the scene has "
              "none\n"
              "  add a [[species]], or leave the field out");
}

TEST(WrongScene, several_species_and_no_word_of_which) {
    std::string two = drug;
    two.replace(two.find("[[measure]]"), 11, "[[species]]\nname = \"dye\"\ndiffusivity = \"1e-9 m^2/s\"\n[[measure]]");
    const std::string text = scene_with("[[measure]]", two);
    EXPECT_EQ(fault_of(text), "no error");
    EXPECT_EQ(fault_of(text + "\n[[measure]]\nname = \"m\"\nkind = \"amount\"\n"),
              "scene.toml:56:8: measure 'm' does not name its species\n"
              "  write species = one of 'drug' and 'dye'");
    EXPECT_EQ(fault_of(text, {"output.fields=['concentration']", "output.picture_field=concentration"}),
              "--set output.picture_field=concentration: output.picture_field = \"concentration\": there are "
              "several species, each with its own field\n"
              "  keep only one [[species]], or choose another field");
    EXPECT_EQ(fault_of(text, {"species.dye.name=drug"}),
              "--set species.dye.name=drug: there is already a species called 'drug', at scene.toml:37:8\n"
              "  give each species its own name");
}

}  // namespace
}  // namespace dmp::tests::scene_species_tests
