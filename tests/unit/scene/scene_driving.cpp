// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Forces on parts and moving shapes: what is read, and each way to get it wrong.
#include "tests/modules.hpp"
#include "tests/unit/scene/fault.hpp"

namespace dmp::tests::scene_driving_tests {
namespace {

const std::string driven_scene = good_scene + R"toml([[force]]
name = "squeeze"
part = "leaflets"
force = [0, "-0.008 N * sin(2*pi*t/3 s)"]
amount = "total"
from = "0 s"
until = "1.5 s"
period = "3 s"

[[moving_shape]]
name = "ghost"
kind = "parabola"
parts = ["leaflets"]
position = ["1 mm/s * t", "2 mm"]
half_width = "3 mm"
height = "4 mm"
strength = "2 uN"
range = "0.2 mm"
side = "outside"
)toml";

std::string driven_with(const std::string& found, const std::string& replacement) {
    std::string text = driven_scene;
    const auto at = text.rfind(found);
    if (at == std::string::npos) throw std::logic_error("the test scene has no " + found);
    return text.replace(at, found.size(), replacement);
}

TEST(DrivenScene, reads_forces_and_shapes) {
    const Scene scene = read_text(driven_scene);
    ASSERT_EQ(scene.forces.size(), 1U);
    const ForceOnPart& force = scene.forces[0];
    EXPECT_EQ(*force.part, "leaflets");
    EXPECT_NEAR((*force.force)[1](0.75), -0.008, 1e-17);
    EXPECT_EQ(*force.amount, ForceAmount::total);
    const Expression at_rest = (*read_text(driven_with("-0.008 N *", "-0.008 N * X / 1 m *")).forces[0].force)[1];
    EXPECT_NEAR(at_rest.at(0.75, Vec(9, 9, 9), Vec(2, 3, 4)), -0.016, 1e-17);
    EXPECT_EQ(*force.until, 1.5);
    EXPECT_EQ(*force.period, 3);
    ASSERT_EQ(scene.moving_shapes.size(), 1U);
    const MovingShape& shape = scene.moving_shapes[0];
    EXPECT_EQ(*shape.kind, ShapeKind::parabola);
    EXPECT_EQ(*shape.parts, std::vector<std::string>{"leaflets"});
    EXPECT_EQ((*shape.position)[0](2), 0.002);
    EXPECT_EQ(*shape.strength, 2e-6);
    EXPECT_EQ(*shape.side, PushedSide::outside);
    EXPECT_EQ(*shape.until, 0) << "not given: never";
    const std::string resolved = resolved_scene(scene);
    EXPECT_EQ(resolved_scene(read_text(resolved)), resolved);
    EXPECT_EQ(*read_text(driven_scene, {"moving_shape.ghost.range=0.3 mm"}).moving_shapes[0].range, 0.0003);
}

class WrongDriving : public testing::TestWithParam<Fault> {};

TEST_P(WrongDriving, is_refused_with_its_place) {
    EXPECT_EQ(fault_of(driven_with(GetParam().found, GetParam().replacement)), GetParam().message);
}

INSTANTIATE_TEST_SUITE_P(
    Scene, WrongDriving,
    testing::Values(
        Fault{"force_per_what", "amount = \"total\"\n", "",
              "scene.toml:46:1: missing key: force.squeeze.amount\n"
              "  add 'amount' in [[force]]: one of 'total' and 'per_particle'"},
        Fault{"force_without_unit", "force = [0, \"-0.008 N * sin(2*pi*t/3 s)\"]", "force = [0, -0.008]",
              "scene.toml:49:13: missing unit: force = -0.008, expected a force such as \"1 mN\"\n"
              "  write force = \"-0.008 mN\" or \"-0.008 N\", with the unit you mean"},
        Fault{"force_on_nobody", "part = \"leaflets\"\nforce", "part = \"leaflet\"\nforce",
              "scene.toml:48:8: the scene has no part 'leaflet'\n  did you mean 'leaflets'?"},
        Fault{"force_on_a_wall", "part = \"leaflets\"\nforce", "part = \"wall\"\nforce",
              "scene.toml:48:8: part 'wall' is of kind 'rigid', whose motion is prescribed: no force acts on it\n"
              "  give the part a velocity, or name a part of kind 'fluid', 'elastic' or 'spheres'"},
        Fault{"force_out_of_the_plane", "force = [0,", "force = [0, 0, \"1 N\"] # [0,",
              "scene.toml:49:9: the force 'squeeze' has a third component in a 2-D scene\n  leave it out, or write 0"},
        Fault{"force_of_nothing", "force = [0,", "force = [0, 0] # [0,",
              "scene.toml:49:9: the force 'squeeze' is 0\n  give it a component, or leave it out"},
        Fault{"rest_place_in_a_liquid", "part = \"leaflets\"\nforce = [0, \"-0.008 N *",
              "part = \"blood\"\nforce = [0, \"-0.008 N * X / 1 m *",
              "scene.toml:49:9: the force 'squeeze' depends on X, Y or Z, and 'blood', of kind 'fluid', has no rest "
              "coordinates\n"
              "  write x, y and z, the present place, or name an elastic part"},
        Fault{"rest_place_out_of_the_plane", "-0.008 N *", "-0.008 N * Z / 1 m *",
              "scene.toml:49:9: the force 'squeeze' depends on Z in a 2-D scene\n"
              "  write a formula of X and Y, or dimension = 3"},
        Fault{"shape_at_a_rest_place", "position = [\"1 mm/s * t\"", "position = [\"0.1 * X\"",
              "scene.toml:59:20: 'X' is a place in the initial state, which only a [[force]] knows in \"0.1 * X\"\n"
              "  write x, y or z for the present place, or leave it out"},
        Fault{"end_before_the_start", "from = \"0 s\"\nuntil", "from = \"2 s\"\nuntil",
              "scene.toml:52:9: the force 'squeeze' ends before it starts\n  give an until that is after from"},
        Fault{"period_without_an_end", "until = \"1.5 s\"\n", "",
              "scene.toml:52:10: the force 'squeeze' has a period but no end\n  add until"},
        Fault{"period_too_short", "period = \"3 s\"", "period = \"1 s\"",
              "scene.toml:53:10: the force 'squeeze' repeats before it has ended\n"
              "  give a period of at least until - from"},
        Fault{"shape_felt_by_nobody", "parts = [\"leaflets\"]", "parts = []",
              "scene.toml:58:9: moving_shape.ghost.parts: found an empty list\n"
              "  give a list of names such as [\"cilia\"]"},
        Fault{"shape_felt_by_a_wall", "parts = [\"leaflets\"]", "parts = [\"blood\", \"wall\"]",
              "scene.toml:58:9: part 'wall' is of kind 'rigid', whose motion is prescribed: no force acts on it\n"
              "  give the part a velocity, or name a part of kind 'fluid', 'elastic' or 'spheres'"},
        Fault{"shape_that_bends", "position = [\"1 mm/s * t\"", "position = [\"0.1 * x\"",
              "scene.toml:59:12: the moving shape 'ghost': its position depends on x, y or z\n  give formulas of t"},
        Fault{"flat_parabola", "height = \"4 mm\"", "height = 0",
              "scene.toml:61:10: the moving shape 'ghost' is flat: its height is 0\n  give the height of its ends"},
        Fault{"radius_of_a_parabola", "height = \"4 mm\"", "height = \"4 mm\"\nradius = \"1 mm\"",
              "scene.toml:62:1: 'radius' does not apply to the moving_shape 'ghost' of kind 'parabola', only to kind "
              "'circle'\n"
              "  remove it, or correct the moving_shape's kind"},
        Fault{"negative_strength", "strength = \"2 uN\"", "strength = \"-2 uN\"",
              "scene.toml:62:12: moving_shape.ghost.strength: found \"-2 uN\", expected more than 0\n"
              "  give a value that is more than 0"}),
    name_of);

TEST(WrongDriving, names_that_stand_twice) {
    EXPECT_EQ(fault_of(driven_scene +
                       driven_scene.substr(driven_scene.find("[[force]]"),
                                           driven_scene.find("[[moving_shape]]") - driven_scene.find("[[force]]"))),
              "scene.toml:66:8: there is already a force called 'squeeze', at scene.toml:47:8\n"
              "  give each force its own name");
}

TEST(Driving, spheres_can_be_pushed) {
    const std::string spheres =
        "schema = 1\ndimension = 3\n[[part]]\nname = \"beads\"\nkind = \"spheres\"\nradius = \"1 mm\"\nmass = \"1 g\"\n"
        "youngs_modulus = \"1 GPa\"\npoisson_ratio = 0\ncentres = [[0, 0, 0]]\n[run]\nduration = \"1 s\"\n[output]\n"
        "every = \"1 s\"\n[[force]]\nname = \"push\"\npart = \"beads\"\nforce = [\"1 N\"]\namount = \"total\"\n";
    EXPECT_EQ(fault_of(spheres), "no error");
}

TEST(WrongDriving, across_a_plane_of_symmetry) {
    EXPECT_EQ(
        fault_of(driven_scene, {"flow.symmetry=['y_low']"}),
        "scene.toml:49:9: the force 'squeeze' pushes across the plane of symmetry 'y_low': the two sides would not "
        "be alike\n"
        "  leave out that component, or the side");
}

}  // namespace
}  // namespace dmp::tests::scene_driving_tests
