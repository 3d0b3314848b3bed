// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// A vessel whose soft walls are dry outside: its pressure stays, and the walls feel all of it.
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/modules.hpp"
#include "tests/unit/solver/small_scenes.hpp"
#include "tests/unit/solver/walled_water.hpp"

namespace dmp::tests::soft_walls_on_ranks_tests {
namespace {

/// 10 particles across.
SceneAndParticles vessel(const std::string& gradient, const std::string& duration) {
    SceneAndParticles made = case_of("verification/soft_vessel", {"flow.pressure_gradient=['" + gradient + " Pa/m', 0]",
                                                                  "run.duration=" + duration});
    return made;
}

double column_at_end(const RunSummary& run, const std::string& name) {
    const auto column = std::ranges::find(run.measures.names, name) - run.measures.names.begin();
    return run.measures.rows.back().at(static_cast<std::size_t>(column));
}

/// How far the walls' particles beside the liquid have moved outwards, on average [m].
double given_way(const Frame& frame, double height) {
    double sum = 0;
    int count = 0;
    for (const FrameGroup& group : frame.groups)
        for (const FrameField& field : group.fields) {
            if (field.name != "displacement") continue;
            for (std::size_t i = 0; i < group.size(); ++i) {
                const double y = group.position[3 * i + 1], outside = std::abs(y - height / 2) - height / 2;
                if (outside > 0.5 * frame.spacing + 1e-5) continue;
                sum += field.values[3 * i + 1] * (y > height / 2 ? 1 : -1);
                ++count;
            }
        }
    return sum / count;
}

TEST(SoftWallsOnRanks, hold_the_whole_pressure) {
    for (const std::string gradient : {"0", "-20"}) {
        KeptFrames kept;
        const RunSummary run = run_of(vessel(gradient, "0.5 s"), &kept);
        EXPECT_NEAR(column_at_end(run, "p_mean"), 1000, 2) << gradient;
        if (gradient != "0") {  // at rest there are no impulses to compare with
            EXPECT_LT(run.momentum_residual, 1e-12);
        }
        EXPECT_TRUE(run.chambers.empty()) << "the walls move: one chamber";
        // p h (1 + nu) (1 - 2 nu) / ((1 - nu) E) at the surface. The kernel's sums put 0.842 of the load on the first
        // of the wall's two rows and 0.155 on the second; cells hand it to the nodes at their corners, so that the
        // middle of the first gives way by 5/8 and 1/4 of that.
        const double at_surface = 1000 * 0.8e-3 * 1.25 * 0.5 / (0.75 * 1e6);
        const double expected = (0.842 * 0.625 + 0.155 * 0.25) * at_surface;
        EXPECT_NEAR(given_way(kept.frames.back(), 4e-3), expected, 0.02 * expected) << gradient;
    }
}

TEST(SoftWallsOnRanks, have_the_same_bits) {
    const Ranks ranks = Ranks::world();
    const SceneAndParticles made = vessel("-20", "0.05 s");
    const RunSummary shared = run_of(made, nullptr, ranks), alone = run_of(made);
    if (!ranks.is_first()) return;
    EXPECT_EQ(shared.state_hash, alone.state_hash);
    EXPECT_EQ(shared.impulse_of_fixed, alone.impulse_of_fixed);
}

}  // namespace
}  // namespace dmp::tests::soft_walls_on_ranks_tests
