// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Keys and values of version 0.1 are refused with their new names.
#include <gmock/gmock.h>

#include "scene/read_scene.hpp"
#include "scene/renamed.hpp"
#include "tests/modules.hpp"
#include "tests/unit/thrown.hpp"

namespace dmp::tests::scene_renamed_tests {
namespace {

using testing::HasSubstr;

TEST(RenamedKeys, are_named_as_advice) {
    EXPECT_EQ(advice_for_renamed_key("accuracy"), "this table is now called [numerics]");
    EXPECT_EQ(advice_for_renamed_key("accuracy.kernel"), "write numerics.kernel");
    EXPECT_EQ(advice_for_renamed_key("run.until_still"), "this key is now called until_steady");
    EXPECT_EQ(advice_for_renamed_key("moving_shape.*.place"), "this key is now called position");
    EXPECT_THAT(advice_for_renamed_key("contact_pair.*.law"), HasSubstr("normal_stiffness_factor = 3"));
    EXPECT_EQ(advice_for_renamed_key("numerics.kernel"), "");
    EXPECT_EQ(advice_for_renamed_key("part.*.law"), "");
}

TEST(RenamedKeys, of_values_go_by_their_key) {
    EXPECT_EQ(advice_for_renamed_value("part.leaflets.kind", "springs"), "this kind is now called \"elastic\"");
    EXPECT_THAT(advice_for_renamed_value("contact_pair.drug.adhesion", "jkr"), HasSubstr("normal = \"jkr\""));
    EXPECT_EQ(advice_for_renamed_value("part.leaflets.kind", "fluid"), "");
    EXPECT_EQ(advice_for_renamed_value("part.leaflets.name", "springs"), "");
}

TEST(RenamedKeys, are_refused_on_the_command_line_and_in_a_scene) {
    const std::string scene = DMP_SOURCE_DIR "/cases/bent_channel";
    const auto fault = [&](const std::string& override) {
        return text_thrown<InputError>([&] { (void)read_scene(scene, std::vector<std::string>{override}); });
    };
    EXPECT_THAT(fault("accuracy.kernel=lucy"), HasSubstr("write numerics.kernel"));
    EXPECT_THAT(fault("run.until_still=1 s"), HasSubstr("until_steady"));
    EXPECT_THAT(fault("part.wall.kind=springs"), HasSubstr("this kind is now called \"elastic\""));
}

}  // namespace
}  // namespace dmp::tests::scene_renamed_tests
