// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Forces on parts, moving shapes and a pressure gradient: the same bits on any number of ranks.
#include <gtest/gtest.h>

#include "tests/modules.hpp"
#include "tests/unit/solver/walled_water.hpp"

namespace dmp::tests::driving_on_ranks_tests {
namespace {

TEST(DrivingOnRanks, water_that_is_pushed_and_stirred) {
    WalledWater made(9, 7, {"plates"}, [](int column, int) { return column >= 0 && column < 9 ? 1 : 0; });
    made.make_periodic(0);
    ForceOnPart push;
    push.name = std::string("push");
    push.part = std::string("water");
    push.force = std::array{formula_of("300"), formula_of("50 * sin(7 * x)"), Expression()};
    push.amount = ForceAmount::total;
    push.until = 0.2;
    push.from = 0.05;
    ForceOnPart even = push;
    even.force = std::array{formula_of("1 / 3"), Expression(), Expression()};
    even.amount = ForceAmount::per_particle;
    MovingShape spoon;
    spoon.kind = ShapeKind::circle;
    spoon.parts = std::vector<std::string>{"water"};
    spoon.position = std::array{formula_of("0.1 + t"), formula_of("0.35"), Expression()};
    spoon.radius = 0.1;
    spoon.strength = 20.0;
    spoon.range = 0.1;
    made.scene.forces = {push, even};
    made.scene.moving_shapes = {spoon};
    made.scene.flow.pressure_gradient.value[0] = formula_of("-200 * cos(5 * t)");
    made.scene.flow.acceleration = {formula_of("0.1"), formula_of("0.2 * sin(7 * x)"), Expression()};
    made.scene.run.duration = 0.3;
    const Ranks ranks = Ranks::world();
    const RunSummary shared = run_of(made, nullptr, ranks), alone = run_of(made);
    EXPECT_GT(alone.steps, 20);
    if (!ranks.is_first()) return;
    EXPECT_EQ(shared.state_hash, alone.state_hash);
    EXPECT_EQ(shared.impulse_of_body_forces, alone.impulse_of_body_forces);
    EXPECT_NE(alone.impulse_of_body_forces[1], 0);
    EXPECT_LT(alone.momentum_residual, 1e-12);
}

}  // namespace
}  // namespace dmp::tests::driving_on_ranks_tests
