// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Liquid at rest that turns solid on a square lattice, against counting and an independent Monte Carlo.
#include <array>
#include <cmath>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "tests/modules.hpp"
#include "tests/verification/record.hpp"
#include "tests/verification/run_case.hpp"

namespace dmp::tests::aggregate_tests {
namespace {

constexpr double interval = 1e-3;
constexpr int runs = 400;

/// The case with a rule, many times with other random numbers.
class Growth {
  public:
    Growth(const std::string& rule, double probability, const std::vector<std::string>& more = {}) {
        std::vector<std::string> overrides{"solidify.clot.rule=" + rule,
                                           set_to("solidify.clot.probability", probability)};
        overrides.insert(overrides.end(), more.begin(), more.end());
        scene_ = scene_of_case("verification/aggregate", overrides);
        particles_ = particles_of(scene_);
    }
    /// Solid particles after the first, second, ... event.
    std::vector<double> sizes(int events, int seed) {
        scene_.solidify.at(0).seed = seed;
        last = run_scene(scene_, particles_, (events - 0.5) * interval, nullptr, 1);
        std::vector<double> found = column(last.measures, "clot_particles");
        found.resize(static_cast<std::size_t>(events));
        return found;
    }
    RunSummary last;

  private:
    Scene scene_;
    ParticleSet particles_;
};

// All four neighbours of each: 1 + 2 n (n + 1) particles after n events.
TEST(Aggregate, FillsADiamondForCertain) {
    for (const std::string rule : {"per_pair", "per_candidate"}) {
        Growth growth(rule, 1);
        const std::vector<double> sizes = growth.sizes(20, 1);
        double worst = 0;
        for (int n = 1; n <= 20; ++n)
            worst = std::max(worst, std::abs(sizes.at(static_cast<std::size_t>(n - 1)) - (1 + 2 * n * (n + 1))));
        Record record("aggregate", rule + ", p = 1", growth.last);
        record.at_most("particles after 1 to 20 events, largest difference from 1 + 2 n (n + 1)", worst, 0);
        const RunSummary& run = growth.last;
        record.at_most("change of the mass, over the mass", (run.end.mass - run.start.mass) / run.start.mass, 1e-14);
    }
}

/// The same growth, made apart from the program: cells of a square that each make their own random trials, by how many
/// of their four neighbours are solid. Means and variances of the size after some events.
struct MonteCarlo {
    static constexpr int runs = 4000, half = 21, row = 2 * half + 1;
    std::array<double, 3> mean{}, variance{};

    MonteCarlo(bool by_pair, double probability, const std::array<int, 3>& events) {
        std::mt19937_64 random(20120902);
        std::array<double, 3> sum{}, squares{};
        for (int run = 0; run < runs; ++run) {
            std::vector<char> solid(row * row, 0);
            solid[row * row / 2] = 1;
            int size = 1;
            for (int event = 1; event <= events.back(); ++event) {
                std::vector<char> next = solid;
                for (int y = half - event; y <= half + event; ++y)
                    for (int x = half - event; x <= half + event; ++x) {
                        const auto at = static_cast<std::size_t>(y * row + x);
                        const int near = solid[at - 1] + solid[at + 1] + solid[at - row] + solid[at + row];
                        if (solid[at] != 0 || near == 0) continue;
                        const double chance = by_pair ? 1 - std::pow(1 - probability, near) : probability;
                        if (static_cast<double>(random() >> 11) * 0x1p-53 >= chance) continue;
                        next[at] = 1;
                        ++size;
                    }
                solid = next;
                for (std::size_t k = 0; k < events.size(); ++k)
                    if (event == events.at(k)) {
                        sum.at(k) += size;
                        squares.at(k) += static_cast<double>(size) * size;
                    }
            }
        }
        for (std::size_t k = 0; k < events.size(); ++k) {
            mean.at(k) = sum.at(k) / runs;
            variance.at(k) = squares.at(k) / runs - mean.at(k) * mean.at(k);
        }
    }
};

class AggregateOfChance : public testing::TestWithParam<std::pair<std::string, double>> {};

TEST_P(AggregateOfChance, GrowsAsAMonteCarloSays) {
    const auto& [rule, probability] = GetParam();
    constexpr std::array<int, 3> events{5, 10, 20};
    const MonteCarlo expected(rule == "per_pair", probability, events);
    Growth growth(rule, probability);
    std::array<double, 3> sum{};
    for (int seed = 0; seed < runs; ++seed) {
        const std::vector<double> sizes = growth.sizes(events.back(), seed);
        for (std::size_t k = 0; k < events.size(); ++k) sum.at(k) += sizes.at(static_cast<std::size_t>(events[k] - 1));
    }
    Record record("aggregate", rule + ", p = " + (probability == 0.5 ? "0.5" : "0.25"), growth.last);
    for (std::size_t k = 0; k < events.size(); ++k) {
        const double error = std::sqrt(expected.variance.at(k) * (1.0 / runs + 1.0 / MonteCarlo::runs));
        record.at_most("mean size after " + std::to_string(events.at(k)) + " events, difference in standard errors",
                       (sum.at(k) / runs - expected.mean.at(k)) / error, 3);
    }
}

INSTANTIATE_TEST_SUITE_P(Rules, AggregateOfChance,
                         testing::Values(std::pair{"per_pair", 0.25}, std::pair{"per_candidate", 0.25},
                                         std::pair{"per_pair", 0.5}, std::pair{"per_candidate", 0.5}));

// A seed whose children are none, with k = 4 neighbours: each turns solid by itself, so that k (1 - (1 - p)^n) do on
// average; of mutually closest pairs there is one an event, which binds with p: min(k, B), B binomial of n and p.
TEST(Aggregate, OfASeedAloneHasClosedForms) {
    constexpr double p = 0.3;
    constexpr int n = 4, k = 4;
    const double turned = 1 - std::pow(1 - p, n);
    for (const std::string rule : {"per_pair", "per_candidate", "mutually_closest"}) {
        const bool one_a_time = rule == "mutually_closest";
        const double mean = one_a_time ? n * p : k * turned;
        const double deviation = std::sqrt(one_a_time ? n * p * (1 - p) : k * turned * (1 - turned));
        Growth growth(rule, p,
                      {"solidify.clot.spreads=false", "geometry.parameters={ side = \"12 mm\" }",
                       R"(region.nidus.from=["6.25 mm", "6.25 mm"])", R"(region.nidus.to=["6.75 mm", "6.75 mm"])"});
        double sum = 0;
        for (int seed = 0; seed < runs; ++seed) sum += growth.sizes(n, seed).back() - 1;
        Record record("aggregate", rule + ", a seed alone, p = 0.3", growth.last);
        record.at_most("mean of " + std::to_string(runs) + " after 4 events, difference in standard errors",
                       (sum / runs - mean) / (deviation / std::sqrt(runs)), 3);
    }
}

}  // namespace
}  // namespace dmp::tests::aggregate_tests
