// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include <gtest/gtest.h>

#include "models/pair.hpp"
#include "models/sph/kernels.hpp"
#include "models/sph/viscous_laws.hpp"
#include "tests/modules.hpp"

namespace dmp::tests::one_pair {

using Point = FluidPoint<double, 2>;
using Solid = SolidPoint<double, 2>;
using V2 = Vector<double, 2>;

/// Support radius 3; i and j are a 3-4-5 triangle's legs apart: r = 1.25, x_ij = (0.75, -1).
inline const WendlandC2<2> kernel(3.0);
inline const V2 separation{{0.75, -1.0}};
inline constexpr double distance = 1.25;

inline const Point particle_i{{{1.75, 1.0}}, {{0.4, -0.3}}, 1.1, 990, 120, 1e-3};
inline const Point particle_j{{{1.0, 2.0}}, {{-0.2, 0.5}}, 0.9, 1010, 80, 3e-3};

/// Of a lattice of spacing 1.
inline const ViscousScales scales = viscous_scales(2, 1, 3, [](double r) { return kernel.slope(r); });
inline const ViscousTerm<MorrisViscosity, ArithmeticMean> morris{MorrisViscosity(scales)};
inline const ViscousTerm<MorrisViscosity, HarmonicMean> harmonic_morris{MorrisViscosity(scales)};

/// dW/dr by central differences.
inline double kernel_derivative(double r) { return (kernel.value(r + 1e-5) - kernel.value(r - 1e-5)) / 2e-5; }

inline auto pair_of(const Point& i, const Point& j, const V2& x_ij) {
    const double r = std::sqrt(dot(x_ij, x_ij));
    return Pair<Point, Point, V2, double, double>{i, j, x_ij, r, kernel.slope(r)};
}

inline void expect_near(const V2& found, const V2& expected, double tolerance) {
    for (int axis = 0; axis < 2; ++axis) EXPECT_NEAR(found[axis], expected[axis], tolerance) << "axis " << axis;
}

}  // namespace dmp::tests::one_pair
