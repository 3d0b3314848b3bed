// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// The program under mpirun: the same results, one voice, and one end for all.
#include <filesystem>
#include <sstream>
#include <string>
#include <utility>

#include <gmock/gmock.h>

#include "tests/end_to_end/small_valve.hpp"

namespace dmp::tests::under_mpirun_tests {

namespace {

using testing::HasSubstr;
using testing::SizeIs;

std::size_t times(const std::string& text, const std::string& words) {
    std::size_t count = 0;
    for (auto at = text.find(words); at != std::string::npos; at = text.find(words, at + 1)) ++count;
    return count;
}

class SomeRanks : public SmallValve {
  protected:
    [[nodiscard]] Words briefly(Words more = {}) const {
        more.insert(more.end(), {"--until", "0.03 s", "--overwrite"});
        return more;
    }
};

TEST_F(SomeRanks, ThreadsAndVectorUnitsDoNotChangeABit) {
    ASSERT_EQ(run("whole", briefly()).code, 0);
    for (const std::string threads : {"2", "3"}) {
        ASSERT_EQ(run("out", briefly({"--threads", threads})).code, 0);
        EXPECT_EQ(hash("out"), hash("whole")) << threads << " threads";
    }
    if (run_dmp(folder_.path(), {"doctor"}).output.find("avx2") == std::string::npos) return;  // no x86 processor
    ASSERT_EQ(run("out", briefly({"--vector-unit", "avx2"})).code, 0);
    EXPECT_EQ(hash("out"), hash("whole"));
    EXPECT_EQ(summary("out")["vector_unit"], "avx2");
}

/// What Open MPI's library says where there is no /sys.
std::string without_words_about_the_machine(const std::string& errors) {
    std::istringstream lines(errors);
    std::string kept;
    for (std::string line; std::getline(lines, line);)
        if (!line.starts_with("[hwloc/")) kept += line + "\n";
    return kept;
}

TEST_F(SomeRanks, RanksDoNotChangeABitAndTheFirstOneSpeaks) {
    ASSERT_EQ(run("whole", briefly()).code, 0);
    for (const int ranks : {1, 2, 3, 4}) {
        const auto outcome = run("out", briefly(), {.ranks = ranks});
        ASSERT_EQ(outcome.code, 0) << outcome.errors;
        EXPECT_EQ(hash("out"), hash("whole")) << ranks << " ranks";
        EXPECT_EQ(summary("out")["ranks"], ranks);
        const auto shares = summary("out")["rank_shares"];
        EXPECT_EQ(shares["messages_per_step"].get<double>() > 1, ranks > 1) << shares;
        EXPECT_EQ(shares["bytes_per_step"].get<double>() > 100, ranks > 1) << shares;
        EXPECT_LT(shares["imbalance"].get<double>(), 1.5) << shares;
        EXPECT_GT(shares["copies_per_owned"].get<double>(), 0) << "its period makes copies";
        const std::string errors = without_words_about_the_machine(outcome.errors);
        EXPECT_THAT(errors, testing::StartsWith("warning: leaflets: EA lowered from 100 to 24 N"));
        EXPECT_EQ(times(errors, "\n"), 1U) << errors;
        for (const char* once : {"Writing to out", "Done: ", "Results in out"})
            EXPECT_EQ(times(outcome.output, once), 1U) << once << "\n" << outcome.output;
        EXPECT_EQ(folder_.read("out/measures.csv"), folder_.read("whole/measures.csv"));
    }
}

TEST_F(SomeRanks, AFinishedRunGoesOnOnAnyNumberOfThem) {
    ASSERT_EQ(run("whole", {"--until", "0.03 s"}).code, 0);
    for (const auto& [first, then] : {std::pair{2, 2}, std::pair{1, 4}, std::pair{4, 1}}) {
        const std::string out = "from_" + std::to_string(first);
        // Neither at a frame nor at a row of the measures.
        ASSERT_EQ(run(out, {"--until", "0.0133 s"}, {.ranks = first}).code, 0);
        const auto resumed = run(out, {"--until", "0.03 s", "--resume"}, {.ranks = then});
        ASSERT_EQ(resumed.code, 0) << resumed.errors;
        EXPECT_EQ(hash(out), hash("whole")) << first << " and " << then << " ranks";
        EXPECT_EQ(folder_.read(out + "/measures.csv"), folder_.read("whole/measures.csv"));
        EXPECT_EQ(files(out + "/frames"), files("whole/frames"));
    }
}

TEST_F(SomeRanks, TryARunOutTogetherAndLeaveNoColoursInTheLogOfTheJob) {
    const auto outcome = run("out", {"--dry-run"}, {.environment = {"TERM=xterm-256color", "NO_COLOR="}, .ranks = 2});
    ASSERT_EQ(outcome.code, 0) << outcome.errors;
    EXPECT_THAT(outcome.output, testing::AllOf(HasSubstr("What will run"), HasSubstr("Nothing was written"),
                                               testing::Not(HasSubstr("\033"))));
}

TEST_F(SomeRanks, NorDoManyOrWithThreadsAndAnotherVectorUnit) {
    ASSERT_EQ(run("whole", briefly()).code, 0);
    ASSERT_EQ(run("out", briefly(), {.ranks = 8}).code, 0);
    EXPECT_EQ(hash("out"), hash("whole"));
    Words mixed = briefly({"--threads", "2"});
    if (run_dmp(folder_.path(), {"doctor"}).output.find("avx2") != std::string::npos)
        mixed.insert(mixed.end(), {"--vector-unit", "avx2"});
    ASSERT_EQ(run("out", mixed, {.ranks = 2}).code, 0);
    EXPECT_EQ(hash("out"), hash("whole"));
    EXPECT_EQ(summary("out")["threads"], 2);
}

TEST_F(SomeRanks, TheFluidsOptionsAreTheSameBitsOnAnyNumberOfRanks) {
    const auto options = [](Words more = {}) {
        for (const char* option : {"scheme=plain", "gradient_correction=true", "density=summation",
                                   "transport_velocity=true", "viscous_law=monaghan", "kernel=quintic_spline"})
            more.insert(more.end(), {"--set", std::string("numerics.") + option});
        more.insert(more.end(), {"--until", "0.01 s"});
        return more;
    };
    ASSERT_EQ(run("whole", options()).code, 0);
    const auto outcome = run("out", options(), {.ranks = 3});
    ASSERT_EQ(outcome.code, 0) << outcome.errors;
    EXPECT_EQ(hash("out"), hash("whole"));
}

TEST_F(SomeRanks, ATermSignalToMpirunLeavesACheckpointForAnyNumberOfRanks) {
    // mpirun takes its time to hand the signal on, and a fast machine little for half a second.
    const Words long_enough{"--until", "1.5 s"};
    ASSERT_EQ(run("whole", long_enough).code, 0);
    const auto stopped = stopped_run("parts", long_enough, 2);
    EXPECT_NE(stopped.code, 0);
    EXPECT_THAT(files("parts/checkpoints"), SizeIs(1)) << stopped.output << stopped.errors;
    const auto resumed = run("parts", {"--until", "1.5 s", "--resume"}, {.ranks = 3});
    ASSERT_EQ(resumed.code, 0) << resumed.errors;
    EXPECT_THAT(resumed.output, HasSubstr("Going on in parts from step "));
    EXPECT_EQ(hash("parts"), hash("whole"));
    EXPECT_EQ(folder_.read("parts/measures.csv"), folder_.read("whole/measures.csv"));
    EXPECT_EQ(folder_.read("parts/fluid.pvd"), folder_.read("whole/fluid.pvd"));
}

TEST_F(SomeRanks, AnInputErrorEndsThemAllAndIsSaidOnce) {
    const auto outcome = run("out", {"--set", "particles.spacin=1"}, {.ranks = 2});
    EXPECT_EQ(outcome.code, 2);
    EXPECT_EQ(times(outcome.errors, "error: "), 1U) << outcome.errors;
    EXPECT_EQ(outcome.output.find("spacin"), std::string::npos);
}

TEST_F(SomeRanks, ADivergenceEndsThemAllAndIsSaidOnce) {
    const auto outcome = run("out", {"--set", "flow.pressure_gradient=[\"-1e6 Pa/m\", 0]"}, {.ranks = 3});
    EXPECT_EQ(outcome.code, 3);
    EXPECT_EQ(times(outcome.errors, "diverged"), 1U) << outcome.errors;
}

TEST_F(SomeRanks, WhatOnlyTheFirstOneMeetsEndsThemAll) {
    std::filesystem::create_directories(folder_.path() / "out/measures.csv/in_the_way");
    folder_.write("out/summary.json", "{}");
    const auto outcome = run("out", briefly(), {.ranks = 3});
    EXPECT_EQ(outcome.code, 2);
    EXPECT_EQ(times(outcome.errors, "error: "), 1U) << outcome.errors;
    EXPECT_THAT(outcome.errors, HasSubstr("measures.csv"));
}

}  // namespace

}  // namespace dmp::tests::under_mpirun_tests
