// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Forces on parts and soft shapes: their laws against closed forms.
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "tests/modules.hpp"
#include "tests/unit/solver/driven_scenes.hpp"

namespace dmp::tests::solver_forcing_tests {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

TEST(ScheduleWindow, acts_from_until_and_again) {
    const ScheduleWindow always, once{1, 3, 0}, again{1, 1.5, 2};
    EXPECT_TRUE(always.acts(0));
    EXPECT_EQ(always.next_change(5), infinity);
    EXPECT_FALSE(once.acts(0.999));
    EXPECT_TRUE(once.acts(1));
    EXPECT_FALSE(once.acts(3));
    EXPECT_EQ(once.next_change(0), 1);
    EXPECT_EQ(once.next_change(1), 3);
    EXPECT_EQ(once.next_change(3), infinity);
    EXPECT_FALSE(again.acts(0.5));
    EXPECT_TRUE(again.acts(5.25));
    EXPECT_FALSE(again.acts(4.75));
    EXPECT_EQ(again.next_change(1.25), 1.5);
    EXPECT_EQ(again.next_change(1.5), 3);
    EXPECT_EQ(again.next_change(3), 3.5);
    // The last bit of a cycle's start must not lose it.
    const ScheduleWindow tenths{0, 0.05, 0.1};
    double t = 0;
    for (int change = 0; change < 2000; ++change) {
        const double next = tenths.next_change(t);
        ASSERT_GT(next, t);
        EXPECT_EQ(tenths.acts(t), change % 2 == 0) << t;
        t = next;
    }
    EXPECT_NEAR(t, 100, 1e-9);
}

TEST(SoftRepulsion, is_the_slope_of_its_energy_and_ends_softly) {
    const SoftRepulsion law{3, 0.5};
    EXPECT_EQ(law.force(0), 6);
    EXPECT_EQ(law.force(-1), 6);
    EXPECT_EQ(law.force(0.5), 0);
    EXPECT_NEAR(law.force(0.25), 3, 1e-15);
    EXPECT_NEAR(law.energy(0), 3 * 0.5, 1e-15) << "K r*: what it takes to come through";
    constexpr double h = 1e-6;
    for (const double d : {-0.3, -0.01, 0.02, 0.2, 0.4, 0.49, 0.6})
        EXPECT_NEAR(law.force(d), -(law.energy(d + h) - law.energy(d - h)) / (2 * h), 1e-8) << d;
    // The stiffest place is the middle: pi K / r*.
    const double stiffness = -(law.force(0.25 + h) - law.force(0.25 - h)) / (2 * h);
    EXPECT_NEAR(law.step_limit(2), 0.5 * 2 / std::sqrt(stiffness / 2), 1e-9);
}

TEST(ParabolaArc, finds_the_nearest_of_its_points) {
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> number(-1, 1);
    for (const double height : {0.1, 2.0, -1.5, 40.0}) {
        const ParabolaArc arc{1.5, height, ShapeSide::both};
        for (int k = 0; k < 200; ++k) {
            const Vec point(3 * number(random), 4 * number(random), number(random));
            const FromShape found = arc.from(point);
            double sampled = infinity;
            for (int n = -4000; n <= 4000; ++n) {
                const double x = 1.5 * n / 4000;
                sampled = std::min(sampled, std::hypot(point[0] - x, point[1] - height * std::pow(x / 1.5, 2)));
            }
            EXPECT_LE(found.distance, sampled + 1e-12);
            EXPECT_GE(found.distance, sampled - 0.02 * std::max(1.0, std::abs(height)) * sampled - 1e-3);
            EXPECT_NEAR(found.away.norm(), 1, 1e-14);
            // The way back leads onto the arc.
            const Vec foot = point - found.distance * found.away;
            EXPECT_NEAR(foot[1], height * std::pow(foot[0] / 1.5, 2), 1e-9 * (1 + std::abs(height)));
            EXPECT_LE(std::abs(foot[0]), 1.5 + 1e-12);
        }
    }
}

TEST(ParabolaArc, pushes_back_from_behind_where_it_has_one_side) {
    const ParabolaArc both{1, 1, ShapeSide::both}, inside{1, 1, ShapeSide::inside}, outside{1, 1, ShapeSide::outside};
    const Vec above(0, 0.2, 0), below(0, -0.2, 0);
    EXPECT_NEAR(both.from(above).distance, 0.2, 1e-15);
    EXPECT_NEAR(both.from(below).distance, 0.2, 1e-15);
    EXPECT_EQ(both.from(below).away[1], -1);
    EXPECT_NEAR(inside.from(above).distance, 0.2, 1e-15);
    EXPECT_NEAR(inside.from(below).distance, -0.2, 1e-15);
    EXPECT_EQ(inside.from(below).away[1], 1) << "back in";
    EXPECT_NEAR(outside.from(above).distance, -0.2, 1e-15);
    EXPECT_EQ(outside.from(above).away[1], -1);
    EXPECT_EQ(inside.from(Vec::Zero()).away, Vec(0, 1, 0));
    EXPECT_EQ(outside.from(Vec::Zero()).away, Vec(0, -1, 0));
    EXPECT_GT(inside.from(Vec(4, 0, 0)).distance, 0) << "beyond its end there is no behind";
    const ParabolaArc downward{1, -1, ShapeSide::inside};
    EXPECT_NEAR(downward.from(Vec(0, -0.2, 0)).distance, 0.2, 1e-15);
    EXPECT_NEAR(downward.from(Vec(0, 0.2, 0)).distance, -0.2, 1e-15);
}

TEST(Circle, pushes_to_the_side_it_has) {
    EXPECT_NEAR((Circle{2, ShapeSide::both}.from(Vec(1.5, 0, 7)).distance), 0.5, 1e-15);
    EXPECT_EQ((Circle{2, ShapeSide::both}.from(Vec(1.5, 0, 7)).away), Vec(-1, 0, 0));
    EXPECT_EQ((Circle{2, ShapeSide::both}.from(Vec(0, 2.5, 0)).away), Vec(0, 1, 0));
    EXPECT_NEAR((Circle{2, ShapeSide::outside}.from(Vec(1.5, 0, 0)).distance), -0.5, 1e-15);
    EXPECT_EQ((Circle{2, ShapeSide::outside}.from(Vec(1.5, 0, 0)).away), Vec(1, 0, 0));
    EXPECT_NEAR((Circle{2, ShapeSide::inside}.from(Vec(2.5, 0, 0)).distance), -0.5, 1e-15);
}

TEST(MovingShape, carries_a_mass_that_swings_in_it_as_a_pendulum) {
    // At rest the bead hangs at the distance d0 with f(d0) = 20 N. Seen from the parabola, it swings on the parallel
    // curve, of radius 1 / (2 c) - d0 at the vertex: omega^2 = g / (1 / 2 - d0). Started at rest it is carried along:
    // x = v t - v / omega sin(omega t).
    const DrivenBead made = bead_in_a_parabola();
    const Driving driving(made.scene, made.particles, made.particles);
    const double d0 = 0.1 / std::numbers::pi * std::acos(20.0 / 50 - 1), v = 0.3;
    Vec x(0, d0, 0), speed = Vec::Zero();
    const double omega = std::sqrt(10 / (0.5 - d0)), period = 2 * std::numbers::pi / omega;
    const double dt = period / 40000;
    EXPECT_LT(dt, driving.step_limit(1, 0));
    double largest = 0, t = 0;
    const auto kick = [&] { speed += 0.5 * dt / 2 * driving.force(0, x, t); };
    for (int step = 0; step < 3 * 40000; ++step) {
        kick();
        x += dt * speed;
        t += dt;
        kick();
        largest = std::max(largest, std::abs(x[0] - (v * t - v / omega * std::sin(omega * t))));
    }
    // Anharmonic terms go with the square of the swing over the radius, (0.06 / 0.45)^2.
    EXPECT_LT(largest, 0.02 * 3 * v * period);
    EXPECT_NEAR(x[0] / t, v, 0.02 * v) << "as fast as the shape, on average";
    EXPECT_EQ(x[2], 0);
}

TEST(MovingShape, at_rest_keeps_the_energy_of_what_it_pushes) {
    DrivenBead made = bead_in_a_parabola();
    made.scene.moving_shapes[0].position = std::array<Expression, 3>{};
    const Driving driving(made.scene, made.particles, made.particles);
    Vec x(0.3, 0.4, 0), speed(0.5, 0, 0.1);
    constexpr double dt = 1e-5;
    const auto energy = [&] { return speed.squaredNorm() + 20 * x[1] + driving.energy(0, x, 0); };
    const double before = energy();
    double most = 0;
    Vec force = driving.force(0, x, 0);
    for (int step = 0; step < 200000; ++step) {
        speed += 0.25 * dt * force;
        x += dt * speed;
        force = driving.force(0, x, 0);
        speed += 0.25 * dt * force;
        most = std::max(most, std::abs(energy() - before));
    }
    EXPECT_LT(most, 1e-6 * before);
}

TEST(MovingShape, is_felt_by_its_parts_alone_and_across_a_period) {
    DrivenBead made = bead_in_a_parabola();
    made.particles.parts.push_back({"other", PartKind::spheres});
    made.particles.periodic = {true, false, false};  // of 2 m
    const Driving driving(made.scene, made.particles, made.particles);
    const Vec near(0, 0.05, 0);
    EXPECT_GT(driving.force(0, near, 0)[1], 0);
    EXPECT_EQ(driving.force(1, near, 0), Vec::Zero());
    for (const double t : {1.0, 5.0, 20.0}) {
        const double vertex = 0.3 * t, image = vertex - 2 * std::round(vertex / 2);
        EXPECT_NEAR((driving.force(0, Vec(image, 0.05, 0), t) - driving.force(0, near, 0)).norm(), 0, 1e-12);
    }
}

}  // namespace
}  // namespace dmp::tests::solver_forcing_tests
