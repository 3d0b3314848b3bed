// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <gtest/gtest.h>

#include "bench/half_list.hpp"
#include "bench/start.hpp"
#include "tests/modules.hpp"

namespace dmp::bench {
namespace {

struct Sums {
    std::vector<Vec> force;
    std::vector<double> rate;
    std::size_t pairs = 0;
};

/// dW/dr, written down anew.
double kernel_derivative(KernelKind kernel, int dimension, double r, double support) {
    const double q = r / support, volume = std::pow(support, dimension);
    if (kernel == KernelKind::lucy) {
        const double constant = (dimension == 2 ? 5 / M_PI : 105 / (16 * M_PI)) / volume;
        return constant * -12 * q * std::pow(1 - q, 2) / support;
    }
    const double constant = (dimension == 2 ? 7 / M_PI : 21 / (2 * M_PI)) / volume;
    return constant * -20 * q * std::pow(1 - q, 3) / support;
}

double pressure(double density) { return 1056 * 100.0 / 7 * (std::pow(density / 1056, 7) - 1); }

/// Every particle with every other, nearest images, each equation as the papers have it.
Sums all_pairs(const ParticleSet& set, KernelKind kernel, double support) {
    Sums sums{std::vector<Vec>(set.size(), Vec::Zero()), std::vector<double>(set.size(), 0.0), 0};
    for (std::size_t i = 0; i < set.size(); ++i)
        for (std::size_t j = 0; j < set.size(); ++j) {
            if (i == j || (set.fixed[i] != 0 && set.fixed[j] != 0)) continue;
            Vec apart = set.position[i] - set.position[j];
            for (int axis = 0; axis < 3; ++axis) {
                const double period = set.box.extent()[axis];
                if (set.periodic[axis]) apart[axis] -= period * std::round(apart[axis] / period);
            }
            const double r = apart.norm();
            if (r >= support) continue;
            ++sums.pairs;
            const SweepState a = sweep_state(set, i), b = sweep_state(set, j);
            const double slope = kernel_derivative(kernel, set.dimension, r, support) / r;
            const Vec velocity = Vec(a.velocity.data()) - Vec(b.velocity.data());
            const double pressures =
                pressure(a.density) / (a.density * a.density) + pressure(b.density) / (b.density * b.density);
            sums.rate[i] += set.mass[j] * velocity.dot(apart) * slope;
            sums.force[i] += set.mass[i] * set.mass[j] * slope *
                             (2 * 3.5e-3 / (a.density * b.density) * velocity - pressures * apart);
        }
    sums.pairs /= 2;
    return sums;
}

class BenchHalfLists : public testing::TestWithParam<std::tuple<int, KernelKind, bool>> {};

TEST_P(BenchHalfLists, SumsAreThoseOfAllPairs) {
    const auto [dimension, kernel, disordered] = GetParam();
    Channel channel;
    channel.dimension = dimension;
    channel.disordered = disordered;
    channel.particles = 400;
    const ParticleSet set = make_particles(channel);
    const double support = channel.support * set.spacing;
    const auto list = make_half_list(set, kernel, support);
    list->sweep();
    list->sweep();  // begins anew
    const Sums sums = all_pairs(set, kernel, support);

    double largest_force = 0, largest_rate = 0;
    for (std::size_t i = 0; i < set.size(); ++i) {
        largest_force = std::max(largest_force, sums.force[i].norm());
        largest_rate = std::max(largest_rate, std::abs(sums.rate[i]));
    }
    ASSERT_GT(largest_force, 0);
    for (std::size_t i = 0; i < set.size(); ++i) {
        ASSERT_LT((Vec(list->force(i).data()) - sums.force[i]).norm(), 1e-9 * largest_force) << i;
        ASSERT_NEAR(list->density_rate(i), sums.rate[i], 1e-9 * largest_rate) << i;
    }
    EXPECT_EQ(list->particles(), set.size());
    EXPECT_EQ(list->pairs_within_support(), sums.pairs);
    EXPECT_GE(list->pairs_listed(), sums.pairs);
}

std::string name_of(const testing::TestParamInfo<BenchHalfLists::ParamType>& info) {
    const auto [dimension, kernel, disordered] = info.param;
    return std::string(dimension == 2 ? "plane" : "space") + (kernel == KernelKind::lucy ? "_lucy" : "_wendland") +
           (disordered ? "_disordered" : "_lattice");
}

INSTANTIATE_TEST_SUITE_P(Starts, BenchHalfLists,
                         testing::Combine(testing::Values(2, 3),
                                          testing::Values(KernelKind::wendland_c2, KernelKind::lucy), testing::Bool()),
                         name_of);

TEST(BenchHalfList, CountsNoNeighboursExactlyAtTheSupport) {
    Channel channel;
    channel.particles = 400;
    const ParticleSet set = make_particles(channel);
    const auto narrow = make_half_list(set, KernelKind::lucy, 1.99 * set.spacing);
    const auto exact = make_half_list(set, KernelKind::lucy, 2 * set.spacing);
    EXPECT_EQ(exact->pairs_within_support(), narrow->pairs_within_support());
    EXPECT_GT(exact->pairs_listed(), exact->pairs_within_support());
}

}  // namespace
}  // namespace dmp::bench
