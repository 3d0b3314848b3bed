// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>
#include <random>
#include <string>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include "arranged_crowd.hpp"
#include "base/simd/lanes.hpp"
#include "solver/sweeps/reproducible_sum.hpp"
#include "tests/modules.hpp"

namespace dmp::tests::solver_reproducible_sum_tests {
namespace {

constexpr double largest_term = 3.7;

/// As a sum over neighbours may have them: a few far larger than was expected.
std::vector<double> some_terms(unsigned seed, std::size_t count = 200) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> unit(-1, 1);
    std::vector<double> terms(count);
    for (std::size_t k = 0; k < count; ++k)
        terms[k] = largest_term * unit(random) * (k % 50 == 0 ? 15 : std::pow(10.0, 5 * unit(random) - 5));
    return terms;
}

template <class Rounded>
double sum_of(const std::vector<double>& terms, const Rounded& rounded) {
    double sum = 0;
    for (const double term : terms) sum += rounded(term);
    return sum;
}

TEST(ReproducibleSum, sums_are_the_same_bits_in_any_order) {
    const ReproducibleSum rounding(largest_term);
    const auto as_it_is = [](double term) { return term; };
    std::mt19937 random(2);
    int unlike = 0;
    for (const unsigned seed : {1U, 2U, 3U}) {
        std::vector<double> terms = some_terms(seed);
        const double sum = sum_of(terms, rounding), plain = sum_of(terms, as_it_is);
        for (int k = 0; k < 200; ++k) {
            std::shuffle(terms.begin(), terms.end(), random);
            EXPECT_EQ(sum_of(terms, rounding), sum);
            unlike += sum_of(terms, as_it_is) == plain ? 0 : 1;
        }
    }
    EXPECT_GT(unlike, 100) << "terms that are never rounded show nothing";
}

TEST(ReproducibleSum, sums_are_right_within_half_a_quantum_a_term) {
    const ReproducibleSum rounding(largest_term);
    for (unsigned seed = 1; seed < 50; ++seed) {
        const std::vector<double> terms = some_terms(seed);
        long double exact = 0;
        for (const double term : terms) exact += term;
        const auto error = static_cast<double>(std::abs(sum_of(terms, rounding) - exact));
        EXPECT_LT(error, 0.51 * static_cast<double>(terms.size()) * rounding.quantum());
    }
}

TEST(ReproducibleSum, quantum_is_a_power_of_two_2_to_46_times_below_the_largest_term) {
    for (const double largest : {1e-30, 0.99, 1.0, largest_term, 1.7e20}) {
        const ReproducibleSum rounding(largest);
        int exponent = 0;
        EXPECT_EQ(std::frexp(rounding.quantum(), &exponent), 0.5);
        EXPECT_LE(rounding.quantum(), std::ldexp(largest, -46));
        EXPECT_GT(rounding.quantum(), std::ldexp(largest, -47));
        EXPECT_EQ(rounding(0.4 * rounding.quantum()), 0);
        EXPECT_EQ(rounding(0.6 * rounding.quantum()), rounding.quantum());
    }
}

TEST(ReproducibleSum, terms_and_their_opposites_cancel) {
    const ReproducibleSum rounding(largest_term);
    std::vector<double> terms = some_terms(4, 1000);
    for (int halves = -5; halves < 6; ++halves) terms.push_back(0.5 * halves * rounding.quantum());  // ties
    for (const double term : terms) EXPECT_EQ(rounding(term), -rounding(-term));
    const std::size_t count = terms.size();
    for (std::size_t k = 0; k < count; ++k) terms.push_back(-terms[k]);
    std::shuffle(terms.begin(), terms.end(), std::mt19937(7));
    EXPECT_EQ(sum_of(terms, rounding), 0);
}

TEST(ReproducibleSum, rounds_vectors_and_lanes_as_numbers) {
    const ReproducibleSum rounding(largest_term);
    const std::vector<double> terms = some_terms(5, 2 * Lanes::width);
    Vector<Lanes, 2> wide{};
    for (std::size_t k = 0; k < Lanes::width; ++k)
        for (int axis = 0; axis < 2; ++axis) wide[axis].set(k, terms[2 * k + axis]);
    const auto rounded = rounding(wide);
    for (std::size_t k = 0; k < Lanes::width; ++k)
        for (int axis = 0; axis < 2; ++axis) EXPECT_EQ(rounded[axis][k], rounding(terms[2 * k + axis]));
}

/// `sign` times the sum of products of one term and the next.
double running_sum(const std::vector<double>& terms, const std::vector<std::size_t>& order, double sign) {
    const ReproducibleSum rounding(largest_term * largest_term);
    double sum = 0;
    rounding.start(sum);
    for (const std::size_t k : order) ReproducibleSum::add(sum, sign * terms[k], terms[k + 1]);
    return rounding.total(sum);
}

TEST(ReproducibleSum, running_sums_of_products_are_the_same_bits_in_any_order_and_cancel) {
    const double quantum = ReproducibleSum(largest_term * largest_term).quantum();
    for (const unsigned seed : {1U, 2U, 3U}) {
        const std::vector<double> terms = some_terms(seed);
        std::vector<std::size_t> order(terms.size() - 1);
        std::iota(order.begin(), order.end(), 0U);
        const double sum = running_sum(terms, order, 1);
        long double exact = 0;
        for (const std::size_t k : order) exact += static_cast<long double>(terms[k]) * terms[k + 1];
        EXPECT_LT(std::abs(static_cast<double>(sum - exact)), 0.51 * static_cast<double>(order.size()) * quantum);
        std::mt19937 random(seed);
        for (int k = 0; k < 200; ++k) {
            std::shuffle(order.begin(), order.end(), random);
            EXPECT_EQ(running_sum(terms, order, 1), sum);
            EXPECT_EQ(running_sum(terms, order, -1), -sum);
        }
    }
}

/// Of `factor` times each term.
double running_sum_of(double factor, const std::vector<double>& terms) {
    const ReproducibleSum rounding(largest_term);
    double sum = 0;
    rounding.start(sum);
    for (const double term : terms) ReproducibleSum::add(sum, factor, term);
    return rounding.total(sum);
}

TEST(ReproducibleSum, running_sums_with_a_factor_of_few_digits_need_its_mantissa_filled) {
    std::mt19937 random(4);
    int unlike = 0;
    for (const double factor : {1.0, 0.5, -0.75}) {
        std::vector<double> terms = some_terms(5);
        for (double& term : terms) term /= 3;
        const double as_it_is = running_sum_of(factor, terms);
        const double filled = running_sum_of(ReproducibleSum::full_mantissa * factor, terms);
        EXPECT_NEAR(filled / ReproducibleSum::full_mantissa, as_it_is, 1e-10);
        for (int k = 0; k < 200; ++k) {
            std::shuffle(terms.begin(), terms.end(), random);
            EXPECT_EQ(running_sum_of(ReproducibleSum::full_mantissa * factor, terms), filled);
            unlike += running_sum_of(factor, terms) == as_it_is ? 0 : 1;
        }
    }
    EXPECT_GT(unlike, 100) << "products that are never half-way between two multiples show nothing";
}

TEST(ReproducibleSum, running_sums_of_vectors_and_lanes_are_those_of_numbers) {
    const ReproducibleSum rounding(largest_term * largest_term);
    const std::vector<double> terms = some_terms(6, 2 * Lanes::width);
    Lanes factor = 0.0;
    Vector<Lanes, 2> wide{}, sum{};
    for (std::size_t k = 0; k < Lanes::width; ++k) {
        factor.set(k, terms[k]);
        for (int axis = 0; axis < 2; ++axis) wide[axis].set(k, terms[2 * k + axis]);
    }
    rounding.start(sum);
    for (int times = 0; times < 3; ++times) ReproducibleSum::add(sum, factor, wide);
    const auto total = rounding.total(sum);
    for (std::size_t k = 0; k < Lanes::width; ++k)
        for (int axis = 0; axis < 2; ++axis) {
            double one = 0;
            rounding.start(one);
            for (int times = 0; times < 3; ++times) ReproducibleSum::add(one, terms[k], terms[2 * k + axis]);
            EXPECT_EQ(total[axis][k], rounding.total(one));
        }
}

using Variant = std::tuple<int, WallModel, bool>;  ///< the last: with what is off by default

PairSettings settings_of(const ParticleSet& set, const Variant& variant) {
    PairSettings settings = crowd_settings(set, true, std::get<WallModel>(variant));
    if (!std::get<bool>(variant)) return settings;
    settings.viscosity.unlike = true;
    settings.hydrostatic = settings.gradient_correction = settings.transport_velocity = true;
    settings.shifting = 0;
    return settings;
}

/// Forces, density rates and shifts of a crowd with all models, in a box that is periodic all around.
class SumsOver : public testing::TestWithParam<Variant> {
  protected:
    [[nodiscard]] Sums in(const Arrangement& arrangement) const {
        return ArrangedCrowd(set, settings, arrangement).sweep();
    }
    void expect_same(const Arrangement& arrangement) const {
        const Sums found = in(arrangement);
        for (std::size_t id = 0; id < set.size(); ++id) {
            EXPECT_EQ(found.force[id], usual.force[id]) << "particle " << id;
            EXPECT_EQ(found.density_rate[id], usual.density_rate[id]) << "particle " << id;
            EXPECT_EQ(found.shift[id], usual.shift[id]) << "particle " << id;
        }
        for (const auto sums : {&Sums::force, &Sums::shift})  // 0 and -0 are not the same state
            EXPECT_EQ(std::memcmp((found.*sums).data(), (usual.*sums).data(), set.size() * sizeof(Vec)), 0);
        EXPECT_EQ(std::memcmp(found.density_rate.data(), usual.density_rate.data(), set.size() * sizeof(double)), 0);
    }

    ParticleSet set = crowd(std::get<int>(GetParam()), {true, true, std::get<int>(GetParam()) == 3}, 9);
    PairSettings settings = settings_of(set, GetParam());
    Sums usual = in({});
};

TEST_P(SumsOver, do_not_depend_on_the_vector_unit) {
    for (const VectorUnit unit : available_vector_units()) {
        SCOPED_TRACE(to_string(unit));
        expect_same({.vector_unit = unit});
    }
}

TEST_P(SumsOver, do_not_depend_on_the_number_of_threads) {
    for (const int threads : {2, 3}) expect_same({.threads = threads});
}

TEST_P(SumsOver, do_not_depend_on_the_order_of_the_particles) {
    for (const unsigned seed : {1U, 2U, 3U}) expect_same({.shuffled = seed});
}

TEST_P(SumsOver, do_not_depend_on_how_far_the_lists_look) {
    for (const double farther : {0.02, 0.1, 0.25}) expect_same({.extra_reach = farther});
    for (const VectorUnit unit : available_vector_units())
        expect_same({.vector_unit = unit, .threads = 3, .extra_reach = 0.1, .near_only = true});
}

TEST_P(SumsOver, do_not_depend_on_sweeping_the_border_by_itself) { expect_same({.border_apart = true}); }

TEST_P(SumsOver, do_not_depend_on_where_particles_were_wrapped) { expect_same({.wrapped = true}); }

TEST_P(SumsOver, do_not_depend_on_where_the_border_lies) {
    expect_same({.displaced = Vec(0.31, -0.47, set.dimension == 3 ? 0.123 : 0)});
    expect_same({.displaced = Vec(-1.7, 5.3, set.dimension == 3 ? 0.4 : 0)});
}

TEST_P(SumsOver, do_not_depend_on_all_of_it_at_once) {
    for (const VectorUnit unit : available_vector_units())
        expect_same({.vector_unit = unit,
                     .threads = 3,
                     .extra_reach = 0.13,
                     .shuffled = 17,
                     .wrapped = true,
                     .displaced = Vec(0.77, 0.05, set.dimension == 3 ? -0.3 : 0)});
}

TEST_P(SumsOver, tell_one_state_from_another) {
    settings.sound_speed *= 1.01;  // only diffusion of density knows it
    const Sums other = in({});
    EXPECT_NE(other.density_rate, usual.density_rate);
    EXPECT_EQ(other.shift, usual.shift);
}

TEST_P(SumsOver, of_fluid_and_bodies_without_walls_leave_no_force_in_all) {
    for (std::size_t i = 0; i < set.size(); ++i) {
        if (set.kind(i) != PartKind::rigid) continue;
        set.part[i] = 0;
        set.wall_normal[i] = Vec::Zero();
        set.wall_distance[i] = 0;
    }
    for (const VectorUnit unit : available_vector_units()) {
        const Sums sums = in({.vector_unit = unit});
        for (int axis = 0; axis < set.dimension; ++axis) {
            double total = 0;  // of multiples of one quantum: exact
            for (const Vec& force : sums.force) total += force[axis];
            EXPECT_EQ(total, 0) << to_string(unit) << ", axis " << axis;
        }
    }
}

TEST_P(SumsOver, neighbours_of_masses_are_densities_whatever_the_arrangement) {
    settings.density.by_summation = true;
    const std::vector<double> rest_density(set.parts.size(), settings.density.largest);
    const auto densities_in = [&](const Arrangement& arrangement) {
        return ArrangedCrowd(set, settings, arrangement).densities(rest_density);
    };
    const std::vector<double> first = densities_in({});
    for (const VectorUnit unit : available_vector_units())
        EXPECT_EQ(densities_in({.vector_unit = unit, .threads = 3, .extra_reach = 0.1, .near_only = true}), first);
    EXPECT_EQ(densities_in({.border_apart = true, .shuffled = 3, .wrapped = true, .displaced = Vec(0.31, -0.47, 0)}),
              first);
}

INSTANTIATE_TEST_SUITE_P(Crowds, SumsOver,
                         testing::Values(Variant{2, WallModel::extrapolated, false},
                                         Variant{2, WallModel::plain, false}, Variant{2, WallModel::extrapolated, true},
                                         Variant{3, WallModel::extrapolated, false},
                                         Variant{3, WallModel::plain, false},
                                         Variant{3, WallModel::extrapolated, true}),
                         [](const auto& variant) {
                             return std::to_string(std::get<int>(variant.param)) + "d_" +
                                    to_string(std::get<WallModel>(variant.param)) +
                                    (std::get<bool>(variant.param) ? "_with_options" : "");
                         });

}  // namespace
}  // namespace dmp::tests::solver_reproducible_sum_tests
