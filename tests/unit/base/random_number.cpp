// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "base/random_number.hpp"

#include <array>
#include <cmath>
#include <functional>

#include <gtest/gtest.h>

#include "tests/modules.hpp"

namespace dmp::tests::random_number_tests {
namespace {

constexpr int many = 200000;
/// Four standard errors of a mean of `many` numbers whose standard deviation is this.
double four_errors(double deviation) { return 4 * deviation / std::sqrt(static_cast<double>(many)); }
const double deviation = std::sqrt(1.0 / 12);

TEST(RandomNumber, follows_from_what_it_is_for_alone) {
    EXPECT_EQ(random_number({1, 2, 3}), random_number({1, 2, 3}));
    EXPECT_NE(random_number({1, 2, 3}), random_number({2, 2, 3}));
    EXPECT_NE(random_number({1, 2, 3}), random_number({1, 3, 2}));
    EXPECT_NE(random_number({1, 2}), random_number({1, 2, 0}));
    // Of SplitMix64: its first two outputs from 0 are the mixed bits of 0 and of its increment.
    EXPECT_EQ(mixed_bits(0), 0xe220a8397b1dcdafU);
    EXPECT_EQ(mixed_bits(0x9e3779b97f4a7c15U), 0x6e789e6aa1b965f4U);
}

TEST(RandomNumber, is_evenly_distributed_along_each_of_its_keys) {
    const std::array<std::function<double(std::uint64_t)>, 3> along{[](std::uint64_t k) {
                                                                        return random_number({k, 5, 7});
                                                                    },
                                                                    [](std::uint64_t k) {
                                                                        return random_number({1, k, 7});
                                                                    },
                                                                    [](std::uint64_t k) {
                                                                        return random_number({1, 5, k});
                                                                    }};
    for (const auto& number : along) {
        double sum = 0, squares = 0;
        std::array<int, 20> bins{};
        for (std::uint64_t k = 0; k < many; ++k) {
            const double u = number(k);
            ASSERT_GE(u, 0);
            ASSERT_LT(u, 1);
            sum += u;
            squares += (u - 0.5) * (u - 0.5);
            ++bins[static_cast<std::size_t>(20 * u)];
        }
        EXPECT_NEAR(sum / many, 0.5, four_errors(deviation));
        EXPECT_NEAR(squares / many, 1.0 / 12, four_errors(std::sqrt(1.0 / 180)));
        double chi_square = 0;
        for (const int bin : bins) chi_square += std::pow(bin - many / 20.0, 2) / (many / 20.0);
        EXPECT_LT(chi_square, 43.8) << "exceeded once in a thousand by 19 degrees of freedom";
    }
}

TEST(RandomNumber, of_neighbouring_keys_are_not_correlated) {
    const double variance = 1.0 / 12;
    double along_first = 0, along_second = 0, swapped = 0;
    for (std::uint64_t k = 0; k < many; ++k) {
        const double u = random_number({1, k, k + 1}) - 0.5;
        along_first += u * (random_number({1, k + 1, k + 1}) - 0.5);
        along_second += u * (random_number({1, k, k + 2}) - 0.5);
        swapped += u * (random_number({1, k + 1, k}) - 0.5);
    }
    for (const double sum : {along_first, along_second, swapped}) EXPECT_NEAR(sum / many, 0, four_errors(variance));
}

}  // namespace
}  // namespace dmp::tests::random_number_tests
