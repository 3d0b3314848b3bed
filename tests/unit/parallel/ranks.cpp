// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/parallel/ranks.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <random>

#include <gtest/gtest.h>

#include "solver/parallel/communicator.hpp"
#include "tests/modules.hpp"

namespace dmp::tests::ranks_tests {
namespace {

struct Sample {
    std::int64_t number = 0;
    float weight = 0;
    friend bool operator==(const Sample&, const Sample&) = default;
};

/// What rank `from` sends to rank `to`: nothing to most.
std::vector<Sample> message(int from, int to) {
    std::vector<Sample> samples;
    if ((from + 2 * to) % 3 == 0)
        for (int k = 0; k < 5 * from + to; ++k) samples.push_back({1000 * from + to, static_cast<float>(k)});
    return samples;
}

TEST(Ranks, AreThoseOfTheCommunicator) {
    const Ranks ranks = Ranks::world();
    int rank = -1, size = -1;
    MPI_Comm_rank(MPI_COMM_WORLD, &rank);
    MPI_Comm_size(MPI_COMM_WORLD, &size);
    EXPECT_EQ(ranks.rank(), rank);
    EXPECT_EQ(ranks.size(), size);
    EXPECT_EQ(ranks.is_first(), rank == 0);
    int relation = MPI_UNEQUAL;
    MPI_Comm_compare(ranks.communicator().handle, MPI_COMM_WORLD, &relation);
    EXPECT_EQ(relation, MPI_CONGRUENT) << "messages must not mix with others'";
}

TEST(Ranks, Reduce) {
    const Ranks ranks = Ranks::world();
    const int last = ranks.size() - 1;
    EXPECT_EQ(ranks.largest(ranks.rank() - 0.5), last - 0.5);
    EXPECT_EQ(ranks.smallest(ranks.rank() - 0.5), -0.5);
    EXPECT_EQ(ranks.sum(std::int64_t{1} << (40 + ranks.rank())),
              (std::int64_t{1} << (41 + last)) - (std::int64_t{1} << 40));
    std::vector<std::int64_t> counts{ranks.rank(), 1};
    ranks.sum(counts);
    EXPECT_EQ(counts, (std::vector<std::int64_t>{last * (last + 1) / 2, last + 1}));
    EXPECT_TRUE(ranks.any(ranks.rank() == last));
    EXPECT_FALSE(ranks.any(false));
    std::vector<double> values{1.0 * ranks.rank(), -1.0 * ranks.rank(), -std::numeric_limits<double>::infinity()};
    ranks.largest(values);
    EXPECT_EQ(values, (std::vector<double>{1.0 * last, 0, -std::numeric_limits<double>::infinity()}));
}

TEST(Ranks, CarryNaNOn) {
    const Ranks ranks = Ranks::world();
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (int broken = 0; broken < ranks.size(); ++broken) {
        EXPECT_TRUE(std::isnan(ranks.largest(ranks.rank() == broken ? nan : 1)));
        EXPECT_TRUE(std::isnan(ranks.smallest(ranks.rank() == broken ? nan : 1)));
        std::vector<double> values{1, ranks.rank() == broken ? nan : 2, 3};
        ranks.largest(values);
        EXPECT_EQ(values[0], 1);
        EXPECT_TRUE(std::isnan(values[1]));
        EXPECT_EQ(values[2], 3);
    }
}

TEST(Ranks, SumExactly) {
    const Ranks ranks = Ranks::world();
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> mantissa(-1, 1);
    std::uniform_int_distribution<int> exponent(-300, 300), owner(0, ranks.size() - 1);
    ExactSum whole, part;
    for (int k = 0; k < 20000; ++k) {
        const double value = std::ldexp(mantissa(random), exponent(random));
        whole.add(value);
        if (owner(random) == ranks.rank()) part.add(value);
    }
    ranks.sum(part);
    EXPECT_EQ(std::bit_cast<std::uint64_t>(part.value()), std::bit_cast<std::uint64_t>(whole.value()));

    // Several in one message, each by itself.
    std::array<ExactSum, 3> several;
    several[0].add(ranks.rank());
    several[2].add(-0.5);
    ranks.sum(several);
    EXPECT_EQ(several[0].value(), ranks.size() * (ranks.size() - 1) / 2);
    EXPECT_EQ(several[1].value(), 0);
    EXPECT_EQ(several[2].value(), -0.5 * ranks.size());

    ExactSum broken;
    if (ranks.rank() == ranks.size() - 1) broken.add(std::numeric_limits<double>::infinity());
    ranks.sum(broken);
    EXPECT_EQ(broken.value(), std::numeric_limits<double>::infinity());
}

TEST(Ranks, BroadcastFromTheFirst) {
    const Ranks ranks = Ranks::world();
    std::vector<Sample> samples(static_cast<std::size_t>(ranks.rank()));
    std::string text = "rank " + std::to_string(ranks.rank());
    if (ranks.is_first()) samples = message(0, 3);
    ranks.broadcast(samples);
    ranks.broadcast(text);
    EXPECT_EQ(samples, message(0, 3));
    EXPECT_EQ(text, "rank 0");
}

TEST(Ranks, Gather) {
    const Ranks ranks = Ranks::world();
    std::vector<Sample> all;
    for (int rank = 0; rank < ranks.size(); ++rank)
        for (const Sample& sample : message(rank, 0)) all.push_back(sample);
    EXPECT_EQ(ranks.all_gather(message(ranks.rank(), 0)), all);
    EXPECT_EQ(ranks.gather_to_first(message(ranks.rank(), 0)), ranks.is_first() ? all : std::vector<Sample>{});
}

TEST(Ranks, Exchange) {
    const Ranks ranks = Ranks::world();
    for (int round = 0; round < 3; ++round) {  // no round's messages get into the next
        std::vector<std::vector<Sample>> to_each;
        for (int to = 0; to < ranks.size(); ++to) to_each.push_back(message(ranks.rank() + round, to));
        const auto from_each = ranks.exchange(to_each);
        ASSERT_EQ(from_each.size(), to_each.size());
        for (int from = 0; from < ranks.size(); ++from)
            EXPECT_EQ(from_each[static_cast<std::size_t>(from)], message(from + round, ranks.rank()));
    }
}

}  // namespace
}  // namespace dmp::tests::ranks_tests
