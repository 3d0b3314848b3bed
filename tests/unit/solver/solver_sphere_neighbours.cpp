// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <numeric>
#include <optional>
#include <random>
#include <set>

#include <gtest/gtest.h>

#include "solver/spheres/sphere_group.hpp"
#include "solver/spheres/sphere_search.hpp"
#include "solver/spheres/sphere_step.hpp"
#include "tests/modules.hpp"
#include "tests/unit/solver/sphere_scenes.hpp"

namespace dmp::tests::solver_sphere_neighbours_tests {
namespace {

TEST(SphereSearch, finds_what_all_pairs_find_at_a_size_ratio_of_twenty) {
    SphereScene made;
    const int part = made.part("s", PartKind::spheres);
    std::mt19937 random(3);
    std::uniform_real_distribution<double> unit(0, 1);
    for (int k = 0; k < 1500; ++k) {
        const double radius = k < 12 ? 0.02 + 0.02 * unit(random) : 0.002 + 0.004 * unit(random) * unit(random);
        made.sphere(part, Vec(unit(random), unit(random), unit(random)) * 0.12, radius);
    }
    const PositionQuantum quantum(made.set);
    const ParticleGroup group = sphere_group(made.set, quantum, Ranks::alone());
    SphereRows rows;
    rows.take(group, std::vector<bool>(made.set.size()));
    const double gap = 1e-3;
    std::vector<float> skins(made.set.size());
    for (float& skin : skins) skin = static_cast<float>(1e-3 * unit(random));
    skins[1000] = 0.02F;
    std::set<std::pair<int, int>> expected, found;
    for (std::size_t i = 0; i < made.set.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            if ((made.set.position[i] - made.set.position[j]).norm() <
                made.set.radius[i] + made.set.radius[j] + gap + skins[i] + skins[j])
                expected.emplace(j, i);
    std::vector<NearSpheres> near;
    const SphereSearch search(rows, gap, skins);
    search.append_near(0, 700, near);
    search.append_near(700, static_cast<std::int32_t>(rows.total()), near);
    for (const NearSpheres& pair : near) found.emplace(std::minmax(pair.finder, pair.other));
    EXPECT_EQ(near.size(), found.size());  // each once
    EXPECT_EQ(found, expected);
    EXPECT_GT(expected.size(), 1000U);
}

/// A heap that hardly moves, through which some fly.
struct Shot {
    explicit Shot(int threads) : resources(threads) {
        const int part = made.part("s", PartKind::spheres);
        std::mt19937 random(8);
        std::uniform_real_distribution<double> unit(-1, 1);
        const auto anywhere = [&] { return Vec(unit(random), unit(random), unit(random)); };
        for (int x = 0; x < 7; ++x)
            for (int y = 0; y < 7; ++y)
                for (int z = 0; z < 7; ++z)
                    made.sphere(part, 2.02e-3 * Vec(x, y, z) + 1e-5 * anywhere(), 1e-3, 0.01 * anywhere());
        for (int k = 0; k < 5; ++k)
            made.sphere(part, Vec(-4e-3 - 3e-3 * k, 2e-3 * k, 3e-3 * k), 5e-4, Vec(20, 0, 0) + 0.5 * anywhere());
        made.set.box = {Vec::Constant(-0.1), Vec::Constant(0.1)};
        made.contact(0.9, 0.3);
        setup = sphere_setup(made.scene, made.set);
        group = sphere_group(made.set, PositionQuantum(made.set), Ranks::alone());
        step.emplace(made.scene, made.set, made.set, *group, setup, resources);
        step->start(true, 0);
    }
    SphereScene made;
    SphereSetup setup;
    Resources resources;
    std::optional<ParticleGroup> group;
    std::optional<SphereStep> step;
};

TEST(SphereNeighbours, miss_no_contact_however_unlike_the_speeds) {
    for (const int threads : {1, 3}) {
        Shot shot(threads);
        std::size_t touching = 0;
        for (int k = 0; k < 600; ++k) {
            shot.step->advance(k * 1e-6, 1e-6);
            std::set<std::pair<int, int>> listed;
            const ContactList& list = shot.step->neighbours().list();
            list.for_each(
                [&](std::size_t c, std::int16_t) { listed.emplace(std::minmax(list.low()[c], list.high()[c])); });
            const auto motion = shot.step->rows().motion();
            const auto position = [&](int i) { return Eigen::Map<const Vec>(motion[i].position.c); };
            for (int j = 0; j < static_cast<int>(shot.made.set.size()); ++j)
                for (int i = 0; i < j; ++i)
                    if ((position(i) - position(j)).norm() < motion[i].radius() + motion[j].radius()) {
                        ++touching;
                        ASSERT_TRUE(listed.contains({i, j})) << "step " << k;
                    }
        }
        EXPECT_GT(touching, 1000U);
        // With one skin for all, the fast ones would ask for a list every dozen steps: 51 of them.
        EXPECT_LT(shot.step->neighbours().renewals(), 20);
    }
}

TEST(SphereSkins, are_wide_for_the_fast_and_the_mean_on_average) {
    SphereScene made;
    const int part = made.part("s", PartKind::spheres);
    for (int k = 0; k < 100; ++k) made.sphere(part, Vec(k, 0, 0), 0.1, Vec(3, k == 42 ? 1.0 : 0.01 * (k % 2), 0));
    made.set.box = {Vec::Constant(-1), Vec::Constant(100)};
    SphereRows rows;
    rows.take(sphere_group(made.set, PositionQuantum(made.set), Ranks::alone()), std::vector<bool>(100));
    for (const int threads : {1, 3}) {
        SphereSkins skins;
        skins.make(rows, {3, 0, 0}, 1e-3, 1, Ranks::alone(), threads);
        const auto skin = skins.by_row();
        EXPECT_NEAR(std::accumulate(skin.begin(), skin.end(), 0.0), 100 * 1e-3, 1e-7);
        EXPECT_NEAR(*std::ranges::max_element(skin) / skins.least(), (1 + 0.015) / 0.015, 0.01);
        EXPECT_NEAR(skins.inverse_squares()[7] * skin[7] * skin[7], 1, 1e-6);
        SphereSkins kept;
        kept.make_within(0.25, skins, rows, {3, 0, 0}, 1e-2, Ranks::alone(), threads);
        for (std::size_t i = 0; i < 100; ++i) EXPECT_FLOAT_EQ(kept.by_row()[i], 0.25F * skin[i]);
        skins.make(rows, {3, 0, 0}, 1e-3, 2e-3, Ranks::alone(), threads);
        EXPECT_FLOAT_EQ(static_cast<float>(skins.largest()), 2e-3F);
    }
    SphereSkins same;
    for (SphereMotion& sphere : rows.motion()) sphere.velocity.c[1] = 0;
    same.make(rows, {3, 0, 0}, 1e-3, 1, Ranks::alone(), 1);
    for (std::size_t i = 0; i < 100; ++i) EXPECT_FLOAT_EQ(same.by_row()[i], 1e-3F);
}

}  // namespace
}  // namespace dmp::tests::solver_sphere_neighbours_tests
