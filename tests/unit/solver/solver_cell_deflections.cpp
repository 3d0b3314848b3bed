// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
//
// Large deflections of elastic bodies of cells in 2-D.
#include <cmath>

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

}  // namespace
}  // namespace dmp::tests::solver_cell_deflections_tests
