// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// One process alone: everything of solver/parallel works without MPI, which is never started here.
#include <gtest/gtest.h>

#include "solver/domain/domain.hpp"
#include "solver/domain/halo.hpp"
#include "solver/parallel/communicator.hpp"
#include "solver/parallel/ranks.hpp"
#include "tests/modules.hpp"
#include "tests/unit/parallel/moving_particles.hpp"

namespace dmp::tests::parallel_alone_tests {
namespace {

class Alone : public testing::Test {
  protected:
    void TearDown() override {
        int started = 1;
        MPI_Initialized(&started);
        EXPECT_EQ(started, 0);
    }
};

TEST_F(Alone, ASessionDoesNotStartMpi) {
    ASSERT_FALSE(MpiSession::started_by_mpirun());
    const MpiSession session;
    EXPECT_EQ(session.ranks().size(), 1);
    session.end_all(7);  // comes back
}

TEST_F(Alone, RanksAgreeWithThemselves) {
    const Ranks alone = Ranks::alone();
    EXPECT_EQ(alone.size(), 1);
    EXPECT_TRUE(alone.is_first());
    EXPECT_EQ(alone.largest(-3.5), -3.5);
    EXPECT_EQ(alone.smallest(-3.5), -3.5);
    EXPECT_EQ(alone.sum(std::int64_t{7}), 7);
    EXPECT_TRUE(alone.any(true));
    EXPECT_FALSE(alone.any(false));
    const std::vector<double> values{4, 2};
    EXPECT_EQ(alone.all_gather(values), values);
    EXPECT_EQ(alone.gather_to_first(values), values);
    const std::vector<std::vector<double>> to_each{values};
    EXPECT_EQ(alone.exchange(to_each), to_each);
    std::string text = "as it was";
    alone.broadcast(text);
    EXPECT_EQ(text, "as it was");
    ExactSum sum(values);
    alone.sum(sum);
    EXPECT_EQ(sum.value(), 6);
}

TEST_F(Alone, ADomainOwnsEverything) {
    MovingParticles particles(2, {true, false, false}, 1000, 1);
    Domain domain(Ranks::alone(), particles.space);
    ParticleGroup group = particles.group(dealt(1000, 0, 1));
    for (std::size_t i = 0; i < group.owned(); ++i)
        group.data(Field::position, 0)[i] += static_cast<double>(i % 5) - 2;  // whole periods
    domain.divide({&group}, {});
    domain.migrate({&group});
    ASSERT_EQ(group.total(), 1000);
    for (std::size_t i = 0; i < 1000; ++i) {
        ASSERT_EQ(group.tags()[i].id, i);
        ASSERT_TRUE(particles.holds(group, i, group.declared()));
    }
    EXPECT_EQ(domain.owner(Vec(1e9, -1e9, 0)), 0);
    EXPECT_EQ(domain.imbalance({&group}, {}), 1);
}

/// The channel's images stand where the sides are near, and nowhere else.
TEST_F(Alone, AHaloHoldsTheImages) {
    MovingParticles particles(2, {true, false, false}, 30000, 2);
    const Domain domain(Ranks::alone(), particles.space);
    ParticleGroup group = particles.group(dealt(30000, 0, 1));
    Halo halo(Ranks::alone(), particles.space);
    const double reach = 0.0625, low = particles.space.box.low[0], high = particles.space.box.high[0];
    halo.build(group, domain, reach);
    std::size_t expected = 0;
    for (std::size_t i = 0; i < group.owned(); ++i) {
        const double x = group.data(Field::position, 0)[i];
        expected += (x - low <= reach ? 1 : 0) + (high - x <= reach ? 1 : 0);
    }
    EXPECT_EQ(halo.ghosts(), expected);
    EXPECT_EQ(halo.ghosts_per_owned(), static_cast<double>(expected) / 30000);
    particles.change_values();
    particles.write(group, group.declared());
    halo.exchange(group, group.declared());
    for (std::size_t i = group.owned(); i < group.total(); ++i) {
        const double x = group.data(Field::position, 0)[i];
        EXPECT_TRUE((x < low && low - x <= reach) || (x >= high && x - high <= reach)) << x;
        ASSERT_TRUE(particles.holds(group, i, group.declared(), Vec(x < low ? low - high : high - low, 0, 0)));
    }
}

}  // namespace
}  // namespace dmp::tests::parallel_alone_tests
