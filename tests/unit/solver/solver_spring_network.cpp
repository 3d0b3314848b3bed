// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "base/errors.hpp"
#include "tests/modules.hpp"
#include "tests/unit/solver/statics.hpp"
#include "tests/unit/temporary_files.hpp"
#include "tests/unit/thrown.hpp"

namespace dmp::tests::solver_spring_network_tests {
namespace {

using V3 = Vector<double, 3>;
using Body = SpringNetwork<3>;
using Vectors3 = Body::Vectors;
constexpr double pi = std::numbers::pi;

V3 vector(const Vec& v) { return {{v[0], v[1], v[2]}}; }
Vec vector(const V3& v) { return {v[0], v[1], v[2]}; }

double angle(const Vec& a, const Vec& b) { return std::atan2(a.cross(b).norm(), a.dot(b)); }

/// phi of four places, as particles/particle_set.hpp says.
double dihedral_angle(const Vec& a, const Vec& b, const Vec& c, const Vec& d) {
    const Vec axis = (c - b).normalized();
    const Vec to_a = (a - b) - axis * axis.dot(a - b), to_d = (d - c) - axis * axis.dot(d - c);
    return std::atan2(axis.dot(to_a.cross(to_d)), to_a.dot(to_d));
}

/// A chain of nodes in 3-D with bonds, hinges and dihedrals along it, all of them strained; one hinge rests straight,
/// one folded, one dihedral flat.
ParticleSet strained_chain(int nodes = 12) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> number(-1, 1);
    std::vector<Vec> position;
    std::vector<double> mass;
    for (int n = 0; n < nodes; ++n) {
        position.emplace_back(0.8 * n + 0.2 * number(random), 0.6 * number(random), 0.6 * number(random));
        mass.push_back(1 + 0.5 * number(random));
    }
    ParticleSet set = set_of_nodes(3, position, mass);
    for (int n = 1; n < nodes; ++n)
        set.bonds.push_back({n - 1, n, (position[n] - position[n - 1]).norm() * (1 + 0.1 * number(random)), 5});
    for (int n = 2; n < nodes; ++n)
        set.hinges.push_back(
            {n - 2, n - 1, n, angle(position[n - 2] - position[n - 1], position[n] - position[n - 1]), 0.7});
    set.hinges[1].rest_angle = pi;
    set.hinges[3].rest_angle = 0;
    set.hinges[5].rest_angle *= 0.8;
    for (int n = 7; n < nodes; ++n)  // not over the straight and the folded hinge: there phi has no slope
        set.dihedrals.push_back(
            {n - 3, n - 2, n - 1, n,
             dihedral_angle(position[n - 3], position[n - 2], position[n - 1], position[n]) + 0.3 * number(random),
             0.4});
    set.dihedrals[2].rest_angle = pi;
    return set;
}

double energy_at(Body& body, const Vectors3& position) {
    Vectors3 kept = position;
    std::swap(kept, body.positions());
    const double energy = body.energy();
    std::swap(kept, body.positions());
    return energy;
}

TEST(SpringNetwork, energy_is_that_of_the_definition) {
    const ParticleSet set = strained_chain();
    double expected = 0;
    const auto& x = set.position;
    for (const Bond& bond : set.bonds)
        expected += bond.stiffness * std::pow((x[bond.a] - x[bond.b]).norm() - bond.rest_length, 2);
    for (const Hinge& hinge : set.hinges)
        expected += hinge.stiffness *
                    std::pow(angle(x[hinge.a] - x[hinge.centre], x[hinge.b] - x[hinge.centre]) - hinge.rest_angle, 2);
    for (const Dihedral& four : set.dihedrals)
        expected += four.stiffness *
                    std::pow(std::remainder(
                                 dihedral_angle(x[four.a], x[four.b], x[four.c], x[four.d]) - four.rest_angle, 2 * pi),
                             2);
    EXPECT_NEAR(Body(set, part_with(0), 0).energy() / expected, 1, 1e-13);
}

TEST(SpringNetwork, forces_are_the_slope_of_the_energy_and_have_no_resultant_and_no_moment) {
    const ParticleSet set = strained_chain();
    Body body(set, part_with(0), 0);
    const Vectors3 force = body.forces(body.positions(), Vectors3(set.size(), V3{}));
    constexpr double d = 1e-6;
    Vec sum = Vec::Zero(), moment = Vec::Zero();
    for (std::size_t n = 0; n < set.size(); ++n) {
        for (int axis = 0; axis < 3; ++axis) {
            Vectors3 plus = body.positions(), minus = body.positions();
            plus[n][axis] += d;
            minus[n][axis] -= d;
            const double slope = -(energy_at(body, plus) - energy_at(body, minus)) / (2 * d);
            EXPECT_NEAR(force[n][axis], slope, 1e-8) << "node " << n << ", axis " << axis;
        }
        sum += vector(force[n]);
        moment += set.position[n].cross(vector(force[n]));
    }
    EXPECT_LT(sum.norm(), 1e-13);
    EXPECT_LT(moment.norm(), 1e-12);
}

TEST(SpringNetwork, dashpots_take_energy_and_do_not_brake_a_body_that_turns) {
    const ParticleSet set = strained_chain();
    const Body damped(set, part_with(0.1), 0), free(set, part_with(0), 0);
    const Vectors3 still(set.size(), V3{});
    std::mt19937 random(11);
    std::uniform_real_distribution<double> number(-1, 1);
    const Vectors3 elastic = free.forces(free.positions(), still);
    for (int trial = 0; trial < 20; ++trial) {
        Vectors3 velocity(set.size());
        for (V3& v : velocity) v = {{number(random), number(random), number(random)}};
        const Vectors3 force = damped.forces(damped.positions(), velocity);
        double power = 0;
        for (std::size_t n = 0; n < set.size(); ++n) power += dot(force[n] - elastic[n], velocity[n]);
        EXPECT_LT(power, -1e-3);
    }
    Vectors3 turning(set.size());
    for (std::size_t n = 0; n < set.size(); ++n)
        turning[n] = vector(Vec(Vec(0.3, -1, 2).cross(set.position[n]) + Vec(1, 2, 3)));
    const Vectors3 force = damped.forces(damped.positions(), turning);
    for (std::size_t n = 0; n < set.size(); ++n)
        for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(force[n][axis], elastic[n][axis], 1e-12);
}

TEST(SpringNetwork, dihedral_is_flat_at_pi_and_changes_sign_with_the_side) {
    const auto phi = [](double z) {
        return DihedralForce::angle({vector(Vec(-1, 0, 0)), vector(Vec(0, -1, 0)), vector(Vec(1, 0, z))});
    };
    EXPECT_DOUBLE_EQ(std::abs(phi(0)), pi);
    EXPECT_NEAR(phi(0.5), dihedral_angle(Vec(-1, 0, 0), Vec(0, 0, 0), Vec(0, 1, 0), Vec(1, 1, 0.5)), 1e-14);
    EXPECT_DOUBLE_EQ(phi(0.5), -phi(-0.5));
    // A flat one that is folded across pi: the shorter way round.
    const DihedralForce flat(pi, 2, 0, 1);
    for (const double z : {0.1, -0.1})
        EXPECT_NEAR(
            std::abs(flat.deviation({vector(Vec(-1, 0, 0)), vector(Vec(0, -1, 0)), vector(Vec(1, 0, z))}).value),
            std::atan(0.1), 1e-12);
}

TEST(SpringNetwork, forces_stay_finite_where_nodes_lie_on_one_line) {
    for (const double rest : {0.0, 1.0, pi})
        for (const double side : {1.0, -1.0})
            for (const double off : {0.0, 1e-18, 1e-12, 1e-6}) {
                const HingeForce<3> hinge(rest, 1, 0.1, 1);
                const auto at = hinge.deviation({vector(Vec(1, 0, 0)), vector(Vec(side, off, 0))});
                EXPECT_NEAR(at.value, (side > 0 ? off : pi - off) - rest, 1e-15 + 1e-9 * off);
                for (const V3& slope : at.gradient) EXPECT_NEAR(std::sqrt(dot(slope, slope)), 1, 1e-12);
            }
    const DihedralForce dihedral(1, 1, 0, 1);
    const auto at = dihedral.deviation({vector(Vec(-1, 0, 0)), vector(Vec(1, 0, 0)), vector(Vec(1, 1, 0))});
    for (const V3& slope : at.gradient) EXPECT_EQ(dot(slope, slope), 0);
    // A hinge that rests straight pushes straight back, in proportion, from any side.
    const HingeForce<3> straight(pi, 1, 0, 1);
    for (const double off : {1e-9, 1e-5, 1e-2})
        for (const double turn : {0.0, 1.0, 2.5, 4.0}) {
            const Vec b(-1, off * std::cos(turn), off * std::sin(turn));
            const auto bent = straight.deviation({vector(Vec(1, 0, 0)), vector(b)});
            const Vec on_b = -straight.tension(bent, {V3{}, V3{}}) * vector(bent.gradient[1]);
            EXPECT_NEAR((on_b - Vec(0, -2 * b[1], -2 * b[2])).norm() / off, 0, 1e-6 + 2.1 * off);
        }
}

/// A straight cantilever of one row along x: bonds, and hinges that rest straight; the first two nodes are held.
ParticleSet filament(int nodes, double k_a) {
    std::vector<Vec> position;
    position.reserve(static_cast<std::size_t>(nodes));
    for (int n = 0; n < nodes; ++n) position.emplace_back(n, 0, 0);
    ParticleSet set = set_of_nodes(3, position, std::vector<double>(position.size(), 1));
    for (int n = 1; n < nodes; ++n) set.bonds.push_back({n - 1, n, 1, 10});
    for (int n = 2; n < nodes; ++n) set.hinges.push_back({n - 2, n - 1, n, pi, k_a});
    set.fixed[0] = set.fixed[1] = 1;
    return set;
}

/// Steps the body under constant forces until it no longer moves.
void rest_test(Body& body, const Vectors3& load, double dt, int steps) {
    for (int step = 0; step < steps; ++step) {
        body.kick_from_outside(load, dt);
        body.advance_implicit(dt);
    }
}

TEST(SpringNetwork, implicit_steps_far_beyond_the_explicit_limit_settle_a_filament_sideways_in_any_direction) {
    const int nodes = 22;
    const double k_a = 50, load = 1e-4;
    const ParticleSet set = filament(nodes, k_a);
    // EI = 2 k_a a, clamped half a spacing inside the second held node; the hinges' sum is exact for that length.
    double expected = 0;
    for (int hinge = 1; hinge + 1 < nodes; ++hinge) {
        const double arm = nodes - 1 - hinge;
        expected += load * arm * arm / (2 * k_a);
    }
    for (const double turn : {0.0, 1.1}) {
        Body body(set, part_with(0.01, 0.1), 0);
        Vectors3 force(set.size(), V3{});
        force.back() = {{0, load * std::cos(turn), load * std::sin(turn)}};
        rest_test(body, force, 100 * body.step_limit(), 600);
        const V3& tip = body.positions().back();
        EXPECT_NEAR(tip[1], expected * std::cos(turn), 1e-3 * expected);
        EXPECT_NEAR(tip[2], expected * std::sin(turn), 1e-3 * expected);
    }
}

TEST(SpringNetwork, both_ways_to_step_give_the_same_motion_in_space) {
    ParticleSet set = strained_chain();
    set.fixed[0] = 1;
    Body fine(set, part_with(0.02), 0), coarse(set, part_with(0.02), 0);
    double swing = 0;
    for (int step = 0; step < 150; ++step) {
        fine.advance_subcycled(0.05, 10);
        for (int half = 0; half < 2; ++half) coarse.advance_implicit(0.025);
        for (std::size_t n = 0; n < set.size(); ++n) {
            const V3 difference = fine.positions()[n] - coarse.positions()[n];
            EXPECT_LT(std::sqrt(dot(difference, difference)), 0.02) << "node " << n << " in step " << step;
            swing = std::max(swing, (vector(fine.positions()[n]) - set.position[n]).norm());
        }
    }
    EXPECT_GT(swing, 0.3);
}

TEST(SpringNetwork, momentum_and_moment_of_momentum_are_kept_in_space) {
    const ParticleSet set = strained_chain();
    for (const bool implicit : {false, true}) {
        Body body(set, part_with(0.05), 0);
        Vectors3 kicks(set.size(), V3{});
        kicks[2] = {{1, 2, -1}};
        body.kick_from_outside(kicks, 1);
        const auto moment = [&] {
            Vec sum = Vec::Zero();
            for (std::size_t n = 0; n < set.size(); ++n)
                sum += set.mass[n] * body.position(n).cross(vector(body.velocities()[n]));
            return sum;
        };
        const Vec before = body.total_momentum(), turning = moment();
        for (int step = 0; step < 100; ++step) implicit ? body.advance_implicit(0.05) : body.advance_subcycled(0.05, 3);
        EXPECT_LT((body.total_momentum() - before).norm(), 1e-11);
        EXPECT_LT((moment() - turning).norm(), implicit ? 1e-6 : 1e-11);  // to the tolerance of the solution
    }
}

TEST(SpringNetwork, goes_on_from_a_checkpoint_with_the_same_bits) {
    const TemporaryFolder folder;
    const Ranks alone = Ranks::alone();
    const ParticleSet set = strained_chain();
    Body body(set, part_with(0.05), 0);
    for (int step = 0; step < 20; ++step) body.advance_implicit(0.05);
    {
        Hdf5Writer file(folder.path() / "state.h5");
        Archive archive(alone, &file);
        body.archive(archive, "springs/body_0");
        file.close();
    }
    const Hdf5Reader file(folder.path() / "state.h5");
    Archive archive(alone, file);
    Body other(set, part_with(0.05), 0);
    other.archive(archive, "springs/body_0");
    for (int step = 0; step < 20; ++step)
        for (Body* each : {&body, &other}) each->advance_implicit(0.05);
    for (std::size_t n = 0; n < set.size(); ++n)
        for (int axis = 0; axis < 3; ++axis) {
            EXPECT_EQ(other.positions()[n][axis], body.positions()[n][axis]);
            EXPECT_EQ(other.velocities()[n][axis], body.velocities()[n][axis]);
        }
}

TEST(SpringNetwork, plane_bodies_have_no_dihedrals) {
    ParticleSet set = strained_chain();
    set.dimension = 2;
    EXPECT_EQ(text_thrown<InputError>([&] { (void)SpringBody::make(set, part_with(0), 0); }),
              "'beam' has dihedrals, and there are none in 2-D\n  write dimension = 3, or leave them out");
}

TEST(SpringNetwork, a_ring_closes_under_end_moments_in_the_plane_and_in_space) {
    // n bonds, 180-degree hinges; each turns by M / (2 k_a): closed at M = 4 pi k_a / n. The start is a chain on that
    // ring's circle, which the moment as a force pair on the end bonds must hold in balance.
    const auto check = [](auto dimension) {
        constexpr int D = decltype(dimension)::value;
        for (const int n : {8, 20, 50}) {
            std::vector<Vec> straight, ring;
            Vec at = Vec::Zero();
            for (int k = 0; k <= n; ++k) {
                straight.emplace_back(k, 0, 0);
                ring.push_back(at);
                at += Vec(std::cos(2 * pi * k / n), std::sin(2 * pi * k / n), 0);
            }
            ParticleSet set = set_of_nodes(D, straight, std::vector<double>(straight.size(), 1));
            for (int k = 1; k <= n; ++k) set.bonds.push_back({k - 1, k, 1, 10});
            for (int k = 2; k <= n; ++k) set.hinges.push_back({k - 2, k - 1, k, pi, 0.35});
            const SpringNetwork<D> body(set, part_with(0), 0);
            typename SpringNetwork<D>::Vectors bent(ring.size());
            for (std::size_t k = 0; k < ring.size(); ++k)
                for (int axis = 0; axis < D; ++axis) bent[k][axis] = ring[k][axis];
            const auto force = body.forces(bent, typename SpringNetwork<D>::Vectors(ring.size(), Vector<double, D>{}));
            const double moment = 4 * pi * 0.35 / n;
            EXPECT_LT((ring.back() - ring.front()).norm(), 1e-12 * n);
            for (int k = 2; k + 1 < n; ++k) EXPECT_LT(std::sqrt(dot(force[k], force[k])), 1e-6 * moment);
            // The last bond, of length 1, feels the pair of forces -M.
            const Vec bond = ring[n] - ring[n - 1];
            EXPECT_NEAR((bond[0] * force[n][1] - bond[1] * force[n][0]) / -moment, 1, 1e-6);
        }
    };
    check(std::integral_constant<int, 2>());
    check(std::integral_constant<int, 3>());
}

}  // namespace
}  // namespace dmp::tests::solver_spring_network_tests
