// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "base/simd/lanes.hpp"
#include "models/contact/repulsion.hpp"
#include "models/springs/bond_force.hpp"
#include "models/springs/hinge_force.hpp"
#include "tests/modules.hpp"

namespace dmp::tests::solver_spring_laws_tests {
namespace {

using V2 = Vector<double, 2>;
constexpr double pi = std::numbers::pi;

using Hinge2 = HingeForce<2>;

/// Force on x_a of a bond along this separation.
V2 law(const BondForce<2>& bond, const V2& separation, const V2& velocity) {
    const auto from_rest = bond.deviation({separation});
    return -bond.tension(from_rest, {velocity}) * from_rest.gradient[0];
}
double energy(const BondForce<2>& bond, double length) { return bond.energy(bond.deviation({V2{{length, 0}}}).value); }

struct Arm {
    V2 reach, velocity;
};
struct HingeForces {
    V2 on_a, on_b;
};
HingeForces law(const Hinge2& hinge, const Arm& a, const Arm& b) {
    const auto from_rest = hinge.deviation({a.reach, b.reach});
    const double moment = hinge.tension(from_rest, {a.velocity, b.velocity});
    return {-moment * from_rest.gradient[0], -moment * from_rest.gradient[1]};
}
double deviation(const Hinge2& hinge, const V2& a, const V2& b) { return hinge.deviation({a, b}).value; }
double energy(const Hinge2& hinge, const V2& a, const V2& b) { return hinge.energy(deviation(hinge, a, b)); }

V2 polar(double length, double angle) { return {{length * std::cos(angle), length * std::sin(angle)}}; }

TEST(Repulsion, pushes_apart_inside_its_range_and_is_zero_at_and_beyond_it) {
    const Repulsion law{2.5};
    const double range = 0.5;
    const V2 direction = polar(1, 0.7);
    EXPECT_GT(dot(law.law(0.4 * direction, range), direction), 0);
    for (const double r : {0.5, 0.500001, 0.7, 100.0}) {
        const auto force = law.law(r * V2{{1, 0}}, range);
        EXPECT_EQ(force[0], 0) << r;
        EXPECT_EQ(force[1], 0) << r;
    }
}

TEST(Repulsion, one_pair_by_hand) {
    // r* / r = 2: F = K (2^12 - 2^6) / r
    const auto force = Repulsion{3}.law(V2{{0, -0.25}}, 0.5);
    EXPECT_EQ(force[0], 0);
    EXPECT_NEAR(force[1], -3 * (4096 - 64) / 0.25, 1e-9);
}

TEST(Repulsion, force_is_the_slope_of_its_energy) {
    const Repulsion law{2.5};
    const double range = 0.5, d = 1e-7;
    for (const double r : {0.3, 0.4, 0.45, 0.499}) {
        const double slope = -(law.energy(r + d, range) - law.energy(r - d, range)) / (2 * d);
        EXPECT_NEAR(law.law(V2{{r, 0}}, range)[0], slope, 1e-5 * std::abs(slope) + 1e-6) << r;
    }
    EXPECT_EQ(law.energy(0.5, range), 0);
    EXPECT_EQ(law.energy(0.6, range), 0);
    EXPECT_NEAR(law.energy(0.5 - 1e-9, range), 0, 1e-12);  // no jump at the cut
}

TEST(Repulsion, pairs_without_contact_stay_finite_even_at_the_same_place) {
    for (const double r : {0.0, 1e-300, 0.1}) {
        const auto force = Repulsion{2.5}.law(V2{{r, 0}}, 0.0);
        EXPECT_EQ(force[0], 0) << r;
        EXPECT_EQ(force[1], 0) << r;
    }
}

TEST(Repulsion, does_the_same_on_lanes) {
    const Repulsion law{2.5};
    Vector<Lanes, 2> separation{};
    for (std::size_t k = 0; k < Lanes::width; ++k) {
        separation[0].set(k, 0.1 * static_cast<double>(k));
        separation[1].set(k, 0.2);
    }
    const auto force = law.law(separation, Lanes(0.5));
    for (std::size_t k = 0; k < Lanes::width; ++k) {
        const auto expected = law.law(V2{{separation[0][k], 0.2}}, 0.5);
        for (int a = 0; a < 2; ++a)
            EXPECT_NEAR(force[a][k], expected[a], 1e-13 * std::abs(expected[a])) << "lane " << k;
    }
}

TEST(Repulsion, step_limit_is_that_of_the_stiffness_at_touch) {
    const Repulsion law{2.5};
    const double range = 0.5, mass = 0.02, d = 1e-6;
    const double stiffness = (law.law(V2{{range - d, 0}}, range)[0]) / d;
    const double omega = std::sqrt(2 * stiffness / mass);  // both sides free
    EXPECT_NEAR(law.step_limit(range, mass), 2 / omega, 2e-4 / omega);
}

TEST(BondForce, is_the_slope_of_its_energy) {
    const BondForce<2> bond(0.2, 50, 0, 0.01);
    for (const double length : {0.1, 0.19, 0.2, 0.23, 0.6}) {
        const double d = 1e-7, slope = -(energy(bond, length + d) - energy(bond, length - d)) / (2 * d);
        const auto force = law(bond, polar(length, 0.9), {{0, 0}});
        EXPECT_NEAR(force[0], slope * std::cos(0.9), 1e-6);
        EXPECT_NEAR(force[1], slope * std::sin(0.9), 1e-6);
    }
    EXPECT_NEAR(law(bond, {{0.23, 0}}, {{0, 0}})[0], -2 * 50 * 0.03, 1e-12);  // no 1/2 in the energy
}

TEST(BondForce, dashpot_is_the_asked_fraction_of_critical_and_acts_along_the_bond) {
    const double k = 50, zeta = 0.07, reduced_mass = 0.01;
    const BondForce<2> bond(0.2, k, zeta, reduced_mass);
    // omega = sqrt(2 k / m), critical c = 2 m omega
    EXPECT_NEAR(bond.dashpot, zeta * 2 * reduced_mass * std::sqrt(2 * k / reduced_mass), 1e-14);
    const V2 along = polar(1, 0.4), across = polar(1, 0.4 + pi / 2);
    const auto braked = law(bond, 0.2 * along, 3.0 * along);
    EXPECT_NEAR(dot(braked, along), -3 * bond.dashpot, 1e-12);
    EXPECT_NEAR(dot(braked, across), 0, 1e-12);
    const auto turning = law(bond, 0.2 * along, 3.0 * across);
    EXPECT_NEAR(turning[0], 0, 1e-12);
    EXPECT_NEAR(turning[1], 0, 1e-12);
}

struct HingeCase {
    double rest, angle;  ///< [rad]
};

class HingeForceAt : public testing::TestWithParam<HingeCase> {
  protected:
    HingeForceAt() : a(polar(0.3, 0.5)), b(polar(0.2, 0.5 + GetParam().angle)), hinge(GetParam().rest, 0.7, 0, 0.01) {}
    V2 a, b;
    Hinge2 hinge;
};

TEST_P(HingeForceAt, force_is_the_slope_of_its_energy) {
    const auto force = law(hinge, {a, {{0, 0}}}, {b, {{0, 0}}});
    constexpr double d = 1e-6;
    for (int axis = 0; axis < 2; ++axis) {
        V2 step{{0, 0}};
        step[axis] = d;
        const double on_a = -(energy(hinge, a + step, b) - energy(hinge, a - step, b)) / (2 * d);
        const double on_b = -(energy(hinge, a, b + step) - energy(hinge, a, b - step)) / (2 * d);
        const double on_centre = -(energy(hinge, a - step, b - step) - energy(hinge, a + step, b + step)) / (2 * d);
        EXPECT_NEAR(force.on_a[axis], on_a, 1e-7);
        EXPECT_NEAR(force.on_b[axis], on_b, 1e-7);
        EXPECT_NEAR(-force.on_a[axis] - force.on_b[axis], on_centre, 1e-7);
    }
}

TEST_P(HingeForceAt, has_no_moment) {
    const auto force = law(hinge, {a, {{1, 2}}}, {b, {{-3, 0.5}}});
    const auto moment = [](const V2& arm, const V2& f) { return arm[0] * f[1] - arm[1] * f[0]; };
    // About the centre; there is no resultant, as the centre takes -F_a - F_b, so the moment is that about any point.
    EXPECT_NEAR(moment(a, force.on_a) + moment(b, force.on_b), 0, 1e-13);
}

TEST_P(HingeForceAt, deviation_is_the_signed_angle_from_rest) {
    const double expected = std::remainder(GetParam().angle - GetParam().rest, 2 * pi);
    EXPECT_NEAR(deviation(hinge, a, b), expected, 1e-12);
    EXPECT_NEAR(energy(hinge, a, b), 0.7 * expected * expected, 1e-12);
}

TEST_P(HingeForceAt, dashpot_takes_energy_and_never_gives) {
    const Hinge2 damped(GetParam().rest, 0.7, 0.05, 0.01);
    const std::array<V2, 4> velocities{{{{1, 2}}, {{-3, 0.5}}, {{0.1, -4}}, {{2, 2}}}};
    for (const V2& v_a : velocities)
        for (const V2& v_b : velocities) {
            const auto with = law(damped, {a, v_a}, {b, v_b}), without = law(hinge, {a, v_a}, {b, v_b});
            const double power = dot(with.on_a - without.on_a, v_a) + dot(with.on_b - without.on_b, v_b);
            EXPECT_LE(power, 1e-14);
        }
    // A body that turns as a whole is not braked: v = omega x r.
    const auto turning = [](const V2& arm) { return V2{{-5 * arm[1], 5 * arm[0]}}; };
    const auto with = law(damped, {a, turning(a)}, {b, turning(b)}), without = law(hinge, {a, {{0, 0}}}, {b, {{0, 0}}});
    for (int axis = 0; axis < 2; ++axis) EXPECT_NEAR(with.on_a[axis], without.on_a[axis], 1e-13);
}

INSTANTIATE_TEST_SUITE_P(Angles, HingeForceAt,
                         testing::Values(HingeCase{pi / 2, 1.2}, HingeCase{pi / 2, pi / 2}, HingeCase{-pi / 2, -2.0},
                                         HingeCase{pi, pi - 0.02}, HingeCase{pi, -pi + 0.02}, HingeCase{pi, pi},
                                         HingeCase{3.0, -3.0}, HingeCase{0.1, 2.5}, HingeCase{-2.0, 1.0}));

TEST(HingeForce, dashpot_is_the_asked_fraction_of_critical) {
    const double k = 0.7, zeta = 0.03, inertia = 0.002;
    EXPECT_NEAR(Hinge2(1, k, zeta, inertia).dashpot, zeta * 2 * inertia * std::sqrt(2 * k / inertia), 1e-15);
}

TEST(HingeForce, chain_bent_to_a_closed_ring_needs_the_moment_of_theory) {
    // A chain of n bonds with 180-degree hinges closes when each of them turns by 2 pi / n: M = 4 pi k_a / n.
    for (const int n : {8, 20, 100}) {
        const double turn = 2 * pi / n, k = 0.35;
        const Hinge2 hinge(pi, k, 0, 1);
        const V2 back = polar(0.1, pi), forth = polar(0.1, turn);
        const auto force = law(hinge, {back, {{0, 0}}}, {forth, {{0, 0}}});
        const double moment = forth[0] * force.on_b[1] - forth[1] * force.on_b[0];
        EXPECT_NEAR(std::abs(moment), 4 * pi * k / n, 1e-9 * k);
        EXPECT_LT(moment, 0);  // it wants to straighten
    }
}

}  // namespace
}  // namespace dmp::tests::solver_spring_laws_tests
