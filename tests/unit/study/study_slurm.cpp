// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// [slurm] of a study: what is read, what the command line says in its place, and what is wrong with it.
#include <map>
#include <ostream>

#include <gmock/gmock.h>

#include "study/points.hpp"
#include "study/read_slurm.hpp"
#include "tests/modules.hpp"
#include "tests/unit/study/study_text.hpp"
#include "tests/unit/thrown.hpp"

namespace dmp::tests::study_slurm_tests {
namespace {

Slurm slurm_of(const std::string& lines) { return study_of(good_study + "\n[slurm]\n" + lines).slurm; }

TEST(SlurmOfAStudy, IsReadWithItsUnits) {
    const Slurm slurm = slurm_of(
        "partition = \"long\"\naccount = \"veins:2026\"\nqos = \"normal\"\nconstraint = \"avx512&[rack1|rack2]\"\n"
        "memory = \"4G\"\ntime = \"1.5 h\"\nstop_before = \"5 min\"\nranks = 4\nthreads = 2\nruns_per_job = 10\n"
        "launcher = \"srun\"\n");
    EXPECT_EQ(*slurm.partition, "long");
    EXPECT_EQ(*slurm.account, "veins:2026");
    EXPECT_EQ(*slurm.qos, "normal");
    EXPECT_EQ(*slurm.constraint, "avx512&[rack1|rack2]");
    EXPECT_EQ(*slurm.memory, "4G");
    EXPECT_EQ(*slurm.time, 5400);
    EXPECT_EQ(slurm.seconds_before_limit(), 300);
    EXPECT_EQ(*slurm.ranks, 4);
    EXPECT_EQ(*slurm.threads, 2);
    EXPECT_EQ(*slurm.runs_per_job, 10);
    EXPECT_EQ(*slurm.launcher, Launcher::srun);
}

TEST(SlurmOfAStudy, AsksForNothingWhereNothingIsGiven) {
    const Slurm slurm = study_of(good_study).slurm;
    EXPECT_FALSE(slurm.partition.given() || slurm.time.given() || slurm.threads.given() || slurm.memory.given());
    EXPECT_EQ(*slurm.ranks, 1);
    EXPECT_EQ(*slurm.runs_per_job, 1);
    EXPECT_EQ(*slurm.launcher, Launcher::mpirun);
}

TEST(SlurmOfAStudy, CheckpointsStartTwoMinutesBeforeTheLimitOrAQuarterOfIt) {
    EXPECT_EQ(slurm_of("").seconds_before_limit(), 120);
    EXPECT_EQ(slurm_of("time = \"1 h\"").seconds_before_limit(), 120);
    EXPECT_EQ(slurm_of("time = \"2 min\"").seconds_before_limit(), 30);
}

TEST(SlurmOfAStudy, IsNoPartOfWhatItsRunsAre) {
    EXPECT_EQ(identity_of(study_of(good_study)), identity_of(study_of(good_study + "\n[slurm]\nranks = 4\n")));
}

TEST(SlurmOfAStudy, TheCommandLineComesFirst) {
    const Slurm slurm =
        with_options(slurm_of("partition = \"long\"\ntime = \"1 h\"\nqos = \"normal\""),
                     {{"--partition", "short"}, {"--account", ""}, {"--time", "10 min"}, {"--ranks", "8"}});
    EXPECT_EQ(*slurm.partition, "short");
    EXPECT_EQ(*slurm.time, 600);
    EXPECT_EQ(*slurm.qos, "normal");
    EXPECT_EQ(*slurm.ranks, 8);
    EXPECT_FALSE(slurm.account.given());
}

TEST(SlurmOfAStudy, AWrongOptionIsNamed) {
    const auto fault = [](const std::string& option, const std::string& text) {
        return text_thrown<InputError>([&] { static_cast<void>(with_options(Slurm(), {{option, text}})); });
    };
    EXPECT_EQ(fault("--partition", "a b"),
              "--partition: partition: found \"a b\" (text), expected the name of a partition, such as \"long\"\n"
              "  it may have letters, digits and _ - . , : + @ & | * [ ] ( )");
    EXPECT_EQ(fault("--time", "10"),
              "--time: missing unit: time = 10, expected a time such as \"2 h\"\n"
              "  write time = \"10 h\", with the unit you mean");
    EXPECT_EQ(fault("--time", "10 s"),
              "--time: slurm.time is less than a minute, the shortest limit that Slurm has\n  give \"1 min\" or more");
}

/// Lines of [slurm], and the message that they must give.
struct SlurmFault {
    const char* name;
    const char* lines;
    const char* message;
};

void PrintTo(const SlurmFault& fault, std::ostream* stream) { *stream << fault.name; }

class BadSlurm : public testing::TestWithParam<SlurmFault> {};

TEST_P(BadSlurm, SaysWhereWhatAndWhatToDo) {
    EXPECT_EQ(study_fault(std::string("scene = \"scene.toml\"\n[slurm]\n") + GetParam().lines), GetParam().message);
}

INSTANTIATE_TEST_SUITE_P(
    Study, BadSlurm,
    testing::ValuesIn(std::vector<SlurmFault>{
        {"misspelt_key", "partion = \"long\"",
         "study.toml:3:1: unknown key 'partion' in [slurm]\n"
         "  did you mean 'partition'?"},
        {"no_text", "partition = 3",
         "study.toml:3:13: slurm.partition: found 3 (a whole number), expected text\n"
         "  write it in quotes: partition = \"3\""},
        {"line_break", "account = \"a\\nexec\"",
         "study.toml:3:11: slurm.account: found \"a\\nexec\" (text), expected the name of an account\n"
         "  it may have letters, digits and _ - . , : + @ & | * [ ] ( )"},
        {"option_in_a_name", "qos = \"--wrap\"",
         "study.toml:3:7: slurm.qos: found \"--wrap\" (text), expected the name of a quality of service\n"
         "  it may have letters, digits and _ - . , : + @ & | * [ ] ( )"},
        {"memory_without_unit", "memory = \"4\"",
         "study.toml:3:10: slurm.memory: found \"4\" (text), expected a memory as Slurm writes it, such as \"4G\"\n"
         "  write a number and K, M, G or T"},
        {"time_without_unit", "time = 60",
         "study.toml:3:8: missing unit: time = 60, expected a time such as \"2 h\"\n"
         "  write time = \"60 h\", with the unit you mean"},
        {"short_time", "time = \"30 s\"",
         "study.toml:3:8: slurm.time is less than a minute, the shortest limit that Slurm has\n"
         "  give \"1 min\" or more"},
        {"late_checkpoint", "time = \"1 h\"\nstop_before = \"1 h\"",
         "study.toml:4:15: slurm.stop_before is not shorter than slurm.time\n"
         "  give the time that a checkpoint needs, such as \"2 min\""},
        {"no_ranks", "ranks = 0",
         "study.toml:3:9: slurm.ranks: found 0, expected at least 1\n"
         "  give a value that is at least 1"},
        {"unknown_launcher", "launcher = \"mpiexec\"",
         "study.toml:3:12: slurm.launcher: found \"mpiexec\", expected one of 'mpirun' and 'srun'\n"
         "  write one of these names"},
    }),
    [](const auto& fault) { return std::string(fault.param.name); });

}  // namespace
}  // namespace dmp::tests::study_slurm_tests
