// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Which liquid turns solid: on a frozen square lattice, against the statistics of a Monte Carlo of its own.
#include <cmath>
#include <map>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "models/solidify/activity.hpp"
#include "models/springs/bond_break.hpp"
#include "solver/elastic/body_change.hpp"
#include "solver/solidify/bond_candidates.hpp"
#include "tests/modules.hpp"

namespace dmp::tests::solver_solidify_rules_tests {
namespace {

/// Particles at the points of a square lattice of spacing 1, the first seed in its middle; only the four nearest are
/// within reach.
class FrozenLattice {
  public:
    explicit FrozenLattice(int half) {
        space_.dimension = 2;
        space_.spacing = 1;
        for (int y = -half; y <= half; ++y)
            for (int x = -half; x <= half; ++x)
                points_.push_back({static_cast<std::int64_t>(points_.size()), Vec(x, y, 0)});
        first_ = static_cast<std::int64_t>(points_.size() / 2);
    }

    struct Rule {
        SolidifyRule kind;
        double probability;
        Activity activity{};
        bool spreads = true;
        int most_bonds = 1000;
    };
    /// Solid particles after each of the events.
    [[nodiscard]] std::vector<int> sizes(const Rule& rule, int events, std::uint64_t seed) const {
        std::map<std::int64_t, std::int64_t> since{{first_, 0}};
        std::set<std::int64_t> solid{first_};
        std::unordered_map<std::int64_t, int> room;
        const Binds binds = binding_rule(rule.kind, rule.probability);
        std::vector<int> sizes;
        for (int event = 0; event < events; ++event) {
            std::vector<ParticlePosition> seeds, liquid;
            for (const ParticlePosition& point : points_) {
                if (!solid.contains(point.id)) {
                    liquid.push_back(point);
                } else if (const auto found = since.find(point.id);
                           found != since.end() && rule.activity.acts_at(event - found->second) &&
                           room.try_emplace(point.id, rule.most_bonds).first->second > 0) {
                    seeds.push_back(point);
                }
            }
            auto candidates = find_bond_candidates(seeds, liquid, reach, space_);
            find_nearest(candidates, reach);
            const RandomTrial trial{seed, 0, static_cast<std::uint64_t>(event)};
            for (const BondCandidate& bond : binding_ones(candidates, binds, trial, room, rule.most_bonds)) {
                for (const std::int64_t end : {bond.seed, bond.liquid})
                    --room.try_emplace(end, rule.most_bonds).first->second;
                solid.insert(bond.liquid);
                if (rule.spreads) since.try_emplace(bond.liquid, event + 1);
            }
            sizes.push_back(static_cast<int>(solid.size()));
        }
        return sizes;
    }

    static constexpr double reach = 1.2;

  private:
    ParticleSpace space_;
    std::vector<ParticlePosition> points_;
    std::int64_t first_;
};

constexpr int runs = 400;

struct Mean {
    double value = 0, deviation = 0;
};
/// Over many runs of the size after so many events.
Mean mean_size(const FrozenLattice::Rule& rule, int events, int half) {
    const FrozenLattice lattice(half);
    double sum = 0, squares = 0;
    for (std::uint64_t seed = 0; seed < runs; ++seed) {
        const double size = lattice.sizes(rule, events, seed).back();
        sum += size;
        squares += size * size;
    }
    const double mean = sum / runs;
    return {mean, std::sqrt((squares - runs * mean * mean) / (runs - 1))};
}

TEST(SolidifyRules, that_bind_for_certain_fill_a_diamond) {
    const FrozenLattice lattice(22);
    for (const auto rule : {SolidifyRule::per_pair, SolidifyRule::per_candidate}) {
        const auto sizes = lattice.sizes({rule, 1}, 20, 1);
        for (int n = 1; n <= 20; ++n) EXPECT_EQ(sizes[n - 1], 1 + 2 * n * (n + 1)) << n;
    }
}

struct Growth {
    double probability;
    SolidifyRule rule;
    int events;
    double mean, deviation;  ///< of an independent Monte Carlo, of `runs_of_table` runs
};
constexpr double runs_of_table = 8000;
const std::vector<Growth> growths{
    {0.25, SolidifyRule::per_pair, 5, 11.85, 4.8},        {0.25, SolidifyRule::per_pair, 10, 42.06, 12.2},
    {0.25, SolidifyRule::per_pair, 20, 175.97, 31.7},     {0.25, SolidifyRule::per_candidate, 5, 10.60, 4.1},
    {0.25, SolidifyRule::per_candidate, 10, 34.39, 10.2}, {0.25, SolidifyRule::per_candidate, 20, 139.45, 27.5},
    {0.5, SolidifyRule::per_pair, 5, 31.12, 6.7},         {0.5, SolidifyRule::per_pair, 10, 121.36, 16.1},
    {0.5, SolidifyRule::per_pair, 20, 503.40, 38.0},      {0.5, SolidifyRule::per_candidate, 5, 27.60, 6.1},
    {0.5, SolidifyRule::per_candidate, 10, 105.31, 15.2}, {0.5, SolidifyRule::per_candidate, 20, 442.27, 37.3}};

/// Of the difference of the test's mean and the table's.
double three_errors(double deviation) { return 3 * deviation * std::sqrt(1.0 / runs + 1 / runs_of_table); }

TEST(SolidifyRules, grow_on_a_frozen_lattice_as_a_monte_carlo_says) {
    for (const Growth& growth : growths) {
        const Mean found = mean_size({growth.rule, growth.probability}, growth.events, growth.events + 1);
        EXPECT_NEAR(found.value, growth.mean, three_errors(growth.deviation))
            << to_string(growth.rule) << " p = " << growth.probability << " n = " << growth.events;
        EXPECT_NEAR(found.deviation / growth.deviation, 1, 0.25);
    }
}

TEST(SolidifyRules, with_seeds_active_once_make_threads) {
    const Activity once{SeedActivity::once, 1};
    for (const auto& [probability, size] : {std::pair{0.25, 4.0}, {0.5, 45.5}}) {
        const Mean found = mean_size({SolidifyRule::per_pair, probability, once}, 10, 11);
        EXPECT_NEAR(found.value, size, 3 * found.deviation * std::sqrt(2.0 / runs) + 0.05);
    }
}

/// Mean and standard deviation of what a seed alone, whose children are none, has turned solid of four.
Mean alone(SolidifyRule kind, double probability, int events) {
    Mean mean = mean_size({kind, probability, {}, false}, events, 2);
    mean.value -= 1;
    return mean;
}

TEST(SolidifyRules, of_a_seed_alone_have_closed_forms) {
    constexpr double p = 0.3;
    constexpr int n = 4, k = 4;
    const double expected = k * (1 - std::pow(1 - p, n));
    for (const auto kind : {SolidifyRule::per_pair, SolidifyRule::per_candidate}) {
        const Mean found = alone(kind, p, n);
        EXPECT_NEAR(found.value, expected, 3 * found.deviation / std::sqrt(runs));
    }
    // min(k, B), B binomial of n and p: here n = k, so B itself. With n = 8, cut at 4.
    const Mean few = alone(SolidifyRule::mutually_closest, p, n);
    EXPECT_NEAR(few.value, n * p, 3 * few.deviation / std::sqrt(runs));
    double cut = 0, squares = 0, term = std::pow(1 - 0.6, 8);
    for (int b = 0; b <= 8; ++b) {
        cut += std::min(b, k) * term;
        squares += std::min(b, k) * std::min(b, k) * term;
        term *= (8.0 - b) / (b + 1) * 0.6 / (1 - 0.6);
    }
    const Mean many = alone(SolidifyRule::mutually_closest, 0.6, 8);
    EXPECT_NEAR(many.value, cut, 3 * std::sqrt((squares - cut * cut) / runs));
}

TEST(SolidifyRules, mutually_closest_gives_a_particle_one_bond_an_event_and_never_stops_before_all_is_solid) {
    const FrozenLattice lattice(6);
    const auto sizes = lattice.sizes({SolidifyRule::mutually_closest, 1}, 40, 1);
    EXPECT_EQ(sizes[0], 2);
    EXPECT_EQ(sizes[1], 4);
    for (int n = 1; n < 8; ++n) {
        EXPECT_LE(sizes[n], 2 * sizes[n - 1]);
        EXPECT_GT(sizes[n], sizes[n - 1]);
    }
    EXPECT_EQ(sizes.back(), 13 * 13);
}

TEST(SolidifyRules, with_two_bonds_a_particle_make_a_thread_of_one_particle_a_time) {
    // The first seed has two children, and each of them one more, and so on: two more an event.
    FrozenLattice::Rule rule{SolidifyRule::per_pair, 1};
    rule.most_bonds = 2;
    const auto sizes = FrozenLattice(12).sizes(rule, 4, 1);
    for (int n = 1; n <= 4; ++n) {
        EXPECT_LE(sizes[n - 1], 1 + 2 * n);
        EXPECT_GT(sizes[n - 1], n == 1 ? 2 : sizes[n - 2]);
    }
}

TEST(SolidifyRules, act_once_or_in_one_of_n_events) {
    const Activity once{SeedActivity::once, 1}, seldom{SeedActivity::one_in, 3}, always{};
    for (std::int64_t age = 0; age < 10; ++age) {
        EXPECT_TRUE(always.acts_at(age));
        EXPECT_EQ(once.acts_at(age), age == 0);
        EXPECT_EQ(seldom.acts_at(age), age % 3 == 0);
    }
    EXPECT_FALSE(always.acts_at(-1));
}

TEST(SolidifyRules, find_all_pairs_within_reach_across_periodic_borders_and_no_others) {
    ParticleSpace space;
    space.dimension = 3;
    space.box = {Vec(-1, 0, 2), Vec(4, 3, 7)};
    space.periodic = {true, false, true};
    std::vector<ParticlePosition> seeds, liquid;
    std::uint64_t k = 0;
    const auto somewhere = [&] {
        Vec at;
        for (int axis = 0; axis < 3; ++axis)
            at[axis] = space.box.low[axis] + random_number({7, ++k}) * space.box.extent()[axis];
        return at;
    };
    for (int n = 0; n < 60; ++n) seeds.push_back({n, somewhere()});
    for (int n = 0; n < 300; ++n) liquid.push_back({1000 + n, somewhere()});
    liquid[5].position[0] += 5;  // wherever it was wrapped
    seeds[7].position[2] -= 10;
    auto found = find_bond_candidates(seeds, liquid, 0.9, space);
    find_nearest(found, 0.9);
    std::size_t expected = 0;
    for (const auto& particle : liquid) {
        const BondCandidate* nearest = nullptr;
        for (const auto& seed : seeds) {
            const double distance = nearest_image(particle.position - seed.position, space).norm();
            if (distance > 0.9) continue;
            const auto pair = std::ranges::find_if(
                found, [&](const BondCandidate& e) { return e.seed == seed.id && e.liquid == particle.id; });
            ASSERT_NE(pair, found.end());
            EXPECT_NEAR(pair->distance, distance, 1e-12);
            if (nearest == nullptr || pair->distance < nearest->distance) nearest = &*pair;
            ++expected;
        }
        if (nearest != nullptr) {
            EXPECT_TRUE(nearest->nearest_seed);
        }
    }
    EXPECT_EQ(found.size(), expected);
    EXPECT_GT(expected, 100U);
}

TEST(BondBreak, is_by_tension_alone_at_the_length_that_its_limit_says) {
    const BondBreak by_force{BreakCriterion::force, 0.4}, by_strain{BreakCriterion::strain, 0.1};
    constexpr double k = 50, r0 = 0.02;
    const double at_limit = 0.4 / (2 * k);
    EXPECT_NEAR(by_force.excess(at_limit, r0, k), 0, 1e-14);
    EXPECT_GT(by_force.excess(1.001 * at_limit, r0, k), 0);
    EXPECT_LT(by_force.excess(0.999 * at_limit, r0, k), 0);
    EXPECT_LT(by_force.excess(-10 * at_limit, r0, k), 0);
    EXPECT_NEAR(by_strain.excess(0.1 * r0, r0, k), 0, 1e-14);
    EXPECT_GT(by_strain.excess(0.11 * r0, r0, k), 0);
    EXPECT_LT(by_strain.excess(-0.5 * r0, r0, k), 0);
}

}  // namespace
}  // namespace dmp::tests::solver_solidify_rules_tests
