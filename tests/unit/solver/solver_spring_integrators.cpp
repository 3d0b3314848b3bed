// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "mesher/spring_lattice.hpp"
#include "tests/modules.hpp"
#include "tests/unit/solver/ladder_body.hpp"

namespace dmp::tests::solver_spring_integrators_tests {
namespace {

constexpr double pi = std::numbers::pi;

/// A node of mass 1 on a bond along x, at rest at x = 1000, with omega^2 = 2 k_b; swings of order 1 are linear.
ParticleSet oscillator(double omega) {
    ParticleSet set = set_of_nodes(2, {Vec(0, 0, 0), Vec(1000, 0, 0)}, {1, 1});
    set.bonds.push_back({0, 1, 1000, omega * omega / 2});
    set.fixed[0] = 1;
    return set;
}

void hit(PlaneBody& body, double velocity) { body.kick_from_outside(Vectors{V2{{0, 0}}, V2{{velocity, 0}}}, 1); }
double swing(const PlaneBody& body) { return body.positions()[1][0] - 1000; }

class Leapfrog : public testing::TestWithParam<double> {};

TEST_P(Leapfrog, has_the_period_and_the_dip_of_energy_of_theory_and_no_drift) {
    const double x = GetParam();  // omega dt
    PlaneBody body(oscillator(1), part_with(0), 0);
    hit(body, 1);
    const auto energy = [&] { return std::pow(swing(body), 2) + std::pow(body.velocities()[1][0], 2); };
    double lowest = 1, highest = 1, before = 0, first = 0, last = 0;
    long crossings = 0;
    constexpr long steps = 20000;
    for (long step = 1; step <= steps; ++step) {
        body.advance_subcycled(x, 1);
        const double now = swing(body);
        if (before < 0 && now >= 0) {  // where a sine through both values crosses
            const double theta = 2 * std::asin(x / 2);
            const double share = std::atan2(-before * std::sin(theta), now - before * std::cos(theta)) / theta;
            last = (static_cast<double>(step - 1) + share) * x;
            if (crossings++ == 0) first = last;
        }
        before = now;
        lowest = std::min(lowest, energy());
        highest = std::max(highest, energy());
    }
    const double period = (last - first) / static_cast<double>(crossings - 1);
    EXPECT_NEAR(period / (2 * pi), x / (2 * std::asin(x / 2)), 1e-6);
    // Of the six places it is seen at when x = 1, none is where it turns.
    EXPECT_NEAR(1 - lowest, x == 1 ? 3.0 / 16 : x * x / 4, 2e-3 * x * x);
    EXPECT_NEAR(highest, 1, 1e-7);
}

INSTANTIATE_TEST_SUITE_P(Steps, Leapfrog, testing::Values(0.05, 0.1, 0.2, 0.5, 1.0));

/// Largest relative growth of energy of a fast bond (omega = 10) with a slow force (-x), kicked once in a step H, over
/// 300 time units.
double change_of_energy(double step, double damping, bool implicit) {
    PlaneBody body(oscillator(10), part_with(damping), 0);
    body.positions()[1][0] += 1;
    const auto energy = [&] {  // with the velocity between two half kicks
        const double x = swing(body), v = body.velocities()[1][0] - step / 2 * x;
        return (v * v + 101 * x * x) / 2;
    };
    const double start = energy();
    double largest = 0;
    for (int n = 0; n * step < 300; ++n) {
        hit(body, -step * swing(body));
        implicit ? body.advance_implicit(step) : body.advance_subcycled(step, 20);
        largest = std::max(largest, energy() / start - 1);
    }
    return largest;
}

TEST(SubcycledSprings, resonate_with_the_kicks_of_the_fluid_at_half_a_period_unless_damped) {
    const double resonance = pi / std::hypot(10, 0.5);  // where it is strongest: the slow force stiffens a little
    EXPECT_LT(change_of_energy(0.1, 0, false), 6e-3);
    EXPECT_LT(change_of_energy(0.2, 0, false), 3e-2);
    EXPECT_GT(change_of_energy(pi / 10, 0, false), 5);
    EXPECT_GT(change_of_energy(resonance, 0, false), 5);
    for (const double step : {pi / 10, resonance}) {
        EXPECT_LT(change_of_energy(step, 0.01, false), 0.2);
        EXPECT_LT(change_of_energy(step, 0, true), 0.1);  // the implicit stepper has none
    }
}

TEST(SpringBeam, that_is_free_drifts_by_less_than_a_thousandth_in_energy_over_a_hundred_periods) {
    const ParticleSet set = ladder({12, 0.5, false});
    PlaneBody body(set, part_with(0), 0);
    // The first bending shape of a free beam, roughly, as velocities without momentum and spin.
    Vectors impulse;
    double mean = 0;
    const auto shape = [](double x) { return std::cos(2 * pi * x / 12); };
    for (const Vec& at : set.position) mean += shape(at[0]) / static_cast<double>(set.size());
    for (const Vec& at : set.position) impulse.push_back({{0, 1e-2 * (shape(at[0]) - mean)}});
    body.kick_from_outside(impulse, 1);
    const double period = 2 * pi * 144 / (22.373 * std::sqrt(bending_stiffness(0.5) / 2));
    constexpr double dt = 0.1;
    const auto energy = [&] {
        double kinetic = 0;
        for (const V2& v : body.velocities()) kinetic += 0.5 * dot(v, v);
        return kinetic + body.energy();
    };
    const long window = std::lround(5 * period / dt), steps = std::lround(100 * period / dt);
    double early = 0, late = 0, lowest = energy(), highest = lowest;
    for (long step = 0; step < steps; ++step) {
        body.advance_subcycled(dt, 1);
        const double now = energy();
        if (step < window) early += now;
        if (step >= steps - window) late += now;
        lowest = std::min(lowest, now);
        highest = std::max(highest, now);
    }
    EXPECT_NEAR(late / early, 1, 1e-3);
    EXPECT_LT(highest / lowest, 1.02);
}

TEST(SpringBeam, ten_thousand_times_stiffer_than_an_explicit_step_allows_settles_to_the_right_deflection) {
    for (const double k_a : {0.05, 0.5}) {
        const ParticleSet set = ladder({20, k_a, true});
        const double length = 20, load = 1e-5, mass = 2;
        const double first = 3.516 / (length * length) * std::sqrt(bending_stiffness(k_a) / mass);
        PlaneBody body(set, part_with(0.01, 2 * 0.7 * first), 0);
        const double dt = 100 * body.step_limit();  // omega dt = 200: k is 1e4 times that of the limit at this dt
        const Vectors force = end_load(set, {{0, load}});
        for (int step = 0; step < 400; ++step) {
            body.kick_from_outside(force, dt);
            body.advance_implicit(dt);
        }
        const double tip =
            load * std::pow(length, 3) / (3 * bending_stiffness(k_a)) + load * length / shear_stiffness(k_a);
        EXPECT_NEAR((body.positions().back()[1] + 0.5) / tip, 1, 5e-3);
    }
}

TEST(SpringPlate, swings_with_the_period_of_the_oscillating_plate) {
    // Gray, Monaghan & Swift 2001: a clamped plate in plane strain, thin-plate period 0.25403 s. Its lattice has a
    // whole column of mass at the end: 1 - 1/n.
    const int cells = 40;
    const double length = 0.2, height = 0.02, modulus = 2e6, poisson = 0.3975, density = 1000;
    const double spacing = length / cells, plane_strain = modulus / (1 - poisson * poisson);
    Part part = part_with(0);
    part.bending_stiffness = plane_strain * std::pow(height, 3) / 12;
    part.axial_stiffness = plane_strain * height;
    const LadderConstants constants = ladder_constants(part, spacing, spacing);
    ParticleSet set = ladder({cells, 1, true});
    for (Vec& at : set.position) at *= spacing;
    for (double& mass : set.mass) mass = density * height * spacing / 2;
    for (Bond& bond : set.bonds) {
        bond.rest_length *= spacing;
        bond.stiffness = constants.bond_stiffness;
    }
    for (Hinge& hinge : set.hinges) hinge.stiffness = constants.hinge_stiffness;
    set.spacing = spacing;

    PlaneBody body(set, part, 0);
    const double tip_load = 0.01 * length * 3 * part.bending_stiffness / std::pow(length, 3);
    body.positions() = statics(body, set, end_load(set, {{0, tip_load}}));
    const Vectors shape = body.positions();
    EXPECT_NEAR(shape.back()[1] + 0.5 * spacing, 0.01 * length, 1e-4 * length);
    const auto amplitude = [&] {
        double sum = 0;
        for (std::size_t n = 0; n < set.size(); ++n)
            sum += (body.positions()[n][1] - set.position[n][1]) * (shape[n][1] - set.position[n][1]);
        return sum;
    };
    const double expected = 0.25403 / (1 - 1.0 / cells), dt = expected / 400;
    std::vector<double> crossings;
    double before = amplitude();
    for (int step = 1; crossings.size() < 5 && step < 2000; ++step) {
        body.advance_implicit(dt);
        const double now = amplitude();
        if (before * now < 0) crossings.push_back((step - now / (now - before)) * dt);
        before = now;
    }
    ASSERT_EQ(crossings.size(), 5U);
    EXPECT_NEAR((crossings.back() - crossings.front()) / 2 / expected, 1, 5e-3);
}

}  // namespace
}  // namespace dmp::tests::solver_spring_integrators_tests
