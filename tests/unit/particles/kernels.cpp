// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "models/sph/kernels.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/modules.hpp"

namespace dmp::tests::kernels_tests {
namespace {

constexpr double pi = std::numbers::pi;

template <class KernelType, int Dimension>
struct Sample {
    using Kernel = KernelType;
    static constexpr int dimension = Dimension;
};

template <class S>
class Kernels : public testing::Test {};

using Samples =
    testing::Types<Sample<WendlandC2<2>, 2>, Sample<WendlandC2<3>, 3>, Sample<WendlandC4<2>, 2>,
                   Sample<WendlandC4<3>, 3>, Sample<Lucy<2>, 2>, Sample<Lucy<3>, 3>, Sample<CubicSpline<2>, 2>,
                   Sample<CubicSpline<3>, 3>, Sample<QuinticSpline<2>, 2>, Sample<QuinticSpline<3>, 3>>;
TYPED_TEST_SUITE(Kernels, Samples);

/// Simpson's rule for f over [0, end].
template <class F>
double integral(double end, const F& f) {
    constexpr int intervals = 2000;
    const double step = end / intervals;
    double sum = f(0.0) + f(end);
    for (int i = 1; i < intervals; ++i) sum += (i % 2 == 1 ? 4 : 2) * f(i * step);
    return sum * step / 3;
}

/// Circumference or area of the sphere of radius r.
double sphere(int dimension, double r) { return dimension == 2 ? 2 * pi * r : 4 * pi * r * r; }

TYPED_TEST(Kernels, AreNormalised) {
    for (const double support : {3e-4, 1.0, 2.6}) {
        const typename TypeParam::Kernel kernel(support);
        const auto whole =
            integral(support, [&](double r) { return sphere(TypeParam::dimension, r) * kernel.value(r); });
        EXPECT_NEAR(whole, 1, 1e-10) << support;
        // Integrated by parts: -integral of r dW/dr is the dimension.
        const auto moment =
            integral(support, [&](double r) { return -sphere(TypeParam::dimension, r) * r * r * kernel.slope(r); });
        EXPECT_NEAR(moment, TypeParam::dimension, 1e-9) << support;
    }
}

TYPED_TEST(Kernels, SlopeIsTheDerivativeOverR) {
    const double support = 0.7, d = 1e-5;
    const typename TypeParam::Kernel kernel(support);
    const double scale = kernel.value(0.0) / square(support);
    for (int i = 1; i < 70; ++i) {
        const double r = 0.01 * i;
        const double derivative = (kernel.value(r + d) - kernel.value(r - d)) / (2 * d);
        EXPECT_NEAR(kernel.slope(r), derivative / r, 1e-6 * scale) << r;
    }
}

TYPED_TEST(Kernels, ArePositiveFallAndEndAtTheSupport) {
    const double support = 0.3;
    const typename TypeParam::Kernel kernel(support);
    for (int i = 0; i < 30; ++i) {
        const double r = 0.01 * i;
        EXPECT_GT(kernel.value(r), kernel.value(r + 0.01));
        EXPECT_LT(kernel.slope(r), 0);
    }
    for (const double r : {support, std::nextafter(support, 1.0), 0.4, 1e3}) {
        EXPECT_NEAR(kernel.value(r), 0, 1e-40) << r;
        EXPECT_NEAR(kernel.slope(r), 0, 1e-25) << r;
    }
    EXPECT_EQ(kernel.value(0.31), 0);
    EXPECT_EQ(kernel.slope(0.31), 0);
}

/// Transforms of a kernel of support 1 and of its slope at wave number k, by the midpoint rule.
struct Transform {
    double value = 0, slope = 0;

    template <class Kernel>
    Transform(const Kernel& kernel, int dimension, double k) {
        constexpr int intervals = 400;
        for (int i = 0; i < intervals; ++i) {
            const double r = (i + 0.5) / intervals, x = k * r;
            const double wave = dimension == 2 ? std::cyl_bessel_j(0, x) : x > 0 ? std::sin(x) / x : 1;
            const double weight = sphere(dimension, r) / intervals * wave;
            value += weight * kernel.value(r);
            slope += weight * kernel.slope(r);
        }
    }
};

// kernels.hpp tells the analysis. Beyond k = 40 no kernel's transforms have anything to add.
TYPED_TEST(Kernels, StepLimitsAreThoseOfVonNeumannAnalysis) {
    using Kernel = typename TypeParam::Kernel;
    const Kernel kernel(1);
    const double at_rest = Transform(kernel, TypeParam::dimension, 0).slope;
    double sound = 0, viscous = -at_rest;  // of infinite wave number
    for (int tenth = 1; tenth < 400; ++tenth) {
        const double k = 0.1 * tenth;
        const Transform at(kernel, TypeParam::dimension, k);
        sound = std::max(sound, k * std::abs(at.value));
        viscous = std::max(viscous, at.slope - at_rest);
    }
    EXPECT_LE(Kernel::sound_limit, 2 / sound + 5e-4);  // three digits, and as many of the viscous limit
    EXPECT_GE(Kernel::sound_limit, 2 / sound - 1e-3);
    EXPECT_LE(Kernel::viscous_limit, 1 / viscous + 5e-5);
    EXPECT_GE(Kernel::viscous_limit, 1 / viscous - 1.5e-4);
}

TEST(KernelValues, OfSplinesAtTheirKnots) {
    const double h = 0.5;
    EXPECT_DOUBLE_EQ(CubicSpline<2>(2 * h).value(0.0), 10 / (7 * pi * h * h));
    EXPECT_DOUBLE_EQ(CubicSpline<3>(2 * h).value(0.0), 1 / (pi * h * h * h));
    EXPECT_DOUBLE_EQ(CubicSpline<2>(2 * h).value(h), 10 / (7 * pi * h * h) / 4);
    EXPECT_DOUBLE_EQ(CubicSpline<2>(2 * h).slope(0.0), -3 * 10 / (7 * pi * h * h) / (h * h));
    EXPECT_DOUBLE_EQ(QuinticSpline<2>(3 * h).value(0.0), 66 * 7 / (478 * pi * h * h));
    EXPECT_DOUBLE_EQ(QuinticSpline<3>(3 * h).value(0.0), 66 / (120 * pi * h * h * h));
    EXPECT_DOUBLE_EQ(QuinticSpline<2>(3 * h).value(h), 26 * 7 / (478 * pi * h * h));
    EXPECT_DOUBLE_EQ(QuinticSpline<2>(3 * h).value(2 * h), 1 * 7 / (478 * pi * h * h));
    EXPECT_DOUBLE_EQ(QuinticSpline<2>(3 * h).slope(0.0), -120 * 7 / (478 * pi * h * h) / (h * h));
}

TEST(KernelValues, AtTheCentreAndHalfWay) {
    EXPECT_DOUBLE_EQ(WendlandC2<2>(2).value(0.0), 7 / (4 * pi));
    EXPECT_DOUBLE_EQ(WendlandC2<3>(2).value(0.0), 21 / (16 * pi));
    EXPECT_DOUBLE_EQ(WendlandC2<2>(2).value(1.0), 7 / (4 * pi) * 3 / 16);
    EXPECT_DOUBLE_EQ(WendlandC2<2>(2).slope(1.0), -20 * 7 / (4 * pi) / 4 / 8);
    EXPECT_DOUBLE_EQ(WendlandC4<2>(2).value(0.0), 9 / (4 * pi));
    EXPECT_DOUBLE_EQ(WendlandC4<3>(2).value(0.0), 495 / (256 * pi));
    EXPECT_DOUBLE_EQ(WendlandC4<2>(2).value(1.0), 9 / (4 * pi) / 64 * (4 + 35.0 / 12));
    EXPECT_DOUBLE_EQ(WendlandC4<2>(2).slope(1.0), -56.0 / 3 * 9 / (4 * pi) / 4 * 3.5 / 32);
    EXPECT_DOUBLE_EQ(Lucy<2>(2).value(0.0), 5 / (4 * pi));
    EXPECT_DOUBLE_EQ(Lucy<3>(2).value(0.0), 105 / (128 * pi));
    EXPECT_DOUBLE_EQ(Lucy<2>(2).value(1.0), 5 / (4 * pi) * 2.5 / 8);
    EXPECT_DOUBLE_EQ(Lucy<2>(2).slope(1.0), -12 * 5 / (4 * pi) / 4 / 4);
}

}  // namespace
}  // namespace dmp::tests::kernels_tests
