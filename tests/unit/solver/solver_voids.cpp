// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
//
// Voids that open in a liquid without a free surface.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <unistd.h>

#include "models/sph/void_closing.hpp"
#include "solver/monitor/void_monitor.hpp"
#include "tests/modules.hpp"
#include "tests/unit/solver/small_scenes.hpp"
#include "tests/unit/solver/water_beside_a_block.hpp"
#include "tests/unit/thrown.hpp"

namespace dmp::tests::solver_voids_tests {
namespace {

using testing::AllOf;
using testing::ContainsRegex;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::SizeIs;

TEST(Voids, open_behind_a_block_that_moves_faster_than_water_can_follow) {
    EXPECT_THAT(voids_of(run_of(water_beside_a_block(0.1))), IsEmpty());
    // At x < 0.4 m, where the block was, and y < 0.7 m.
    EXPECT_THAT(voids_of(run_of(water_beside_a_block(2))),
                ElementsAre(AllOf(ContainsRegex(R"(of 'water' at \(0\.[0-3][0-9]* m, 0\.[0-6][0-9]* m\))"),
                                  HasSubstr("particles.spacing of 0.1 m is too large"), HasSubstr("Suction closes it"),
                                  HasSubstr("compare with a smaller spacing"))));
}

/// By the mean corrections of the fluid's first particles; all others have `usual`.
bool finds_void(int dimension, const std::vector<double>& corrections, double usual = 1.02) {
    WalledWater made(3, 3, {}, [](int, int) { return 0; });
    made.scene.dimension = made.particles.dimension = dimension;
    made.particles.box.high[2] = dimension == 3 ? 1 : 0;
    ParticleStore store(made.particles, {1000});
    ParticleGroup& fluid = store.fluid();
    fluid.declare({Field::mean_correction});
    std::fill_n(fluid.data(Field::mean_correction), fluid.owned(), usual);
    std::ranges::copy(corrections, fluid.data(Field::mean_correction));
    VoidMonitor voids(made.scene, {.watches = true, .closes = true});
    const bool found = voids.look(store, Ranks::alone(), 0.5).has_value();
    EXPECT_EQ(found, voids.text().starts_with("a void opened in the fluid by 0.5 s, at particle "));
    return found;
}

TEST(Voids, are_where_three_particles_lack_neighbours) {
    for (const int dimension : {2, 3}) {
        EXPECT_FALSE(finds_void(dimension, {}));
        EXPECT_FALSE(finds_void(dimension, {1.6, 1.6, 1.3}));
        EXPECT_TRUE(finds_void(dimension, {1.6, 1.6, 1.36}));
        // Too few for a correction: that is 1 then.
        EXPECT_FALSE(finds_void(dimension, {1, 1}));
        EXPECT_TRUE(finds_void(dimension, {1, 1, 1}));
        constexpr double no_number = std::numeric_limits<double>::quiet_NaN();
        EXPECT_FALSE(finds_void(dimension, {no_number, no_number, no_number}));
    }
}

/// The largest distance between a place where the block has been and the nearest particle of a frame [m].
double largest_hole(const Frame& frame) {
    double largest = 0;
    for (double x = spacing / 2; x < 4 * spacing; x += spacing / 4)
        for (double y = spacing / 2; y < 6 * spacing; y += spacing / 4) {
            double nearest = std::numeric_limits<double>::infinity();
            for (const FrameGroup& group : frame.groups)
                for (std::size_t k = 0; k < group.size(); ++k)
                    nearest = std::min(nearest, std::hypot(group.position[3 * k] - x, group.position[3 * k + 1] - y));
            largest = std::max(largest, nearest);
        }
    return largest;
}

TEST(Voids, are_pulled_at_by_three_deviations_of_the_pressure) {
    EXPECT_EQ(models::VoidClosing::time(0.3, 15), 0.2);
    EXPECT_EQ(models::VoidClosing::suction(0, 2, 10, 0.1), 0) << "two particles are no void";
    EXPECT_DOUBLE_EQ(models::VoidClosing::suction(0, 3, 10, 0.1), 3);
    EXPECT_DOUBLE_EQ(models::VoidClosing::suction(20, 3, 10, 0.1), 21);
    EXPECT_EQ(models::VoidClosing::suction(20, 3, 10, 5), 30);
    EXPECT_DOUBLE_EQ(models::VoidClosing::suction(20, 0, 10, 0.1), 18) << "closed: it fades";
    EXPECT_EQ(models::VoidClosing::suction(0.011, 0, 10, 0.1), 0) << "a thousandth of a deviation";
    EXPECT_EQ(models::VoidClosing::suction(20, 0, 0, 0.1), 0) << "of pressures that are alike";
}

TEST(Voids, are_closed_by_the_water_around_them) {
    WalledWater made = water_beside_a_block(2);
    made.scene.run.duration = made.scene.output.every = 1.2;
    KeptFrames kept;
    static_cast<void>(run_of(made, &kept));  // it diverges without suction
    EXPECT_LT(largest_hole(kept.frames.back()), spacing);
}

TEST(Voids, are_in_the_state_of_a_run_that_is_resumed) {
    WalledWater made = water_beside_a_block(2);
    made.scene.output.every = 0.35;  // while suction closes it
    made.scene.run.duration = 0.6;
    const auto folder = std::filesystem::temp_directory_path() / ("dmp_voids_" + std::to_string(::getpid()));
    const RunSummary whole = run_of(made), parts = run_in_two_parts(made, folder);
    EXPECT_THAT(voids_of(whole), SizeIs(1));
    EXPECT_EQ(voids_of(parts), voids_of(whole));
    EXPECT_EQ(parts.state_hash, whole.state_hash);
    std::filesystem::remove_all(folder);
}

TEST(Voids, are_a_likely_cause_of_a_run_that_diverges_where_no_other_is_known) {
    WalledWater made = water_beside_a_block(2);
    ParticleSet& set = made.particles;
    for (std::size_t i = 0; i < set.size(); ++i)  // no surface on its left: water there is behind that on its right
        if (set.part[i] == 2 && set.wall_normal[i][0] < 0) {
            set.wall_normal[i] = Vec(1, 0, 0);
            set.wall_distance[i] = 4 * spacing - set.position[i][0];
        }
    made.scene.run.duration = 0.7;
    EXPECT_THAT(text_thrown<DivergenceError>([&] { (void)run_of(made); }),
                ContainsRegex("likely causes: a void opened in the fluid by 0\\.[0-9]+ s, .*; or a wall there"));
    // All of the water is too fast: that is the cause, of the void as well.
    EXPECT_THAT(text_thrown<DivergenceError>([&] { (void)run_of(water_beside_a_block(4)); }),
                AllOf(HasSubstr("likely cause: flow.largest_speed"), Not(HasSubstr("a void"))));
}

TEST(Voids, are_not_looked_for_in_water_with_a_free_surface) {
    WalledWater made = water_beside_a_block(2);
    ParticleSet& set = made.particles;
    for (std::size_t i = 0; i < set.size(); ++i)  // without the lid
        if (set.part[i] == 1 && set.position[i][1] > 0.8) set.position[i][1] += 1;
    set.box.high[1] += 1;
    EXPECT_THAT(voids_of(run_of(made)), IsEmpty());
}

}  // namespace
}  // namespace dmp::tests::solver_voids_tests
