// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/parallel/exact_sum.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "tests/modules.hpp"

namespace dmp::tests::exact_sum_tests {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double least = std::numeric_limits<double>::denorm_min();
constexpr double greatest = std::numeric_limits<double>::max();

double sum(std::vector<double> values) { return ExactSum(values).value(); }

std::uint64_t bits(double value) { return std::bit_cast<std::uint64_t>(value); }

/// Numbers of both signs, their exponents evenly spread.
std::vector<double> random_numbers(std::size_t count, int least_exponent, int greatest_exponent, unsigned seed) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> mantissa(-2, 2);
    std::uniform_int_distribution<int> exponent(least_exponent, greatest_exponent);
    std::vector<double> values(count);
    for (double& value : values) value = std::ldexp(mantissa(random), exponent(random));
    return values;
}

TEST(ExactSum, IsOneNumberItself) {
    std::vector<double> values = random_numbers(2000, -1080, 1022, 1);
    for (const double value : {0.0, 1.0, least, -least, 3 * least, std::numeric_limits<double>::min(), greatest,
                               -greatest, std::ldexp(1, 32)})
        values.push_back(value);
    for (const double value : values) EXPECT_EQ(bits(sum({value})), bits(value + 0.0)) << value;  // -0 becomes +0
    EXPECT_EQ(bits(sum({})), bits(0.0));
    EXPECT_EQ(bits(sum({0.1, -0.1})), bits(0.0));
}

TEST(ExactSum, LosesNothingToCancellation) {
    EXPECT_EQ(sum({1e300, 1, -1e300}), 1);
    EXPECT_EQ(sum({greatest, greatest, least, -greatest, -greatest}), least);
    EXPECT_EQ(sum({1e-320, 1e308, -1e-320, -1e308, -7}), -7);
    std::vector<double> values = random_numbers(10000, -1080, 1022, 2);
    for (std::size_t k = 0, count = values.size(); k < count; ++k) values.push_back(-values[k]);
    std::shuffle(values.begin(), values.end(), std::mt19937_64(3));
    EXPECT_EQ(bits(sum(values)), bits(0.0));
}

TEST(ExactSum, RoundsToNearestAndTiesToEven) {
    const double step = std::ldexp(1, -52);  // between 1 and 2
    EXPECT_EQ(sum({1, step / 2}), 1);
    EXPECT_EQ(sum({1 + step, step / 2}), 1 + 2 * step);
    EXPECT_EQ(sum({1, step / 2, least}), 1 + step);
    EXPECT_EQ(sum({-1, -step / 2, -least}), -1 - step);
    EXPECT_EQ(sum({1, step / 2, -least}), 1);
    EXPECT_EQ(sum({2 - step, step / 2}), 2);
    for (const double scale : {std::ldexp(1, -1000), std::ldexp(1, -31), std::ldexp(1, 11), std::ldexp(1, 900)}) {
        EXPECT_EQ(sum({scale, scale * step / 2, scale * step / 1024}), scale * (1 + step));
        EXPECT_EQ(sum({scale, scale * step / 2}), scale);
    }
}

TEST(ExactSum, SumsSubnormals) {
    std::vector<double> values(3000, least);
    EXPECT_EQ(sum(values), 3000 * least);
    values.push_back(-2999 * least);
    EXPECT_EQ(sum(values), least);
    EXPECT_EQ(sum({std::numeric_limits<double>::min(), -least}), std::numeric_limits<double>::min() - least);
}

TEST(ExactSum, RemembersWhatIsNotFinite) {
    EXPECT_EQ(sum({infinity, 1}), infinity);
    EXPECT_EQ(sum({1, -infinity, 1e300}), -infinity);
    EXPECT_TRUE(std::isnan(sum({infinity, -infinity})));
    EXPECT_TRUE(std::isnan(sum({1, std::numeric_limits<double>::quiet_NaN(), infinity})));
    EXPECT_EQ(sum({greatest, greatest}), infinity);
    EXPECT_EQ(sum({-greatest, -greatest}), -infinity);
    ExactSum whole;
    whole.add(ExactSum(std::vector{infinity}));
    EXPECT_EQ(whole.value(), infinity);
}

/// Quadruple precision (113 bits) holds sums of 1e4 numbers between 2^-20 and 2^20 exactly.
TEST(ExactSum, AgreesWithQuadruplePrecision) {
    for (unsigned seed = 0; seed < 200; ++seed) {
        const std::vector<double> values = random_numbers(10000, -20, 19, seed);
        __extension__ __float128 expected = 0;
        for (const double value : values) expected += value;
        EXPECT_EQ(bits(sum(values)), bits(static_cast<double>(expected)));
    }
}

TEST(ExactSum, DoesNotDependOnOrderOrOnWhoSums) {
    std::vector<double> values = random_numbers(20000, -1060, 1000, 7);
    const std::uint64_t expected = bits(sum(values));
    std::mt19937_64 random(8);
    for (int permutation = 0; permutation < 20; ++permutation) {
        std::shuffle(values.begin(), values.end(), random);
        std::vector<ExactSum> parts(7);
        for (std::size_t k = 0; k < values.size(); ++k) parts[random() % parts.size()].add(values[k]);
        ExactSum whole;
        for (const ExactSum& part : parts) whole.add(part);
        EXPECT_EQ(bits(sum(values)), expected);
        EXPECT_EQ(bits(whole.value()), expected);
    }
}

TEST(ExactSum, CarriesInTime) {
    // The largest digits there are, of one sign and in one place, far more often than carries may wait.
    const double ones = std::ldexp(std::ldexp(1, 53) - 1, 31);
    ExactSum total;
    for (int k = 0; k < 1 << 20; ++k) total.add(ones);
    EXPECT_EQ(total.value(), std::ldexp(ones, 20));
    for (int k = 0; k < 1 << 20; ++k) total.add(-ones);
    total.add(-ones);
    EXPECT_EQ(total.value(), -ones);
}

}  // namespace
}  // namespace dmp::tests::exact_sum_tests
