// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "report/even_choice.hpp"
#include "report/html.hpp"
#include "report/particle_data.hpp"
#include "report/particle_plan.hpp"
#include "report/shown_particles.hpp"
#include "tests/unit/report/made_frames.hpp"

namespace dmp::tests::report_particles_tests {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

constexpr std::size_t plenty = 1'000'000;

/// n x n particles, a unit apart, with ids from `first` on.
FrameGroup square(int n, const std::string& name = "fluid", std::int64_t first = 0) {
    std::vector<float> position;
    for (int i = 0; i < n * n; ++i)
        position.insert(position.end(), {static_cast<float>(i % n), static_cast<float>(i / n), 0.0F});
    FrameGroup group = made_group(name, position);
    for (std::int64_t& id : group.id) id += first;
    return group;
}

/// Position in base64 as the page has it.
std::string places(const std::vector<std::uint16_t>& steps) {
    std::string bytes;
    for (const std::uint16_t step : steps) {
        bytes += static_cast<char>(step & 0xFF);
        bytes += static_cast<char>(step >> 8);
    }
    return base64(bytes);
}

TEST(EvenChoice, TakesOneParticleOfEachBlockOfALattice) {
    EvenChoice choice(4);
    const FrameGroup group = square(32);
    std::set<std::pair<int, int>> blocks;
    for (const std::size_t i : choice.of(group))
        blocks.insert({static_cast<int>(group.position[3 * i]) / 2, static_cast<int>(group.position[3 * i + 1]) / 2});
    EXPECT_THAT(blocks, SizeIs(testing::Ge(250U))) << "of 256 blocks of 2 x 2";
}

TEST(EvenChoice, IsTheSameInAllFramesWhereverParticlesAre) {
    EvenChoice choice(5);
    FrameGroup group = square(20);
    const auto ids = [&](const FrameGroup& frame) {
        std::set<std::int64_t> found;
        for (const std::size_t i : choice.of(frame)) found.insert(frame.id[i]);
        return found;
    };
    const auto first = ids(group);
    EXPECT_THAT(first, SizeIs(80));
    std::ranges::reverse(group.id);  // others lie in these places, as if all had moved
    EXPECT_EQ(ids(group), first);
    FrameGroup more = square(20, "fluid", 200);  // half of them new
    const auto later = ids(more);
    EXPECT_THAT(later, SizeIs(testing::AllOf(testing::Ge(75U), testing::Le(85U))));
    for (const std::int64_t id : later) {
        if (id < 400) {
            EXPECT_TRUE(first.contains(id));
        }
    }
}

TEST(EvenChoice, OfAllLeavesNothingOut) { EXPECT_THAT(EvenChoice(1).of(square(7)), SizeIs(49)); }

TEST(ParticlePlan, ShowsFewerFramesBeforeFewerParticles) {
    const auto plan = [](ParticleBytes all, std::size_t frames) {
        return plan_particles(all, frames, 1000, 1'000'000);
    };
    EXPECT_EQ(plan({1000, 0, 500}, 100).frames, 100U);
    EXPECT_EQ(plan({1000, 0, 500}, 400).frames, most_frames_shown);
    EXPECT_EQ(plan({10'000, 0, 100'000}, 400).frames, 90U);
    const ParticlePlan thinned = plan({100'000, 1000, 50'000}, 400);
    EXPECT_EQ(thinned.frames, enough_frames_shown);
    EXPECT_EQ(thinned.every, 4U) << "3 050 000 bytes in 970 000";
    EXPECT_EQ(thinned.every_solid, 1U);
    const ParticlePlan solid = plan({1000, 400'000, 0}, 3);
    EXPECT_EQ(solid.frames, 3U);
    EXPECT_EQ(solid.every_solid, 4U) << "1 200 000 in a third of the bytes";
    EXPECT_EQ(plan_particles({1000, 0, 0}, 400, 7, 1'000'000).frames, 7U) << "no more may be read";
}

TEST(ParticlePlan, NeverTakesMoreThanItMay) {
    for (const std::size_t thinned : {10UL, 5000UL, 123'456UL, 40'000'000UL})
        for (const std::size_t solid : {0UL, 777UL, 90'000UL})
            for (const std::size_t once : {0UL, 60'000UL, 3'000'000UL}) {
                const ParticlePlan plan = plan_particles({thinned, solid, once}, 300, 300, 1'000'000);
                const double bytes = static_cast<double>(plan.frames) *
                                         (static_cast<double>(thinned) / static_cast<double>(plan.every) +
                                          static_cast<double>(solid) / static_cast<double>(plan.every_solid)) +
                                     static_cast<double>(once) / static_cast<double>(plan.every);
                EXPECT_LE(bytes, 1'000'001) << thinned << " " << solid << " " << once;
            }
}

TEST(EvenlySpaced, HasTheFirstAndTheLast) {
    EXPECT_THAT(evenly_spaced(3, 11), ElementsAre(0, 5, 10));
    EXPECT_THAT(evenly_spaced(5, 3), ElementsAre(0, 1, 2));
    EXPECT_THAT(evenly_spaced(1, 11), ElementsAre(10));
    EXPECT_THAT(evenly_spaced(200, 1000).back(), 999);
}

TEST(ShownParticles, HavePlacesAndMagnitudes) {
    const ShownParticles shown = read_shown_particles(two_frames(), plenty);
    EXPECT_THAT(shown.notes, IsEmpty());
    EXPECT_THAT(shown.times, ElementsAre(0, 0.5));
    ASSERT_THAT(shown.groups, SizeIs(1));
    EXPECT_EQ(shown.groups[0].fields[0].name, "speed");
    EXPECT_THAT(shown.groups[0].at[1].values[0], ElementsAre(0, 2, 5));
    EXPECT_TRUE(is_flat(shown));
}

TEST(ShownParticles, SayWhichFramesAreDamaged) {
    MadeFrames frames = two_frames();
    frames.damaged = {0};
    frames.walls_damaged = true;
    const ShownParticles shown = read_shown_particles(frames, plenty);
    EXPECT_THAT(shown.times, ElementsAre(0.5));
    EXPECT_THAT(shown.notes,
                ElementsAre("the walls are left out of the particles: cannot be read (walls.vtp)",
                            "the frame at 0 s is left out of the particles: cannot be <read> (frame_7.vtp)"));
    frames.damaged = {0, 1};
    EXPECT_THAT(read_shown_particles(frames, plenty).times, IsEmpty());
    EXPECT_THAT(read_shown_particles(MadeFrames({}), plenty).times, IsEmpty());
}

TEST(ShownParticles, OfARunThatDivergedLeaveOutWhatHasFlownAway) {
    FrameGroup good = square(40), bad = square(40);
    bad.position[0] = std::numeric_limits<float>::quiet_NaN();
    bad.position[4] = 1e20F;
    const ShownParticles shown =
        read_shown_particles(MadeFrames({made_frame(0, {good}), made_frame(1, {bad})}), plenty);
    EXPECT_EQ(shown.groups[0].at[0].size(), 1600U);
    EXPECT_EQ(shown.groups[0].at[1].size(), 1598U);
    EXPECT_THAT(shown.notes, ElementsAre(HasSubstr("2 of the particles shown, counted in each of 1 frames")));
}

TEST(ShownParticles, OfALargeRunFitTheirBytes) {
    std::vector<Frame> frames;
    for (int k = 0; k < 50; ++k) frames.push_back(made_frame(k, {square(60), square(6, "solid", 100'000)}));
    MadeFrames source(std::move(frames));
    source.at_rest = square(50, "walls", 200'000);
    const ShownParticles shown = read_shown_particles(source, 100'000);
    std::size_t bytes = 0;
    for (const ShownGroup& group : shown.groups) {
        EXPECT_EQ(group.every == 1, group.name == "solid") << group.name;
        for (const GroupAtTime& at : group.at) bytes += bytes_of(group, at.size(), true);
    }
    EXPECT_LE(bytes, 101'000U);
    EXPECT_GE(bytes, 80'000U);
    EXPECT_THAT(shown.times, SizeIs(enough_frames_shown));
}

TEST(ShownParticles, OfAGroupThatAppearsLaterAreEmptyBefore) {
    MadeFrames frames(
        {made_frame(0, {square(3)}), made_frame(1, {square(3), square(2, "solid", 50)}), made_frame(2, {square(3)})});
    const ShownParticles shown = read_shown_particles(frames, plenty);
    ASSERT_THAT(shown.groups, SizeIs(2));
    ASSERT_THAT(shown.groups[1].at, SizeIs(3));
    EXPECT_EQ(shown.groups[1].at[0].size(), 0U);
    EXPECT_EQ(shown.groups[1].at[1].size(), 4U);
    EXPECT_EQ(shown.groups[1].at[2].size(), 0U);
}

TEST(ShownParticles, LeaveOutASurfaceThatIsTooLarge) {
    MadeFrames frames = two_frames();
    frames.at_rest = square(3, "walls", 50);
    frames.at_rest->triangles.assign(30'000, 1);
    EXPECT_THAT(read_shown_particles(frames, 1000).notes,
                ElementsAre(HasSubstr("its 10000 triangles would take 0.1 MB")));
    EXPECT_THAT(read_shown_particles(frames, plenty).groups, SizeIs(2));
}

TEST(ParticleData, HasKnownBytesForKnownPlaces) {
    const auto json = nlohmann::json::parse(particle_data(read_shown_particles(two_frames(), plenty)));
    EXPECT_TRUE(json["flat"]);
    EXPECT_EQ(json["low"], (nlohmann::json{0.0, 0.0, 0.0}));
    EXPECT_EQ(json["high"], (nlohmann::json{1.0, 1.0, 0.0}));
    EXPECT_EQ(json["time"], (nlohmann::json{0.0, 0.5}));
    const auto& group = json["groups"][0];
    EXPECT_EQ(group["name"], "fluid");
    EXPECT_EQ(group["at"][0]["place"], places({0, 0, 65535, 0, 0, 65535}));
    EXPECT_EQ(group["fields"][0]["low"], 0.0);
    EXPECT_EQ(group["fields"][0]["high"], 5.0);
    EXPECT_EQ(group["at"][0]["values"][0], base64(std::string("\0\x33\xfe", 3))) << "0, 1 and 5 of 5";
    EXPECT_EQ(group["at"][1]["values"][0], base64(std::string("\0\x66\xfe", 3)));
    EXPECT_NEAR(group["radius"], 0.95 * 0.5, 1e-12);
}

TEST(ParticleData, OfSpheresHasTheirRadiiAndAThirdAxis) {
    const FrameGroup spheres = made_group(
        "spheres", {0, 0, 0, 2, 0, 4}, {{"radius", "m", 1, {0.5, 1}}, {"contact_force", "N", 3, {0, 0, 0, 0, 0, 0}}});
    const auto json =
        nlohmann::json::parse(particle_data(read_shown_particles(MadeFrames({made_frame(0, {spheres})}), plenty)));
    EXPECT_FALSE(json["flat"]);
    const auto& group = json["groups"][0];
    EXPECT_EQ(group["largest"], 1.0);
    EXPECT_EQ(group["at"][0]["radius"], places({32768, 65535}));
    EXPECT_EQ(group["at"][0]["place"], places({0, 0, 0, 65535, 0, 65535}));
    EXPECT_THAT(group["fields"], IsEmpty()) << "a radius is no colour";
}

TEST(ParticleData, DrawsThinnedParticlesLarger) {
    ShownParticles shown = read_shown_particles(two_frames(), plenty);
    shown.groups[0].every = 4;
    const auto json = nlohmann::json::parse(particle_data(shown));
    EXPECT_NEAR(json["groups"][0]["radius"], 2 * 0.95 * 0.5, 1e-12) << "in 2-D: four times the area each";
}

}  // namespace
}  // namespace dmp::tests::report_particles_tests
