// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "base/errors.hpp"
#include "tests/modules.hpp"
#include "tests/unit/solver/ladder_body.hpp"

namespace dmp::tests::solver_spring_body_tests {
namespace {

class LadderWith : public testing::TestWithParam<double> {};

TEST_P(LadderWith, bends_and_shears_as_a_beam_under_an_end_load) {
    const double k_a = GetParam();
    const LadderShape shape{64, k_a, true};
    const ParticleSet set = ladder(shape);
    const PlaneBody body(set, part_with(0), 0);
    const double load = 1e-9, length = shape.cells;
    const Vectors bent = statics(body, set, end_load(set, {{0, load}}));
    const double tip = bent.back()[1] - set.position.back()[1];
    const double theory =
        load * length * length * length / (3 * bending_stiffness(k_a)) + load * length / shear_stiffness(k_a);
    EXPECT_NEAR(tip / theory, 1, 2e-3);
}

TEST_P(LadderWith, stretches_as_a_bar) {
    const LadderShape shape{64, GetParam(), true};
    const ParticleSet set = ladder(shape);
    const PlaneBody body(set, part_with(0), 0);
    const double load = 1e-6;
    const Vectors pulled = statics(body, set, end_load(set, {{load, 0}}));
    EXPECT_NEAR((pulled.back()[0] - set.position.back()[0]) / (load * shape.cells / axial_stiffness()), 1, 1e-6);
}

TEST_P(LadderWith, stores_the_energy_of_a_uniform_stretch_curvature_and_shear) {
    const double k_a = GetParam(), strain = 1e-5;
    const LadderShape shape{64, k_a, true};
    const ParticleSet set = ladder(shape);
    PlaneBody body(set, part_with(0), 0);
    const auto energy_of = [&](const std::function<V2(double, double)>& displacement) {
        for (std::size_t n = 0; n < set.size(); ++n)
            body.positions()[n] =
                V2{{set.position[n][0], set.position[n][1]}} + displacement(set.position[n][0], set.position[n][1]);
        return body.energy();
    };
    const double half_length = 0.5 * shape.cells;
    EXPECT_NEAR(energy_of([&](double x, double) {
                    return V2{{strain * x, 0}};
                }),
                half_length * axial_stiffness() * strain * strain,
                1e-4 * half_length * axial_stiffness() * strain * strain);
    EXPECT_NEAR(energy_of([&](double x, double) {
                    return V2{{0, strain * x}};
                }),
                half_length * shear_stiffness(k_a) * strain * strain,
                1e-4 * half_length * shear_stiffness(k_a) * strain * strain);
    const double curvature = 1e-6;  // sections stay plane and square to the axis
    EXPECT_NEAR(energy_of([&](double x, double y) {
                    return V2{{-curvature * x * y, 0.5 * curvature * x * x}};
                }),
                half_length * bending_stiffness(k_a) * curvature * curvature,
                1e-3 * half_length * bending_stiffness(k_a) * curvature * curvature);
}

INSTANTIATE_TEST_SUITE_P(HingeStiffness, LadderWith, testing::Values(0.05, 0.5, 5.0));

TEST(SpringBody, rests_where_it_was_drawn) {
    const ParticleSet set = ladder({8, 0.5, false});
    PlaneBody body(set, part_with(0.01), 0);
    EXPECT_NEAR(body.energy(), 0, 1e-28);
    for (const V2& force : body.forces(body.positions(), Vectors(set.size(), V2::zero()))) {
        EXPECT_NEAR(force[0], 0, 1e-14);
        EXPECT_NEAR(force[1], 0, 1e-14);
    }
}

TEST(SpringBody, step_limit_is_that_of_the_lattice) {
    const ParticleSet set = ladder({64, 0.5, true});
    const PlaneBody body(set, part_with(0), 0);
    EXPECT_NEAR(body.step_limit() / 0.496, 1, 0.02);  // times sqrt(m / k_b) = 1
}

TEST(SpringBody, step_limit_scales_with_mass_and_stiffness) {
    ParticleSet set = ladder({16, 0.5, true});
    const double before = PlaneBody(set, part_with(0), 0).step_limit();
    for (double& mass : set.mass) mass *= 9;
    for (Bond& bond : set.bonds) bond.stiffness *= 4;
    for (Hinge& hinge : set.hinges) hinge.stiffness *= 4;
    EXPECT_NEAR(PlaneBody(set, part_with(0), 0).step_limit(), before * 1.5, 1e-4 * before);
}

TEST(SpringBody, is_stable_below_its_step_limit_and_not_above) {
    const ParticleSet set = ladder({16, 0.5, true});
    for (const auto& [fraction, stable] : {std::pair{0.98, true}, std::pair{1.05, false}}) {
        PlaneBody body(set, part_with(0), 0);
        for (std::size_t n = 2; n < set.size(); ++n) body.positions()[n][1] += n % 3 == 0 ? 1e-6 : -1e-6;
        const double before = body.energy(), dt = fraction * body.step_limit();
        double largest = 0;
        for (int step = 0; step < 1500; ++step) {
            body.advance_subcycled(dt, 1);
            largest = std::max(largest, body.energy());
            if (!(largest < 1e6 * before)) break;
        }
        EXPECT_EQ(largest < 100 * before, stable) << "at " << fraction << " of the limit";
    }
}

}  // namespace
}  // namespace dmp::tests::solver_spring_body_tests
