// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <map>
#include <set>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>
#include <omp.h>

#include "all_pairs.hpp"

namespace dmp {
namespace {

using testing_solver::crowd;
using testing_solver::for_all_pairs;
using testing_solver::never_meet;

constexpr std::array kinds{ParticleKind::fluid, ParticleKind::rigid, ParticleKind::springs};

/// A neighbour as its owner and the whole periods it is away: what is left when images have no numbers.
using Neighbour = std::tuple<int, int, int>;

class ClusterListIn : public testing::TestWithParam<std::array<bool, 3>> {
  protected:
    ClusterListIn() : set(crowd(GetParam())), particles(set) {
        particles.renew_images(set.box, set.periodic, reach);
        list.build(particles, set, reach, 1);
    }

    [[nodiscard]] Neighbour named(int index) const {
        const int source = particles.source(index);
        std::array<int, 2> periods{};
        for (int axis = 0; axis < 2; ++axis) {
            const double* x = particles.data(Field::position, axis);
            periods[axis] = static_cast<int>(std::lround((x[index] - x[source]) / set.box.extent()[axis]));
        }
        return {source, periods[0], periods[1]};
    }

    template <class Visit>
    void for_each_cluster(const Visit& visit) const {
        for (const ParticleKind kind : kinds)
            for (const Cluster& cluster : list.clusters(kind)) visit(kind, cluster);
    }

    static constexpr double reach = 0.34;
    ParticleSet set;
    ParticleStore particles;
    ClusterList list;
};

TEST_P(ClusterListIn, every_particle_is_in_one_cluster_of_its_kind) {
    std::vector<int> times(set.size(), 0);
    for_each_cluster([&](ParticleKind kind, const Cluster& cluster) {
        ASSERT_GT(cluster.count, 0U);
        for (std::size_t k = 0; k < Lanes::width; ++k) {
            const int i = cluster.member[k];
            EXPECT_EQ(set.kind(i), kind);
            EXPECT_EQ(set.body[i], set.body[cluster.member[0]]);
            if (k < cluster.count) {
                ++times[i];
            } else {
                EXPECT_EQ(i, cluster.member[0]);
            }
        }
    });
    EXPECT_EQ(std::count(times.begin(), times.end(), 1), static_cast<std::ptrdiff_t>(set.size()));
}

TEST_P(ClusterListIn, every_pair_within_reach_is_found_and_no_neighbour_comes_twice) {
    std::map<int, std::set<Neighbour>> found;
    for_each_cluster([&](ParticleKind, const Cluster& cluster) {
        std::set<Neighbour> neighbours;
        for (const ParticleKind kind : kinds)
            for (const int index : list.neighbours(cluster, kind)) {
                EXPECT_EQ(set.kind(particles.source(index)), kind);
                EXPECT_TRUE(neighbours.insert(named(index)).second) << "twice: " << particles.source(index);
            }
        for (std::size_t k = 0; k < cluster.count; ++k) found[cluster.member[k]] = neighbours;
    });
    std::size_t pairs = 0;
    for_all_pairs(particles, set, reach, [&](int i, int j, const Vector<double, 2>& separation) {
        if (never_meet(set, i, j)) return;
        ++pairs;
        std::array<int, 2> periods{};
        for (int axis = 0; axis < 2; ++axis) {
            const double* x = particles.data(Field::position, axis);
            periods[axis] = static_cast<int>(std::lround((x[i] - separation[axis] - x[j]) / set.box.extent()[axis]));
        }
        EXPECT_TRUE(found[i].contains({j, periods[0], periods[1]})) << i << " does not see " << j;
    });
    EXPECT_GT(pairs, 5000U);
}

TEST_P(ClusterListIn, lists_nobody_who_is_out_of_reach_of_all_members_or_never_interacts) {
    for_each_cluster([&](ParticleKind, const Cluster& cluster) {
        for (const ParticleKind kind : kinds)
            for (const int index : list.neighbours(cluster, kind)) {
                double nearest = 1e300;
                for (std::size_t k = 0; k < cluster.count; ++k) {
                    double square = 0;
                    for (int axis = 0; axis < 2; ++axis) {
                        const double* x = particles.data(Field::position, axis);
                        square += (x[index] - x[cluster.member[k]]) * (x[index] - x[cluster.member[k]]);
                    }
                    nearest = std::min(nearest, square);
                }
                EXPECT_LT(nearest, reach * reach * (1 + 1e-12));
                EXPECT_FALSE(never_meet(set, cluster.member[0], particles.source(index)));
            }
    });
}

void expect_equal(const ClusterList& a, const ClusterList& b) {
    ASSERT_EQ(a.size(), b.size());
    for (const ParticleKind kind : kinds) {
        ASSERT_EQ(a.clusters(kind).size(), b.clusters(kind).size());
        for (std::size_t c = 0; c < a.clusters(kind).size(); ++c) {
            const Cluster &one = a.clusters(kind)[c], &other = b.clusters(kind)[c];
            EXPECT_EQ(one.member, other.member);
            EXPECT_EQ(one.count, other.count);
            EXPECT_EQ(one.first, other.first);
            for (const ParticleKind of : kinds) {
                const auto x = a.neighbours(one, of), y = b.neighbours(other, of);
                EXPECT_TRUE(std::equal(x.begin(), x.end(), y.begin(), y.end()));
            }
        }
    }
}

TEST_P(ClusterListIn, is_the_same_on_any_number_of_threads) {
    for (const int threads : {2, 3}) {
        ClusterList other;
        other.build(particles, set, reach, threads);
        expect_equal(list, other);
    }
}

TEST_P(ClusterListIn, is_the_same_when_fewer_threads_are_to_be_had_than_asked_for) {
    // Inside a parallel region one thread runs a nested one, as under OMP_THREAD_LIMIT=1.
    ClusterList other;
    omp_set_max_active_levels(1);
#pragma omp parallel num_threads(2)
    {
#pragma omp single
        other.build(particles, set, reach, 3);
    }
    expect_equal(list, other);
}

TEST_P(ClusterListIn, can_be_built_again) {
    ClusterList other;
    other.build(particles, set, 2 * reach, 1);
    other.build(particles, set, reach, 1);
    expect_equal(list, other);
}

INSTANTIATE_TEST_SUITE_P(Periodic, ClusterListIn,
                         testing::Values(std::array{false, false, false}, std::array{true, false, false},
                                         std::array{false, true, false}, std::array{true, true, false}),
                         [](const auto& periodic) {
                             const std::string name =
                                 std::string(periodic.param[0] ? "x" : "") + (periodic.param[1] ? "y" : "");
                             return name.empty() ? "none" : name;
                         });

TEST(ClusterList, of_nobody_is_empty) {
    ParticleSet set;
    set.spacing = 0.1;
    ParticleStore particles(set);
    ClusterList list;
    list.build(particles, set, 0.3, 2);
    EXPECT_EQ(list.size(), 0U);
    for (const ParticleKind kind : kinds) EXPECT_TRUE(list.clusters(kind).empty());
}

}  // namespace
}  // namespace dmp
