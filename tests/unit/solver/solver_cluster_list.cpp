// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <omp.h>

#include "all_pairs.hpp"
#include "solver/neighbours/neighbours.hpp"
#include "tests/modules.hpp"

namespace dmp::tests::solver_cluster_list_tests {
namespace {

/// A neighbour as its owner and the whole periods it is away: what is left when copies have no numbers.
using Neighbour = std::pair<std::size_t, std::array<int, 3>>;
using Clusters = std::array<std::vector<Cluster>, 3>;

const Ranks ranks = Ranks::alone();

std::size_t id_of(const ParticleGroup& group, std::int32_t index) {
    return static_cast<std::size_t>(group.tags()[static_cast<std::size_t>(index)].id);
}

/// Sorts the particles and makes their copies.
Clusters sorted_with_ghosts(ParticleStore& particles, double reach) {
    Neighbours neighbours(ranks, particles.space(), reach, 1);
    neighbours.renew(particles);
    Clusters clusters;
    for (const PartKind kind : all_kinds) {
        const auto found = neighbours.list().clusters(kind);
        clusters[static_cast<std::size_t>(kind)].assign(found.begin(), found.end());
    }
    return clusters;
}

struct Space {
    int dimension;
    std::array<bool, 3> periodic;
    bool strays = false;  ///< some particles stand far outside the box
};

ParticleSet crowd_in(const Space& space) {
    ParticleSet set = crowd(space.dimension, space.periodic);
    for (std::size_t i = 0; space.strays && i < 40; i += 10)
        for (int axis = 0; axis < space.dimension; ++axis)
            set.position[i][axis] += (axis == 1 ? -1e6 : 1e6) * set.spacing;
    return set;
}

class ClusterListIn : public testing::TestWithParam<Space> {
  protected:
    ClusterListIn() : set(crowd_in(GetParam())), particles(set, {1000, 1000, 1000}) {
        list.build(particles, clusters, reach, 1);
    }

    [[nodiscard]] Neighbour named(const ParticleGroup& group, std::int32_t index) {
        const std::size_t id = id_of(group, index);
        std::array<int, 3> periods{};
        for (int axis = 0; axis < set.dimension; ++axis) {
            const double moved = group.data(Field::position, axis)[index] - by_id.value(Field::position, id, axis);
            periods[axis] = static_cast<int>(std::lround(moved / particles.space().box.extent()[axis]));
        }
        return {id, periods};
    }

    /// Calls visit(group, number, cluster) for all clusters of all kinds.
    template <class Visit>
    void for_each_cluster(const Visit& visit) const {
        for (const PartKind kind : all_kinds)
            for (std::size_t c = 0; c < list.clusters(kind).size(); ++c)
                visit(particles.of(kind), c, list.clusters(kind)[c]);
    }

    static constexpr double reach = 0.34;
    ParticleSet set;
    ParticleStore particles;
    Clusters clusters = sorted_with_ghosts(particles, reach);
    ClusterList list;
    ById by_id{(particles)};
};

TEST_P(ClusterListIn, every_particle_is_in_one_cluster_of_its_kind_and_body) {
    std::vector<int> times(set.size(), 0);
    for_each_cluster([&](const ParticleGroup& group, std::size_t, const Cluster& cluster) {
        ASSERT_GT(cluster.count, 0);
        for (std::int32_t k = cluster.first; k < cluster.first + cluster.count; ++k) {
            EXPECT_EQ(set.kind(id_of(group, k)), group.kind());
            EXPECT_EQ(set.body[id_of(group, k)], set.body[id_of(group, cluster.first)]);
            ++times[id_of(group, k)];
        }
    });
    EXPECT_EQ(std::count(times.begin(), times.end(), 1), static_cast<std::ptrdiff_t>(set.size()));
}

TEST_P(ClusterListIn, every_pair_within_reach_is_found_and_no_neighbour_comes_twice) {
    std::map<std::size_t, std::set<Neighbour>> found;
    for_each_cluster([&](const ParticleGroup& group, std::size_t number, const Cluster& cluster) {
        std::set<Neighbour> neighbours;
        for (const PartKind kind : all_kinds)
            for (const std::int32_t index : list.neighbours(group.kind(), number, kind))
                EXPECT_TRUE(neighbours.insert(named(particles.of(kind), index)).second);
        for (std::int32_t k = 0; k < cluster.count; ++k) found[id_of(group, cluster.first + k)] = neighbours;
    });
    EXPECT_EQ(found.size(), set.size());
    std::size_t pairs = 0;
    for_all_pairs(particles, reach, [&](const Meeting& m) {
        if (never_meet(set, m.i, m.j)) return;
        ++pairs;
        EXPECT_TRUE(found[m.i].contains({m.j, m.periods})) << m.i << " does not see " << m.j;
    });
    EXPECT_GT(pairs, 5000U);
}

TEST_P(ClusterListIn, lists_nobody_who_is_out_of_reach_of_all_members_or_never_interacts) {
    for_each_cluster([&](const ParticleGroup& group, std::size_t number, const Cluster& cluster) {
        for (const PartKind kind : all_kinds)
            for (const std::int32_t index : list.neighbours(group.kind(), number, kind)) {
                const ParticleGroup& others = particles.of(kind);
                double nearest = 1e300;
                for (std::int32_t k = cluster.first; k < cluster.first + cluster.count; ++k) {
                    double square = 0;
                    for (int axis = 0; axis < set.dimension; ++axis) {
                        const double d =
                            others.data(Field::position, axis)[index] - group.data(Field::position, axis)[k];
                        square += d * d;
                    }
                    nearest = std::min(nearest, square);
                }
                EXPECT_LT(nearest, reach * reach * (1 + 1e-12));
                EXPECT_FALSE(never_meet(set, id_of(group, cluster.first), id_of(others, index)));
            }
    });
}

void expect_equal(const ClusterList& a, const ClusterList& b) {
    ASSERT_EQ(a.size(), b.size());
    for (const PartKind kind : all_kinds) {
        ASSERT_EQ(a.clusters(kind).size(), b.clusters(kind).size());
        for (std::size_t c = 0; c < a.clusters(kind).size(); ++c)
            for (const PartKind of : all_kinds) {
                const auto x = a.neighbours(kind, c, of), y = b.neighbours(kind, c, of);
                EXPECT_TRUE(std::equal(x.begin(), x.end(), y.begin(), y.end()));
            }
    }
}

TEST_P(ClusterListIn, is_the_same_on_any_number_of_threads) {
    for (const int threads : {2, 3}) {
        ClusterList other;
        other.build(particles, clusters, reach, threads);
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
        other.build(particles, clusters, reach, 3);
    }
    expect_equal(list, other);
}

TEST_P(ClusterListIn, can_be_built_again) {
    ClusterList other;
    for (const int threads : {1, 3}) {
        other.build(particles, clusters, 2 * reach, threads);
        other.build(particles, clusters, reach, threads);
        expect_equal(list, other);
    }
}

INSTANTIATE_TEST_SUITE_P(Periodic, ClusterListIn,
                         testing::Values(Space{2, {false, false, false}}, Space{2, {true, false, false}},
                                         Space{2, {false, true, false}}, Space{2, {true, true, false}},
                                         Space{3, {false, false, false}}, Space{3, {false, false, true}},
                                         Space{3, {true, true, false}}, Space{3, {true, true, true}},
                                         Space{2, {false, false, false}, true}, Space{3, {false, false, false}, true}),
                         [](const auto& space) {
                             std::string name = std::to_string(space.param.dimension) + "d_";
                             for (int axis = 0; axis < 3; ++axis)
                                 name += space.param.periodic[axis] ? "xyz"[axis] : '_';
                             return name + (space.param.strays ? "_strays" : "");
                         });

TEST(ClusterList, of_nobody_is_empty) {
    ParticleSet set;
    set.spacing = 0.1;
    ParticleStore particles(set, {});
    ClusterList list;
    EXPECT_TRUE(list.empty());
    list.build(particles, {}, 0.3, 2);
    EXPECT_FALSE(list.empty());
    EXPECT_EQ(list.size(), 0U);
    for (const PartKind kind : all_kinds) EXPECT_TRUE(list.clusters(kind).empty());
}

TEST(ClusterList, of_one_kind_alone_leaves_the_others_empty) {
    ParticleSet set = crowd(2, {false, false, false});
    for (std::size_t i = 0; i < set.size(); ++i) {
        set.part[i] = 0;
        set.body[i] = -1;
    }
    ParticleStore particles(set, {1000, 1000, 1000});
    Neighbours neighbours(ranks, particles.space(), 0.3, 1);
    neighbours.renew(particles);
    const ClusterList& list = neighbours.list();
    ASSERT_FALSE(list.clusters(PartKind::fluid).empty());
    for (std::size_t c = 0; c < list.clusters(PartKind::fluid).size(); ++c) {
        EXPECT_FALSE(list.neighbours(PartKind::fluid, c, PartKind::fluid).empty());
        EXPECT_TRUE(list.neighbours(PartKind::fluid, c, PartKind::rigid).empty());
        EXPECT_TRUE(list.neighbours(PartKind::fluid, c, PartKind::elastic).empty());
    }
}

/// The neighbours of all clusters, one after another.
std::vector<std::int32_t> neighbours_in(const ClusterList& list) {
    std::vector<std::int32_t> all;
    for (const PartKind own : all_kinds)
        for (std::size_t c = 0; c < list.clusters(own).size(); ++c)
            for (const PartKind other : all_kinds) {
                const auto some = list.neighbours(own, c, other);
                all.insert(all.end(), some.begin(), some.end());
                all.push_back(-1);
            }
    return all;
}

TEST(ClusterList, keeps_the_near_ones_and_finds_the_others_again) {
    ParticleStore particles(crowd(2, {true, false, false}), {1000, 1000, 1000});
    constexpr double reach = 0.3;
    ClusterList list;
    list.build(particles, sorted_with_ghosts(particles, reach), reach, 2);
    const std::vector<std::int32_t> all = neighbours_in(list);
    const std::size_t listed = list.size();
    const auto keep = [&](auto is_near) {
        for (const PartKind own : all_kinds)
            for (std::size_t c = 0; c < list.clusters(own).size(); ++c)
                for (const PartKind other : all_kinds) list.prune(own, c, other, is_near, static_cast<int>(c % 2));
    };
    const auto with_all = [](bool near) { return NearHalves{near, near}; };
    keep([&](std::int32_t index) { return with_all(index % 3 == 0); });
    std::vector<std::int32_t> expected = all;
    std::erase_if(expected, [](std::int32_t index) { return index >= 0 && index % 3 != 0; });
    EXPECT_EQ(neighbours_in(list), expected) << "in their order";
    EXPECT_LT(expected.size(), all.size());
    EXPECT_EQ(list.size(), listed) << "the others are listed still";
    keep([&](std::int32_t) { return with_all(true); });
    std::vector<std::int32_t> again = neighbours_in(list), sorted = all;
    std::ranges::sort(again);
    std::ranges::sort(sorted);
    EXPECT_EQ(again, sorted);
}

TEST(ClusterList, each_half_of_a_cluster_keeps_the_ones_near_to_it) {
    ParticleStore particles(crowd(2, {true, false, false}), {1000, 1000, 1000});
    constexpr double reach = 0.3;
    ClusterList list;
    list.build(particles, sorted_with_ghosts(particles, reach), reach, 1);
    const auto in_first = [](std::int32_t index) { return index % 4 == 0 || index % 4 == 1; };
    const auto in_second = [](std::int32_t index) { return index % 4 == 1 || index % 4 == 2; };
    std::size_t kept = 0;
    for (const PartKind own : all_kinds)
        for (std::size_t c = 0; c < list.clusters(own).size(); ++c)
            for (const PartKind other : all_kinds) {
                std::vector<std::int32_t> all;
                for (const std::int32_t index : list.neighbours(own, c, other)) all.push_back(index);
                const auto kept_by = [&](Members members) {
                    const auto some = list.neighbours(own, c, other, members);
                    std::vector<std::int32_t> sorted(some.begin(), some.end());
                    std::ranges::sort(sorted);
                    return sorted;
                };
                const auto expected = [&](const auto& keeps) {
                    std::vector<std::int32_t> some;
                    std::ranges::copy_if(all, std::back_inserter(some), keeps);
                    std::ranges::sort(some);
                    return some;
                };
                EXPECT_EQ(kept_by(Members::first_half), kept_by(Members::all)) << "before it is pruned";
                EXPECT_EQ(kept_by(Members::second_half), kept_by(Members::all));
                list.prune(
                    own, c, other,
                    [&](std::int32_t index) {
                        return NearHalves{in_first(index), in_second(index)};
                    },
                    0);
                EXPECT_EQ(kept_by(Members::first_half), expected(in_first));
                EXPECT_EQ(kept_by(Members::second_half), expected(in_second));
                EXPECT_EQ(kept_by(Members::all),
                          expected([&](std::int32_t index) { return in_first(index) || in_second(index); }));
                kept += list.neighbours(own, c, other).size();
            }
    EXPECT_GT(kept, 1000U);
}

TEST(ClusterList, tells_clusters_near_copies_from_all_others) {
    ParticleStore particles(crowd(2, {true, false, false}), {1000, 1000, 1000});
    Neighbours neighbours(ranks, particles.space(), 0.3, 1);
    neighbours.renew(particles);
    const ClusterList& list = neighbours.list();
    std::size_t inner = 0, border = 0;
    for (const PartKind own : all_kinds)
        for (std::size_t c = 0; c < list.clusters(own).size(); ++c) {
            bool near_ghost = false;
            for (const PartKind other : all_kinds)
                for (const std::int32_t index : list.neighbours(own, c, other))
                    near_ghost = near_ghost || index >= static_cast<std::int32_t>(particles.of(other).owned());
            EXPECT_TRUE(list.chosen(own, c, ClusterChoice::all));
            EXPECT_EQ(list.chosen(own, c, ClusterChoice::border), near_ghost);
            EXPECT_EQ(list.chosen(own, c, ClusterChoice::inner), !near_ghost);
            ++(near_ghost ? border : inner);
        }
    EXPECT_GT(inner, 0U);
    EXPECT_GT(border, 0U);
}

TEST(Neighbours, look_through_their_list_before_pairs_can_be_missed) {
    ParticleStore particles(crowd(2, {true, false, false}), {1000, 1000, 1000});
    Neighbours neighbours(ranks, particles.space(), 0.3, 1);
    neighbours.renew(particles);
    double reach = 0;
    const auto look = [&] { return neighbours.prune_list(particles, [&](ClusterList&, double r) { reach = r; }); };
    const auto all_go = [&](double distance) {
        for (ParticleGroup& group : particles.groups())
            for (std::size_t i = 0; i < group.owned(); ++i) group.data(Field::position, 1)[i] += distance;
        neighbours.moved(distance);
    };
    EXPECT_TRUE(look()) << "a new list holds what is not near";
    EXPECT_GT(reach, 0.3);
    EXPECT_FALSE(look());
    const double margin = reach - 0.3;
    all_go(0.3 * margin);
    EXPECT_FALSE(look());
    neighbours.moved(0.3 * margin);
    EXPECT_FALSE(look()) << "what may have gone too far and did not is no reason";
    all_go(0.15 * margin);
    EXPECT_FALSE(look());
    all_go(0.06 * margin);
    EXPECT_TRUE(look()) << "two that came to meet each other may be within the support";
    // However far the list reaches, what is near by it can be no farther.
    while (!neighbours.outdated(particles)) {
        all_go(0.1 * neighbours.skin());
        if (neighbours.outdated(particles) || !look()) continue;
        EXPECT_LE(reach, 0.3 + neighbours.skin());
    }
}

}  // namespace
}  // namespace dmp::tests::solver_cluster_list_tests
