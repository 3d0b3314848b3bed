// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// [[select]]: faces of a geometry in 3-D.
#include <gmock/gmock.h>

#include "tests/modules.hpp"
#include "tests/unit/scene/scene_text.hpp"

namespace dmp::tests::scene_select_tests {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// A pipe with this between its geometry and its particles.
std::string pipe_with(const std::string& selections, const std::string& dimension = "3") {
    return "schema = 1\ndimension = " + dimension + "\n[geometry]\nfile = \"pipe.step\"\n" + selections +
           "[particles]\nspacing = \"0.1 mm\"\n"
           "[[part]]\nname = \"water\"\nkind = \"fluid\"\ndensity = \"1000 kg/m^3\"\nviscosity = \"1 mPa*s\"\n"
           "[flow]\nlargest_speed = \"1 m/s\"\n[run]\nduration = \"1 s\"\n[output]\nevery = \"1 s\"\n";
}

const std::string inlet = "[[select]]\nname = \"inlet\"\nof = \"water\"\nx = \"0 mm\"\n";

TEST(SceneSelect, readsWhatIsGivenAndWritesItAgain) {
    const std::string text =
        pipe_with(inlet +
                  "[[select]]\nname = \"wall\"\nof = \"water\"\nfrom = [0, 0, 0]\nto = [\"1 mm\", \"2 mm\", \"3 mm\"]\n"
                  "normal = [0, 0, 2]\nangle = \"90 deg\"\nexcept = [\"inlet\"]\n");
    const Scene scene = read_text(text);
    ASSERT_EQ(scene.selections.size(), 2U);
    EXPECT_EQ(*scene.selections[0].name, "inlet");
    EXPECT_TRUE(scene.selections[0].x.given());
    EXPECT_EQ(*scene.selections[0].x, 0);
    EXPECT_FALSE(scene.selections[0].y.given());
    EXPECT_FALSE(scene.selections[0].normal.given());
    EXPECT_FALSE(scene.selections[0].except.given());
    EXPECT_EQ(*scene.selections[1].to, Vec(1e-3, 2e-3, 3e-3));
    EXPECT_NEAR(scene.selections[1].angle, 1.5707963, 1e-6);
    EXPECT_THAT(*scene.selections[1].except, ElementsAre("inlet"));
    const Scene again = read_text(resolved_scene(scene));
    EXPECT_TRUE(again.selections[0].x.given());
    EXPECT_FALSE(again.selections[0].y.given());
    EXPECT_EQ(resolved_scene(again), resolved_scene(scene));
}

TEST(SceneSelect, refusesWhatSelectsNothing) {
    const std::string named = "[[select]]\nname = \"lid\"\nof = \"water\"\n";
    EXPECT_EQ(fault_of(pipe_with(named)),
              "scene.toml:6:8: selection 'lid' does not say which faces\n"
              "  give a plane (x, y or z), a box (from and to), a normal, or except");
    EXPECT_THAT(fault_of(pipe_with(named + "z = 0\n", "2")),
                HasSubstr("scene.toml:8:5: selection 'lid' gives z, but the scene is 2-D"));
    EXPECT_EQ(read_text(pipe_with(inlet, "2")).selections.size(), 1U);
    // It may be a surface of the geometry.
    EXPECT_EQ(*read_text(pipe_with(named + "except = [\"rim\"]\n")).selections[0].except,
              std::vector<std::string>{"rim"});
    EXPECT_THAT(fault_of(pipe_with(named + "from = [0, 0, 0]\n")),
                HasSubstr("scene.toml:8:8: selection 'lid' has one corner of a box only"));
    EXPECT_THAT(fault_of(pipe_with(inlet + "angle = \"5 deg\"\n")), HasSubstr("has an angle but no normal"));
    EXPECT_THAT(fault_of(pipe_with(inlet + "normal = [1, 0, 0]\nangle = \"0 deg\"\n")), HasSubstr("more than 0"));
    EXPECT_THAT(fault_of(pipe_with(named + "except = [\"inlet\"]\n" + inlet)),
                HasSubstr("selection 'lid': there is no selection 'inlet' before it"));
    EXPECT_THAT(fault_of(pipe_with(inlet + inlet)), HasSubstr("there is already a select called 'inlet'"));
    EXPECT_THAT(fault_of(pipe_with("[[select]]\nname = \"lid\"\nx = \"0 mm\"\n")),
                HasSubstr("missing key: select.lid.of"));
    EXPECT_THAT(fault_of(pipe_with("[[select]]\nname = \"lid\"\nof = \"water\"\nplane = \"0 mm\"\n")),
                HasSubstr("unknown key 'plane' in [[select]]"));
}

}  // namespace
}  // namespace dmp::tests::scene_select_tests
