// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/winding_number.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "geometry/winding_vote.hpp"
#include "tests/modules.hpp"
#include "tests/unit/geometry/surface_shapes.hpp"

namespace dmp::tests::winding_number_tests {
namespace {

TEST(SolidAngle, of_an_octant_is_half_pi) {
    const std::array<Vec, 3> triangle{Vec(1, 0, 0), Vec(0, 1, 0), Vec(0, 0, 1)};
    EXPECT_NEAR(solid_angle(Vec(0, 0, 0), triangle), 0.5 * std::numbers::pi, 1e-15);
    EXPECT_NEAR(solid_angle(Vec(0, 0, 0), {triangle[1], triangle[0], triangle[2]}), -0.5 * std::numbers::pi, 1e-15);
    // Just behind a large triangle, which hides half of all that is seen.
    EXPECT_NEAR(solid_angle(Vec(1.0 / 3, 1.0 / 3, 1.0 / 3 - 1e-9), triangle), 2 * std::numbers::pi, 1e-7);
}

TEST(WindingNumber, is_one_inside_and_none_outside) {
    const TriangleSurface surface = cube();
    const WindingNumber fast(surface);
    for (const Vec& point : {Vec(0.5, 0.5, 0.5), Vec(0.001, 0.999, 0.5), Vec(0.1, 0.1, 0.9)}) {
        EXPECT_NEAR(winding_number(surface, point), 1, 1e-14);
        EXPECT_NEAR(fast.at(point), 1, 1e-14);
        EXPECT_TRUE(fast.inside(point));
    }
    for (const Vec& point : {Vec(1.5, 0.5, 0.5), Vec(0.5, -0.001, 0.5), Vec(-7, 0.1, 9)}) {
        EXPECT_NEAR(winding_number(surface, point), 0, 1e-13);
        EXPECT_NEAR(fast.at(point), 0, 1e-3);
    }
}

TEST(WindingNumber, counts_bodies_within_each_other_and_hollows) {
    TriangleSurface nested = box({0, 0, 0}, {3, 3, 3});
    append(nested, box({1, 1, 1}, {2, 2, 2}));
    EXPECT_NEAR(winding_number(nested, Vec(1.5, 1.5, 1.5)), 2, 1e-14);
    for (std::size_t t = 12; t < 24; ++t) flip(nested, t);
    EXPECT_NEAR(winding_number(nested, Vec(1.5, 1.5, 1.5)), 0, 1e-14);
    EXPECT_NEAR(winding_number(nested, Vec(0.5, 1.5, 1.5)), 1, 1e-14);
}

TEST(WindingNumber, loses_the_share_that_a_hole_is_seen_under) {
    TriangleSurface open = cube();
    open.triangles.resize(10);  // without the side x = 1: a sixth of all directions from the middle
    EXPECT_NEAR(winding_number(open, Vec(0.5, 0.5, 0.5)), 5.0 / 6, 1e-14);
    EXPECT_NEAR(winding_number(open, Vec(1, 0.5, 0.5)), 0.5, 1e-14) << "in the middle of the hole";
}

TEST(WindingNumber, of_dipoles_is_near_that_of_triangles) {
    TriangleSurface surface = ball(32);
    std::erase_if(surface.triangles, [&](const auto& triangle) {
        return surface.corners[static_cast<std::size_t>(triangle[0])].z() > 0.9;
    });
    append(surface, box({0.9, 0.9, 0.9}, {1.5, 1, 1.2}));
    const WindingNumber fast(surface), careful(surface, 8);
    std::mt19937 random(3);
    std::uniform_real_distribution<double> position(-1.5, 1.5);
    double largest = 0, largest_careful = 0;
    for (int k = 0; k < 1000; ++k) {
        const Vec point(position(random), position(random), position(random));
        const double exact = winding_number(surface, point);
        largest = std::max(largest, std::abs(fast.at(point) - exact));
        largest_careful = std::max(largest_careful, std::abs(careful.at(point) - exact));
    }
    RecordProperty("largest_error", std::to_string(largest));
    RecordProperty("largest_error_careful", std::to_string(largest_careful));
    EXPECT_LT(largest, 0.02);
    EXPECT_LT(largest_careful, 0.002);
    EXPECT_LT(largest_careful, largest);
    EXPECT_EQ(WindingNumber(TriangleSurface{}).at(Vec(0, 0, 0)), 0);
}

TEST(WindingVote, knows_the_volume_and_doubts_large_holes) {
    const WindingVote closed = vote_on(cube());
    EXPECT_NEAR(closed.volume, 1, 1e-12);
    EXPECT_EQ(closed.doubt, 0);
    const WindingVote round = vote_on(ball(16));
    EXPECT_NEAR(round.volume, ball(16).enclosed_volume(), 0.01 * round.volume);
    TriangleSurface open = cube();
    open.triangles.resize(10);
    EXPECT_GT(vote_on(open).doubt, 0.2);
}

TEST(TurnOpenPieces, turns_each_piece_by_its_own_vote) {
    TriangleSurface surface = box({0, 0, 0}, {4, 4, 4});
    append(surface, box({1, 1, 1}, {2, 2, 2}));     // a hollow
    append(surface, box({9, 9, 9}, {10, 10, 10}));  // beside
    surface.triangles.erase(surface.triangles.begin() + 35);
    surface.triangles.erase(surface.triangles.begin() + 23);
    surface.triangles.erase(surface.triangles.begin() + 11);
    for (std::size_t t = 0; t < 11; ++t) flip(surface, t);
    for (std::size_t t = 22; t < 33; ++t) flip(surface, t);
    EXPECT_TRUE(turn_open_pieces(surface).empty());
    EXPECT_GT(winding_number(surface, Vec(0.5, 0.5, 0.5)), 0.75);
    EXPECT_LT(winding_number(surface, Vec(1.4, 1.5, 1.5)), 0.25);
    EXPECT_GT(winding_number(surface, Vec(9.4, 9.5, 9.5)), 0.75);
    TriangleSurface sheet;
    sheet.corners = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0.1}};
    sheet.triangles = {{0, 1, 2}, {0, 2, 3}};
    EXPECT_EQ(turn_open_pieces(sheet), (std::vector<int>{0, 1}));
}

}  // namespace
}  // namespace dmp::tests::winding_number_tests
