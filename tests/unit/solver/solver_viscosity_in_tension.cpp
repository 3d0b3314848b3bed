// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "tests/unit/solver/one_pair.hpp"

namespace dmp::tests::solver_viscosity_in_tension_tests {
namespace {

using namespace one_pair;

constexpr double dt = 2e-4;
const ViscosityInTension tension{dt};
const NewtonianTerm<ArithmeticMean> term{tension};

/// The pair with these pressures and gradients, and viscosities of 1 and 3 mPa s.
struct UnderPressure {
    Point i = particle_i, j = particle_j;

    UnderPressure(double p_i, double p_j) {
        i.pressure = p_i, j.pressure = p_j;
        i.correction = 1.1, j.correction = 0.9;
        i.gradient[0] = V2{{0.3, -0.7}}, i.gradient[1] = V2{{0.2, -0.3}};
        j.gradient[0] = V2{{-0.1, 0.5}}, j.gradient[1] = V2{{0.4, 0.1}};
    }
    [[nodiscard]] auto pair() const { return pair_of(i, j, separation); }
};

TEST(ViscosityInTension, IsThePressureTimesTheStepWhereThatIsMore) {
    const UnderPressure pulled(-30, -10), slightly(-12, -7.9), pressed(30, 10), mixed(-30, 29);
    EXPECT_DOUBLE_EQ(tension.at_least(pulled.pair(), 4e-3), dt * 40);
    EXPECT_EQ(tension.at_least(slightly.pair(), 4e-3), 4e-3);
    EXPECT_EQ(tension.at_least(pressed.pair(), 4e-3), 4e-3);
    EXPECT_EQ(tension.at_least(mixed.pair(), 4e-3), 4e-3);
    EXPECT_EQ(tension.at_least(pressed.pair(), 0.0), 0);
}

TEST(ViscosityInTension, ForceIsThatOfAFluidOfThisViscosity) {
    const UnderPressure pulled(-30, -10);
    UnderPressure viscous(-30, -10);
    viscous.i.viscosity = viscous.j.viscosity = dt * 20;
    expect_near(term.law(pulled.pair()),
                ViscousTerm<NewtonianViscosity, ArithmeticMean>{NewtonianViscosity()}.law(viscous.pair()), 1e-15);
}

TEST(ViscosityInTension, ForcesOfAPairAreOpposite) {
    const UnderPressure pulled(-30, -10);
    const V2 on_i = term.law(pulled.pair());
    const V2 on_j = term.law(pair_of(pulled.j, pulled.i, V2{{-separation[0], -separation[1]}}));
    for (int axis = 0; axis < 2; ++axis) EXPECT_EQ(on_i[axis], -on_j[axis]);
}

TEST(ViscosityInTension, IsWhatTheTwoPartsOfImplicitSteppingAddUpTo) {
    const NewtonianGradientTerm<ArithmeticMean> explicit_part{tension};
    const NewtonianVelocityTerm<ArithmeticMean> implicit_part;
    for (const double pressure : {-20.0, 20.0}) {
        const UnderPressure under(pressure, pressure);
        expect_near(explicit_part.law(under.pair()) + implicit_part.law(under.pair()), term.law(under.pair()), 1e-15);
    }
}

}  // namespace
}  // namespace dmp::tests::solver_viscosity_in_tension_tests
