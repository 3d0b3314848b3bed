// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
//
// Large deflections of elastic bodies of cells in 2-D.
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "tests/modules.hpp"
#include "tests/unit/solver/cell_bodies.hpp"

namespace dmp::tests::solver_cell_deflections_tests {
namespace {

using namespace cell_bodies;

TEST(Elastica, of_either_law_is_that_of_a_thin_beam) {
    // P L^2 / EI = 5: Bisshopp & Drucker 1945, by elliptic integrals.
    for (std::size_t law = 0; law < ElasticLaws::size; ++law)
        for (const int across : {2, 4, 8}) {
            const double length = 20;
            const Material material{1, 0.25, 1, ElasticLaw(law)};
            CellBody<2> body = cantilever(across, 20, material);
            const double force = 5 * material.held_modulus() / 12 / (length * length);
            settle(body, on_end<2>(body, length, 1, 1.0 / across, [&](const Vec&) { return Vec(0, force, 0); }), 5);
            const Vec end = tip(body, length);
            EXPECT_NEAR(end[1] / length, 0.71379, 0.005 * 0.71379);
            EXPECT_NEAR(-end[0] / length, 0.38763, 0.005 * 0.38763);
        }
}

/// The bar of Turek & Hron 2006 behind its cylinder: from the cylinder of radius 0.05 m around (0.2, 0.2) m to 0.6 m,
/// 0.02 m thick.
Region bar_behind_cylinder(std::vector<Vec>& root) {
    const double radius = 0.05, half = 0.01, edge = std::asin(half / radius);
    const int arcs = 200;
    root.clear();
    for (int n = 0; n <= arcs; ++n) {
        const double angle = edge * (1 - 2.0 * n / arcs);
        root.emplace_back(0.2 + radius * std::cos(angle), 0.2 + radius * std::sin(angle), 0);
    }
    Polyline outline{root, true};
    outline.points.emplace_back(0.6, 0.2 - half, 0);
    outline.points.emplace_back(0.6, 0.2 + half, 0);
    return {"beam", {outline}};
}

/// How far the middle of the end of a bar of this solid has moved under its weight.
Vec moved_by_weight(const SolidCells& solid, const Pick& clamped) {
    CellBody<2> body = body_of<2>(solid, {1.4e6, 0.4, 1000}, clamped);
    settle(body, on_nodes<2>(body, [](const Vec&, double mass) { return Vec(0, -2 * mass, 0); }), 4);
    return at_node(body, Vec(0.6, 0.2, 0));
}

constexpr double benchmark_x = -7.187e-3, benchmark_y = -66.10e-3;  ///< CSM1 of Turek & Hron 2006 [m]

TEST(BarBehindCylinder, hangs_as_in_the_benchmark_where_nodes_stand_on_the_corners_of_its_root) {
    for (const auto& [across, bound] : {std::pair{2, 0.01}, std::pair{4, 0.003}, std::pair{8, 0.003}}) {
        const double a = 0.02 / across, root = 0.2 + std::sqrt(0.05 * 0.05 - 0.01 * 0.01);
        const int along = static_cast<int>(std::lround((0.6 - root) / a));
        const BoxLattice boxes{2, Vec(root, 0.19, 0), Vec((0.6 - root) / along, a, 0)};
        const Vec end =
            moved_by_weight(block(boxes, {along, across, 1}), [&](const Vec& at) { return at[0] < root + 1e-6 * a; });
        EXPECT_NEAR(end[0] / benchmark_x, 1, bound) << across << " across";
        EXPECT_NEAR(end[1] / benchmark_y, 1, bound) << across << " across";
    }
}

TEST(BarBehindCylinder, is_as_long_as_the_nodes_that_are_clamped_tell) {
    for (const int across : {2, 4, 8}) {
        const double a = 0.02 / across;
        std::vector<Vec> root;
        const Region region = bar_behind_cylinder(root);
        const NearestCurve cylinder({"cylinder", {{root, false}}}, a);
        const BoxLattice boxes = lattice(2, a, Vec(0.6, 0.19, 0));
        // The row of nodes nearest to the cylinder is clamped: half a spacing from it at most.
        const Vec end = moved_by_weight(RegionOnBoxes(region, boxes).cells(), [&](const Vec& at) {
            const auto nearest = cylinder.nearest(at);
            return nearest && nearest->distance <= (0.5 + 1e-6) * a;
        });
        // A deflection goes with the fourth power of the length.
        EXPECT_NEAR(end[1] / benchmark_y, 1, 4 * (a / 2) / 0.35) << across << " across";
    }
}

}  // namespace
}  // namespace dmp::tests::solver_cell_deflections_tests
