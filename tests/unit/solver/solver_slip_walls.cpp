// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <gtest/gtest.h>

#include "models/sph/morris_viscosity.hpp"
#include "models/sph/walls.hpp"
#include "small_scenes.hpp"
#include "tests/modules.hpp"
#include "tests/unit/solver/one_pair.hpp"
#include "walled_water.hpp"

namespace dmp::tests::solver_slip_walls_tests {
namespace {

/// A channel, periodic in x, between walls of parts 1 (below) and 2 (above).
WalledWater channel(int rows) {
    WalledWater made(6, rows, {"floor", "ceiling"}, [rows](int column, int row) {
        if (column < 0 || column >= 6) return 0;
        return row < 0 ? 1 : row >= rows ? 2 : 0;
    });
    made.make_periodic(0);
    return made;
}

TEST(SlipWalls, do_not_hold_a_plug_flow_back) {
    WalledWater made = channel(10);
    made.part(1).slip = made.part(2).slip = true;
    // 1 m/s by t = 0.1, and from then on left alone.
    made.scene.flow.acceleration[0] = formula_of("t < 0.1 ? 10 : 0");
    made.scene.output.every = 0.1;  // a step ends where the drive does
    made.scene.run.duration = 2.1;
    KeptFrames kept;
    const RunSummary summary = run_of(made, &kept);
    const FrameGroup& fluid = *group_of(kept.frames.back(), "fluid");
    const FrameField& velocity = *field_of(fluid, "velocity");
    for (std::size_t k = 0; k < fluid.size(); ++k) {
        EXPECT_NEAR(velocity.values[3 * k], 1, 1e-4);
        EXPECT_NEAR(velocity.values[3 * k + 1], 0, 1e-3);
    }
    EXPECT_LT(std::abs(summary.impulse_of_fixed[0]), 1e-5 * summary.end.momentum[0]);
    EXPECT_LT(summary.momentum_residual, 1e-12);
    EXPECT_EQ(summary.lost, 0U);
}

TEST(SlipWalls, sticking_ones_do_hold_it_back) {
    WalledWater made = channel(10);
    made.scene.flow.acceleration[0] = formula_of("t < 0.1 ? 10 : 0");
    made.scene.output.every = 0.1;
    made.scene.run.duration = 2.1;
    const RunSummary summary = run_of(made);
    EXPECT_LT(summary.end.momentum[0], 0.3 * 600);
}

TEST(SlipWalls, one_of_two_gives_half_a_parabola) {
    constexpr int rows = 20;
    constexpr double height = rows * spacing, viscosity = 4, drive = 1;
    WalledWater made = channel(rows);
    made.part(1).slip = true;
    made.scene.parts[0].viscosity = 1000 * viscosity;
    made.scene.flow.acceleration[0] = formula_of("1");
    made.scene.run.duration = 3;  // exp(-(pi/2)^2 nu t / H^2) = 6e-4
    KeptFrames kept;
    const RunSummary summary = run_of(made, &kept);
    const FrameGroup& fluid = *group_of(kept.frames.back(), "fluid");
    const FrameField& velocity = *field_of(fluid, "velocity");
    double square = 0, reference = 0;
    for (std::size_t k = 0; k < fluid.size(); ++k) {
        const double y = fluid.position[3 * k + 1];
        const double expected = drive / (2 * viscosity) * (height * height - y * y);
        square += std::pow(velocity.values[3 * k] - expected, 2);
        reference += expected * expected;
    }
    EXPECT_LT(std::sqrt(square / reference), 0.01);
    EXPECT_LT(summary.momentum_residual, 1e-12);
}

TEST(SlipWalls, leave_a_column_of_liquid_at_rest) {
    // A closed box under gravity: what the walls let slip they hold up all the same, by the pressure behind them.
    const auto column = [](bool slips) {
        WalledWater made(10, 10, {"box"}, [](int, int) { return 1; });
        made.part(1).slip = slips;
        made.scene.flow.acceleration[1] = formula_of("-1 * min(t / 0.5, 1)");
        made.scene.run.duration = 3;
        KeptFrames kept;
        const RunSummary summary = run_of(made, &kept);
        EXPECT_EQ(summary.lost, 0U);
        const FrameGroup& fluid = *group_of(kept.frames.back(), "fluid");
        double fastest = 0, slope = 0, moment = 0;
        for (std::size_t k = 0; k < fluid.size(); ++k) {
            const float* v = &field_of(fluid, "velocity")->values[3 * k];
            fastest = std::max<double>(fastest, std::hypot(v[0], v[1]));
            const double y = fluid.position[3 * k + 1] - 0.5;
            slope += y * field_of(fluid, "pressure")->values[k];
            moment += y * y;
        }
        EXPECT_NEAR(slope / moment, -1000, 20);
        return fastest;
    };
    const double fastest = column(true);
    EXPECT_LT(fastest, 0.01);  // of sqrt(2 g H) = 1.4 m/s
}

/// A fluid particle at height 0.2 and a wall particle at depth 0.1 below it, the surface across the last axis.
template <int D>
struct Meeting {
    FluidPoint<double, D> fluid{};
    SolidPoint<double, D> wall{};
    Meeting() {
        fluid.position[D - 1] = 0.2;
        fluid.position[0] = 0.05;
        wall.position[D - 1] = -0.1;
        wall.depth = 0.1;
        wall.normal[D - 1] = 1;
        wall.volume = 2;
        fluid.volume = 3;
        fluid.density = 1000;
        fluid.pressure = 7;
        fluid.viscosity = 0.5;
        for (int a = 0; a < D; ++a) {
            fluid.velocity[a] = 1 + a;
            wall.velocity[a] = 0.25 * (a + 1);
            wall.motion[a] = 0.25 * (a + 1);
        }
    }
};

template <int D>
void expect_the_law() {
    Meeting<D> m;
    const auto apart = m.fluid.position - m.wall.position;
    ExtrapolatedSolid<D, true> law{{}, 0.05};
    for (int a = 0; a < D; ++a) law.acceleration[a] = 0.5 - a;
    // Without slip: on the line through both velocities, v_w - (d_j / d_i) (v_i - v_w).
    const auto sticks = law.rigid(m.fluid, m.wall, apart);
    for (int a = 0; a < D; ++a)
        EXPECT_DOUBLE_EQ(sticks.velocity[a], m.wall.velocity[a] - 0.5 * (m.fluid.velocity[a] - m.wall.velocity[a]));
    double hydrostatic = 0;
    for (int a = 0; a < D; ++a) hydrostatic -= 1000 * law.acceleration[a] * apart[a];
    EXPECT_DOUBLE_EQ(sticks.pressure, 7 + hydrostatic);
    EXPECT_EQ(sticks.volume, 2);
    EXPECT_EQ(sticks.density, 1000);
    // The same as the law for scenes where no wall slips or moves.
    ExtrapolatedSolid<D> plain{law.acceleration, 0.05};
    const auto same = plain.rigid(m.fluid, m.wall, apart);
    for (int a = 0; a < D; ++a) EXPECT_DOUBLE_EQ(same.velocity[a], sticks.velocity[a]);
    EXPECT_DOUBLE_EQ(same.pressure, sticks.pressure);
    // With slip: only the normal part, and no shear stress.
    m.wall.slip = 1;
    const auto slips = law.rigid(m.fluid, m.wall, apart);
    for (int a = 0; a < D - 1; ++a) EXPECT_DOUBLE_EQ(slips.velocity[a], m.fluid.velocity[a]);
    EXPECT_DOUBLE_EQ(slips.velocity[D - 1], sticks.velocity[D - 1]);
    const Pair pair{m.fluid, slips, apart, 1.0, 1.0};
    for (int a = 0; a < D - 1; ++a) EXPECT_NEAR(one_pair::morris.law(pair)[a], 0, 1e-14);
    EXPECT_NE(one_pair::morris.law(pair)[D - 1], 0);
    // In the density rate the wall goes along with what slips past it, and does not with what sticks.
    const auto passed = ExtrapolatedSolid<D, true>::approached(m.fluid, m.wall);
    for (int a = 0; a < D - 1; ++a) EXPECT_DOUBLE_EQ(passed.velocity[a], m.fluid.velocity[a]);
    EXPECT_DOUBLE_EQ(passed.velocity[D - 1], m.wall.velocity[D - 1]);
    // A wall that falls with the liquid leaves its pressure as it is.
    for (int a = 0; a < D; ++a) m.wall.acceleration[a] = law.acceleration[a];
    EXPECT_DOUBLE_EQ(law.rigid(m.fluid, m.wall, apart).pressure, 7);
}

TEST(ExtrapolatedWall, law_of_one_pair_in_the_plane) { expect_the_law<2>(); }
TEST(ExtrapolatedWall, law_of_one_pair_in_space) { expect_the_law<3>(); }

}  // namespace
}  // namespace dmp::tests::solver_slip_walls_tests
