// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <iostream>
#include <string>

#include <gtest/gtest.h>

#include "solver/parallel/ranks.hpp"
#include "tests/modules.hpp"

namespace {

/// Says what failed on a rank that is not the first, and nothing else.
class FailuresOnly : public testing::EmptyTestEventListener {
  public:
    explicit FailuresOnly(int rank) : rank_(rank) {}

    void OnTestStart(const testing::TestInfo& test) override { test_ = test.name(); }

    void OnTestPartResult(const testing::TestPartResult& result) override {
        if (!result.failed()) return;
        const char* file = result.file_name() == nullptr ? "" : result.file_name();
        std::cout << "rank " + std::to_string(rank_) + ", " + test_ + ", " + file + ":" +
                         std::to_string(result.line_number()) + ": " + result.message() + "\n"
                  << std::flush;
    }

  private:
    int rank_;
    std::string test_;
};

}  // namespace

/// Any rank's failure is the whole run's.
int main(int argc, char** argv) {
    testing::InitGoogleTest(&argc, argv);
    const dmp::solver::MpiSession session;
    const dmp::solver::Ranks ranks = session.ranks();
    if (!ranks.is_first()) {
        testing::TestEventListeners& listeners = testing::UnitTest::GetInstance()->listeners();
        delete listeners.Release(listeners.default_result_printer());
        listeners.Append(new FailuresOnly(ranks.rank()));
    }
    const bool failed = RUN_ALL_TESTS() != 0;
    return ranks.any(failed) ? 1 : 0;
}
