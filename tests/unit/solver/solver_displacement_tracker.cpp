// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "solver/neighbours/displacement_tracker.hpp"
#include "tests/modules.hpp"

namespace dmp::tests::solver_displacement_tracker_tests {
namespace {

using Coordinates = std::vector<std::array<double, 3>>;

Positions positions_of(const Coordinates& x, int dimension) {
    const double* first = x.data()->data();
    return {x.size(), dimension, {first, first + 1, first + 2}, 3};
}

/// Axis by axis.
struct SideBySide {
    std::array<std::vector<double>, 3> axes;
    explicit SideBySide(const Coordinates& x) {
        for (const auto& position : x)
            for (std::size_t axis = 0; axis < 3; ++axis) axes[axis].push_back(position[axis]);
    }
    [[nodiscard]] Positions positions(int dimension) const {
        return {axes[0].size(), dimension, {axes[0].data(), axes[1].data(), axes[2].data()}, 1};
    }
};

Coordinates anywhere(std::size_t count, double low, double high) {
    std::mt19937 random(4);
    std::uniform_real_distribution<double> coordinate(low, high);
    Coordinates x(count);
    for (auto& position : x) position = {coordinate(random), coordinate(random), coordinate(random)};
    return x;
}

TEST(ReferencePositions, tell_how_far_the_farthest_has_gone) {
    for (const int dimension : {2, 3})
        for (const std::size_t count : {1U, 31U, 32U, 100U})
            for (const std::size_t goes : {std::size_t{0}, count / 2, count - 1})
                for (const int threads : {1, 3}) {
                    Coordinates x = anywhere(count, 7, 8);
                    ReferencePositions then;
                    then.take(positions_of(x, dimension), threads);
                    EXPECT_LT(then.farthest_gone(positions_of(x, dimension), threads), 1e-6);
                    for (auto& position : x) position[1] += 1e-4;
                    x[goes] = {x[goes][0] - 3e-3, x[goes][1] + 4e-3 - 1e-4, x[goes][2] + 12e-3};
                    const double way = dimension == 3 ? 13e-3 : 5e-3;
                    const double found = then.farthest_gone(positions_of(x, dimension), threads);
                    EXPECT_GE(found, way - 1e-15);  // a last bit of the places themselves
                    EXPECT_LT(found, way + 1e-6);
                    EXPECT_DOUBLE_EQ(then.farthest_gone(SideBySide(x).positions(dimension), threads), found);
                }
}

/// Far from the origin too: floats have six digits, and count from the first particle.
TEST(ReferencePositions, never_tell_less_than_was_gone) {
    Coordinates x = anywhere(1000, 1e3, 1e3 + 50);
    ReferencePositions then;
    then.take(positions_of(x, 3), 1);
    for (double way = 1e-9; way < 1; way *= 10) {
        Coordinates gone = x;
        for (auto& position : gone) position[0] += way;
        const double found = then.farthest_gone(positions_of(gone, 3), 1);
        EXPECT_GE(found, way);
        EXPECT_LT(found, way + 5e-5);
    }
}

/// What all do together does not count; and each has its own measure.
TEST(ReferencePositions, tell_the_largest_share_of_a_length_of_each_ones_own) {
    Coordinates x = anywhere(50, 0, 1);
    ReferencePositions then;
    then.take(positions_of(x, 3), 2);
    for (auto& position : x) position = {position[0] + 0.5, position[1] - 0.25, position[2] + 2};
    x[3][0] += 0.02;
    x[40][2] -= 0.01;
    std::vector<float> inverse_squares(x.size(), 100);
    inverse_squares[40] = 2500;
    Positions now = positions_of(x, 3);
    now.common = {0.5, -0.25, 2};
    EXPECT_NEAR(then.farthest_gone(now, 2), 0.02, 1e-6);
    EXPECT_NEAR(then.farthest_gone(now, 2, inverse_squares, 0.02), 0.5, 1e-4);
}

TEST(ReferencePositions, of_what_is_no_number_are_infinitely_far) {
    Coordinates x = anywhere(40, 0, 1);
    ReferencePositions then;
    then.take(positions_of(x, 2), 1);
    for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        Coordinates broken = x;
        broken[17][1] = bad;
        EXPECT_EQ(then.farthest_gone(positions_of(broken, 2), 2), std::numeric_limits<double>::infinity());
    }
    then.take({}, 1);
    EXPECT_EQ(then.farthest_gone({}, 2), 0);
    EXPECT_THROW((void)then.farthest_gone(positions_of(x, 2), 1), std::logic_error);
}

TEST(DisplacementTracker, is_measured_only_where_its_bound_says_too_far) {
    DisplacementTracker displacement;
    int measured = 0;
    double gone = 0.1;
    const auto beyond = [&] {
        return displacement.beyond(1, [&] {
            ++measured;
            return gone;
        });
    };
    displacement.add(0.9);
    EXPECT_FALSE(beyond());
    EXPECT_EQ(measured, 0);
    displacement.add(0.2);
    EXPECT_FALSE(beyond());
    EXPECT_EQ(measured, 1);
    EXPECT_DOUBLE_EQ(displacement.farthest(), 0.1) << "from here on the bound grows anew";
    displacement.add(0.89);
    EXPECT_FALSE(beyond());
    displacement.add(0.02);
    gone = 0.85;
    EXPECT_TRUE(beyond()) << "so little is left that measuring again would not pay";
    gone = 0;
    EXPECT_TRUE(beyond()) << "once too far is too far";
    EXPECT_EQ(measured, 2);
    displacement.start();
    EXPECT_FALSE(beyond());
    EXPECT_EQ(displacement.farthest(), 0);
}

}  // namespace
}  // namespace dmp::tests::solver_displacement_tracker_tests
