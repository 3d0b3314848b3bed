// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
//
// Bars of cells in 3-D: how they bend and twist.
#include <cmath>
#include <functional>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/modules.hpp"
#include "tests/unit/solver/cell_bodies.hpp"
#include "tests/unit/solver/lattice_solids.hpp"

namespace dmp::tests::solver_cell_bars_tests {
namespace {

using namespace cell_bodies;

constexpr double pi = std::numbers::pi;
constexpr double length = 8;  ///< of a bar of thickness 1 along x

/// A bar whose section is where `inside` says, by 20^2 points in each box.
SolidCells bar(double a, const Vec& shift, const std::function<bool(double y, double z)>& inside) {
    const BoxLattice boxes = lattice(3, a, a * shift);
    const int points = 20, reach = static_cast<int>(std::ceil(0.5 / a)) + 1;
    const double edge = a / points;
    const auto filling = [&](const std::array<int, 3>& box) {
        Filling sum;
        for (int n = 0; n < points * points; ++n) {
            const Vec at = boxes.corner(box) + Vec(a / 2, (n % points + 0.5) * edge, (n / points + 0.5) * edge);
            if (!inside(at[1], at[2])) continue;
            const Filling rod{a * edge * edge, at, Vec(a * a, edge * edge, edge * edge) / 12};
            if (sum.volume > 0)
                sum.add(rod);
            else
                sum = rod;
        }
        return sum;
    };
    return solid_cells(boxes, {0, -reach, -reach}, {static_cast<int>(std::lround(length / a)), reach, reach},
                       {filling, [](const auto& /*box*/, int /*axis*/) { return true; }});
}

/// A force density [N/m^3] in the last 1 m of both ends, opposite at the far one.
Vectors<3> at_both_ends(const CellBody<3>& body, const std::function<Vec(const Vec& at)>& density) {
    return on_particles<3>(body, [&](const Vec& at, double volume) -> Vec {
        if (at[0] < 1) return -volume * density(at);
        if (at[0] > length - 1) return volume * density(at);
        return Vec::Zero();
    });
}
double sum_at_near_end(const CellBody<3>& body, const std::function<double(const Vec& at)>& value) {
    double sum = 0;
    for (std::size_t p = 0; p < body.nodes(); ++p)
        if (const Vec at = body.rest_position(p); at[0] < 1)
            sum += body.network().cells()[p].element.volume * value(at);
    return sum;
}

/// GJ, from the turning of sections in the middle 3 m under couples at the ends.
double torsional_stiffness(const SolidCells& solid, const Material& material) {
    CellBody<3> body = body_of<3>(solid, material);
    const double volume = sum_at_near_end(body, [](const Vec&) { return 1; });
    const Vec middle(0, sum_at_near_end(body, [](const Vec& at) { return at[1]; }) / volume,
                     sum_at_near_end(body, [](const Vec& at) { return at[2]; }) / volume);
    const auto square = [&](const Vec& at) { return (at - middle).tail<2>().squaredNorm(); };
    respond(body, at_both_ends(body, [&](const Vec& at) { return Vec(0, middle[2] - at[2], at[1] - middle[1]); }));
    Eigen::Matrix2d sums = Eigen::Matrix2d::Zero();
    Eigen::Vector2d right = Eigen::Vector2d::Zero();
    for (std::size_t p = 0; p < body.nodes(); ++p) {
        const Vec at = body.rest_position(p), moved = body.displacement(p);
        if (std::abs(at[0] - length / 2) > 1.5) continue;
        const Eigen::Vector2d line(1, at[0] - length / 2);
        const double v = body.network().cells()[p].element.volume;
        sums += v * square(at) * line * line.transpose();
        right += v * ((at - middle)[1] * moved[2] - (at - middle)[2] * moved[1]) * line;
    }
    return sum_at_near_end(body, square) / sums.ldlt().solve(right)[1];
}

/// EI in the plane x, y, from the curvature of the middle 3 m under couples at the ends.
double bending_stiffness(const SolidCells& solid, const Material& material) {
    CellBody<3> body = body_of<3>(solid, material);
    const double middle = sum_at_near_end(body, [](const Vec& at) { return at[1]; }) /
                          sum_at_near_end(body, [](const Vec&) { return 1; });
    respond(body, at_both_ends(body, [&](const Vec& at) { return Vec(middle - at[1], 0, 0); }));
    std::vector<Vec> places, moved;
    for (std::size_t p = 0; p < body.nodes(); ++p) {
        const Vec at = body.rest_position(p);
        if (std::abs(at[0] - length / 2) > 1.5) continue;
        places.push_back(at - length / 2 * Vec::UnitX());
        moved.push_back(body.displacement(p));
    }
    const auto shapes = [](const Vec& x) {
        return (Eigen::VectorXd(6) << 1, x[0], x[1], x[0] * x[0] / 2, x[1] * x[1] - x[2] * x[2], x[2]).finished();
    };
    return sum_at_near_end(body, [&](const Vec& at) { return (at[1] - middle) * at[1]; }) /
           lattice_solids::fit(places, moved, 1, shapes)[3];
}

bool in_square(double y, double z) { return std::max(std::abs(y), std::abs(z)) < 0.5; }
bool in_disc(double y, double z) { return std::hypot(y, z) < 0.5; }

TEST(SquareBar, bends_exactly_and_twists_a_little_stiff) {
    const Material material{1, 0.3};
    for (const auto& [across, torsion] : {std::pair{2, 1.186}, std::pair{4, 1.052}, std::pair{6, 1.024}}) {
        const SolidCells solid = bar(1.0 / across, Vec::Zero(), in_square);
        const double twist = torsional_stiffness(solid, material) / (0.1406 * material.constants().mu);
        EXPECT_NEAR(bending_stiffness(solid, material), 1.0 / 12, 0.005 / 12) << across << " across";
        EXPECT_NEAR(twist, torsion, 0.01) << across << " across";
    }
}

TEST(RoundStrut, bends_and_twists_as_a_round_one_does) {
    const Material material{1, 0.3};
    const double ei = pi / 64, gj = pi / 32 * material.constants().mu;
    for (const auto& [across, bound] : {std::pair{4, 0.03}, std::pair{6, 0.01}}) {
        const SolidCells solid = bar(1.0 / across, Vec::Zero(), in_disc);
        EXPECT_NEAR(bending_stiffness(solid, material) / ei, 1, bound) << across << " across";
        EXPECT_NEAR(torsional_stiffness(solid, material) / gj, 1, bound) << across << " across";
    }
}

TEST(RoundStrut, twists_as_a_round_one_does_wherever_it_lies_on_the_lattice) {
    const Material material{1, 0.3};
    const double gj = pi / 32 * material.constants().mu;
    // In the last two places boxes are filled by just less than a cell needs.
    for (const auto& [shift, bound] :
         {std::pair{Vec(0, 0.5, 0.5), 0.002}, std::pair{Vec(0, 0.2, 0), 0.02}, std::pair{Vec(0, 0.45, 0.45), 0.035}})
        EXPECT_NEAR(torsional_stiffness(bar(0.25, shift, in_disc), material) / gj, 1, bound)
            << "shift " << shift.transpose();
}

}  // namespace
}  // namespace dmp::tests::solver_cell_bars_tests
