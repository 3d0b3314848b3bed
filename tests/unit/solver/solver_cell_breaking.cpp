// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Solids of cells that tear: which face breaks, at what load, and what is left.
#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "solver/elastic/body_change.hpp"
#include "solver/elastic/cut_cells.hpp"
#include "tests/unit/solver/cell_bodies.hpp"

namespace dmp::tests::solver_cell_breaking_tests {
namespace {

using namespace cell_bodies;

constexpr double a = 0.25;
using Pairs = std::vector<std::array<int, 2>>;
const Material rubber{1e4, 0.3, 1000, {}};

ParticleSpace space(int dimension) {
    ParticleSpace of;
    of.dimension = dimension;
    of.spacing = a;
    of.box = {Vec(-100, -100, dimension == 3 ? -100 : 0), Vec(100, 100, dimension == 3 ? 100 : 0)};
    return of;
}

template <int D>
BodyParts block_of(const std::array<int, 3>& count, const Pick& clamped = nowhere) {
    return parts_of<D>(block(lattice(D, a), count), rubber, clamped);
}

/// Positions of the nodes and of the particles, by F X.
void deform(BodyParts& parts, const Eigen::Matrix3d& gradient) {
    for (BodyParts::Node& node : parts.nodes) node.position = node.position_before = gradient * node.rest_position;
}

Eigen::Matrix3d turned(double angle) { return Eigen::AngleAxisd(angle, Vec::UnitZ()).toRotationMatrix(); }

double mass_of(const BodyParts& parts) {
    return std::accumulate(parts.nodes.begin(), parts.nodes.end(), 0.0,
                           [](double sum, const auto& node) { return sum + node.mass; });
}
Vec momentum_of(const BodyParts& parts) {
    Vec sum = Vec::Zero();
    for (const BodyParts::Node& node : parts.nodes) sum += node.mass * node.velocity;
    return sum;
}

/// Pairs of particles along x on both sides of the plane between column `left` and the next one, of the rows given.
Pairs across(const BodyParts& parts, int left, int rows) {
    Pairs ends;
    for (const BodyParts::Face& face : parts.faces) {
        const BodyParts::Cell& low = parts.cells[face.cell[0]];
        const Vec corner = parts.nodes[low.node[0]].rest_position;
        if (face.axis == 0 && std::lround(corner[0] / a) == left && std::lround(corner[1] / a) < rows)
            ends.push_back({low.id, parts.cells[face.cell[1]].id});
    }
    return ends;
}

TEST(CellFaces, are_those_between_neighbours) {
    EXPECT_EQ(block_of<2>({4, 3, 1}).faces.size(), 3U * 3 + 4 * 2);
    EXPECT_EQ(block_of<3>({4, 3, 2}).faces.size(), 3U * 3 * 2 + 4 * 2 * 2 + 4 * 3 * 1);
    // A row that closes through a periodic side: of two cells, which share two faces, and of three.
    for (const int period : {2, 3}) {
        BoxLattice ring = lattice(2, a);
        ring.period[0] = period;
        SolidCells solid = block(ring, {period, 1, 1});
        EXPECT_EQ(faces_between(parts_of<2>(solid, rubber).cells, 4).size(), static_cast<std::size_t>(period));
    }
}

TEST(CutCells, split_the_nodes_whose_cells_no_longer_hang_together) {
    BodyParts whole = block_of<2>({32, 16, 1});
    for (BodyParts::Node& node : whole.nodes) node.velocity = Vec(node.rest_position[1], 1 - node.rest_position[0], 0);
    const auto check = [&](int rows, std::size_t pieces, std::size_t new_nodes) {
        const auto between = across(whole, 15, rows);
        ASSERT_EQ(between.size(), static_cast<std::size_t>(rows));
        const CutSolid cut = cut_faces(whole, between, 2);
        ASSERT_EQ(cut.pieces.size(), pieces);
        EXPECT_EQ(cut.broken.size(), between.size());
        std::size_t nodes = 0, cells = 0;
        double mass = 0;
        Vec momentum = Vec::Zero();
        for (const BodyParts& piece : cut.pieces) {
            nodes += piece.nodes.size();
            cells += piece.cells.size();
            mass += mass_of(piece);
            momentum += momentum_of(piece);
        }
        EXPECT_EQ(nodes, whole.nodes.size() + new_nodes);
        EXPECT_EQ(cells, whole.cells.size());
        EXPECT_NEAR(mass / mass_of(whole), 1, 1e-14);
        EXPECT_LT((momentum - momentum_of(whole)).norm(), 1e-12 * momentum_of(whole).norm());
    };
    check(1, 1, 1);
    check(5, 1, 5);
    check(16, 2, 17);
}

TEST(CutCells, one_face_inside_splits_no_node_and_is_not_joined_again) {
    const BodyParts whole = block_of<2>({4, 4, 1});
    const std::array<int, 2> inside = across(whole, 1, 2)[1];
    const CutSolid cut = cut_faces(whole, Pairs{inside}, 2);
    ASSERT_EQ(cut.pieces.size(), 1U);
    EXPECT_EQ(cut.pieces[0].nodes.size(), whole.nodes.size());
    EXPECT_EQ(cut.pieces[0].faces.size(), whole.faces.size() - 1);
    EXPECT_EQ(cut_faces(cut.pieces[0], Pairs{inside}, 2).broken.size(), 0U) << "it has broken already";
    // With its neighbour above it does: the crack's middle opens.
    const CutSolid longer = cut_faces(cut.pieces[0], Pairs{across(whole, 1, 3)[2]}, 2);
    ASSERT_EQ(longer.pieces.size(), 1U);
    EXPECT_EQ(longer.pieces[0].nodes.size(), whole.nodes.size() + 1);
}

TEST(CutCells, cut_a_block_in_two) {
    const BodyParts whole = block_of<3>({4, 3, 2});
    const Pairs between = across(whole, 1, 3);
    ASSERT_EQ(between.size(), 6U);
    const CutSolid cut = cut_faces(whole, between, 3);
    ASSERT_EQ(cut.pieces.size(), 2U);
    EXPECT_EQ(cut.pieces[0].cells.size(), 12U);
    EXPECT_EQ(cut.pieces[1].nodes.size(), 3U * 4 * 3);
    EXPECT_EQ(cut.pieces[0].faces.size() + cut.pieces[1].faces.size() + 6, whole.faces.size());
}

TEST(CutCells, keep_clamps_drag_and_the_forces_on_each_cell) {
    BodyParts whole = block_of<2>({6, 2, 1}, [](const Vec& at) { return at[0] < 1e-9; });
    for (BodyParts::Cell& cell : whole.cells) cell.drag = 0.5;
    for (BodyParts::Node& node : whole.nodes) node.drag = 0.5 / 1000 / a / a * node.mass;
    Eigen::Matrix3d stretched = turned(0.4);
    stretched.col(0) *= 1.2;
    deform(whole, stretched);
    BodyChange change;
    change.broken = across(whole, 2, 2);
    const ChangedBodies cut = change_bodies({whole}, change, space(2));
    ASSERT_EQ(cut.bodies.size(), 2U);
    EXPECT_EQ(cut.broken, (std::vector{0, 0}));
    double drag = 0, energy = 0;
    std::size_t fixed = 0;
    for (const BodyParts& piece : cut.bodies) {
        for (const BodyParts::Node& node : piece.nodes) {
            drag += node.drag;
            fixed += node.fixed ? 1 : 0;
        }
        energy += body_of<2>(piece).energy();
    }
    EXPECT_NEAR(drag, 12 * 0.5, 1e-12);
    EXPECT_EQ(fixed, 3U);
    EXPECT_NEAR(energy / body_of<2>(whole).energy(), 1, 1e-13) << "nothing has moved";
}

TEST(CellBreaking, is_at_the_principal_tension_at_any_angle_to_the_lattice) {
    constexpr double limit = 100;
    for (const double angle : {0.0, 0.3, 0.7, 0.7853981633974483, 1.3}) {
        for (const double over : {0.999, 1.001}) {
            // Small strains: e = sigma / E' along, free across; then the whole is turned.
            const double held = rubber.held_modulus(), nu = rubber.poisson_ratio / (1 - rubber.poisson_ratio);
            Eigen::Matrix3d strain = Eigen::Vector3d(1, -nu, 0).asDiagonal();
            strain *= over * limit / held;
            const Eigen::Matrix3d q = turned(angle);
            BodyParts parts = block_of<2>({4, 4, 1});
            deform(parts, turned(-0.8) * (Eigen::Matrix3d::Identity() + q * strain * q.transpose()));
            // Of a large strain (1 %) the two stresses differ: what counts is Cauchy's.
            const CellBody<2> body = body_of<2>(parts);
            const auto virial = body.virial();
            Eigen::Matrix2d stress;
            stress << -virial[5][0], -virial[5][3], -virial[5][3], -virial[5][1];
            stress /= a * a * body.volume_ratio(5);
            const double largest = Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(stress).eigenvalues()[1];
            EXPECT_NEAR(largest / (over * limit), 1, 0.03);
            const SolidBreak here{SolidBreak::Criterion::stress, largest / over};
            EXPECT_EQ(body.overloaded_face(here, 0).has_value(), over > 1) << "at an angle of " << angle;
            EXPECT_FALSE(body.overloaded_face(here, 1)) << "of another origin";
            const SolidBreak by_strain{SolidBreak::Criterion::strain, limit / held};
            EXPECT_EQ(body.overloaded_face(by_strain, 0).has_value(), over > 1) << "at an angle of " << angle;
        }
    }
}

TEST(CellBreaking, is_not_by_compression_nor_by_pressure) {
    const SolidBreak by_stress{SolidBreak::Criterion::stress, 1e-3}, by_strain{SolidBreak::Criterion::strain, 1e-6};
    BodyParts parts = block_of<3>({3, 2, 2});
    deform(parts, 0.9 * Eigen::Matrix3d(turned(0.5)));
    EXPECT_FALSE(body_of<3>(parts).overloaded_face(by_stress, 0));
    EXPECT_FALSE(body_of<3>(parts).overloaded_face(by_strain, 0));
    deform(parts, turned(1.9));
    EXPECT_FALSE(body_of<3>(parts).overloaded_face(by_stress, 0)) << "a turn is no strain";
}

TEST(CellBreaking, starts_across_the_tension_and_where_it_is_largest) {
    BodyParts parts = block_of<2>({8, 2, 1});
    for (BodyParts::Node& node : parts.nodes) {
        const double x = node.rest_position[0];  // the strain grows with x
        node.position = node.position_before = node.rest_position + Vec(0.01 * x * x, 0, 0);
    }
    const auto ends = body_of<2>(parts).overloaded_face({SolidBreak::Criterion::stress, 1}, 0);
    ASSERT_TRUE(ends);
    const auto expected = across(parts, 6, 1)[0];
    EXPECT_EQ((std::set{(*ends)[0], (*ends)[1]}), (std::set{expected[0], expected[1]}));
}

/// Pulls a bar apart whose column in the middle is weak, as in a test of tension, and returns the pieces.
template <int D>
void tear(int across_bar, SpringStepping stepping) {
    constexpr double strength = 300;  // Pa; a strain of 3 %
    Material material = rubber;
    material.poisson_ratio = 0;
    const int length = 8 * across_bar;
    SolidCells solid = block(lattice(D, a), {length, across_bar, D == 3 ? across_bar : 1});
    BodyParts parts =
        parts_of<D>(solid, material, [&](const Vec& at) { return at[0] < 1e-9 || at[0] > length * a - 1e-9; });
    const double dt = (stepping == SpringStepping::implicit ? 2.0 : 0.5) * a / material.sound_speed();
    const double speed = 1e-3 * material.sound_speed(), pulled = length * a;
    const SolidBreak law{SolidBreak::Criterion::stress, strength};
    // It begins uniformly strained, and with velocities that go on with that: no waves.
    for (BodyParts::Node& node : parts.nodes) {
        node.position[0] = node.position_before[0] =
            node.rest_position[0] * (1 + 0.95 * strength / rubber.youngs_modulus);
        node.velocity[0] = node.fixed ? 0 : speed * node.rest_position[0] / pulled;
    }
    std::vector<BodyParts> bodies{parts};
    double load = 0, at_break = 0;
    int steps = 0;
    const auto pull = [&](BodyParts& body) {
        for (BodyParts::Node& node : body.nodes)
            if (node.fixed && node.rest_position[0] > a) node.position[0] += speed * dt;
    };
    const auto end_of = [](const BodyParts& body) {
        return std::ranges::max(body.nodes, {}, [](const auto& node) { return node.position[0]; }).position[0];
    };
    std::size_t faces = 0;
    for (; steps < 4000 && bodies.size() == 1; ++steps) {
        std::vector<BodyParts> next;
        for (BodyParts& each : bodies) {
            pull(each);
            CellBody<D> body = body_of<D>(each);
            const auto of_anchors = body.advance(std::vector<Vec>(body.nodes(), Vec::Zero()), dt,
                                                 stepping == SpringStepping::implicit ? 0 : 1);
            (void)of_anchors;
            const BodyParts now = body.parts();
            const auto virial = body.virial();
            load = 0;
            for (std::size_t p = 0; p < body.nodes(); ++p) load -= virial[p][0];
            load /= end_of(now);  // mean force along the bar
            if (const auto ends = body.overloaded_face(law, 0)) {
                if (at_break == 0) at_break = load;
                ++faces;
                for (BodyParts& piece : cut_faces(now, Pairs{*ends}, D).pieces) next.push_back(std::move(piece));
            } else {
                next.push_back(now);
            }
        }
        bodies = std::move(next);
    }
    ASSERT_EQ(bodies.size(), 2U) << "after " << steps << " steps";
    const double area = std::pow(across_bar * a, D - 1);
    // Cauchy's strength acts on the current section; with nu = 0 that is the one at rest.
    EXPECT_NEAR(at_break / (strength * area), 1, 0.01);
    EXPECT_GE(faces, static_cast<std::size_t>(std::pow(across_bar, D - 1)));
    std::size_t cells = 0;
    for (const BodyParts& body : bodies) cells += body.cells.size();
    EXPECT_EQ(cells, parts.cells.size());
    EXPECT_NEAR((mass_of(bodies[0]) + mass_of(bodies[1])) / mass_of(parts), 1, 1e-13);
}

TEST(CellBreaking, a_bar_pulled_apart_bears_its_strength_and_is_two_pieces_then) {
    for (const SpringStepping stepping : {SpringStepping::implicit, SpringStepping::subcycled}) {
        tear<2>(4, stepping);
        tear<3>(2, stepping);
    }
}

}  // namespace
}  // namespace dmp::tests::solver_cell_breaking_tests
