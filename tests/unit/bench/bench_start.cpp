// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/errors.hpp"
#include "bench/start.hpp"
#include "solver/simulation.hpp"
#include "tests/modules.hpp"

namespace dmp::bench {
namespace {

constexpr double dx = Liquid::spacing;

Channel small(int dimension, bool disordered = false) {
    Channel channel;
    channel.dimension = dimension;
    channel.disordered = disordered;
    channel.particles = dimension == 2 ? 1000 : 2000;
    return channel;
}

TEST(BenchStart, HoldsAboutTheFluidAskedFor) {
    for (const int dimension : {2, 3}) {
        const ParticleSet set = make_particles(small(dimension));
        EXPECT_NEAR(static_cast<double>(set.count(PartKind::fluid)), dimension == 2 ? 1000 : 2000, 150);
    }
}

TEST(BenchStart, PutsFluidOnALatticeBetweenWalls) {
    const ParticleSet set = make_particles(small(3));
    EXPECT_THAT(set.periodic, testing::ElementsAre(true, false, true));
    const int layers = 3;
    const double top = set.box.high[1] - layers * dx;
    EXPECT_DOUBLE_EQ(set.box.low[1], -layers * dx);
    for (std::size_t i = 0; i < set.size(); ++i) {
        for (int axis = 0; axis < 3; ++axis) {
            const double cells = set.position[i][axis] / dx - 0.5;
            ASSERT_NEAR(cells, std::round(cells), 1e-9);
        }
        const double y = set.position[i][1];
        ASSERT_EQ(set.kind(i) == PartKind::fluid, y > 0 && y < top);
        ASSERT_EQ(set.fixed[i] != 0, set.kind(i) == PartKind::rigid);
        ASSERT_DOUBLE_EQ(set.mass[i], 1056 * dx * dx * dx);
        if (set.fixed[i] == 0) continue;
        ASSERT_NEAR(set.wall_distance[i], y < 0 ? -y : y - top, 1e-12);
        ASSERT_EQ(set.wall_normal[i], Vec(0, y < 0 ? 1 : -1, 0));
    }
}

TEST(BenchStart, WallsAreAsThickAsTheSupport) {
    Channel channel = small(2);
    for (const auto& [support, layers] : {std::pair{2.0, 2}, std::pair{2.5, 3}, std::pair{3.0, 3}, std::pair{3.1, 4}}) {
        channel.support = support;
        EXPECT_DOUBLE_EQ(make_particles(channel).box.low[1], -layers * dx);
    }
}

TEST(BenchStart, DisorderMovesFluidByUpToThreeTenthsOfTheSpacing) {
    for (const int dimension : {2, 3}) {
        const ParticleSet ordered = make_particles(small(dimension)), moved = make_particles(small(dimension, true));
        ASSERT_EQ(ordered.size(), moved.size());
        Vec largest = Vec::Zero(), mean = Vec::Zero();
        for (std::size_t i = 0; i < ordered.size(); ++i) {
            const Vec by = (moved.position[i] - ordered.position[i]) / dx;
            if (ordered.fixed[i] != 0) {
                ASSERT_EQ(by, Vec(Vec::Zero()));
                continue;
            }
            largest = largest.cwiseMax(by.cwiseAbs());
            mean += by / static_cast<double>(ordered.count(PartKind::fluid));
        }
        for (int axis = 0; axis < 3; ++axis) {
            const bool there = axis < dimension;
            EXPECT_LE(largest[axis], 0.3 + 1e-9);
            EXPECT_GT(largest[axis], there ? 0.29 : -1);
            EXPECT_NEAR(mean[axis], 0, there ? 0.03 : 0);
        }
        EXPECT_EQ(moved.position, make_particles(small(dimension, true)).position);
    }
}

TEST(BenchStart, NoiseDependsOnSeedIdAndAxis) {
    const double one = noise(1, 2, 0);
    EXPECT_EQ(one, noise(1, 2, 0));
    for (const double other : {noise(2, 2, 0), noise(1, 3, 0), noise(1, 2, 1)}) EXPECT_NE(one, other);
}

TEST(BenchStart, TheSceneIsTheChannels) {
    Channel channel = small(2);
    channel.kernel = KernelKind::lucy;
    channel.support = 2.7;
    channel.walls = WallModel::extrapolated;
    channel.density_diffusion = 0.05;
    channel.shifting = 2;
    const Scene scene = make_scene(channel);
    EXPECT_DOUBLE_EQ(scene.particles.spacing, dx);
    EXPECT_EQ(scene.numerics.kernel.value, KernelKind::lucy);
    EXPECT_DOUBLE_EQ(scene.numerics.support, 2.7);
    EXPECT_EQ(scene.numerics.walls.value, WallModel::extrapolated);
    EXPECT_DOUBLE_EQ(scene.numerics.density_diffusion, 0.05);
    EXPECT_DOUBLE_EQ(scene.numerics.shifting, 2);
    EXPECT_DOUBLE_EQ(scene.contact.range, 0);
    EXPECT_TRUE(scene.flow.periodic[0]);
}

TEST(BenchStart, HasTheDefaultsOfScenes) {
    const Scene by_default;
    Channel channel = small(2);
    use_defaults_of_scenes(channel, FluidScheme::corrected);
    const Scene scene = make_scene(channel);
    EXPECT_EQ(scene.numerics.scheme.value, FluidScheme::corrected);
    EXPECT_EQ(scene.numerics.kernel.value, by_default.numerics.kernel.value);
    EXPECT_EQ(scene.numerics.support.value, by_default.numerics.support.value);
    EXPECT_EQ(scene.numerics.walls.value, by_default.numerics.walls.value);
    EXPECT_EQ(scene.numerics.density_diffusion.value, by_default.numerics.density_diffusion.value);
    EXPECT_EQ(scene.numerics.shifting.value, by_default.numerics.shifting.value);
    EXPECT_EQ(scene.numerics.step_factor.value, by_default.numerics.step_factor.value);
    EXPECT_EQ(scene.contact.range.value, by_default.contact.range.value);
}

TEST(BenchStart, DissolvesSpeciesWhereTheyAreAskedFor) {
    Channel channel;
    EXPECT_TRUE(make_scene(channel).species.empty());
    channel.species = 2;
    const Scene scene = make_scene(channel);
    ASSERT_EQ(scene.species.size(), 2U);
    EXPECT_NE(*scene.species[0].name, *scene.species[1].name);
}

TEST(BenchStart, SaysSpaceInTheSceneOfSpace) {
    const std::string text = scene_text(small(3));
    EXPECT_THAT(text, testing::HasSubstr("dimension = 3"));
    EXPECT_THAT(text, testing::HasSubstr(R"(periodic = ["x", "z"])"));
}

TEST(BenchStart, TheLiquidGetsUpToSpeedInTheFirstSteps) {
    const Channel channel = small(2);
    Simulation simulation(make_scene(channel), make_particles(channel), 1);
    RunOptions options;
    options.until = 0.2e-3;
    const RunSummary summary = simulation.run(options);
    EXPECT_NEAR(summary.end.momentum[0] / summary.end.mass / Liquid::speed, 1, 0.05);
    EXPECT_LT(summary.steps, 40);
}

}  // namespace
}  // namespace dmp::bench
