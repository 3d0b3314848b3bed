// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// The stress at the surface of cells.
#include <cmath>

#include <gtest/gtest.h>

#include "tests/modules.hpp"
#include "tests/unit/solver/cell_bodies.hpp"

namespace dmp::tests::solver_cell_surfaces_tests {
namespace {

using namespace cell_bodies;

/// A cell under a small strain that varies along one axis: in 2-D x = X (1 + c Y) and the dip that goes with it.
template <int D>
typename ElasticCell<D>::Corners bent(const ElasticCell<D>& /*cell*/, const Vec& size, double curvature) {
    typename ElasticCell<D>::Corners x;
    for (int k = 0; k < ElasticCell<D>::corners; ++k)
        for (int i = 0; i < D; ++i) x(i, k) = (k >> i & 1 ? 0.5 : -0.5) * size[i];
    for (int k = 0; k < ElasticCell<D>::corners; ++k) x(0, k) += curvature * x(0, k) * x(1, k);
    return x;
}

double von_mises_of(const Matrix<3>& s) {
    const Matrix<3> deviator = s - s.trace() / 3 * Matrix<3>::Identity();
    return std::sqrt(1.5 * deviator.squaredNorm());
}

TEST(CellSurfaces, have_the_stress_of_bending_there_and_none_in_the_middle) {
    constexpr double curvature = 1e-6, e = 1e6, nu = 0.3;
    const Vec size(0.1, 0.2, 0.1);
    const SaintVenantKirchhoff law{LameConstants::of(e, nu)};
    {
        const ElasticCell<2> cell(size.head<2>(), {0, 0}, 0.02, size.head<2>().cwiseAbs2() / 12, e, nu);
        const auto x = bent(cell, size, curvature);
        EXPECT_LT(cell.stress(law, x).norm(), 1e-6 * e * curvature);
        const double held = e / (1 - nu * nu) * curvature * 0.1;
        for (const auto& stress : cell.surface_stresses(law, x)) {
            EXPECT_NEAR(std::abs(stress(0, 0)), held, 1e-4 * held);
            EXPECT_NEAR(stress(2, 2), nu * stress(0, 0), 1e-4 * held);
            EXPECT_NEAR(von_mises_of(stress), std::sqrt(1 - nu + nu * nu) * held, 1e-4 * held);
        }
    }
    const ElasticCell<3> cell(size, Vec::Zero(), 0.002, size.cwiseAbs2() / 12, e, nu);
    const double held = e / (1 - nu * nu) * curvature * 0.1;
    for (const auto& stress : cell.surface_stresses(law, bent(cell, size, curvature))) {
        EXPECT_NEAR(std::abs(stress(0, 0)), held, 1e-4 * held);
        EXPECT_NEAR(stress(2, 2), nu * stress(0, 0), 1e-4 * held);
    }
}

TEST(CellSurfaces, of_a_cantilever_two_cells_thick_have_the_stress_of_the_beam) {
    const Material material{.youngs_modulus = 1e6, .poisson_ratio = 0.25};
    CellBody<2> beam = cantilever(2, 8, material);
    // Forces on the tip, of which the moment at a distance d is P d.
    constexpr double load = 1e-2;
    auto& network = beam.network();
    Vectors<2> force(network.nodes(), Vector<double, 2>{});
    std::vector<std::size_t> tip;
    for (std::size_t n = 0; n < network.nodes(); ++n)
        if (network.rest_position(n)[0] > 8 - 1e-9) tip.push_back(n);
    ASSERT_EQ(tip.size(), 3U);
    for (const std::size_t n : tip) force[n][1] = load / 3;
    respond(beam, force);
    const double inertia = 1.0 / 12;
    for (std::size_t p = 0; p < beam.nodes(); ++p) {
        const Vec place = beam.rest_position(p);
        if (place[0] < 2 || place[0] > 6) continue;
        const double expected = load * (8 - place[0]) * 0.5 / inertia;  // at the surface
        double largest = 0;
        for (const auto& stress : beam.surface_stresses(p)) largest = std::max(largest, std::abs(stress[0]));
        EXPECT_NEAR(largest / expected, 1, 0.01) << place.transpose();
        EXPECT_NEAR(std::abs(beam.virial()[p][0]) / 0.25 / expected, 0.5, 0.01) << "at the particle half of it";
    }
}

}  // namespace
}  // namespace dmp::tests::solver_cell_surfaces_tests
