// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <map>

#include <gtest/gtest.h>

#include "mirrored_water.hpp"
#include "small_scenes.hpp"
#include "tests/modules.hpp"

namespace dmp::tests::solver_symmetry_tests {
namespace {

/// Position and velocity by where the particle was drawn, in whole lattice cells.
std::map<std::pair<long, long>, std::array<double, 4>> by_position(const WalledWater& made, const Frame& frame) {
    std::map<std::pair<long, long>, std::array<double, 4>> found;
    const FrameGroup& fluid = *group_of(frame, "fluid");
    const FrameField& velocity = *field_of(fluid, "velocity");
    for (std::size_t k = 0; k < fluid.size(); ++k) {
        const Vec& drawn = made.particles.position[static_cast<std::size_t>(fluid.id[k])];
        found[{std::lround(std::floor(10 * drawn[0])), std::lround(std::floor(10 * drawn[1]))}] = {
            fluid.position[3 * k], fluid.position[3 * k + 1], velocity.values[3 * k], velocity.values[3 * k + 1]};
    }
    return found;
}

TEST(Symmetry, half_a_channel_flows_as_the_whole_does) {
    const auto channel = [](int rows, bool has_floor) {
        WalledWater made(6, rows, {"wall"}, [=](int column, int row) {
            if (column < 0 || column >= 6) return 0;
            return row >= rows || (has_floor && row < 0) ? 1 : 0;
        });
        made.make_periodic(0);
        made.scene.flow.acceleration[0] = formula_of("1");
        made.scene.parts[0].viscosity = 500.0;
        return made;
    };
    WalledWater whole = channel(12, true), half = channel(6, false);
    // The whole one's middle at y = 0.
    for (Vec& position : whole.particles.position) position[1] -= 0.6;
    whole.particles.box.low[1] -= 0.6;
    whole.particles.box.high[1] -= 0.6;
    half.mirror({BoxSide::y_low});
    KeptFrames kept_whole, kept_half;
    const RunSummary of_whole = run_of(whole, &kept_whole), of_half = run_of(half, &kept_half);
    const auto expected = by_position(whole, kept_whole.frames.back());
    const auto found = by_position(half, kept_half.frames.back());
    EXPECT_EQ(found.size(), 36U);
    for (const auto& [position, values] : found)
        for (int k = 0; k < 4; ++k) EXPECT_NEAR(values[k], expected.at(position)[k], 1e-6);
    EXPECT_NEAR(2 * of_half.end.momentum[0], of_whole.end.momentum[0], 1e-9 * of_whole.end.momentum[0]);
    EXPECT_GT(of_half.end.momentum[0], 10);
    EXPECT_LT(of_half.momentum_residual, 1e-12);
}

TEST(Symmetry, a_cell_between_four_planes_turns_as_in_the_endless_lattice) {
    const WalledWater cell = vortex(true), period = vortex(false);
    KeptFrames kept_cell, kept_period;
    const RunSummary of_cell = run_of(cell, &kept_cell);
    run_of(period, &kept_period);
    const auto expected = by_position(period, kept_period.frames.back()),
               found = by_position(cell, kept_cell.frames.back());
    EXPECT_EQ(found.size(), 100U);
    double fastest = 0;
    for (const auto& [position, values] : found) {
        for (int k = 0; k < 4; ++k) EXPECT_NEAR(values[k], expected.at(position)[k], 1e-5);
        fastest = std::max(fastest, std::hypot(values[2], values[3]));
    }
    EXPECT_GT(fastest, 0.5);
    EXPECT_LT(fastest, 3);
    EXPECT_EQ(of_cell.lost, 0U);
}

TEST(Symmetry, goes_on_from_a_checkpoint_with_the_same_bits) {
    const auto folder = std::filesystem::path(testing::TempDir()) / "dmp_symmetry";
    std::filesystem::remove_all(folder);
    KeptFrames kept;
    const WalledWater made = vortex(true);
    EXPECT_EQ(run_in_two_parts(made, folder).state_hash, run_of(made, &kept).state_hash);
    std::filesystem::remove_all(folder);
}

TEST(Symmetry, of_a_drawing_leaves_its_side_open) {
    // The Poiseuille case's lower wall out of use, and a plane in its place.
    const auto made =
        case_of("verification/couette", {"part.wall.enabled=false", "flow.symmetry=[\"y_low\"]",
                                         "part.lid.surface_velocity=[0, 0]", "flow.acceleration=[\"1e-4 m/s^2\", 0]"});
    EXPECT_TRUE(made.particles.mirrored[1][0]);
    EXPECT_FALSE(made.particles.mirrored[1][1]);
    EXPECT_EQ(made.particles.count(PartKind::fluid), 20U * 8);
    EXPECT_EQ(made.particles.count(PartKind::rigid), 3U * 8);
    for (const Vec& position : made.particles.position) EXPECT_GT(position[1], 0);
    EXPECT_EQ(made.particles.box.low[1], 0);
}

TEST(Symmetry, is_told_by_explain) {
    const WalledWater made = vortex(true);
    std::size_t planes = 0;
    for (const ModelUse& model : Simulation(made.scene, made.particles, 1).plan().models)
        planes += model.model.starts_with("plane of symmetry at ") ? 1 : 0;
    EXPECT_EQ(planes, 4U);
}

}  // namespace
}  // namespace dmp::tests::solver_symmetry_tests
