// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/touching_spheres.hpp"

#include <algorithm>
#include <random>
#include <tuple>

#include <gtest/gtest.h>

#include "base/closest_point.hpp"
#include "tests/modules.hpp"

namespace dmp::tests::touching_spheres_tests {
namespace {

/// Spheres of very unlike radii at random in a box of 1 m, among them a fluid particle.
ParticleSet crowd(int count, const std::array<bool, 3>& periodic) {
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> number(0, 1);
    ParticleSet set;
    set.dimension = 3;
    set.box = {Vec::Zero(), Vec::Ones()};
    set.periodic = periodic;
    set.parts = {{"beads", PartKind::spheres}, {"water", PartKind::fluid}};
    for (int i = 0; i < count; ++i) {
        set.position.emplace_back(number(random), number(random), number(random));
        set.radius.push_back(0.008 * std::pow(20, std::pow(number(random), 8)));
        set.part.push_back(i % 50 == 7 ? 1 : 0);
    }
    return set;
}

TEST(TouchingSpheres, are_those_that_all_pairs_find) {
    for (const std::array<bool, 3> periodic : {std::array{false, false, false}, {true, false, true}}) {
        const ParticleSet set = crowd(3000, periodic);
        std::vector<std::tuple<int, int>> expected, found;
        double deepest = 0, found_deepest = 0;
        for (int i = 0; i < 3000; ++i)
            for (int j = i + 1; j < 3000; ++j) {
                if (set.part[i] == 1 || set.part[j] == 1) continue;
                Vec apart = set.position[i] - set.position[j];
                for (int axis = 0; axis < 3; ++axis)
                    if (periodic[axis]) apart[axis] -= std::round(apart[axis]);
                const double overlap = set.radius[i] + set.radius[j] - apart.norm();
                if (overlap < 0) continue;
                expected.emplace_back(i, j);
                deepest = std::max(deepest, overlap);
            }
        for (const TouchingSpheres& pair : touching_spheres(set)) {
            found.emplace_back(pair.a, pair.b);
            found_deepest = std::max(found_deepest, pair.overlap);
        }
        EXPECT_GT(expected.size(), 1000U);
        EXPECT_EQ(found, expected);
        EXPECT_NEAR(found_deepest, deepest, 1e-15);
    }
}

TEST(TouchingSpheres, a_sphere_may_meet_itself_around_a_period) {
    ParticleSet set = crowd(1, {true, false, false});
    set.radius[0] = 0.6;
    const auto pairs = touching_spheres(set);
    ASSERT_FALSE(pairs.empty());
    EXPECT_EQ(pairs[0].a, pairs[0].b);
    EXPECT_NEAR(pairs[0].overlap, 0.2, 1e-15);
}

TEST(ClosestOnTriangle, is_nearer_than_any_other_point_of_it) {
    std::mt19937_64 random(6);
    std::uniform_real_distribution<double> number(-1, 1);
    const auto vector = [&] { return Vec(number(random), number(random), number(random)); };
    for (int k = 0; k < 300; ++k) {
        const Vec a = vector(), b = vector(), c = vector(), p = 2 * vector();
        const double distance = (p - closest_on_triangle(p, a, b, c)).norm();
        double sampled = std::numeric_limits<double>::infinity();
        constexpr int steps = 60;
        for (int u = 0; u <= steps; ++u)
            for (int v = 0; u + v <= steps; ++v)
                sampled = std::min(sampled, (p - a - (b - a) * u / steps - (c - a) * v / steps).norm());
        EXPECT_LE(distance, sampled + 1e-14);
        EXPECT_GE(distance, sampled - 0.06);
    }
}

}  // namespace
}  // namespace dmp::tests::touching_spheres_tests
