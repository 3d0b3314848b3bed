// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Particles that follow the surfaces of a geometry in 3-D.
#include <cmath>
#include <numbers>

#include <gmock/gmock.h>
#include <omp.h>

#include "meshed_text.hpp"
#include "mesher/searchable_particles.hpp"
#include "models/sph/kernels.hpp"
#include "tests/modules.hpp"

namespace dmp::tests::fitted_meshes_tests {
namespace {

/// Mean and standard deviation of SUM V W over fluid particles.
struct KernelSums {
    double mean = 0, spread = 0;
    int count = 0;
    void add(double sum) {
        mean += sum;
        spread += sum * sum;
        ++count;
    }
    void finish() {
        mean /= count;
        spread = std::sqrt(std::max(0.0, spread / count - mean * mean));
    }
};

/// Of those whose kernel reaches a wall, and of the others.
std::pair<KernelSums, KernelSums> near_and_inside(const ParticleSet& set, double support) {
    const WendlandC2<3> kernel(support);
    const SearchableParticles search(set, support);
    KernelSums near, inside;
    for (std::size_t i = 0; i < set.size(); ++i) {
        if (set.kind(i) != PartKind::fluid) continue;
        double sum = set.volume[i] * kernel.value(0.0);
        bool sees_wall = false;
        search.for_each_neighbour(i, [&](std::size_t j, const Vec& separation) {
            sum += set.volume[j] * kernel.value(separation.norm());
            sees_wall = sees_wall || set.kind(j) == PartKind::rigid;
        });
        (sees_wall ? near : inside).add(sum);
    }
    near.finish();
    inside.finish();
    return {near, inside};
}

class FittedPipe : public testing::TestWithParam<const char*> {};

/// Twenty spacings across, in each arrangement to start from, and from places at random.
TEST_P(FittedPipe, follows_its_wall) {
    const std::string start = GetParam();
    const auto meshed = mesh_case(
        "verification/pipe",
        start == "sampled" ? std::vector<std::string>{"particles.fill=sampled"}
                           : std::vector<std::string>{"particles.fill=relaxed", "particles.arrangement=" + start});
    const ParticleSet& set = meshed.particles;
    const double spacing = set.spacing, radius = 5e-4, length = 4e-4;
    const auto distance = [&](std::size_t i) {
        return (std::hypot(set.position[i].y(), set.position[i].z()) - radius) / spacing;
    };
    double squares = 0, volume = 0;
    int in_layer = 0;
    for (std::size_t i = 0; i < set.size(); ++i) {
        const double d = distance(i);
        const bool fluid = set.kind(i) == PartKind::fluid;
        EXPECT_EQ(fluid, d < 0);
        EXPECT_GT(std::abs(d), 0.45);
        if (fluid) volume += set.volume[i];
        if (std::abs(d) < 0.75) {
            squares += std::pow(std::abs(d) - 0.5, 2);
            ++in_layer;
        }
        if (fluid) continue;
        EXPECT_LT(d, 3 + 1e-3);
        EXPECT_NEAR(set.wall_distance[i], d * spacing, 5e-3 * spacing);  // how far triangles are from the round wall
        const Vec inward = -Vec(0, set.position[i].y(), set.position[i].z()).normalized();
        EXPECT_GT(set.wall_normal[i].dot(inward), 0.99);
    }
    // One particle for each square spacing of the two layers at the wall.
    const double layers = 2 * std::numbers::pi * (radius - spacing / 2 + radius + spacing / 2) * length;
    EXPECT_NEAR(in_layer, layers / (spacing * spacing), 0.1 * in_layer);
    EXPECT_LT(std::sqrt(squares / in_layer), 0.05);
    EXPECT_NEAR(volume, std::numbers::pi * radius * radius * length, 2e-3 * volume);
    // Of the three layers the last is not straight: some of it is cut off.
    const double shell = std::numbers::pi * (std::pow(radius + 3 * spacing, 2) - radius * radius) * length;
    const double in_shell = static_cast<double>(set.count(PartKind::rigid)) * std::pow(spacing, 3);
    EXPECT_NEAR(in_shell, shell, 0.1 * shell);

    const auto [near, inside] = near_and_inside(set, 3 * spacing);
    EXPECT_NEAR(inside.mean, 1, 0.01);
    EXPECT_LT(inside.spread, 0.01);
    EXPECT_NEAR(near.mean, 1, 0.01);
    EXPECT_LT(near.spread, 0.03);
    EXPECT_THAT(meshed.report.notes, testing::Contains(testing::HasSubstr("relaxed in ")));
}

INSTANTIATE_TEST_SUITE_P(From, FittedPipe, testing::Values("square", "fcc", "hexagonal", "sampled"),
                         [](const auto& start) { return std::string(start.param); });

/// A ball in a box of fluid whose sides are all periodic.
const Texts ball{R"(schema = 1
dimension = 3
[geometry]
file = "channel.geo"
[particles]
spacing = "0.0625 m"
fill = "relaxed"
[[part]]
name = "water"
kind = "fluid"
density = "1000 kg/m^3"
viscosity = "1 mPa*s"
[[part]]
name = "ball"
kind = "rigid"
[flow]
periodic = ["x", "y", "z"]
largest_speed = "1 m/s"
[run]
duration = "1 s"
[output]
every = "1 s"
)",
                 R"(SetFactory("OpenCASCADE");
Box(1) = {0, 0, 0, 1, 1, 1};
Sphere(2) = {0.5, 0.5, 0.5, 0.3};
Physical Volume("water") = {1};
Physical Volume("ball") = {2};
)"};

TEST(FittedMeshes, bodies_in_a_fluid_are_followed_on_both_sides) {
    const auto meshed = mesh_texts(ball);
    const ParticleSet& set = meshed.particles;
    for (std::size_t i = 0; i < set.size(); ++i) {
        const double d = ((set.position[i] - Vec(0.5, 0.5, 0.5)).norm() - 0.3) / set.spacing;
        EXPECT_EQ(set.kind(i) == PartKind::fluid, d > 0);
        EXPECT_GT(std::abs(d), 0.45);
        EXPECT_GT(d, -3.01);
    }
    const auto [near, inside] = near_and_inside(set, 3 * set.spacing);
    EXPECT_LT(inside.spread, 0.01);
    EXPECT_LT(near.spread, 0.03);
    const double free_volume = 1 - 4.0 / 3 * std::numbers::pi * std::pow(0.3, 3);
    EXPECT_NEAR(static_cast<double>(set.count(PartKind::fluid)) * std::pow(set.spacing, 3), free_volume,
                0.01 * free_volume);
}

TEST(FittedMeshes, are_the_same_by_any_number_of_threads) {
    const int before = omp_get_max_threads();
    omp_set_num_threads(1);
    const auto one = mesh_texts(ball);
    omp_set_num_threads(3);
    const auto three = mesh_texts(ball);
    omp_set_num_threads(before);
    ASSERT_EQ(one.particles.size(), three.particles.size());
    for (std::size_t i = 0; i < one.particles.size(); ++i)
        EXPECT_EQ(one.particles.position[i], three.particles.position[i]);
}

}  // namespace
}  // namespace dmp::tests::fitted_meshes_tests
