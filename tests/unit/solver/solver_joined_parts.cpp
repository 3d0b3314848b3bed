// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Bodies of several parts: what joins them stretches, breaks and is told apart as its scene says.
#include <cmath>

#include <gmock/gmock.h>

#include "mesher/join_parts.hpp"
#include "tests/modules.hpp"
#include "tests/unit/solver/bodies_in_space.hpp"
#include "tests/unit/solver/small_scenes.hpp"

namespace dmp::tests::solver_joined_parts_tests {
namespace {

using namespace lattice_solids;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr double spacing = 0.1;

Part elastic_part(const std::string& name, double damping) {
    Part part = part_with(damping);
    part.name = name;
    return part;
}

/// Two square blocks of 4 x 4 nodes beside each other, 'left' held at its left side, joined by 'seam'.
struct TwoBlocks {
    explicit TwoBlocks(double stiffness, double modulus = 1e9) {
        scene.particles.spacing = spacing;
        scene.parts = {elastic_part("left", 0.01), elastic_part("right", 0.02)};
        Join join;
        join.name = std::string("seam");
        join.parts = std::array<std::string, 2>{"right", "left"};
        join.stiffness = stiffness;
        join.damping = 0.5;
        scene.joins = {join};

        ParticleSet& set = meshed.particles;
        const SpringLattice lattice =
            cell_lattice(block(3, 3, 0, spacing), cell_constants(modulus, 0.25, spacing, 2), Vec(spacing, spacing, 0));
        set.spacing = spacing;
        set.box = {Vec(-1, -1, 0), Vec(2, 2, 0)};
        set.parts = {{"left", PartKind::elastic}, {"right", PartKind::elastic}};
        ParticleSet one = set_of_nodes(2, lattice.nodes, lattice.share);
        one.bonds = lattice.bonds;
        one.mass.assign(one.size(), 10);
        one.volume.assign(one.size(), spacing * spacing);
        append(set, one, Vec::Zero(), 0, 0);
        append(set, one, Vec(4 * spacing, 0, 0), 1, 1);
        for (std::size_t n = 0; n < set.size(); ++n) set.fixed[n] = set.position[n].x() < 0.1 * spacing ? 1 : 0;
        join_parts(meshed, scene);
    }
    [[nodiscard]] const ParticleSet& set() const { return meshed.particles; }

    Scene scene;
    MeshResult meshed;
};

TEST(JoinedParts, are_drawn_apart_by_a_load_as_far_as_their_bonds_yield) {
    constexpr double stiffness = 10, load = 1e-4;
    const TwoBlocks blocks(stiffness, 1e5);
    const BodyParts parts = initial_body(blocks.set(), InitialSprings(blocks.set(), blocks.scene), 0, 0);
    ASSERT_EQ(parts.nodes.size(), 32U);
    const SpringNetwork<2> body(parts, "both", spacing, {});
    SpringNetwork<2>::Vectors pull(32, Vector<double, 2>{});
    for (std::size_t n = 0; n < 32; ++n)
        if (blocks.set().position[n].x() > 6.9 * spacing) pull[n][0] = load / 4;
    const auto at = statics(body, blocks.set(), pull);
    // Four bonds straight on, each of 2 k_b, and six at 45 degrees, each of k_b; the blocks are 1e4 times stiffer.
    const double opened = load / (2 * stiffness * 4 + stiffness * 6);
    for (std::size_t n = 0; n < 32; ++n) {
        const double moved = at[n][0] - blocks.set().position[n].x();
        EXPECT_NEAR(moved, blocks.set().part[n] == 1 ? opened : 0, 5e-3 * opened);
    }
}

TEST(JoinedParts, are_one_body_whose_nodes_and_bonds_keep_where_they_are_from) {
    const TwoBlocks blocks(10, 1e5);
    const InitialSprings drawn(blocks.set(), blocks.scene);
    EXPECT_THAT(body_names(blocks.scene), ElementsAre("left", "right", "seam"));
    const BodyParts parts = initial_body(blocks.set(), drawn, 0, 0);
    for (const BodyParts::Node& node : parts.nodes) EXPECT_EQ(node.origin, blocks.set().part[node.id]);
    std::array<int, 3> bonds{};
    for (const auto& bond : parts.bonds) {
        ++bonds.at(bond.origin);
        // In critical fractions: 2 zeta sqrt(2 k m), with half a node's mass.
        const double zeta = std::array{0.01, 0.02, 0.5}.at(bond.origin);
        EXPECT_NEAR(bond.dashpot / (2 * zeta * std::sqrt(2 * bond.stiffness * 5)), 1, 1e-12);
    }
    EXPECT_THAT(bonds, ElementsAre(24 + 18, 24 + 18, 4 + 6));
}

TEST(JoinedParts, part_again_where_their_join_breaks) {
    SceneAndParticles made = endless_water();
    TwoBlocks blocks(2e3, 1e6);
    Scene& scene = blocks.scene;
    scene.run.duration = 0.2;
    scene.output.every = 0.1;
    scene.flow.largest_speed = 1.0;
    ForceOnPart pull;
    pull.name = std::string("pull");
    pull.part = std::string("right");
    pull.force = std::array{Expression("2e3", "2e3"), Expression("0", "0"), Expression("0", "0")};
    pull.amount = ForceAmount::total;
    scene.forces = {pull};
    const auto broken = [&](double limit) {
        Breaking rule;
        rule.name = std::string("tear");
        rule.part = std::string("seam");
        rule.force_above = limit;
        scene.breaking = {rule};
        const RunSummary summary = Simulation(scene, blocks.set(), Resources(1)).run({});
        std::array<std::int64_t, 3> of{};
        for (const Aggregate& each : summary.aggregates)
            of.at(each.name == "left" ? 0 : each.name == "right" ? 1 : 2) = each.bonds_broken;
        EXPECT_LT(summary.momentum_residual, 1e-9);
        return of;
    };
    EXPECT_THAT(broken(100), ElementsAre(0, 0, 10));
    EXPECT_THAT(broken(1e6), ElementsAre(0, 0, 0));
}

TEST(JoinedParts, of_a_join_that_the_scene_does_not_have_are_refused) {
    TwoBlocks blocks(10);
    blocks.scene.joins.clear();
    try {
        const InitialSprings drawn(blocks.set(), blocks.scene);
        FAIL() << "nobody minds";
    } catch (const InputError& error) {
        EXPECT_THAT(error.what(), HasSubstr("bonds of a [[join]] that is not in the scene"));
    }
}

}  // namespace
}  // namespace dmp::tests::solver_joined_parts_tests
