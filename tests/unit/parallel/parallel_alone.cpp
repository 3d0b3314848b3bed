// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// One process alone: everything of solver/parallel works without MPI, which is never started here.
#include <gtest/gtest.h>

#include "solver/parallel/communicator.hpp"
#include "solver/parallel/ranks.hpp"

namespace dmp {
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

}  // namespace
}  // namespace dmp
