// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <span>
#include <string>
#include <tuple>
#include <vector>

#include <gmock/gmock.h>
#include <sys/resource.h>

#include "solver/neighbours/search_grid.hpp"
#include "solver/neighbours/sort_by_cell.hpp"
#include "solver/neighbours/space_order.hpp"
#include "solver/parallel/each_of.hpp"
#include "tests/modules.hpp"

namespace dmp::tests::solver_space_order_tests {
namespace {

constexpr double spacing = 0.1;

/// Disordered particles `lengths` spacings wide, one a cubic spacing, of three bodies if they are springs. Each one's
/// density tells its id, and its place is what position_of says.
class Strewn {
  public:
    Strewn(PartKind kind, const std::vector<int>& lengths)
        : group(kind, static_cast<int>(lengths.size())), positions_(lengths.size()) {
        std::size_t count = 1;
        for (const int length : lengths) count *= static_cast<std::size_t>(length);
        std::mt19937 random(3);
        group.declare({Field::position, Field::density});
        group.resize(count, 2);  // copies, which are to go
        for (std::size_t i = 0; i < group.total(); ++i) {
            const int body = kind == PartKind::elastic ? static_cast<int>(random() % 3) : -1;
            group.tags()[i] = {static_cast<std::int64_t>(i), body, 0};
            group.data(Field::density)[i] = static_cast<double>(i);
            bodies_.push_back(body);
        }
        for (std::size_t axis = 0; axis < lengths.size(); ++axis) {
            std::uniform_real_distribution<double> position(-1, lengths[axis] * spacing - 1);
            for (std::size_t i = 0; i < group.total(); ++i) put(i, axis, position(random));
        }
    }

    void put(std::size_t id, std::size_t axis, double x) {
        positions_[axis].resize(group.total());
        positions_[axis][id] = group.data(Field::position, static_cast<int>(axis))[id] = x;
    }

    /// Every particle is in one cluster, as it was, and clusters are what they should be.
    void expect_sorted_into(const std::vector<Cluster>& clusters) const {
        std::vector<int> times(bodies_.size(), 0);
        std::int32_t next = 0;
        for (const Cluster& cluster : clusters) {
            EXPECT_EQ(cluster.first, next);
            EXPECT_GE(cluster.count, 1);
            EXPECT_LE(cluster.count, cluster_size);
            next += cluster.count;
            for (int axis = 0; axis < group.dimension(); ++axis) {
                const double* x = group.data(Field::position, axis) + cluster.first;
                const auto [low, high] = std::minmax_element(x, x + cluster.count);
                EXPECT_LT(*high - *low, (axis == 0 ? cluster_size : 2) * spacing * (1 + 1e-9)) << "axis " << axis;
                EXPECT_TRUE(axis > 0 || std::is_sorted(x, x + cluster.count));
            }
            for (std::int32_t k = cluster.first; k < next; ++k) {
                const auto id = static_cast<std::size_t>(group.tags()[k].id);
                ++times[id];
                EXPECT_EQ(group.tags()[k].body, group.tags()[cluster.first].body);
                EXPECT_EQ(group.tags()[k].body, bodies_[id]);
                EXPECT_EQ(group.data(Field::density)[k], static_cast<double>(id));
                for (int axis = 0; axis < group.dimension(); ++axis)
                    EXPECT_EQ(group.data(Field::position, axis)[k], positions_[axis][id]);
            }
        }
        EXPECT_EQ(static_cast<std::size_t>(next), group.owned());
        EXPECT_EQ(group.owned(), group.total());
        EXPECT_EQ(group.total(), times.size() - 2);
        EXPECT_TRUE(std::all_of(times.begin(), times.end() - 2, [](int n) { return n == 1; }));
    }

    ParticleGroup group;

  private:
    std::vector<std::vector<double>> positions_;
    std::vector<int> bodies_;
};

/// The most memory this process ever held [bytes].
double peak_memory() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return 1024.0 * static_cast<double>(usage.ru_maxrss);
}

class SpaceOrder : public testing::TestWithParam<std::tuple<PartKind, std::vector<int>>> {
  protected:
    Strewn strewn{std::get<PartKind>(GetParam()), std::get<std::vector<int>>(GetParam())};
};

TEST_P(SpaceOrder, puts_every_particle_into_one_cluster_that_is_small_and_of_one_body) {
    strewn.expect_sorted_into(sort_in_space(strewn.group, spacing, 1));
}

TEST_P(SpaceOrder, sorts_what_is_sorted_into_the_same_clusters) {
    const auto first = sort_in_space(strewn.group, spacing, 1);
    const std::vector<ParticleTag> tags(strewn.group.tags().begin(), strewn.group.tags().end());
    const auto again = sort_in_space(strewn.group, spacing, 3);
    EXPECT_THAT(strewn.group.tags(), testing::ElementsAreArray(tags));
    ASSERT_EQ(again.size(), first.size());
    for (std::size_t c = 0; c < first.size(); ++c) {
        EXPECT_EQ(again[c].first, first[c].first);
        EXPECT_EQ(again[c].count, first[c].count);
    }
}

TEST_P(SpaceOrder, is_the_same_on_any_number_of_threads) {
    Strewn other = strewn;
    const auto on_one = sort_in_space(strewn.group, spacing, 1), on_three = sort_in_space(other.group, spacing, 3);
    EXPECT_EQ(on_one.size(), on_three.size());
    EXPECT_THAT(other.group.tags(), testing::ElementsAreArray(strewn.group.tags()));
}

TEST_P(SpaceOrder, survives_a_particle_that_flew_away) {
    const double before = peak_memory();
    for (int axis = 0; axis < strewn.group.dimension(); ++axis)
        strewn.put(7, static_cast<std::size_t>(axis), (axis == 1 ? -1e6 : 1e6) * spacing);
    strewn.expect_sorted_into(sort_in_space(strewn.group, spacing, 2));
    EXPECT_LT(peak_memory() - before, 64e6);
}

INSTANTIATE_TEST_SUITE_P(Kinds, SpaceOrder,
                         testing::Combine(testing::Values(PartKind::fluid, PartKind::elastic),
                                          testing::Values(std::vector{20, 20}, std::vector{30, 1}, std::vector{300, 7},
                                                          std::vector{9, 8, 7}, std::vector{140, 4, 5})),
                         [](const auto& variant) {
                             std::string name = std::get<0>(variant.param) == PartKind::fluid ? "fluid" : "elastic";
                             for (const int length : std::get<1>(variant.param)) name += "_" + std::to_string(length);
                             return name;
                         });

TEST(SpaceOrder, fills_the_clusters_of_a_fluid) {
    for (const std::vector<int>& lengths : {std::vector{100, 40}, std::vector{100, 10, 10}}) {
        Strewn strewn(PartKind::fluid, lengths);
        const auto clusters = sort_in_space(strewn.group, spacing, 1);
        EXPECT_GT(static_cast<double>(strewn.group.owned()) / static_cast<double>(clusters.size()), 7);
    }
}

TEST(SpaceOrder, of_nobody_is_empty_and_drops_copies) {
    ParticleGroup group(PartKind::fluid, 2);
    group.declare({Field::position});
    group.resize(0, 3);
    EXPECT_TRUE(sort_in_space(group, spacing, 2).empty());
    EXPECT_EQ(group.total(), 0U);
}

TEST(SpaceOrder, of_particles_in_one_place_is_full_clusters) {
    Strewn strewn(PartKind::fluid, {4, 5});
    for (std::size_t i = 0; i < 22; ++i)
        for (const std::size_t axis : {0U, 1U}) strewn.put(i, axis, 0.25);
    const auto clusters = sort_in_space(strewn.group, spacing, 1);
    strewn.expect_sorted_into(clusters);
    EXPECT_EQ(clusters.size(), 3U);
}

TEST(SortByCell, puts_cells_in_order_and_keeps_the_order_within_them) {
    std::mt19937 random(4);
    for (const std::size_t count : {0U, 7U, 5000U, 30000U})
        for (const int cells : {1, 2, 90, 2000}) {
            std::vector<int> cell(count);
            // Crowded below, as where a liquid stands in the bottom of its box.
            for (int& of : cell) of = std::min(static_cast<int>(random() % 20001), static_cast<int>(random() % 20001));
            for (int& of : cell) of %= cells;
            std::vector<std::int32_t> expected(count);
            std::iota(expected.begin(), expected.end(), 0);
            std::ranges::stable_sort(expected, {}, [&](std::int32_t i) { return cell[i]; });
            for (const int threads : {1, 2, 3, 8}) {
                const SortedByCell sorted = sort_by_cell(std::span<const int>(cell), cells, threads);
                EXPECT_THAT(sorted.order, testing::ElementsAreArray(expected)) << threads << " threads";
                ASSERT_EQ(sorted.start.size(), static_cast<std::size_t>(cells) + 1);
                for (int c = 0; c <= cells; ++c)
                    EXPECT_EQ(sorted.start[c],
                              std::ranges::lower_bound(expected, c, {}, [&](std::int32_t i) { return cell[i]; }) -
                                  expected.begin())
                        << c;
            }
        }
}

TEST(SortByCell, refuses_a_cell_that_is_none) {
    std::vector<int> cell(30000, 5);
    for (const int wrong : {-1, 9}) {
        cell[17] = wrong;
        for (const int threads : {1, 2})
            EXPECT_THROW(sort_by_cell(std::span<const int>(cell), 9, threads), std::logic_error);
    }
}

TEST(EachOf, does_all_and_throws_what_the_lowest_threw) {
    for (const int threads : {1, 2, 3}) {
        std::vector<int> done(7);
        each_of(7, threads, [&](std::ptrdiff_t k) { ++done[k]; });
        EXPECT_THAT(done, testing::Each(1));
        try {
            each_of(7, threads, [&](std::ptrdiff_t k) {
                ++done[k];
                if (k > 2) throw std::runtime_error(std::to_string(k));
            });
            FAIL() << "nothing thrown";
        } catch (const std::runtime_error& error) {
            EXPECT_STREQ(error.what(), "3");
        }
        EXPECT_THAT(done, testing::Each(2)) << "what one throws does not stop the others";
    }
    each_of(0, 2, [](std::ptrdiff_t) { FAIL(); });
}

/// Squared distance of particle i from the box [low, high].
double gap_square(const ParticleGroup& group, std::size_t i, const std::array<double, 3>& low,
                  const std::array<double, 3>& high) {
    double square = 0;
    for (int axis = 0; axis < group.dimension(); ++axis) {
        const double x = group.data(Field::position, axis)[i];
        const double gap = std::max({0.0, low[axis] - x, x - high[axis]});
        square += gap * gap;
    }
    return square;
}

/// Compares with all particles, for boxes in, around and far from them.
void expect_finds_all_near(const ParticleGroup& group, double cell_size, int threads) {
    const SearchGrid grid(group, cell_size, threads);
    std::mt19937 random(8);
    std::uniform_real_distribution<double> position(-3, 3), size(0, 0.8), distance(0.01, 1.5);
    std::size_t all = 0;
    for (int k = 0; k < 300; ++k) {
        std::array<double, 3> low{}, high{};
        for (int axis = 0; axis < group.dimension(); ++axis) {
            low[axis] = position(random) * (k % 10 == 0 ? 1000 : 1);
            high[axis] = low[axis] + size(random);
        }
        const double reach = distance(random);
        Uninitialized<std::int32_t> found{-1};  // is to stay
        if (group.dimension() == 3) {
            grid.append_near<3>(low, high, reach, found);
        } else {
            grid.append_near<2>(low, high, reach, found);
        }
        std::vector<std::int32_t> expected{-1};
        for (std::size_t i = 0; i < group.total(); ++i)
            if (gap_square(group, i, low, high) < reach * reach) expected.push_back(static_cast<std::int32_t>(i));
        std::sort(found.begin(), found.end());
        EXPECT_THAT(found, testing::ElementsAreArray(expected));
        all += expected.size() - 1;
    }
    EXPECT_TRUE(group.total() < 100 || all > 1000) << "boxes that are near nobody show nothing";
}

TEST(SearchGrid, finds_all_that_are_near_and_nobody_twice) {
    for (const std::vector<int>& lengths :
         {std::vector{20, 20}, std::vector{40, 3}, std::vector{9, 8, 7}, std::vector{2, 3, 40}}) {
        const Strewn strewn(PartKind::fluid, lengths);
        for (const double cell_size : {0.02, 0.2, 5.0})
            for (const int threads : {1, 3}) expect_finds_all_near(strewn.group, cell_size, threads);
    }
}

TEST(SearchGrid, survives_a_particle_that_flew_away) {
    for (const std::vector<int>& lengths : {std::vector{20, 20}, std::vector{9, 8, 7}}) {
        const double before = peak_memory();
        Strewn strewn(PartKind::fluid, lengths);
        for (std::size_t axis = 0; axis < lengths.size(); ++axis) strewn.put(5, axis, 1e6 * spacing);
        expect_finds_all_near(strewn.group, 2 * spacing, 2);
        EXPECT_LT(peak_memory() - before, 64e6);
    }
}

TEST(SearchGrid, of_nobody_or_of_one_finds_them) {
    for (const std::size_t count : {0U, 1U}) {
        ParticleGroup group(PartKind::elastic, 2);
        group.declare({Field::position});
        group.resize(count, 0);
        expect_finds_all_near(group, 2 * spacing, 2);
    }
}

}  // namespace
}  // namespace dmp::tests::solver_space_order_tests
