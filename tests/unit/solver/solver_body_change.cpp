// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Spring bodies that are joined and cut.
#include <cmath>

#include <gtest/gtest.h>

#include "solver/elastic/body_change.hpp"
#include "tests/modules.hpp"

namespace dmp::tests::solver_body_change_tests {
namespace {

ParticleSpace space_of(bool periodic) {
    ParticleSpace space;
    space.dimension = 2;
    space.spacing = 1;
    space.box = {Vec::Zero(), Vec(8, 8, 0)};
    space.periodic = {periodic, false, false};
    return space;
}

BodyParts::Node node(int id, double x, double y, int origin = 0) {
    BodyParts::Node node;
    node.id = id;
    node.origin = origin;
    node.mass = 1 + 0.1 * id;
    node.position = node.position_before = Vec(x, y, 0);
    node.rest_position = node.position - Vec(0, 0.25, 0);
    node.velocity = Vec(0.3 * id, -0.2, 0);
    return node;
}

/// Three nodes in a row, bonded, with a hinge at the middle one.
BodyParts row(int first_id, double x, double y, int origin) {
    BodyParts parts;
    for (int n = 0; n < 3; ++n) parts.nodes.push_back(node(first_id + n, x + n, y, origin));
    parts.bonds = {{{0, 1}, 1, 5, 0.1, origin}, {{1, 2}, 1, 5, 0.1, origin}};
    parts.hinges = {{{0, 1, 2}, 3.14, 2, 0.3, origin}};
    parts.held_apart = {{0, 1}, {1, 2}};
    return parts;
}

std::vector<int> ids_of(const BodyParts& body) {
    std::vector<int> ids;
    for (const auto& each : body.nodes) ids.push_back(each.id);
    return ids;
}

TEST(BodyChange, a_new_node_joins_the_body_it_is_bonded_to_at_the_distance_it_has) {
    BodyChange change;
    change.nodes = {node(2, 2.25, 1, 1), node(50, 7, 7, 1)};
    change.bonds = {{11, 2, 0, 7, 0.5, 1}};
    const auto changed = change_bodies({row(10, 1, 2, 0)}, change, space_of(false));
    ASSERT_EQ(changed.bodies.size(), 2U);
    EXPECT_EQ(ids_of(changed.bodies[0]), (std::vector{2, 10, 11, 12}));
    EXPECT_EQ(ids_of(changed.bodies[1]), std::vector{50});
    EXPECT_EQ(changed.made, std::vector{1});
    EXPECT_TRUE(changed.broken.empty());
    const BodyParts& body = changed.bodies[0];
    ASSERT_EQ(body.bonds.size(), 3U);
    const auto& made = body.bonds[2];
    EXPECT_EQ(made.node, (std::array{2, 0}));
    EXPECT_DOUBLE_EQ(made.rest, std::hypot(0.25, 1));
    EXPECT_EQ(made.stiffness, 7);
    EXPECT_DOUBLE_EQ(made.dashpot, 2 * 0.5 * std::sqrt(2 * 7 * reduced_mass(2.1, 1.2)));
    EXPECT_EQ(made.origin, 1);
    ASSERT_EQ(body.hinges.size(), 1U);
    EXPECT_EQ(body.hinges[0].node, (std::array{1, 2, 3}));
    EXPECT_EQ(body.held_apart, (std::vector<std::pair<int, int>>{{0, 2}, {1, 2}, {2, 3}}));
    const BodyParts::Node given = node(2, 2.25, 1, 1);
    EXPECT_EQ(body.nodes[0].mass, given.mass);
    EXPECT_EQ(body.nodes[0].velocity, given.velocity);
    EXPECT_EQ(body.nodes[0].position, given.position);
}

TEST(BodyChange, bodies_that_are_bonded_become_one_and_keep_all_they_had) {
    BodyChange change;
    change.bonds = {{12, 20, 0.9, 7, 0, 1}, {20, 12, 0.9, 7, 0, 1}};
    const std::vector before{row(20, 4.5, 2, 1), row(10, 1, 2, 0)};
    const auto changed = change_bodies(before, change, space_of(false));
    ASSERT_EQ(changed.bodies.size(), 1U);
    const BodyParts& body = changed.bodies[0];
    EXPECT_EQ(ids_of(body), (std::vector{10, 11, 12, 20, 21, 22}));
    EXPECT_EQ(changed.made.size(), 1U) << "two nodes have one bond";
    EXPECT_EQ(body.bonds.size(), 5U);
    EXPECT_EQ(body.bonds.back().rest, 0.9);
    EXPECT_EQ(body.hinges.size(), 2U);
    Vec momentum = Vec::Zero(), expected = Vec::Zero();
    for (const auto& each : body.nodes) momentum += each.mass * each.velocity;
    for (const BodyParts& parts : {before[1], before[0]})
        for (const auto& each : parts.nodes) expected += each.mass * each.velocity;
    EXPECT_EQ(momentum, expected);
    EXPECT_EQ(body.nodes[4].origin, 1);
}

TEST(BodyChange, what_hangs_together_no_more_becomes_several_and_the_hinge_goes_with_its_bond) {
    BodyParts body = row(10, 1, 2, 0);
    body.nodes.push_back(node(13, 4, 2));
    body.bonds.push_back({{2, 3}, 1, 5, 0.1, 0});
    body.hinges.push_back({{1, 2, 3}, 3.14, 2, 0.3, 0});
    BodyChange change;
    change.broken = {{12, 11}, {10, 13}};
    const auto changed = change_bodies({body}, change, space_of(false));
    ASSERT_EQ(changed.bodies.size(), 2U);
    EXPECT_EQ(changed.broken.size(), 1U) << "10 and 13 had none";
    EXPECT_EQ(ids_of(changed.bodies[0]), (std::vector{10, 11}));
    EXPECT_EQ(ids_of(changed.bodies[1]), (std::vector{12, 13}));
    for (const BodyParts& piece : changed.bodies) {
        EXPECT_EQ(piece.bonds.size(), 1U);
        EXPECT_TRUE(piece.hinges.empty());
    }
    EXPECT_EQ(changed.bodies[0].held_apart, (std::vector<std::pair<int, int>>{{0, 1}}));
    EXPECT_TRUE(changed.bodies[1].held_apart.empty());
}

TEST(BodyChange, a_dihedral_goes_with_any_side_of_its_triangles_and_not_with_the_diagonal) {
    ParticleSpace space = space_of(false);
    space.dimension = 3;
    BodyParts body;
    for (int n = 0; n < 4; ++n) body.nodes.push_back(node(n, n % 2, n / 2));
    for (int a = 0; a < 4; ++a)
        for (int b = a + 1; b < 4; ++b) body.bonds.push_back({{a, b}, 1, 5, 0, 0});
    body.dihedrals = {{{0, 1, 2, 3}, 3, 1, 0, 0}};
    for (int a = 0; a < 4; ++a)
        for (int b = a + 1; b < 4; ++b) {
            BodyChange change;
            change.broken = {{a, b}};
            const auto changed = change_bodies({body}, change, space);
            ASSERT_EQ(changed.bodies.size(), 1U);
            EXPECT_EQ(changed.bodies[0].dihedrals.size(), a == 0 && b == 3 ? 1U : 0U) << a << b;
        }
}

TEST(BodyChange, joins_in_one_image_and_never_binds_a_body_to_its_own) {
    // The row ends beyond the border at x = 8, the new node lies behind it, and the next one closes the ring.
    BodyChange change;
    change.nodes = {node(1, 0.75, 2, 1)};
    change.bonds = {{22, 1, 0, 7, 0, 1}};
    const auto joined = change_bodies({row(20, 5.75, 2, 0)}, change, space_of(true));
    ASSERT_EQ(joined.bodies.size(), 1U);
    EXPECT_EQ(joined.bodies[0].nodes[0].position, Vec(8.75, 2, 0));
    EXPECT_EQ(joined.bodies[0].nodes[0].rest_position, Vec(8.75, 1.75, 0));
    EXPECT_DOUBLE_EQ(joined.bodies[0].bonds.back().rest, 1);

    BodyChange ring;
    ring.nodes = {node(2, 1.75, 2, 1), node(3, 2.75, 2, 1), node(4, 3.75, 2, 1), node(5, 4.75, 2, 1)};
    ring.bonds = {{1, 2, 0, 7, 0, 1}, {2, 3, 0, 7, 0, 1}, {3, 4, 0, 7, 0, 1}, {4, 5, 0, 7, 0, 1}, {5, 20, 0, 7, 0, 1}};
    const auto closed = change_bodies(joined.bodies, ring, space_of(true));
    ASSERT_EQ(closed.bodies.size(), 1U);
    EXPECT_EQ(closed.made.size(), 4U) << "the fifth would bind it to its image";
    EXPECT_EQ(closed.bodies[0].nodes[4].position, Vec(12.75, 2, 0));

    // Of two bodies the smaller one moves.
    BodyChange pair;
    pair.nodes = {node(60, 0.25, 5), node(61, 1.25, 5)};
    pair.bonds = {{60, 61, 0, 1, 0, 0}, {60, 32, 0, 1, 0, 0}};
    const auto moved = change_bodies({row(30, 5.25, 5, 0)}, pair, space_of(true));
    ASSERT_EQ(moved.bodies.size(), 1U);
    EXPECT_EQ(moved.bodies[0].nodes[0].position, Vec(5.25, 5, 0));
    EXPECT_EQ(moved.bodies[0].nodes[3].position, Vec(8.25, 5, 0));
    EXPECT_EQ(moved.bodies[0].nodes[4].position, Vec(9.25, 5, 0));
}

TEST(BodyChange, a_walls_particle_that_holds_nothing_any_more_is_no_body) {
    BodyChange change;
    change.nodes = {node(3, 1, 1, 1), node(7, 1, 0, 1)};
    change.nodes[1].fixed = change.nodes[1].of_wall = true;
    change.bonds = {{7, 3, 0, 2, 0, 1}};
    const auto bonded = change_bodies({}, change, space_of(false));
    ASSERT_EQ(bonded.bodies.size(), 1U);
    EXPECT_TRUE(bonded.bodies[0].nodes[1].of_wall);
    BodyChange cut;
    cut.broken = {{3, 7}};
    const auto free = change_bodies(bonded.bodies, cut, space_of(false));
    ASSERT_EQ(free.bodies.size(), 1U);
    EXPECT_EQ(ids_of(free.bodies[0]), std::vector{3});
}

}  // namespace
}  // namespace dmp::tests::solver_body_change_tests
