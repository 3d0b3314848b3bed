// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
//
// Masses of the nodes of solids of cells, and how such solids turn.
#include <cmath>
#include <numbers>

#include <gmock/gmock.h>

#include "models/elastic/corner_masses.hpp"
#include "tests/modules.hpp"
#include "tests/unit/solver/cell_bodies.hpp"

namespace dmp::tests::solver_cell_masses_tests {
namespace {

using namespace cell_bodies;

constexpr double pi = std::numbers::pi;
const Material stuff{100, 0.25, 3};

/// Mass, centroid and second moments of the nodes about it.
struct Moments {
    double mass = 0, least = std::numeric_limits<double>::infinity();
    Vec centroid = Vec::Zero();
    Eigen::Matrix3d second = Eigen::Matrix3d::Zero();

    explicit Moments(const BodyParts& parts) {
        for (const BodyParts::Node& node : parts.nodes) {
            mass += node.mass;
            least = std::min(least, node.mass);
            centroid += node.mass * node.rest_position;
        }
        centroid /= mass;
        for (const BodyParts::Node& node : parts.nodes) {
            const Vec arm = node.rest_position - centroid;
            second += node.mass * arm * arm.transpose();
        }
    }
};

TEST(CellMasses, of_blocks_have_the_moments_of_the_solid) {
    for (const int n : {2, 3, 4, 9})
        for (const int length : {n, 3 * n + 1}) {
            SCOPED_TRACE(std::to_string(length) + " x " + std::to_string(n));
            const double a = 0.1;
            const Moments plane(parts_of<2>(block(lattice(2, a), {length, n, 1}), stuff));
            EXPECT_NEAR(plane.mass / (3 * n * length * a * a), 1, 1e-12);
            EXPECT_NEAR(plane.second(0, 0) / (plane.mass * length * length * a * a / 12), 1, 1e-11);
            EXPECT_NEAR(plane.second(1, 1) / (plane.mass * n * n * a * a / 12), 1, 1e-11);
            EXPECT_NEAR(plane.second(0, 1), 0, 1e-12 * plane.second(0, 0));
            const Moments space(parts_of<3>(block(lattice(3, a), {length, n, n}), stuff));
            EXPECT_NEAR(space.second(0, 0) / (space.mass * length * length * a * a / 12), 1, 1e-11);
            EXPECT_NEAR(space.second(2, 2) / (space.mass * n * n * a * a / 12), 1, 1e-11);
            EXPECT_GT(space.least, least_kept_mass * 3 * a * a * a / 8);
        }
}

TEST(CellMasses, of_a_block_two_cells_across_are_the_weights_of_simpsons_rule) {
    for (const BodyParts::Node& node : parts_of<3>(block(lattice(3, 1), {2, 2, 2}), stuff).nodes) {
        double weight = 3 * 8;
        for (int axis = 0; axis < 3; ++axis) weight *= node.rest_position[axis] == 1 ? 2.0 / 3 : 1.0 / 6;
        EXPECT_NEAR(node.mass, weight, 1e-12);
    }
}

/// A disc of radius 1 and a square of 1 m turned by 20 degrees, on lattices that cut their cells anywhere.
TEST(CellMasses, of_cut_solids_have_the_moments_of_what_is_drawn) {
    for (const bool round : {true, false})
        for (const int across : {4, 8})
            for (int place = 0; place < 6; ++place) {
                Polyline edge;
                edge.closed = true;
                for (int n = 0; n < (round ? 120 : 4); ++n) {
                    const double angle = round ? pi * n / 60 : pi * (n / 2.0 + 1.0 / 9);
                    edge.points.emplace_back(std::cos(angle), std::sin(angle), 0);
                }
                const double a = (round ? 2 : std::sqrt(2)) / across;
                const Region region{"beam", {edge}};
                const BoxLattice boxes = lattice(2, a, a * Vec(0.17 * place, 0.31 * place, 0));
                const BodyParts parts = parts_of<2>(RegionOnBoxes(region, boxes).cells(), stuff);
                const Moments moments(parts);
                const double area = round ? 60 * std::sin(pi / 60) : 2;
                const double about_middle = moments.mass * (round ? (2 + std::cos(pi / 60)) / 6 : 4.0 / 12);
                EXPECT_NEAR(moments.mass / (3 * area), 1, 1e-9);
                EXPECT_NEAR(moments.second.trace() / about_middle, 1, 1e-9) << round << across << place;
                EXPECT_GT(moments.least, 0);
            }
}

TEST(CellMasses, of_one_cell_across_stay_as_they_are_across_it) {
    const Moments row(parts_of<2>(block(lattice(2, 1), {7, 1, 1}), stuff));
    EXPECT_NEAR(row.second(0, 0) / (21 * 49.0 / 12), 1, 1e-11);
    EXPECT_NEAR(row.second(1, 1) / (21 / 4.0), 1, 1e-12);
}

TEST(CellMasses, through_a_periodic_side_change_across_it_only) {
    BoxLattice ring = lattice(2, 1);
    ring.period[0] = 6;
    for (const BodyParts::Node& node : parts_of<2>(block(ring, {6, 2, 1}), stuff).nodes)
        EXPECT_NEAR(node.mass, node.rest_position[1] == 1 ? 4 : 1, 1e-12);
}

/// Forces on the particles of a body that are a couple of this moment [N m].
template <int D>
std::vector<Vec> couple(const CellBody<D>& body, double moment) {
    Vec middle = Vec::Zero();
    for (std::size_t p = 0; p < body.nodes(); ++p) middle += body.position(p) / static_cast<double>(body.nodes());
    double sum = 0;
    std::vector<Vec> force;
    for (std::size_t p = 0; p < body.nodes(); ++p) {
        const Vec arm = body.position(p) - middle;
        force.push_back(Vec::UnitZ().cross(arm));
        sum += arm.head<2>().squaredNorm();
    }
    for (Vec& each : force) each *= moment / sum;
    return force;
}

/// A block of n cells across gets a couple's impulse, and tumbles: its period over that of the solid,
/// which its spin of 0.2 rad/s stretches by 10^-4.
template <int D>
double tumbles(int n, int substeps) {
    const double a = 1.0 / n, mass = 3, inertia = mass / 6, moment = 0.1, kick = 0.02;
    BodyParts parts = parts_of<D>(block(lattice(D, a), {n, n, D == 3 ? n : 1}), stuff);
    for (BodyParts::Cell& cell : parts.cells) cell.relaxation = 0.02;
    CellBody<D> body = body_of<D>(parts);
    const std::vector<Vec> force = couple(body, moment / kick);
    (void)body.advance(force, kick, substeps);
    const std::vector<Vec> none(force.size(), Vec::Zero());
    const auto angle = [&] {
        const Vec arm = body.position(force.size() - 1) - body.position(0);
        return std::atan2(arm[1], arm[0]);
    };
    double turned = 0, last = angle();
    const int steps = 500;
    const auto follow = [&](int count) {
        for (int step = 0; step < count; ++step) {
            (void)body.advance(none, kick, substeps);
            turned += std::remainder(angle() - last, 2 * pi);
            last = angle();
        }
    };
    follow(100);  // until it no longer vibrates
    turned = 0;
    follow(steps);
    const double speed = turned / (steps * kick);
    return moment / inertia / speed;
}

TEST(TumblingBlock, has_the_period_of_the_solid) {
    for (const int n : {2, 3, 6}) {
        SCOPED_TRACE(n);
        EXPECT_NEAR(tumbles<2>(n, 0), 1, 5e-4);
        if (n < 6) {
            EXPECT_NEAR(tumbles<3>(n, 0), 1, 5e-4);
        }
    }
    EXPECT_NEAR(tumbles<2>(3, 80), 1, 5e-4) << "sub-cycled";
}

TEST(FreeBody, has_the_momentum_and_moment_of_momentum_that_its_particles_are_given) {
    CellBody<2> body = body_of<2>(block(lattice(2, 0.5), {5, 3, 1}), stuff);
    std::vector<Vec> force;
    for (std::size_t p = 0; p < body.nodes(); ++p)
        force.emplace_back(std::sin(3.0 * static_cast<double>(p)), std::cos(5.0 * static_cast<double>(p)), 0);
    Vec momentum = Vec::Zero(), spin = Vec::Zero();
    const double dt = 1e-3;
    for (int step = 0; step < 50; ++step) {
        for (std::size_t p = 0; p < body.nodes(); ++p) {
            momentum += dt * force[p];
            spin += dt * body.position(p).cross(force[p]);
        }
        (void)body.advance(force, dt, 0);
    }
    Vec of_nodes = Vec::Zero(), of_particles = Vec::Zero();
    double turning = 0;
    const auto& network = body.network();
    for (std::size_t n = 0; n < network.nodes(); ++n) {
        of_nodes += network.mass(n) * network.velocity(n);
        turning += network.mass(n) * network.position(n).cross(network.velocity(n))[2];
    }
    for (std::size_t p = 0; p < body.nodes(); ++p) of_particles += body.mass(p) * body.velocity(p);
    EXPECT_LT((of_nodes - momentum).norm(), 1e-12 * momentum.norm());
    EXPECT_LT((of_particles - momentum).norm(), 1e-12 * momentum.norm());
    EXPECT_NEAR(turning / spin[2], 1, 1e-6);
}

}  // namespace
}  // namespace dmp::tests::solver_cell_masses_tests
