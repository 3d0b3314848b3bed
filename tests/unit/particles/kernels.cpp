// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/kernels.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace dmp {
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
    testing::Types<Sample<WendlandC2<2>, 2>, Sample<WendlandC2<3>, 3>, Sample<Lucy<2>, 2>, Sample<Lucy<3>, 3>>;
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

TEST(KernelValues, AtTheCentreAndHalfWay) {
    EXPECT_DOUBLE_EQ(WendlandC2<2>(2).value(0.0), 7 / (4 * pi));
    EXPECT_DOUBLE_EQ(WendlandC2<3>(2).value(0.0), 21 / (16 * pi));
    EXPECT_DOUBLE_EQ(WendlandC2<2>(2).value(1.0), 7 / (4 * pi) * 3 / 16);
    EXPECT_DOUBLE_EQ(WendlandC2<2>(2).slope(1.0), -20 * 7 / (4 * pi) / 4 / 8);
    EXPECT_DOUBLE_EQ(Lucy<2>(2).value(0.0), 5 / (4 * pi));
    EXPECT_DOUBLE_EQ(Lucy<3>(2).value(0.0), 105 / (128 * pi));
    EXPECT_DOUBLE_EQ(Lucy<2>(2).value(1.0), 5 / (4 * pi) * 2.5 / 8);
    EXPECT_DOUBLE_EQ(Lucy<2>(2).slope(1.0), -12 * 5 / (4 * pi) / 4 / 4);
}

}  // namespace
}  // namespace dmp
