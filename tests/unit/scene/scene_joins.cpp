// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// [[join]]: which parts may be joined.
#include <gmock/gmock.h>

#include "tests/modules.hpp"
#include "tests/unit/scene/fault.hpp"

namespace dmp::tests::scene_joins_tests {
namespace {

using ::testing::HasSubstr;

std::string joined(const std::string& keys) { return scene_with("[flow]", "[[join]]\n" + keys + "\n\n[flow]"); }

TEST(SceneJoins, have_defaults) {
    const Scene scene = read_text(joined("name = \"root\"\nparts = [\"leaflets\", \"wall\"]"));
    ASSERT_EQ(scene.joins.size(), 1U);
    const Join& join = scene.joins[0];
    EXPECT_EQ((*join.parts)[0], "leaflets");
    EXPECT_FALSE(join.within.given());
    EXPECT_EQ(*join.stiffness, 0) << "auto";
    EXPECT_EQ(*join.damping, 0.01);
    EXPECT_EQ(scene.joins_of_enabled().size(), 1U);
}

TEST(SceneJoins, are_in_the_resolved_scene_and_in_its_hash) {
    const Scene plain = read_text(good_scene),
                with = read_text(joined("name = \"root\"\nparts = [\"leaflets\", \"wall\"]\nstiffness = \"3 N/m\""));
    EXPECT_NE(plain.hash, with.hash);
    EXPECT_THAT(resolved_scene(with), HasSubstr("[[join]]\nname = \"root\"\nparts = [\"leaflets\", \"wall\"]"));
}

TEST(SceneJoins, may_break) {
    const std::string rule = "\n[[break]]\nname = \"tear\"\npart = \"root\"\nstrain_above = 0.1";
    EXPECT_EQ(read_text(joined("name = \"root\"\nparts = [\"leaflets\", \"wall\"]" + rule)).breaking.size(), 1U);
}

class BadJoin : public ::testing::TestWithParam<Fault> {};
TEST_P(BadJoin, is_refused_with_its_place) {
    const std::string fault = fault_of(joined(GetParam().replacement));
    EXPECT_THAT(fault, HasSubstr(GetParam().message));
    EXPECT_THAT(fault, HasSubstr("scene.toml:"));
}
INSTANTIATE_TEST_SUITE_P(
    Scene, BadJoin,
    ::testing::Values(
        Fault{"unknown_part", "", "name = \"root\"\nparts = [\"leaflet\", \"wall\"]", "did you mean 'leaflets'?"},
        Fault{"fluid", "", "name = \"root\"\nparts = [\"leaflets\", \"blood\"]",
              "part 'blood' is of kind 'fluid'; bonds join elastic solids, or an elastic solid and a rigid part"},
        Fault{"two_walls", "", "name = \"root\"\nparts = [\"wall\", \"wall\"]", "joins two rigid parts"},
        Fault{"a_part_s_name", "", "name = \"wall\"\nparts = [\"leaflets\", \"wall\"]",
              "there is already a part called 'wall'"},
        Fault{"three_parts", "", "name = \"root\"\nparts = [\"leaflets\", \"wall\", \"wall\"]", "parts"},
        Fault{"no_parts", "", "name = \"root\"", "parts"},
        Fault{"no_reach", "", "name = \"root\"\nparts = [\"leaflets\", \"wall\"]\nwithin = \"0 mm\"", "more than 0"},
        Fault{"negative_stiffness", "", "name = \"root\"\nparts = [\"leaflets\", \"wall\"]\nstiffness = \"-3 N/m\"",
              "more than 0"},
        Fault{"damping", "", "name = \"root\"\nparts = [\"leaflets\", \"wall\"]\ndamping = 2", "between 0 and 1"},
        Fault{"twice", "",
              "name = \"root\"\nparts = [\"leaflets\", \"wall\"]\n[[join]]\nname = \"root\"\nparts = [\"leaflets\", "
              "\"wall\"]",
              "root"}),
    name_of);

TEST(SceneJoins, of_a_wall_that_moves_are_refused) {
    std::string text = joined("name = \"root\"\nparts = [\"leaflets\", \"wall\"]");
    const std::string wall = "kind = \"rigid\"\n";
    text.insert(text.find(wall) + wall.size(), "velocity = [\"1 mm/s\", 0]\n");
    EXPECT_THAT(fault_of(text), HasSubstr("part 'wall' moves; a rigid part with bonds must be at rest"));
}

}  // namespace
}  // namespace dmp::tests::scene_joins_tests
