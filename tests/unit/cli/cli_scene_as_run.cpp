// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>

#include <gmock/gmock.h>

#include "base/safe_file.hpp"
#include "cli/scene_as_run.hpp"
#include "scene/read_scene.hpp"
#include "scene/scene_difference.hpp"
#include "tests/modules.hpp"
#include "tests/unit/temporary_files.hpp"

namespace dmp::tests::cli_scene_as_run_tests {
namespace {

namespace fs = std::filesystem;
using namespace cli;
using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

std::string text_in(const fs::path& folder) { return read_file(folder / "scene.resolved.toml"); }
Scene scene_in(const fs::path& folder) { return read_scene((folder / "scene.resolved.toml").string()); }

TEST(SceneAsRun, OfEachCaseReadsBackInItsFolderAndFindsItsFiles) {
    int scenes = 0;
    for (const auto& entry : fs::recursive_directory_iterator(DMP_SOURCE_DIR "/cases")) {
        if (entry.path().filename() != "scene.toml") continue;
        ++scenes;
        const TemporaryFolder folder;
        const Scene scene = read_scene(entry.path().string(), {});
        write_scene(folder.path(), scene);
        const Scene again = scene_in(folder.path());
        for (const auto& one : differences(resolved_scene(scene), resolved_scene(again)))
            EXPECT_THAT(one.key,
                        testing::AnyOf("geometry.file", testing::EndsWith(".file"), testing::EndsWith(".positions")))
                << entry.path();
        EXPECT_EQ(again.geometry.unit.given(), scene.geometry.unit.given()) << entry.path();
        const auto is_found = [&](const std::string& file) { return fs::exists(folder.path() / file); };
        if (!again.geometry.file->empty()) {
            EXPECT_TRUE(is_found(again.geometry.file)) << entry.path();
        }
        for (const Part& part : again.parts)
            for (const std::string& file : {*part.file, *part.positions})
                EXPECT_TRUE(file.empty() || is_found(file)) << entry.path() << ": " << file;
    }
    EXPECT_GT(scenes, 10);
}

TEST(SceneAsRun, HasWhatWasChosenAndInCommentsWhatTheSceneSays) {
    const TemporaryFolder folder;
    const Scene scene = read_scene(
        DMP_SOURCE_DIR "/cases/vein_valve",
        std::vector<std::string>{"numerics.sound_speed=auto", "output.every=\"20 ms\"", "output.measure_every=auto"});
    Plan plan;
    plan.sound.value = 2.5;
    write_scene_of_run(folder.path(), scene, plan, Resources(1), 0.5);
    const std::string text = text_in(folder.path());
    EXPECT_THAT(text, AllOf(HasSubstr("\nduration = \"0.5 s\"  # in the scene: \"4 s\"\n"),
                            HasSubstr("\nsound_speed = \"2.5 m/s\"  # in the scene: \"auto\"\n"),
                            HasSubstr("\nmeasure_every = \"0.005 s\"  # in the scene: \"auto\"\n"),
                            HasSubstr(" J\"  # in the scene: \"auto\"\n"),
                            HasSubstr("vein_valve.geo\"  # in the scene: \"vein_valve.geo\"\n"),
                            HasSubstr("\nbending_stiffness = \"3e-06 N*m^2\"\n"), Not(HasSubstr("= \"auto\"  #"))));
    EXPECT_THAT(differences(text, resolved_scene(scene)), IsEmpty());
    const Scene again = scene_in(folder.path());
    EXPECT_EQ(*again.numerics.sound_speed, 2.5);
    EXPECT_EQ(*again.run.duration, 0.5);
    EXPECT_GT(*again.contact.strength, 0);
}

TEST(SceneAsRun, KeepsAbsolutePathsAndUnitsThatWereGiven) {
    const TemporaryFolder folder;
    const std::string geometry = fs::absolute(DMP_SOURCE_DIR "/cases/vein_valve/vein_valve.geo").string();
    const Scene scene =
        read_scene(DMP_SOURCE_DIR "/cases/vein_valve",
                   std::vector<std::string>{"geometry.file=\"" + geometry + "\"", "geometry.unit=\"2 m\""});
    write_scene(folder.path(), scene);
    EXPECT_THAT(text_in(folder.path()),
                AllOf(HasSubstr("\nfile = \"" + geometry + "\"\n"), HasSubstr("\nunit = \"2 m\"\n")));
}

}  // namespace
}  // namespace dmp::tests::cli_scene_as_run_tests
