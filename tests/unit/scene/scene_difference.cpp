// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/scene_difference.hpp"

#include <gmock/gmock.h>

#include "scene/read_scene.hpp"
#include "tests/modules.hpp"

namespace dmp::tests::scene_difference_tests {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::string valve(const std::vector<std::string>& overrides = {}) {
    return resolved_scene(read_scene(DMP_SOURCE_DIR "/cases/vein_valve", overrides));
}

std::vector<std::string> keys(const std::string& before, const std::string& now) {
    std::vector<std::string> found;
    for (const auto& one : differences(before, now)) found.push_back(one.key);
    return found;
}

TEST(SceneDifference, IsNoneOfTheSameSceneAndOfOtherThreads) {
    EXPECT_THAT(keys(valve(), valve()), IsEmpty());
    EXPECT_THAT(keys(valve(), valve({"run.threads=3"})), IsEmpty());
}

TEST(SceneDifference, NamesValuesAsSetDoes) {
    EXPECT_THAT(keys(valve(), valve({"particles.spacing=\"0.4 mm\"", "part.blood.viscosity=\"4 mPa*s\"",
                                     "geometry.parameters.leaflet_length=\"16 mm\""})),
                ElementsAre("geometry.parameters", "particles.spacing", "part.blood.viscosity"));
    EXPECT_THAT(keys(valve(), valve({"title=another"})), ElementsAre("title"));
}

TEST(SceneDifference, HasWhatIsInOneSceneOnly) {
    const std::string before = "a = 1\n\n[run]\nduration = \"1 s\"\n", now = "a = 1\n\n[[measure]]\nname = \"flux\"\n";
    const auto found = differences(before, now);
    ASSERT_EQ(found.size(), 2U);
    EXPECT_EQ(found[0].key, "measure.flux.name");
    EXPECT_EQ(found[1].key, "run.duration");
    EXPECT_EQ(differences_text(found),
              "\n  measure.flux.name: was not set, is \"flux\"\n  run.duration: was \"1 s\", is not set");
}

TEST(SceneDifference, InStateLeavesOutWhatARunMayChangeAsItGoesOn) {
    const auto keys_in_state = [](const std::vector<std::string>& overrides) {
        std::vector<std::string> found;
        for (const auto& one : differences_in_state(valve(), valve(overrides))) found.push_back(one.key);
        return found;
    };
    EXPECT_THAT(keys_in_state({"run.duration=\"9 s\"", "output.every=\"1 ms\"", "output.measure_every=\"1 ms\"",
                               "output.pictures=false", "output.fields=['velocity']", "title=another",
                               "measure.tip_gap.name=gap"}),
                IsEmpty());
    EXPECT_THAT(keys_in_state({"output.average_from=\"1 s\"", "run.until_steady=\"1 s\"", "run.duration=\"9 s\"",
                               "numerics.shifting=0.1"}),
                ElementsAre("numerics.shifting", "run.until_steady", "output.average_from"));
    const std::string steady = "[run]\nuntil_steady = \"1 s\"\n", never = "[run]\nuntil_steady = \"0 s\"\n";
    EXPECT_THAT(differences_in_state(steady, never), IsEmpty());
    EXPECT_EQ(differences_in_state(never, steady).size(), 1U);
    const std::string flux = "[[measure]]\nname = \"flux\"\n", gap = "[[measure]]\nname = \"gap\"\n";
    EXPECT_THAT(differences_in_state(flux + gap, gap + flux), IsEmpty());
    const auto gap_of = [](const std::string& part) {
        return "[[measure]]\nname = \"gap\"\npart = \"" + part + "\"\n";
    };
    EXPECT_THAT(differences_in_state(flux + gap_of("a"), gap_of("a")), IsEmpty());
    const auto other_part = differences_in_state(flux + gap_of("a"), gap_of("b"));
    ASSERT_EQ(other_part.size(), 1U) << "its column would go on as if nothing had changed";
    EXPECT_EQ(other_part[0].key, "measure.gap.part");
    const std::string one = "[[part]]\nname = \"a\"\n", other = "[[part]]\nname = \"b\"\n";
    EXPECT_EQ(differences_in_state(one + other + flux, other + one).size(), 1U) << "the order of the parts";
}

TEST(SceneDifference, GoesByTheValuesOfTheSceneInComments) {
    const std::string written = "a = 1\n\n[run]\nduration = \"4 s\"\n";
    const std::string run = with_values_of(written, "a = 1\n\n[run]\nduration = \"0.5 s\"\n");
    EXPECT_EQ(run, "a = 1\n\n[run]\nduration = \"0.5 s\"  # in the scene: \"4 s\"\n");
    EXPECT_THAT(keys(run, written), IsEmpty());
    EXPECT_THAT(keys("# a = 1\n\n[run]\nduration = \"4 s\"\n", written), IsEmpty());
    EXPECT_THAT(keys(run, "a = 1\n\n[run]\nduration = \"5 s\"\n"), ElementsAre("run.duration"));
}

TEST(SceneDifference, SeesAnotherOrder) {
    const std::string one = "[[part]]\nname = \"a\"\n", other = "[[part]]\nname = \"b\"\n";
    EXPECT_THAT(keys(one + other, other + one), ElementsAre("order of the tables"));
}

TEST(SceneDifference, OfTablesWithoutNamesGoesByTheirNumber) {
    const std::string one = "[[x]]\nk = 1\n\n[[x]]\nk = 2\n", other = "[[x]]\nk = 1\n\n[[x]]\nk = 3\n";
    EXPECT_THAT(keys(one, other), ElementsAre("x.2.k"));
}

TEST(SceneDifference, SaysFiveAndHowManyMore) {
    std::string before, now;
    for (int k = 0; k < 8; ++k) {
        before += "k" + std::to_string(k) + " = 1\n";
        now += "k" + std::to_string(k) + " = 2\n";
    }
    const std::string text = differences_text(differences(before, now));
    EXPECT_THAT(text, testing::AllOf(testing::HasSubstr("\n  k4: was 1, is 2\n  and 3 more"),
                                     testing::Not(testing::HasSubstr("k5"))));
}

}  // namespace
}  // namespace dmp::tests::scene_difference_tests
