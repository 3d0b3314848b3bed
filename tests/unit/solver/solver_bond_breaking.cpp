// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Bonds that break: which one, when, and what is left.
#include <cmath>

#include <gtest/gtest.h>

#include "solver/elastic/spring_network.hpp"
#include "solver/solidify/body_events.hpp"
#include "tests/modules.hpp"

namespace dmp::tests::solver_bond_breaking_tests {
namespace {

using Body = SpringNetwork<2>;

constexpr double k = 50, r0 = 0.1, limit = 0.4, mass = 1e-3;
constexpr int bonds = 10;
const BondBreak by_force{BreakCriterion::force, limit};
const ParticleSpace plane = [] {
    ParticleSpace space;
    space.spacing = r0;
    space.box = {Vec(-10, -10, 0), Vec(10, 10, 0)};
    return space;
}();

/// A chain along x whose ends are held; ids are numbered from its left end, or from its right one.
BodyParts chain(double stretch, bool from_right = false) {
    BodyParts parts;
    for (int n = 0; n <= bonds; ++n) {
        BodyParts::Node node;
        node.id = n;
        node.mass = mass;
        node.drag = 0.5;
        const int column = from_right ? bonds - n : n;
        node.fixed = n == 0 || n == bonds;
        node.position = node.position_before = node.rest_position = Vec(column * (r0 + stretch), 0, 0);
        parts.nodes.push_back(node);
    }
    for (int n = 0; n < bonds; ++n) parts.bonds.push_back({{n, n + 1}, r0, k, 0, 0});
    return parts;
}

Body body_of(const BodyParts& parts) { return {parts, "chain", r0, {}}; }

TEST(BondBreaking, of_equals_the_one_with_the_lowest_ids_breaks) {
    constexpr double over = 1.01 * limit / (2 * k);
    for (const bool from_right : {false, true}) {
        const Body body = body_of(chain(over, from_right));
        const auto broken = overloaded_bond(body, by_force, 0);
        ASSERT_TRUE(broken);
        // The places are multiples of r0 + stretch only to rounding: what ties there are is for exact ones.
        EXPECT_EQ((*broken)[1], (*broken)[0] + 1);
    }
    BodyParts two = chain(over);
    two.nodes[1].position = Vec(0.25, 0, 0);  // exact: 0, 0.25, 0.5
    two.nodes[2].position = Vec(0.5, 0, 0);
    two.nodes[0].position = Vec::Zero();
    two.bonds = {{{1, 2}, 0.125, k, 0, 0}, {{0, 1}, 0.125, k, 0, 0}};
    EXPECT_EQ(overloaded_bond(body_of(two), by_force, 0), (std::array{0, 1}));
}

TEST(BondBreaking, only_tension_breaks_and_only_bonds_that_are_meant) {
    constexpr double over = 1.01 * limit / (2 * k);
    EXPECT_FALSE(overloaded_bond(body_of(chain(-9 * over)), by_force, 0));
    EXPECT_FALSE(overloaded_bond(body_of(chain(0.98 * over)), by_force, 0));
    EXPECT_FALSE(overloaded_bond(body_of(chain(over)), by_force, 1)) << "of another origin";
    const BondBreak by_strain{BreakCriterion::strain, 0.05};
    EXPECT_TRUE(overloaded_bond(body_of(chain(0.051 * r0)), by_strain, 0));
    EXPECT_FALSE(overloaded_bond(body_of(chain(0.049 * r0)), by_strain, 0));
}

TEST(BondBreaking, a_chain_pulled_slowly_breaks_once_at_the_length_of_the_law) {
    Body body = body_of(chain(0.95 * limit / (2 * k)));
    constexpr double pull = 1e-6, dt = 0.1;  // a step takes far longer than the chain takes to come to rest
    const std::vector<Vec> nothing(bonds + 1, Vec::Zero());
    std::optional<std::array<int, 2>> broken;
    while (!(broken = overloaded_bond(body, by_force, 0))) {
        ASSERT_LT(body.positions().back()[0], 2 * bonds * r0) << "it never breaks";
        body.positions().back()[0] += pull;
        body.advance(nothing, dt, 0);
    }
    const double length = body.positions().back()[0], at_limit = bonds * (r0 + limit / (2 * k));
    EXPECT_NEAR(length, at_limit, 2 * pull * bonds);

    BodyChange change;
    change.broken = {*broken};
    const double before = body.energy();
    const ChangedBodies cut = change_bodies({body.parts()}, change, plane);
    ASSERT_EQ(cut.bodies.size(), 2U);
    EXPECT_EQ(cut.broken, std::vector<int>{0});
    double after = 0;
    std::vector<Body> pieces;
    for (const BodyParts& parts : cut.bodies) {
        pieces.push_back(body_of(parts));
        after += pieces.back().energy();
    }
    const double of_one_bond = k * std::pow(limit / (2 * k), 2);
    EXPECT_NEAR(before - after, of_one_bond, 1e-3 * of_one_bond);

    for (int step = 0; step < 2000; ++step) {
        pieces.back().positions().back()[0] += pull;
        for (Body& piece : pieces) {
            piece.advance(std::vector<Vec>(piece.nodes(), Vec::Zero()), dt, 0);
            ASSERT_FALSE(overloaded_bond(piece, by_force, 0));
        }
    }
    for (const Body& piece : pieces) EXPECT_LT(piece.energy(), 1e-3 * of_one_bond);
}

}  // namespace
}  // namespace dmp::tests::solver_bond_breaking_tests
