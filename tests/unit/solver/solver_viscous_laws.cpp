// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// What every viscous law must do, whichever there are; and Cleary's constants.
#include <cmath>

#include <gtest/gtest.h>

#include "models/sph/viscous_laws.hpp"
#include "tests/modules.hpp"
#include "tests/unit/solver/one_pair.hpp"

namespace dmp::tests::solver_viscous_laws_tests {
namespace {

using namespace one_pair;

template <class Law>
class EveryViscousLaw : public testing::Test {
  protected:
    /// Force on a particle at the origin of a lattice of spacing 1, volume 1 and viscosity 1 in the flow v_x(x, y).
    template <class Velocity>
    static V2 force_in(const Velocity& velocity) {
        const ViscousTerm<Law, ArithmeticMean> term{Law(scales)};
        V2 sum = V2::zero();
        for (int a = -3; a <= 3; ++a)
            for (int b = -3; b <= 3; ++b) {
                if (a == 0 && b == 0) continue;
                Point i = particle_i, j = particle_j;
                i.volume = j.volume = i.viscosity = j.viscosity = 1;
                i.velocity = {{velocity(0, 0), 0}};
                j.velocity = {{velocity(a, b), 0}};
                if (needs_gradient<Law>()) {
                    i.correction = j.correction = 1 / scales.morris_on_lattice.shear;
                    j.gradient[0] = {
                        {(velocity(a + 1, b) - velocity(a - 1, b)) / 2, (velocity(a, b + 1) - velocity(a, b - 1)) / 2}};
                }
                sum += term.law(pair_of(i, j, {{-1.0 * a, -1.0 * b}}));
            }
        return sum;
    }
};

template <class Laws>
struct TestedLaws;
template <class... Laws>
struct TestedLaws<Registry<Laws...>> {
    using Types = testing::Types<Laws...>;
};
TYPED_TEST_SUITE(EveryViscousLaw, TestedLaws<ViscousLaws>::Types);

TYPED_TEST(EveryViscousLaw, is_antisymmetric_and_does_not_act_on_uniform_flow) {
    const ViscousTerm<TypeParam, HarmonicMean> term{TypeParam(scales)};
    const V2 on_i = term.law(pair_of(particle_i, particle_j, separation));
    expect_near(on_i + term.law(pair_of(particle_j, particle_i, -1.0 * separation)), {{0, 0}}, 1e-18);
    Point moving_along = particle_j;
    moving_along.velocity = particle_i.velocity;
    expect_near(term.law(pair_of(particle_i, moving_along, separation)), {{0, 0}}, 0);
}

TYPED_TEST(EveryViscousLaw, has_the_viscosity_on_the_lattice_that_it_states) {
    if (!TypeParam::linear) GTEST_SKIP() << "the force of a law that is not linear depends on the sign of the flow";
    const LatticeViscosity stated = TypeParam(scales).on_lattice(scales);
    EXPECT_NEAR(this->force_in([](int, int y) { return 0.5 * y * y; })[0], stated.shear, 1e-12);
    EXPECT_NEAR(this->force_in([](int x, int) { return 0.5 * x * x; })[0], stated.longitudinal, 1e-12);
}

TYPED_TEST(EveryViscousLaw, is_linear_where_it_says_so) {
    const ViscousTerm<TypeParam, ArithmeticMean> term{TypeParam(scales)};
    Point i = particle_i, j = particle_j;
    const V2 force = term.law(pair_of(i, j, separation));
    i.velocity = -1.0 * i.velocity;
    j.velocity = -1.0 * j.velocity;
    const V2 reversed = term.law(pair_of(i, j, separation));
    const double difference = std::hypot(force[0] + reversed[0], force[1] + reversed[1]);
    EXPECT_EQ(difference < 1e-18, TypeParam::linear);
}

TYPED_TEST(EveryViscousLaw, chosen_at_run_time_is_the_same) {
    const auto p = pair_of(particle_i, particle_j, separation);
    for (const bool arithmetic : {false, true}) {
        const V2 found = AnyViscousTerm(ViscousLaw::of<TypeParam>(), scales, arithmetic).law(p);
        const V2 expected = arithmetic ? V2(ViscousTerm<TypeParam, ArithmeticMean>{TypeParam(scales)}.law(p))
                                       : V2(ViscousTerm<TypeParam, HarmonicMean>{TypeParam(scales)}.law(p));
        expect_near(found, expected, 1e-18);
    }
}

TEST(ClearyViscosity, one_pair_by_hand) {
    // Monaghan's force of this pair (MonaghanViscosity.one_pair_by_hand) over what it makes of shear on the lattice.
    const double monaghan = 1.1 * 0.9 * 8 * 1.5e-3 * 1.25 / (1.5625 + 0.01 * 2.25) * kernel_derivative(distance);
    const double size = monaghan / scales.monaghan_on_lattice.shear;
    const ViscousTerm<ClearyViscosity, HarmonicMean> cleary{ClearyViscosity(scales)};
    expect_near(cleary.law(pair_of(particle_i, particle_j, separation)), {{size * 0.6, size * -0.8}}, 1e-12);
}

TEST(ClearyViscosity, has_the_exact_shear_viscosity_on_the_lattice) {
    EXPECT_EQ(ClearyViscosity::on_lattice(scales).shear, 1);
    EXPECT_NEAR(ClearyViscosity(scales).strength, 4 / 0.88, 0.1);
    EXPECT_LT(ClearyViscosity(scales).step_share(), MonaghanViscosity(scales).step_share());
}

}  // namespace
}  // namespace dmp::tests::solver_viscous_laws_tests
