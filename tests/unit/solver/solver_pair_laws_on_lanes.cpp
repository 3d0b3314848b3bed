// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <random>

#include "base/simd/lanes.hpp"
#include "models/sph/continuity.hpp"
#include "models/sph/density_diffusion.hpp"
#include "models/sph/morris_viscosity.hpp"
#include "models/sph/pressure_force.hpp"
#include "models/sph/shifting.hpp"
#include "models/sph/tait.hpp"
#include "models/sph/walls.hpp"
#include "tests/modules.hpp"
#include "tests/unit/solver/one_pair.hpp"

namespace dmp::tests::solver_pair_laws_on_lanes_tests {
namespace {

using namespace one_pair;

/// Random particles side by side, as many as this machine's lanes hold, and the same one by one.
class PairLawsOnLanes : public testing::Test {
  protected:
    using WidePoint = FluidPoint<Lanes, 2>;

    PairLawsOnLanes() {
        std::mt19937 random(7);
        std::uniform_real_distribution<double> unit(0, 1);
        for (std::size_t k = 0; k < Lanes::width; ++k) {
            single[k] = {{{3 * unit(random), 3 * unit(random)}},
                         {{unit(random), unit(random)}},
                         0.5 + unit(random),
                         900 + 200 * unit(random),
                         100 * unit(random),
                         unit(random)};
            for (int a = 0; a < 2; ++a) {
                wide.position[a].set(k, single[k].position[a]);
                wide.velocity[a].set(k, single[k].velocity[a]);
            }
            wide.volume.set(k, single[k].volume);
            wide.density.set(k, single[k].density);
            wide.pressure.set(k, single[k].pressure);
            wide.viscosity.set(k, single[k].viscosity);
        }
    }

    [[nodiscard]] auto wide_pair() const {
        const auto x_ij = wide.position - particle_j.position;
        const Lanes r = sqrt(dot(x_ij, x_ij));
        return Pair<WidePoint, Point, Vector<Lanes, 2>, Lanes, Lanes>{wide, particle_j, x_ij, r, kernel.slope(r)};
    }
    [[nodiscard]] auto single_pair(std::size_t k) const {
        return pair_of(single[k], particle_j, single[k].position - particle_j.position);
    }
    static void expect_same(double found, double expected) {
        EXPECT_NEAR(found, expected, 1e-14 * std::abs(expected) + 1e-300);
    }

    std::array<Point, Lanes::width> single;
    WidePoint wide;
};

TEST_F(PairLawsOnLanes, give_what_they_give_on_numbers) {
    const DensityDiffusion diffusion(0.1, 3.0, 20);
    const Shifting<WendlandC2<2>> shifting(4, 3.0, 1.0, kernel);
    const TaitEquation state{20, 1000};
    const auto p = wide_pair();
    for (std::size_t k = 0; k < Lanes::width; ++k) {
        const auto q = single_pair(k);
        for (int a = 0; a < 2; ++a) {
            expect_same(PressureForce::law(p)[a][k], PressureForce::law(q)[a]);
            expect_same(morris.law(p)[a][k], morris.law(q)[a]);
            expect_same(shifting.law(p, kernel)[a][k], shifting.law(q, kernel)[a]);
        }
        EXPECT_NEAR(ContinuityRate::law(p)[k], ContinuityRate::law(q), 1e-12);
        expect_same(diffusion.law(p)[k], diffusion.law(q));
        EXPECT_NEAR(state.pressure(wide.density)[k], state.pressure(single[k].density), 1e-9);
    }
}

TEST_F(PairLawsOnLanes, walls_give_what_they_give_on_numbers) {
    const ExtrapolatedSolid<2> law{{{0.2, -9.81}}, 0.5};
    const Solid wall{{{0.4, -0.7}}, {{0.1, 0}}, 1.2, 0, 0, {{0, 1}}, 0.7};
    const auto ghost = law.rigid(wide, wall, wide.position - wall.position);
    for (std::size_t k = 0; k < Lanes::width; ++k) {
        const auto expected = law.rigid(single[k], wall, single[k].position - wall.position);
        for (int a = 0; a < 2; ++a) EXPECT_NEAR(ghost.velocity[a][k], expected.velocity[a], 1e-13);
        EXPECT_NEAR(ghost.pressure[k], expected.pressure, 1e-10);
        EXPECT_EQ(Lanes(ghost.volume)[k], expected.volume);
        EXPECT_EQ(ghost.density[k], expected.density);
    }
}

}  // namespace
}  // namespace dmp::tests::solver_pair_laws_on_lanes_tests
