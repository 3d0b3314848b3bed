// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
//
// Elastic bodies of cells that turn, spin and vibrate, and their largest explicit step.
#include <Eigen/Dense>
#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "tests/modules.hpp"
#include "tests/unit/solver/cell_bodies.hpp"

namespace dmp::tests::solver_cell_motion_tests {
namespace {

using namespace cell_bodies;

constexpr double pi = std::numbers::pi;

/// A disc of radius 1.
Region disc() {
    Polyline edge;
    edge.closed = true;
    for (int n = 0; n < 60; ++n) edge.points.emplace_back(std::cos(pi * n / 30), std::sin(pi * n / 30), 0);
    return {"beam", {edge}};
}

SolidCells cells_of_disc(double a, const Vec& shift) {
    const Region region = disc();
    const BoxLattice boxes = lattice(2, a, a * shift);
    return RegionOnBoxes(region, boxes).cells();
}

/// A ball of radius 1, from 6^3 points in each box.
SolidCells cells_of_ball(double a, const Vec& shift) {
    const BoxLattice boxes = lattice(3, a, a * shift);
    const int points = 6, reach = static_cast<int>(std::ceil(1 / a)) + 1;
    const auto filling = [&](const std::array<int, 3>& box) {
        Filling sum;
        for (int n = 0; n < points * points * points; ++n) {
            const Vec at = boxes.corner(box) +
                           a / points * Vec(n % points + 0.5, n / points % points + 0.5, n / points / points + 0.5);
            if (at.norm() > 1) continue;
            const double edge = a / points;
            const Filling small{edge * edge * edge, at, Vec::Constant(edge * edge / 12)};
            if (sum.volume > 0)
                sum.add(small);
            else
                sum = small;
        }
        return sum;
    };
    return solid_cells(boxes, {-reach, -reach, -reach}, {reach, reach, reach},
                       {filling, [](const auto& /*box*/, int /*axis*/) { return true; }});
}

template <int D>
SolidCells some_cut_body();
template <>
SolidCells some_cut_body<2>() {
    return cells_of_disc(0.45, Vec(0.3, 0.13, 0));
}
template <>
SolidCells some_cut_body<3>() {
    return cells_of_ball(0.7, Vec(0.3, 0.13, 0.4));
}

Material material_of(std::size_t law) { return {3, 0.3, 2, ElasticLaw(law)}; }

template <int D>
void expect_no_force_when_turned() {
    Eigen::Matrix3d turn = Eigen::AngleAxisd(pi, Vec::UnitZ()).toRotationMatrix();
    if (D == 3) turn = Eigen::AngleAxisd(pi, Vec(1, 2, -1).normalized()).toRotationMatrix();
    for (std::size_t law = 0; law < ElasticLaws::size; ++law) {
        CellBody<D> body = body_of<D>(some_cut_body<D>(), material_of(law));
        auto& network = body.network();
        for (std::size_t n = 0; n < network.nodes(); ++n)
            network.positions()[n] = of_space<D>(turn * network.rest_position(n));
        for (const auto& force : network.forces(network.positions(), Vectors<D>(network.nodes()))) {
            EXPECT_LT(in_space<D>(force).norm(), 1e-14);
        }
        EXPECT_LT(std::abs(body.energy()), 1e-15);
    }
}

TEST(CutBody, has_no_force_when_turned_by_half_a_turn) {
    expect_no_force_when_turned<2>();
    expect_no_force_when_turned<3>();
}

/// What a body without outer forces keeps.
struct Kept {
    Vec momentum = Vec::Zero(), spin = Vec::Zero();
    double energy = 0;

    template <int D>
    explicit Kept(const SpringNetwork<D>& network) : energy(network.energy()) {
        for (std::size_t n = 0; n < network.nodes(); ++n) {
            const Vec v = in_space<D>(network.velocities()[n]);
            momentum += network.mass(n) * v;
            spin += network.mass(n) * network.position(n).cross(v);
            energy += 0.5 * network.mass(n) * v.squaredNorm();
        }
    }
};

template <int D>
void expect_kept(int steps) {
    for (std::size_t law = 0; law < ElasticLaws::size; ++law) {
        SCOPED_TRACE(to_string(ElasticLaw(law)));
        BodyParts parts = parts_of<D>(some_cut_body<D>(), material_of(law));
        const Vec spin = D == 2 ? Vec(0, 0, 0.5) : Vec(0.1, -0.2, 0.5),
                  drift = D == 2 ? Vec(0.2, -0.1, 0) : Vec(0.2, -0.1, 0.1);
        double mass = 0, amount = 0;
        for (BodyParts::Node& node : parts.nodes) {
            node.position = Vec(1.1, 0.95, 1).cwiseProduct(node.rest_position);
            node.position[0] += 0.1 * node.rest_position[1];
            node.velocity = drift + spin.cross(node.position);
            mass += node.mass;
            amount += node.mass * node.velocity.norm();
        }
        CellBody<D> body = body_of<D>(parts);
        auto& network = body.network();
        const double dt = 0.2 * body.step_limit();
        const Kept before(network);
        const double rounding = std::numeric_limits<double>::epsilon() * steps * amount;
        const int blocks = 100;
        std::vector<double> energies;
        for (int block = 0; block < blocks; ++block) {
            double sum = 0;
            for (int part = 0; part < 10; ++part) {
                network.advance_subcycled(dt * steps / blocks / 10, steps / blocks / 10);
                sum += Kept(network).energy / 10;
            }
            energies.push_back(sum);
        }
        const Kept after(network);
        const auto mean = [&](int from, int to) {
            double sum = 0;
            for (int n = from; n < to; ++n) sum += energies[n] / (to - from);
            return sum;
        };
        EXPECT_LT((after.momentum - before.momentum).norm(), rounding);
        EXPECT_LT((after.spin - before.spin).norm(), rounding);
        EXPECT_NEAR(mean(blocks / 2, blocks) / mean(0, blocks / 2), 1, 1e-4);
        EXPECT_NEAR(after.energy / before.energy, 1, 1e-2);
    }
}

TEST(CutBodyInFlight, keeps_momentum_spin_and_energy_over_many_steps) { expect_kept<2>(100000); }
TEST(CutBodyInFlight, keeps_momentum_spin_and_energy_in_3d) { expect_kept<3>(20000); }

/// exp(A), by Taylor's series of a small part and squaring.
Eigen::Matrix4d exponential(const Eigen::Matrix4d& a) {
    Eigen::Matrix4d sum = Eigen::Matrix4d::Identity(), term = sum;
    for (int n = 1; n < 16; ++n) {
        term = term * (a / 1024) / n;
        sum += term;
    }
    for (int n = 0; n < 10; ++n) sum = (sum * sum).eval();
    return sum;
}

/// The lowest frequency of Timoshenko's cantilever of thickness 1 and this length [rad/s], in plane strain: the state
/// (w, psi, M, Q) along it, from no motion at the clamp to no moment and shear force at the end.
double lowest_of_timoshenko(double length, const Material& material) {
    const double ei = material.held_modulus() / 12, ga = 5.0 / 6 * material.constants().mu, rho = material.density;
    const auto left_at_end = [&](double omega) {
        Eigen::Matrix4d rate = Eigen::Matrix4d::Zero();
        rate(0, 1) = 1;
        rate(0, 3) = 1 / ga;
        rate(1, 2) = 1 / ei;
        rate(2, 1) = -rho / 12 * omega * omega;
        rate(2, 3) = -1;
        rate(3, 0) = -rho * omega * omega;
        return exponential(rate * length).bottomRightCorner<2, 2>().determinant();
    };
    double low = 0.5 * std::sqrt(ei / rho) * std::pow(1.875 / length, 2), high = 3 * low;
    for (int n = 0; n < 60; ++n) {
        const double middle = (low + high) / 2;
        (left_at_end(low) * left_at_end(middle) > 0 ? low : high) = middle;
    }
    return low;
}

/// The lowest frequency of a body [rad/s], by inverse iteration.
double lowest_frequency(const CellBody<2>& body) {
    const Unknowns<2> unknowns(body);
    const auto& network = body.network();
    const Eigen::VectorXd mass = unknowns.row(on_nodes<2>(body, [](const Vec&, double m) { return Vec(m, m, 0); }));
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(unknowns.stiffness(network.positions_at_rest()));
    Eigen::VectorXd mode = mass;
    double square = 0;
    for (int n = 0; n < 20; ++n) {
        const Eigen::VectorXd next = solver.solve(mass.cwiseProduct(mode));
        square = mode.dot(mass.cwiseProduct(mode)) / mode.dot(mass.cwiseProduct(next));
        mode = next / next.norm();
    }
    return std::sqrt(square);
}

TEST(VibratingCantilever, has_the_frequency_of_a_beam) {
    const Material material;
    for (const int across : {2, 4, 8}) {
        const double a = 1.0 / across;
        const CellBody<2> body = body_of<2>(block(lattice(2, a), {10 * across, across, 1}), material,
                                            [=](const Vec& at) { return at[0] < 1e-6 * a; });
        const double ratio = lowest_frequency(body) / lowest_of_timoshenko(10, material);
        EXPECT_NEAR(ratio, 1, 0.005) << across << " across";
    }
}

/// omega_max a / c, from the largest explicit step.
double highest_frequency(const CellBody<2>& body, double a, const Material& material) {
    return 2 / (std::sqrt(1.02) * body.step_limit()) * a / material.sound_speed();
}

TEST(LargestStep, of_full_cells_is_that_of_two_sound_speeds_a_spacing) {
    for (const double nu : {0.25, 0.4, 0.49}) {
        const Material material{1, nu};
        const double of_square =
            highest_frequency(body_of<2>(block(lattice(2, 0.125), {8, 8, 1}), material), 0.125, material);
        EXPECT_GT(of_square, 2.0);
        EXPECT_LT(of_square, 2.25);  // 2.248: nodes at the sides are lighter for the moment of inertia
    }
}

TEST(LargestStep, of_cut_cells_is_less) {
    const Material material;
    std::mt19937_64 random{11};
    std::uniform_real_distribution<double> share(0, 1);
    for (int n = 0; n < 6; ++n) {
        const Vec shift(share(random), share(random), 0);
        const double of_disc = highest_frequency(body_of<2>(cells_of_disc(0.25, shift), material), 0.25, material);
        EXPECT_GT(of_disc, 2.0);
        EXPECT_LT(of_disc, 3.0);
    }
}

}  // namespace
}  // namespace dmp::tests::solver_cell_motion_tests
