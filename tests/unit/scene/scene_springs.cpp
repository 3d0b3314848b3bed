// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// What elastic solids are made of: strips in 2-D, materials in 3-D.
#include <gmock/gmock.h>

#include "tests/modules.hpp"
#include "tests/unit/scene/scene_text.hpp"

namespace dmp::tests::scene_springs_tests {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

const std::string strip =
    "bending_stiffness = \"3e-6 N*m^2\"\naxial_stiffness = \"100 N\"\nmass_per_length = \"0.42 kg/m\"";

/// The test scene in 3-D, with this for its elastic solid.
std::string in_space(const std::string& springs) {
    std::string text = scene_with(strip, springs);
    text = text.substr(0, text.find("[[measure]]"));
    return text.replace(text.find("title"), 0, "dimension = 3\n");
}

TEST(SceneSprings, in_space_they_are_a_material) {
    const Scene scene = read_text(in_space(
        "density = \"1100 kg/m^3\"\nyoungs_modulus = \"2 MPa\"\npoisson_ratio = 0.25\nthickness = \"0.3 mm\""));
    EXPECT_EQ(*scene.parts[2].density, 1100);
    EXPECT_EQ(*scene.parts[2].youngs_modulus, 2e6);
    EXPECT_THAT(fault_of(in_space("density = \"1100 kg/m^3\"")), HasSubstr("'leaflets': youngs_modulus is missing"));
    EXPECT_THAT(fault_of(in_space("youngs_modulus = \"2 MPa\"")), HasSubstr("'leaflets': density is missing"));
    EXPECT_THAT(fault_of(in_space(strip)),
                AllOf(HasSubstr("mass_per_length is for strips in 2-D"), HasSubstr("give density")));
    EXPECT_THAT(fault_of(in_space("density = \"1100 kg/m^3\"\nyoungs_modulus = \"2 MPa\"\ncross_bonds = true")),
                HasSubstr("cross_bonds is for strips in 2-D"));
}

TEST(SceneSprings, in_the_plane_they_are_a_strip) {
    EXPECT_THAT(fault_of(scene_with("mass_per_length = \"0.42 kg/m\"\n", "")),
                AllOf(HasSubstr("'leaflets': mass_per_length is missing"), HasSubstr("add mass_per_length")));
    EXPECT_THAT(fault_of(scene_with("mass_per_length", "density = \"1100 kg/m^3\"\nmass_per_length")),
                HasSubstr("mass_per_length is for strips, and a part with a density is an area"));
}

TEST(SceneSprings, a_strip_may_have_a_shear_stiffness_and_then_no_say_about_cross_bonds) {
    const std::string sheared = strip + "\nshear_stiffness = \"40 N\"";
    EXPECT_EQ(*read_text(scene_with(strip, sheared)).parts[2].shear_stiffness, 40);
    EXPECT_THAT(
        fault_of(scene_with(strip, sheared + "\ncross_bonds = true")),
        AllOf(HasSubstr("part 'leaflets' has cross_bonds and shear_stiffness"), HasSubstr("leave out cross_bonds")));
    EXPECT_THAT(fault_of(in_space("density = \"1100 kg/m^3\"\nyoungs_modulus = \"2 MPa\"\nshear_stiffness = \"40 N\"")),
                HasSubstr("shear_stiffness is for strips in 2-D"));
}

TEST(SceneCells, are_areas_and_volumes_without_a_model) {
    const std::string area = "density = \"1100 kg/m^3\"\nyoungs_modulus = \"2 MPa\"\npoisson_ratio = 0.25\n";
    const auto is_of_cells = [](const std::string& text) {
        const Scene scene = read_text(text);
        return scene.is_of_cells(scene.parts[2]);
    };
    EXPECT_TRUE(is_of_cells(scene_with(strip, area)));
    EXPECT_TRUE(is_of_cells(scene_with(strip, area + "model = \"cells\"")));
    EXPECT_FALSE(is_of_cells(scene_with(strip, area + "model = \"springs\"")));
    EXPECT_FALSE(is_of_cells(scene_with(strip, area + "bonds_within = \"0.15 mm\"")));
    EXPECT_FALSE(is_of_cells(scene_with(strip, strip)));
    EXPECT_TRUE(is_of_cells(in_space(area)));
    EXPECT_FALSE(is_of_cells(in_space(area + "thickness = \"0.3 mm\"")));
    const Scene scene = read_text(scene_with(strip, area + "elastic_law = \"neo_hookean\""));
    EXPECT_TRUE(scene.parts[2].elastic_law->is<NeoHookean>());
    EXPECT_EQ(read_text(resolved_scene(scene)).hash, scene.hash);
}

TEST(SceneCells, that_cannot_be_are_refused) {
    const std::string area = "density = \"1100 kg/m^3\"\nyoungs_modulus = \"2 MPa\"\n", cells = "model = \"cells\"\n",
                      springs = "model = \"springs\"\n", neo_hookean = "elastic_law = \"neo_hookean\"\n";
    const auto fault = [&](const std::string& part) { return fault_of(scene_with(strip, part)); };
    EXPECT_THAT(fault(strip + "\n" + cells), AllOf(HasSubstr("is a strip"), HasSubstr("draw the part as an area")));
    EXPECT_THAT(fault_of(in_space(area + cells + "thickness = \"0.3 mm\"")),
                AllOf(HasSubstr("is a shell"), HasSubstr("draw the part as a volume")));
    EXPECT_THAT(fault(area + cells + "bonds_within = \"0.15 mm\""), HasSubstr("bonds_within is for solids of springs"));
    EXPECT_THAT(fault(area + "poisson_ratio = 0.5"), HasSubstr("0.49"));
    for (const std::string& part : {area + springs, area + "bonds_within = \"0.15 mm\"\n", strip + "\n"})
        EXPECT_THAT(fault(part + neo_hookean),
                    AllOf(HasSubstr("elastic_law is for solids of cells"), HasSubstr("leave out")));
    EXPECT_THAT(fault(area + "elastic_law = \"rubber\""), HasSubstr("neo_hookean"));
    const std::string ratio = "damping_ratio = 0.05\n", frequency = "damping_frequency = \"2 Hz\"\n";
    const Part damped =
        read_text(scene_with(strip, area + cells + "poisson_ratio = 0.3\n" + ratio + frequency)).parts[2];
    EXPECT_EQ(*damped.damping_ratio, 0.05);
    EXPECT_EQ(*damped.damping_frequency, 2);
    EXPECT_THAT(fault(area + cells + "poisson_ratio = 0.3\n" + ratio), HasSubstr("no damping_frequency"));
    EXPECT_THAT(fault(area + cells + "poisson_ratio = 0.3\n" + frequency), HasSubstr("no damping_ratio"));
    EXPECT_THAT(fault(area + cells + "poisson_ratio = 0.3\nbond_damping = 0.01\n" + ratio + frequency),
                HasSubstr("both given"));
    EXPECT_THAT(fault(area + springs + "poisson_ratio = 0.25\n" + ratio + frequency), HasSubstr("for solids of cells"));
    EXPECT_THAT(fault(strip + "\ninitial_velocity = [\"1 m/s * t / (1 s)\", 0]"), HasSubstr("depends on t"));
    EXPECT_THAT(fault(strip + "\ninitial_velocity = [0, 0, \"1 m/s\"]"), HasSubstr("third component"));
}

TEST(SceneCells, break_by_stress_or_strain_and_springs_by_force_or_strain) {
    const std::string area = "density = \"1100 kg/m^3\"\nyoungs_modulus = \"2 MPa\"\n", cells = "model = \"cells\"\n";
    const auto breaking = [&](const std::string& part, const std::string& limit) {
        return scene_with(strip, part) + "\n[[break]]\nname = \"tear\"\npart = \"leaflets\"\n" + limit;
    };
    const Scene scene = read_text(breaking(area + cells, "stress_above = \"40 kPa\""));
    EXPECT_EQ(*scene.breaking[0].stress_above, 4e4);
    EXPECT_TRUE(scene.is_of_cells(scene.parts[2]));
    EXPECT_FALSE(read_text(scene_with(strip, strip)).is_of_cells(scene.parts[0]));
    EXPECT_EQ(*read_text(breaking(area + cells, "strain_above = 0.1")).breaking[0].strain_above, 0.1);
    EXPECT_THAT(fault_of(breaking(area + cells, "force_above = \"1 N\"")),
                AllOf(HasSubstr("force_above is for bonds, and 'leaflets' consists of cells"),
                      HasSubstr("give stress_above or strain_above")));
    EXPECT_THAT(fault_of(breaking(strip, "stress_above = \"1 Pa\"")),
                AllOf(HasSubstr("stress_above is for solids of cells, and 'leaflets' consists of bonds"),
                      HasSubstr("give force_above or strain_above")));
    EXPECT_THAT(fault_of(breaking(area + cells, "")), HasSubstr("give stress_above or strain_above"));
    EXPECT_THAT(fault_of(breaking(area + cells, "stress_above = \"1 Pa\"\nstrain_above = 0.1")),
                HasSubstr("two limits"));
}

TEST(SceneSprings, with_bonds_within_are_solids_of_one_poisson_ratio) {
    const std::string area = "density = \"1100 kg/m^3\"\nyoungs_modulus = \"2 MPa\"\nbonds_within = \"0.15 mm\"";
    EXPECT_NEAR(*read_text(scene_with(strip, area)).parts[2].bonds_within, 1.5e-4, 1e-18);
    EXPECT_EQ(*read_text(scene_with(strip, area + "\npoisson_ratio = 0.25")).parts[2].poisson_ratio, 0.25);
    EXPECT_THAT(fault_of(scene_with(strip, area + "\npoisson_ratio = 0.2")),
                AllOf(HasSubstr("gives a Poisson's ratio of 0.25 only"), HasSubstr("poisson_ratio = 0.25")));
    EXPECT_THAT(
        fault_of(scene_with(strip, strip + "\nbonds_within = \"0.15 mm\"")),
        AllOf(HasSubstr("bonds_within is for solids, and this is a strip"), HasSubstr("model the part as an area")));
    EXPECT_THAT(fault_of(in_space(area + "\nthickness = \"0.3 mm\"")),
                AllOf(HasSubstr("this is a shell"), HasSubstr("model the part as a volume")));
}

}  // namespace
}  // namespace dmp::tests::scene_springs_tests
