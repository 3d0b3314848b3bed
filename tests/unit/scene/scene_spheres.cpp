// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Scenes of spheres: what is read, and each way to get it wrong.
#include "tests/modules.hpp"
#include "tests/unit/scene/fault.hpp"

namespace dmp::tests::scene_spheres_tests {
namespace {

const std::string spheres_scene = R"(schema = 1
dimension = 3

[[part]]
name = "carrier"
kind = "spheres"
radius = "50 um"
density = "2502 kg/m^3"
youngs_modulus = "63 GPa"
poisson_ratio = 0.24
centres = [[0, 0, "60 um"]]
initial_velocity = [0, 0, "-5 m/s"]
initial_spin = ["1e5 rad/s", 0, 0]

[[part]]
name = "drug"
kind = "spheres"
radius = "2.5 um"
mass = "84.4 pg"
youngs_modulus = "2.15 GPa"
poisson_ratio = 0.3
around = "carrier"
coverage = 0.5

[[part]]
name = "floor"
kind = "plane"
point = [0, 0, 0]
normal = [0, 0, 2]

[[contact_pair]]
name = "sticky"
parts = ["drug", "carrier"]
restitution = 0.9
friction = 0.3
adhesion = "bradley"
pull_off_force = "258 nN"
equilibrium_distance = "0.4 nm"

[[contact_pair]]
parts = ["any", "any"]
normal_damping = "0.3 1/m/s"
tangential_damping = "0.15 1/m/s"
friction = 0

[run]
duration = "1 us"

[output]
every = "100 ns"
)";

std::string spheres_with(const std::string& found, const std::string& replacement) {
    std::string text = spheres_scene;
    const auto at = text.find(found);
    if (at == std::string::npos) throw std::logic_error("the test scene has no " + found);
    return text.replace(at, found.size(), replacement);
}

TEST(SpheresScene, needs_no_drawing_and_reads_what_is_given) {
    const Scene scene = read_text(spheres_scene);
    ASSERT_EQ(scene.parts_of(PartKind::spheres).size(), 2U);
    const Part &carrier = scene.parts[0], &drug = scene.parts[1], &floor = scene.parts[2];
    EXPECT_EQ(*carrier.radius, std::vector<double>{50e-6});
    EXPECT_EQ(*carrier.density, 2502);
    EXPECT_EQ(*carrier.youngs_modulus, 63e9);
    ASSERT_EQ(carrier.centres->size(), 1U);
    EXPECT_EQ((*carrier.centres)[0], Vec(0, 0, 60e-6));
    EXPECT_EQ((*carrier.initial_velocity)[2](0), -5);
    EXPECT_EQ((*carrier.initial_spin)[0](0), 1e5);
    EXPECT_NEAR(*drug.mass, 84.4e-15, 1e-28);
    EXPECT_EQ(*drug.coverage, 0.5);
    EXPECT_EQ(*drug.count, 0);
    EXPECT_FALSE(drug.initial_velocity.given());
    EXPECT_TRUE(floor.is_wall_for_spheres());
    EXPECT_EQ(*floor.normal, Vec(0, 0, 2));
    EXPECT_EQ(*scene.numerics.steps_per_contact, 30);
    EXPECT_EQ(*scene.numerics.contact_step, 0);
}

TEST(SpheresScene, has_three_axes) {
    const Scene scene = read_text(spheres_scene + "[flow]\nacceleration = [0, 0, \"-9.81 m/s^2\"]\n");
    EXPECT_EQ(scene.flow.acceleration[2](0), -9.81);
    EXPECT_EQ(fault_of(scene_with("largest_speed", "acceleration = [0, 0, \"-9.81 m/s^2\"]\nlargest_speed")),
              "scene.toml:28:23: flow.acceleration has a third component in a 2-D scene\n  leave it out, or write 0");
}

TEST(SpheresScene, finds_the_most_particular_contact) {
    const Scene scene = read_text(spheres_scene);
    const ContactPair *sticky = &scene.contact_pairs[0], *any = &scene.contact_pairs[1];
    EXPECT_EQ(scene.contact_between("carrier", "drug"), sticky);
    EXPECT_EQ(scene.contact_between("drug", "carrier"), sticky);
    EXPECT_EQ(scene.contact_between("drug", "drug"), any);
    EXPECT_EQ(scene.contact_between("drug", "floor"), any);
    EXPECT_EQ(*sticky->friction, 0.3);
    EXPECT_EQ(*sticky->pull_off_force, 258e-9);
    EXPECT_EQ(*any->normal_damping, 0.3);
    EXPECT_EQ(*any->restitution, 0) << "not given";
    const Scene half = read_text(spheres_with(R"(["any", "any"])", R"(["any", "drug"])") +
                                 "[[contact_pair]]\nparts = [\"any\", \"any\"]\nenabled = false\n");
    EXPECT_EQ(half.contact_between("drug", "floor"), &half.contact_pairs[1]);
    EXPECT_EQ(half.contact_between("carrier", "floor"), &half.contact_pairs[2]);
    EXPECT_FALSE(*half.contact_pairs[2].enabled);
}

TEST(SpheresScene, reads_back_as_the_same_scene) {
    const Scene scene = read_text(spheres_scene, {"contact_pair.sticky.friction=0", "part.carrier.fixed=true"});
    EXPECT_TRUE(scene.contact_pairs[0].friction.given());
    const std::string resolved = resolved_scene(scene);
    const Scene again = read_text(resolved);
    EXPECT_EQ(resolved_scene(again), resolved);
    EXPECT_EQ(again.hash, scene.hash);
    EXPECT_TRUE(again.contact_pairs[0].friction.given()) << "0 is not the same as nothing";
    EXPECT_FALSE(again.contact_pairs[0].normal_damping.given());
    EXPECT_EQ(resolved.find("[geometry]\nfile"), std::string::npos);
    EXPECT_TRUE(again.parts[0].initial_velocity.given());
    EXPECT_FALSE(again.parts[1].initial_velocity.given()) << "the drug moves with its carrier";
    EXPECT_FALSE(again.parts[1].initial_spin.given());
}

TEST(SpheresScene, takes_lists_and_walls_of_triangles) {
    const Scene scene = read_text(spheres_with("radius = \"50 um\"", "radius = [\"50 um\", \"40 um\"]") +
                                      "[[part]]\nname = \"tube\"\nkind = \"surface\"\nfile = \"tube.stl\"\nunit = \"1 "
                                      "mm\"\nvelocity = [\"1 m/s\"]\n",
                                  {"part.carrier.centres=[[0, 0, 0], [0, 0, \"1 mm\"]]", "part.drug.enabled=false"});
    EXPECT_EQ(*scene.parts[0].radius, (std::vector<double>{50e-6, 40e-6}));
    const Part& tube = scene.parts[3];
    EXPECT_EQ(*tube.file, "tube.stl");
    EXPECT_EQ(*tube.unit, 0.001);
    EXPECT_TRUE(tube.moves());
}

TEST(SpheresScene, repeats_itself_in_a_box) {
    const std::string periodic = spheres_scene + "[flow]\nperiodic = [\"x\", \"z\"]\n";
    EXPECT_EQ(fault_of(periodic),
              "scene.toml:52:13: the scene is periodic along x, but its period is missing\n"
              "  add [box] with from = [0, 0, 0] and to = [\"1 mm\", \"1 mm\", \"1 mm\"]");
    EXPECT_EQ(fault_of(periodic + "[box]\nfrom = [0, 0, 0]\nto = [\"1 mm\", 0, 0]\n"),
              "scene.toml:55:6: box.to is not beyond box.from along z, a periodic axis\n"
              "  give the low corner as from and the high one as to");
    EXPECT_EQ(*read_text(periodic + "[box]\nfrom = [0, 0, 0]\nto = [\"1 mm\", 0, \"2 mm\"]\n").box.to,
              Vec(0.001, 0, 0.002));
}

class WrongSpheres : public testing::TestWithParam<Fault> {};

TEST_P(WrongSpheres, is_refused_with_its_place) {
    const Fault& fault = GetParam();
    EXPECT_EQ(fault_of(spheres_with(fault.found, fault.replacement)), fault.message);
}

INSTANTIATE_TEST_SUITE_P(
    Parts, WrongSpheres,
    testing::Values(
        Fault{"in_the_plane", "dimension = 3", "dimension = 2",
              "scene.toml:2:13: part 'carrier' is of spheres, which need a 3-D scene, and the scene has 2 "
              "dimensions\n"
              "  write dimension = 3"},
        Fault{"negative_stiffness", "youngs_modulus = \"63 GPa\"", "youngs_modulus = \"-63 GPa\"",
              "scene.toml:9:18: part.carrier.youngs_modulus: found \"-63 GPa\", expected more than 0\n"
              "  give a value that is more than 0"},
        Fault{"no_stiffness", "youngs_modulus = \"63 GPa\"\n", "",
              "scene.toml:4:1: missing key: part.carrier.youngs_modulus\n"
              "  add 'youngs_modulus' in [[part]]: a pressure such as \"60 GPa\", more than 0"},
        Fault{"poisson_ratio_of_more_than_a_half", "poisson_ratio = 0.24", "poisson_ratio = 0.6",
              "scene.toml:10:17: part.carrier.poisson_ratio: found 0.6, expected between 0 and 0.5\n"
              "  give a value that is between 0 and 0.5"},
        Fault{"no_radius", "radius = \"50 um\"\n", "",
              "scene.toml:5:8: part 'carrier': radius is missing\n  add radius = \"1 mm\""},
        Fault{"radius_of_nothing", "radius = \"50 um\"", "radius = 0",
              "scene.toml:7:10: part.carrier.radius: found 0, expected more than 0\n"
              "  give a value that is more than 0"},
        Fault{"too_many_radii", "radius = \"50 um\"", "radius = [\"50 um\", \"1 um\"]",
              "scene.toml:7:10: part 'carrier' has 2 radii and 1 centres\n"
              "  give one radius for all, or one for each of the centres"},
        Fault{"mass_twice", "density = \"2502 kg/m^3\"", "density = \"2502 kg/m^3\"\nmass = \"1 ug\"",
              "scene.toml:9:8: part 'carrier' has both a density and a mass\n  give density, or mass of each sphere"},
        Fault{"no_mass", "density = \"2502 kg/m^3\"\n", "",
              "scene.toml:5:8: part 'carrier' has neither a density nor a mass\n"
              "  give density, or mass of each sphere"},
        Fault{"nowhere", "centres = [[0, 0, \"60 um\"]]\n", "",
              "scene.toml:5:8: part 'carrier' does not say where its spheres are\n"
              "  give one of centres, positions, around, or fill_from and fill_to"},
        Fault{"placed_twice", "coverage = 0.5", "coverage = 0.5\npositions = \"a.csv\"",
              "scene.toml:16:8: part 'drug' says in 2 ways where its spheres are: 'positions' and 'around'\n"
              "  give one of centres, positions, around, or fill_from and fill_to"},
        Fault{"half_a_box", "around = \"carrier\"\ncoverage = 0.5", "fill_from = [0, 0, 0]\ncount = 3",
              "scene.toml:22:13: part 'drug': a box to fill has two corners\n  give fill_from and fill_to"},
        Fault{"box_inside_out", "around = \"carrier\"\ncoverage = 0.5",
              "fill_from = [0, 0, 0]\nfill_to = [\"1 mm\", \"1 mm\", \"-1 mm\"]\ncount = 3",
              "scene.toml:23:11: part 'drug': fill_to is not beyond fill_from along z\n"
              "  give the low corner as fill_from and the high one as fill_to"},
        Fault{"count_and_coverage", "coverage = 0.5", "coverage = 0.5\ncount = 882",
              "scene.toml:23:12: part 'drug' gives both count and coverage\n  give count or coverage"},
        Fault{"neither_count_nor_coverage", "coverage = 0.5\n", "",
              "scene.toml:16:8: part 'drug' gives neither count nor coverage\n  give count or coverage"},
        Fault{"volume_fraction_around", "coverage = 0.5", "volume_fraction = 0.1\ncount = 3",
              "scene.toml:23:19: part 'drug': volume_fraction does not go with around\n  leave it out"},
        Fault{"too_dense", "around = \"carrier\"\ncoverage = 0.5", "volume_fraction = 0.7",
              "scene.toml:22:19: part.drug.volume_fraction: found 0.7, expected more than 0 and at most 0.6\n"
              "  random filling reaches volume fractions up to about 0.35"},
        Fault{"count_of_centres", "centres = [[0, 0, \"60 um\"]]", "centres = [[0, 0, \"60 um\"]]\ncount = 1",
              "scene.toml:12:9: part 'carrier': count does not go with centres\n  leave it out"},
        Fault{"around_nobody", "around = \"carrier\"", "around = \"carier\"",
              "scene.toml:22:10: the scene has no part 'carier'\n  did you mean 'carrier'?"},
        Fault{"around_itself", "around = \"carrier\"", "around = \"drug\"",
              "scene.toml:22:10: part 'drug': its spheres cannot sit on themselves\n"
              "  name an enabled part of one sphere"},
        Fault{"around_a_plane", "around = \"carrier\"", "around = \"floor\"",
              "scene.toml:22:10: part 'drug': its spheres cannot sit on 'floor', which is of kind 'plane'\n"
              "  name an enabled part of one sphere"},
        Fault{"start_with_a_time", "initial_velocity = [0, 0, \"-5 m/s\"]", "initial_velocity = [\"1 m/s^2 * t\"]",
              "scene.toml:12:20: initial_velocity of 'carrier' depends on t: \"1 m/s^2 * t\"\n"
              "  write formulas of x, y and z: initial values do not depend on time"},
        Fault{"normal_that_points_nowhere", "normal = [0, 0, 2]", "normal = [0, 0, 0]",
              "scene.toml:29:10: part.floor.normal: found [0, 0, 0], which has no direction\n"
              "  give a direction of three numbers such as [0, 0, 1]"},
        Fault{"wall_of_half_a_material", "normal = [0, 0, 2]", "normal = [0, 0, 2]\nyoungs_modulus = \"1 GPa\"",
              "scene.toml:30:18: part 'floor' has a youngs_modulus and no poisson_ratio\n"
              "  give both, or neither for a rigid wall"},
        Fault{"wall_that_bends", "normal = [0, 0, 2]", "normal = [0, 0, 2]\nvelocity = [\"1 m/s * x / 1 m\"]",
              "scene.toml:30:12: velocity of 'floor' depends on x, y or z: it would bend\n  give formulas of t"},
        Fault{"drawing_for_nothing", "[run]", "[geometry]\nfile = \"a.geo\"\n[run]",
              "scene.toml:47:8: geometry.file: no part of the scene uses a geometry\n  leave [geometry] out"},
        Fault{"drawn_part_beside_spheres", "kind = \"plane\"\npoint = [0, 0, 0]\nnormal = [0, 0, 2]",
              "kind = \"rigid\"", "scene.toml: missing key: geometry.file\n  add 'file' in [geometry]: text"}),
    name_of);

INSTANTIATE_TEST_SUITE_P(
    Contacts, WrongSpheres,
    testing::Values(
        Fault{"restitution_of_more_than_one", "restitution = 0.9", "restitution = 1.2",
              "scene.toml:34:15: contact_pair.sticky.restitution: found 1.2, expected more than 0 and at most 1\n"
              "  give a value that is more than 0 and at most 1"},
        Fault{"no_restitution", "restitution = 0.9\n", "",
              "scene.toml:33:9: the contact of 'drug' and 'carrier' has neither a restitution nor damping "
              "coefficients\n"
              "  give restitution (1: elastic), or normal_damping and tangential_damping"},
        Fault{"damping_twice", "restitution = 0.9", "restitution = 0.9\nnormal_damping = \"1 1/m/s\"",
              "scene.toml:35:18: the contact of 'drug' and 'carrier' has its damping twice: as a restitution, at "
              "scene.toml:34:15, and as coefficients\n"
              "  give restitution, or normal_damping and tangential_damping"},
        Fault{"no_friction", "friction = 0.3\n", "",
              "scene.toml:33:9: the contact of 'drug' and 'carrier': friction is missing, which the tangential "
              "law 'mindlin' needs\n"
              "  add friction = 0.3 (Coulomb's coefficient), or friction = 0 for spheres that slide freely"},
        Fault{"negative_friction", "friction = 0.3", "friction = -0.3",
              "scene.toml:35:12: contact_pair.sticky.friction: found -0.3, expected at least 0\n"
              "  give a value that is at least 0"},
        Fault{"unknown_part", "[\"drug\", \"carrier\"]", "[\"drg\", \"carrier\"]",
              "scene.toml:33:9: the scene has no part 'drg'\n  did you mean 'drug'?"},
        Fault{"three_parts", "[\"drug\", \"carrier\"]", "[\"drug\", \"carrier\", \"floor\"]",
              "scene.toml:33:9: contact_pair.sticky.parts: found a list of 3, expected two names\n"
              "  name both parts; name a part twice for contacts within it"},
        Fault{"walls_only", "[\"drug\", \"carrier\"]", "[\"floor\", \"floor\"]",
              "scene.toml:33:9: the contact of 'floor' and 'floor': both are walls, which do not touch each other\n"
              "  name at least one part of spheres"},
        Fault{"pair_twice", "parts = [\"any\", \"any\"]", "parts = [\"carrier\", \"drug\"]",
              "scene.toml:41:9: there is already a [[contact_pair]] of 'carrier' and 'drug', at scene.toml:33:9\n"
              "  leave one of them out"},
        Fault{"pair_missing", "parts = [\"any\", \"any\"]", "parts = [\"any\", \"floor\"]",
              "scene.toml:16:8: spheres of 'drug' can touch each other, but have no [[contact_pair]]\n"
              "  add a [[contact_pair]] with parts = [\"drug\", \"drug\"], restitution and friction, or enabled = "
              "false"},
        Fault{"pair_with_the_wall_missing", "parts = [\"any\", \"any\"]", "parts = [\"drug\", \"any\"]",
              "scene.toml:26:8: 'carrier' and 'floor' can touch, but have no [[contact_pair]]\n"
              "  add a [[contact_pair]] with parts = [\"carrier\", \"floor\"], restitution and friction, or "
              "enabled = false"},
        Fault{"adhesion_of_no_strength", "pull_off_force = \"258 nN\"\n", "",
              "scene.toml:36:12: the contact of 'drug' and 'carrier' adheres, but the strength of the adhesion is "
              "missing\n"
              "  give work_of_adhesion or pull_off_force"},
        Fault{"adhesion_twice", "pull_off_force = \"258 nN\"",
              "pull_off_force = \"258 nN\"\nwork_of_adhesion = \"1 mJ/m^2\"",
              "scene.toml:36:12: the contact of 'drug' and 'carrier' gives the strength of its adhesion twice\n"
              "  give work_of_adhesion or pull_off_force"},
        Fault{"bradley_without_a_distance", "equilibrium_distance = \"0.4 nm\"\n", "",
              "scene.toml:36:12: the contact of 'drug' and 'carrier': equilibrium_distance is missing, which "
              "adhesion = \"bradley\" needs\n"
              "  add equilibrium_distance = \"0.4 nm\""},
        Fault{"distance_without_bradley", "adhesion = \"bradley\"", "adhesion = \"dmt\"",
              "scene.toml:38:24: the contact of 'drug' and 'carrier': equilibrium_distance does not go with normal = "
              "\"hertz\" and adhesion = \"dmt\"\n"
              "  leave it out"},
        Fault{"strength_without_adhesion", "adhesion = \"bradley\"\n", "",
              "scene.toml:36:18: the contact of 'drug' and 'carrier': pull_off_force does not go with normal = "
              "\"hertz\" and adhesion = \"none\"\n"
              "  write adhesion = \"bradley\" or \"dmt\", or normal = \"jkr\", or leave it out"},
        Fault{
            "jkr_with_another_adhesion", "adhesion = \"bradley\"", "normal = \"jkr\"\nadhesion = \"bradley\"",
            "scene.toml:37:12: the contact of 'drug' and 'carrier': normal = \"jkr\" and adhesion = \"bradley\" do not "
            "go together: that normal law is adhesive itself\n"
            "  leave one of them out"},
        Fault{"jkr_under_its_old_key", "adhesion = \"bradley\"", "adhesion = \"jkr\"",
              "scene.toml:36:12: contact_pair.sticky.adhesion: found \"jkr\", expected one of 'none', 'bradley' and "
              "'dmt'\n"
              "  JKR's law is now a normal law: write normal = \"jkr\" and leave adhesion out"},
        Fault{"cut_off_too_early", "equilibrium_distance = \"0.4 nm\"",
              "equilibrium_distance = \"0.4 nm\"\nadhesion_cutoff = \"0.4 nm\"",
              "scene.toml:39:19: the contact of 'drug' and 'carrier': adhesion_cutoff is not more than "
              "equilibrium_distance, where the force is largest\n"
              "  give some tens of equilibrium distances"}),
    name_of);

TEST(WrongSpheres, beside_a_fluid) {
    const std::string spheres =
        "[[part]]\nname = \"beads\"\nkind = \"spheres\"\nradius = \"1 mm\"\nmass = \"1 g\"\n"
        "youngs_modulus = \"1 GPa\"\npoisson_ratio = 0\ncentres = [[0, 0, 0]]\n";
    EXPECT_EQ(fault_of("dimension = 3\n" + good_scene + spheres),
              "scene.toml:13:8: spheres ('beads') and parts of kind 'fluid' ('blood') do not interact\n"
              "  leave one of them out of the scene");
}

TEST(WrongSpheres, walls_for_spheres_without_spheres) {
    const std::string plane = "[[part]]\nname = \"floor\"\nkind = \"plane\"\npoint = [0, 0]\nnormal = [0, 0, 1]\n";
    EXPECT_EQ(fault_of(good_scene + plane),
              "scene.toml:48:8: part 'floor' is a wall for spheres, and the scene has none\n"
              "  for walls of a fluid, use kind = \"rigid\"");
}

}  // namespace
}  // namespace dmp::tests::scene_spheres_tests
