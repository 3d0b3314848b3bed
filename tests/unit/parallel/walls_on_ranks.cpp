// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Walls that move and planes of symmetry: the same bits on any number of ranks.
#include <gtest/gtest.h>

#include "tests/modules.hpp"
#include "tests/unit/solver/mirrored_water.hpp"
#include "tests/unit/solver/water_beside_a_block.hpp"

namespace dmp::tests::walls_on_ranks_tests {
namespace {

void expect_same_bits(const WalledWater& made) {
    const Ranks ranks = Ranks::world();
    const RunSummary shared = run_of(made, nullptr, ranks), alone = run_of(made);
    EXPECT_GT(alone.steps, 20);
    if (!ranks.is_first()) return;
    EXPECT_EQ(shared.state_hash, alone.state_hash);
    EXPECT_EQ(shared.impulse_of_fixed, alone.impulse_of_fixed);
    EXPECT_EQ(shared.lost, 0U);
    EXPECT_EQ(voids_of(shared), voids_of(alone));
}

TEST(WallsOnRanks, a_box_that_is_carried_along_and_turned) {
    WalledWater made(9, 7, {"box", "lid"}, [](int, int row) { return row < 7 ? 1 : 2; });
    for (const int part : {1, 2}) {
        made.part(part).velocity = std::array{formula_of("0.5 * sin(3 * t)"), formula_of("0.2 * t"), Expression()};
        made.part(part).spin = formula_of("cos(t)");
        made.part(part).centre = Vec(0.4, 0.3, 0);
    }
    made.part(2).surface_velocity = std::array{formula_of("1 + 0.1 * x"), Expression(), Expression()};
    made.part(1).slip = true;
    made.scene.run.duration = 0.6;
    expect_same_bits(made);
}

TEST(WallsOnRanks, a_belt_that_crosses_a_period) {
    WalledWater made(8, 6, {"plates"}, [](int column, int) { return column >= 0 && column < 8 ? 1 : 0; });
    made.make_periodic(0);
    made.part(1).velocity = std::array{formula_of("1"), Expression(), Expression()};
    expect_same_bits(made);
}

TEST(WallsOnRanks, a_block_that_leaves_a_void_behind) {
    const WalledWater made = water_beside_a_block(2);
    EXPECT_EQ(voids_of(run_of(made)).size(), 1U);
    expect_same_bits(made);
}

TEST(WallsOnRanks, a_vortex_between_planes_of_symmetry) { expect_same_bits(vortex(true)); }

TEST(WallsOnRanks, a_lid_over_half_a_cavity) {
    WalledWater made(8, 8, {"wall", "lid"}, [](int column, int row) {
        return column < 0 || column >= 8 ? 0 : row < 8 ? (row < 0 ? 1 : 0) : 2;
    });
    made.make_periodic(0);
    made.part(2).surface_velocity = std::array{formula_of("1"), Expression(), Expression()};
    made.scene.run.duration = 0.4;
    expect_same_bits(made);
    made.scene.flow.periodic[0] = made.particles.periodic[0] = false;
    made.mirror({BoxSide::x_low, BoxSide::x_high});
    made.part(2).surface_velocity = std::array{formula_of("sin(pi * x / 0.8)"), Expression(), Expression()};
    expect_same_bits(made);
}

}  // namespace
}  // namespace dmp::tests::walls_on_ranks_tests
