// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Bad overrides, and what goes wrong between several keys.
#include "tests/modules.hpp"
#include "tests/unit/scene/fault.hpp"

namespace dmp::tests::scene_more_errors_tests {
namespace {

class BadOverride : public testing::TestWithParam<Fault> {};

TEST_P(BadOverride, says_where_what_and_what_to_do) {
    EXPECT_EQ(fault_of(good_scene, {GetParam().found}), GetParam().message);
}

INSTANTIATE_TEST_SUITE_P(
    Scene, BadOverride,
    testing::ValuesIn(std::vector<Fault>{
        Fault{"nearest_in_another_table", "spcing=1", "",
              "--set spcing=1: unknown key 'spcing'\n"
              "  did you mean 'spacing' in [particles]?"},
        Fault{"nearest_in_its_table", "particles.spcing=1", "",
              "--set particles.spcing=1: unknown key 'particles.spcing'\n"
              "  did you mean 'spacing' in [particles]?"},
        Fault{"value_without_unit", "particles.spacing=0.1", "",
              "--set particles.spacing=0.1: missing unit: spacing = 0.1, expected a length such as \"0.1 mm\"\n"
              "  write spacing = \"0.1 mm\" or \"0.1 m\", with the unit you mean"},
        Fault{"no_equals_sign", "particles.spacing", "",
              "--set particles.spacing: expected KEY=VALUE\n"
              "  write for example --set particles.spacing=\"0.1 mm\""},
        Fault{"unknown_part", "part.leaf.enabled=false", "",
              "--set part.leaf.enabled=false: the scene has no part 'leaf'\n"
              "  its parts are 'blood', 'wall' and 'leaflets'"},
        Fault{"misspelt_part", "part.leaflet.enabled=false", "",
              "--set part.leaflet.enabled=false: the scene has no part 'leaflet'\n"
              "  did you mean 'leaflets'?"},
        Fault{"unknown_item_of_an_empty_list", "species.drug.unit=1", "",
              "--set species.drug.unit=1: the scene has no species 'drug'\n"
              "  it has none at all"},
        Fault{"part_without_name", "part.enabled=false", "",
              "--set part.enabled=false: 'part.enabled' does not say which part and which of its keys\n"
              "  write part.NAME.KEY=VALUE"},
        Fault{"misspelt_measure_key", "measure.tip_gap.prt=x", "",
              "--set measure.tip_gap.prt=x: unknown key 'measure.tip_gap.prt'\n"
              "  did you mean 'part' in [[measure]]?"},
        Fault{"path_into_a_value", "particles.spacing.x=1", "",
              "--set particles.spacing.x=1: unknown key 'particles.spacing.x'\n"
              "  did you mean 'x' in [[select]]?"},
        Fault{"fault_inside_a_formula", "flow.acceleration=[\"1 m/s^2 * sin(t)\"]", "",
              "--set flow.acceleration=[\"1 m/s^2 * sin(t)\"]: sin is given a time, expected a plain number in \"1 "
              "m/s^2 * sin(t)\"\n"
              "  divide it by a quantity of the same dimension, such as 1 s"},
        Fault{"key_of_another_kind", "part.wall.viscosity=\"1 Pa*s\"", "",
              "--set part.wall.viscosity=\"1 Pa*s\": 'viscosity' does not apply to the part 'wall' of kind 'rigid', "
              "only to kind 'fluid'\n"
              "  remove it, or correct the part's kind"},
        Fault{"no_key", "=3", "",
              "--set =3: expected KEY=VALUE\n"
              "  write for example --set particles.spacing=\"0.1 mm\""}}),
    name_of);

TEST(GoodScene, has_no_fault) { EXPECT_EQ(fault_of(good_scene), "no error"); }

TEST(WrongScene, without_anything_that_moves) {
    EXPECT_EQ(fault_of(good_scene, {"part.blood.enabled=false", "part.leaflets.enabled=false"}),
              "scene.toml:12:8: no enabled part is of kind 'fluid', 'elastic' or 'spheres': nothing would move\n"
              "  add a [[part]] with kind = \"fluid\", \"elastic\" or \"spheres\"");
}

const std::string sinus = "[[region]]\nname = \"sinus\"\nfrom = [0, 0]\nto = [\"1 mm\", \"2 mm\"]\n[[measure]]";

std::string fault_with_region(const std::string& found, const std::string& replacement) {
    std::string region = sinus;
    region.replace(region.find(found), found.size(), replacement);
    return fault_of(scene_with("[[measure]]", region), {"output.fields=['residence_time']"});
}

TEST(WrongScene, a_region_that_holds_nothing) {
    EXPECT_EQ(fault_with_region("sinus", "sinus"), "no error");
    EXPECT_EQ(fault_with_region("\"1 mm\"", "0"),
              "scene.toml:39:6: the corners of region 'sinus' have the same x: there is nothing between them\n"
              "  give two opposite corners of a box");
    EXPECT_EQ(fault_with_region("\"2 mm\"", "0"),
              "scene.toml:39:6: the corners of region 'sinus' have the same y: there is nothing between them\n"
              "  give two opposite corners of a box");
    EXPECT_EQ(fault_with_region("\"2 mm\"]", "\"2 mm\", \"1 mm\"]"),
              "scene.toml:39:6: the third coordinate of a point in a 2-D scene is not 0\n"
              "  leave it out, or write 0");
    EXPECT_EQ(fault_with_region("from = [0, 0]", ""),
              "scene.toml:36:1: missing key: region.sinus.from\n"
              "  add 'from' in [[region]]: a point such as [\"1 mm\", 0]");
    EXPECT_EQ(fault_with_region("from", "fron"),
              "scene.toml:38:1: unknown key 'fron' in [[region]]\n"
              "  did you mean 'from' in [[region]]?");
    EXPECT_EQ(fault_with_region("[[measure]]", sinus),
              "scene.toml:41:8: there is already a region called 'sinus', at scene.toml:37:8\n"
              "  give each region its own name");
}

TEST(WrongScene, residence_times_of_no_region) {
    const std::string advice = "\n  add a [[region]] with a name and the corners from and to";
    const std::string problem = ": 'residence_time' needs a region, and the scene has none";
    EXPECT_EQ(fault_of(scene_with("every = \"20 ms\"", "every = \"20 ms\"\nfields = [\"residence_time\"]")),
              "scene.toml:35:10" + problem + advice);
    EXPECT_EQ(fault_of(scene_with("every = \"20 ms\"", "every = \"20 ms\"\npicture_field = \"residence_time\"")),
              "scene.toml:35:17" + problem + advice);
    EXPECT_EQ(fault_of(scene_with("[[measure]]",
                                  "[[measure]]\nname = \"p\"\nkind = \"probe\"\npoint = [0, 0]\nfield = "
                                  "\"residence_time\"\n[[measure]]")),
              "scene.toml:40:9" + problem + advice);
}

TEST(WrongScene, a_picture_of_several_residence_times) {
    std::string two = sinus;
    two.replace(two.find("[[measure]]"), 11, sinus);
    two.replace(two.rfind("sinus"), 5, "other");
    EXPECT_EQ(fault_of(scene_with("[[measure]]", two), {"output.picture_field=residence_time"}),
              "--set output.picture_field=residence_time: output.picture_field = \"residence_time\": there are "
              "several regions, each with its own field\n"
              "  keep only one [[region]], or choose another field");
}

TEST(WrongScene, a_quality_that_there_is_not) {
    EXPECT_EQ(fault_of("quality = \"fin\"\n" + good_scene),
              "scene.toml:1:11: quality: found \"fin\", expected one of 'draft', 'standard' and 'fine'\n"
              "  did you mean \"fine\"?");
}

TEST(WrongScene, a_fine_support_in_a_wall_of_three_rows) {
    const std::string plain = "numerics.scheme=plain";
    EXPECT_EQ(fault_of(good_scene, {plain, "quality=fine"}), "no error") << "rows follow the quality too";
    EXPECT_EQ(fault_of(good_scene, {plain, "quality=fine", "part.wall.layers=3"}),
              "--set part.wall.layers=3: the wall 'wall' is thinner than the kernel: layers = 3, numerics.support = 4\n"
              "  give the part at least as many layers as the support has spacings");
}

TEST(WrongScene, a_mach_number_out_of_range) {
    EXPECT_EQ(fault_of(good_scene, {"numerics.mach_number=0.5"}),
              "--set numerics.mach_number=0.5: numerics.mach_number: found 0.5, expected between 0.01 and 0.3\n"
              "  give a value that is between 0.01 and 0.3");
}

TEST(WrongScene, a_part_that_is_no_table) {
    EXPECT_EQ(fault_of("part = 3\n" + good_scene.substr(0, good_scene.find("[[part]]"))),
              "scene.toml:1:8: 'part' is 3, expected a list of tables\n"
              "  write [[part]] with double brackets, once for each part");
    EXPECT_EQ(fault_of("measure = [3]\n" + good_scene.substr(0, good_scene.find("[[part]]"))),
              "scene.toml:1:12: 'measure' holds 3, expected tables\n  write [[measure]], once for each measure");
}

TEST(WrongScene, springs_alone_need_no_largest_speed) {
    EXPECT_EQ(fault_of(scene_with("largest_speed = \"0.2 m/s\"", ""), {"part.blood.enabled=false"}), "no error");
}

TEST(WrongScene, a_fault_in_a_text_of_several_lines) {
    EXPECT_EQ(
        fault_of(scene_with("largest_speed", "acceleration = [\"\"\"\n1 m/s^2 *\n sinn(1)\"\"\"]\nlargest_speed")),
        "scene.toml:30:2: unknown function 'sinn' in \"1 m/s^2 *\n sinn(1)\"\n  did you mean 'sin'?");
}

TEST(BadPath, says_what_is_missing) {
    const Folder folder;
    const auto fault = [](const std::string& path) {
        try {
            read_scene(path);
        } catch (const InputError& error) {
            return std::string(error.what());
        }
        return std::string("no error");
    };
    EXPECT_EQ(fault("nowhere.toml"),
              "nowhere.toml: there is no such file or folder\n  give a scene file or a folder with a scene.toml");
    EXPECT_EQ(fault("."), ".: this folder has no scene.toml\n  give the folder of a case, or a scene file");
    Folder::write("", "empty.toml");
    EXPECT_EQ(fault("empty.toml"),
              "empty.toml: missing key: schema\n  add 'schema' at the top of the file: a whole number, only 1");
    std::filesystem::create_directory("scene.toml");
    EXPECT_EQ(fault("."), "./scene.toml: the file cannot be read\n  check that it is a file and its permissions");
}

}  // namespace
}  // namespace dmp::tests::scene_more_errors_tests
