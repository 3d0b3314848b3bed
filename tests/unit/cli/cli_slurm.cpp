// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// What dmp writes for Slurm and reads of it, without one; tests/slurm has jobs of a real one.
#include <filesystem>

#include <gmock/gmock.h>

#include "base/safe_file.hpp"
#include "cli/exit_codes.hpp"
#include "cli/sweep/other_program.hpp"
#include "cli/sweep/slurm_folder.hpp"
#include "cli/sweep/slurm_job.hpp"
#include "cli/sweep/slurm_queue.hpp"
#include "tests/modules.hpp"
#include "tests/unit/temporary_files.hpp"
#include "tests/unit/thrown.hpp"

namespace dmp::tests::slurm_tests {
namespace {

namespace fs = std::filesystem;
using namespace cli;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::SizeIs;

SlurmJob small_job() {
    SlurmJob job;
    job.study = "my study";
    job.directory = "/home/me/50% \"a\"";
    job.folder = "/home/me/50% \"a\"/out/slurm/1";
    job.elements = 20;
    job.slurm.threads = 2;
    job.command = {"/opt/dmp", "sweep", "my study.toml", "--out", "out", "--threads", "2"};
    return job;
}

TEST(SlurmJobs, AreScriptsThatAPersonReads) {
    EXPECT_EQ(job_script(small_job(), job_form()), R"(#!/bin/bash
# Written by 'dmp sweep --slurm'. Each element of this array does the runs that its line of a file names.
#SBATCH --job-name="my study"
#SBATCH --array=1-20
#SBATCH --output="/home/me/50%% \"a\"/out/slurm/1/element_%a.log"
#SBATCH --open-mode=append
#SBATCH --chdir="/home/me/50% \"a\""
#SBATCH --ntasks=1
#SBATCH --cpus-per-task=2
#SBATCH --signal=B:USR1@120
#SBATCH --requeue

runs=$(sed -n "${SLURM_ARRAY_TASK_ID}p" '/home/me/50% "a"/out/slurm/1/runs.txt')

/opt/dmp sweep 'my study.toml' --out out --threads 2 --run $runs &
dmp=$!
# Slurm sends SIGUSR1 before the time limit: the run writes a checkpoint, dmp ends with code 138, and the element goes
# back into the queue, to go on from there. SIGTERM comes with scancel: a checkpoint, and that was it.
trap 'kill -USR1 "$dmp" 2>/dev/null' USR1
trap 'kill -TERM "$dmp" 2>/dev/null' TERM
while wait "$dmp"; code=$?; kill -0 "$dmp" 2>/dev/null; do :; done # a signal ends a wait early
if [ "$code" -eq 138 ]; then scontrol requeue "$SLURM_JOB_ID"; fi
exit "$code"
)");
}

TEST(SlurmJobs, AskForWhatIsGiven) {
    SlurmJob job = small_job();
    const SourceLocation here{"study.toml", 1, 1};
    job.at_a_time = 5;
    job.slurm.partition = {"long", here};
    job.slurm.account = {"veins", here};
    job.slurm.qos = {"normal", here};
    job.slurm.constraint = {"avx512", here};
    job.slurm.memory = {"4G", here};
    job.slurm.time = {5401, here};
    job.slurm.ranks = 4;
    const std::string script = job_script(job, job_form());
    for (const char* line : {"array=1-20%5", "partition=long", "account=veins", "qos=normal", "constraint=avx512",
                             "mem=4G", "time=0-01:31:00", "ntasks=4"})
        EXPECT_THAT(script, HasSubstr(std::string("\n#SBATCH --") + line + "\n"));
}

TEST(SlurmJobs, TimesAreRoundedUpToMinutes) {
    EXPECT_EQ(slurm_time(60), "0-00:01:00");
    EXPECT_EQ(slurm_time(61), "0-00:02:00");
    EXPECT_EQ(slurm_time(95400), "1-02:30:00");
}

TEST(SlurmJobs, AFormOfOnesOwnNeedsTheThreeWords) {
    const TemporaryFolder folder;
    const fs::path file = folder.path() / "form.sh";
    const auto fault = [&](const std::string& text) {
        write_file(file, text);
        return text_thrown<InputError>([&] { static_cast<void>(read_job_form(file)); });
    };
    EXPECT_THAT(fault("@options@\n@runs@\n"), HasSubstr("form.sh: the job script has no @command@\n"));
    EXPECT_THAT(fault("@options@ @runs@ @command@ @array@"),
                HasSubstr("form.sh: the job script has @array@, which dmp knows nothing to put for\n"));
    EXPECT_EQ(fault("# me@site.org\n@options@ @runs@ @command@"), "nothing was thrown");
    EXPECT_THAT(job_script(small_job(), "@command@; # @runs@\n"), HasSubstr("--run $runs; # '/home/me/50% \"a\"/"));
}

TEST(SlurmQueues, AreReadElementByElement) {
    const auto queue =
        read_queue("12|3|PD|Resources|/a b/c|d.sh\n12|4|R|None|/x.sh\n7|N/A|R|None|(null)\nslurm_load_jobs error\n");
    ASSERT_THAT(queue, SizeIs(2)) << "a job that is no array is none of dmp's";
    EXPECT_EQ(queue[0].job, "12");
    EXPECT_EQ(queue[0].element, 3);
    EXPECT_EQ(queue[0].reason, "Resources");
    EXPECT_EQ(queue[0].script, "/a b/c|d.sh");
    EXPECT_TRUE(queue[0].is_waiting());
    EXPECT_FALSE(queue[1].is_waiting());
}

TEST(SlurmQueues, SayHowAJobEnded) {
    const JobState state =
        read_job_state("JobId=5 JobName=x JobState=OUT_OF_MEMORY Reason=OutOfMemory Dependency=(null)");
    EXPECT_EQ(state.state, "OUT_OF_MEMORY");
    EXPECT_EQ(state.reason, "OutOfMemory");
    EXPECT_EQ(read_job_state("slurm_load_jobs error: Invalid job id specified").state, "");
}

TEST(SlurmQueues, LimitTheElementsOfAnArray) {
    EXPECT_EQ(largest_element("MaxArraySize            = 501\nMaxBatchRequeue = 5\n"), 500U);
    EXPECT_EQ(largest_element(""), 1000U);
}

class SlurmFolders : public testing::Test {
  protected:
    TemporaryFolder folder_;
    SlurmFolder jobs_{folder_.path()};
};

TEST_F(SlurmFolders, KnowWhichRunsWhichElementDoes) {
    const fs::path first = jobs_.add_job({{"0001_a", "0002_b"}, {"0003_c"}});
    SlurmFolder::note_number(first, "12");
    const fs::path second = jobs_.add_job({{"0004_d"}});
    EXPECT_EQ(read_file(first / job_runs_name), "0001_a 0002_b\n0003_c\n");
    const std::vector<SubmittedJob> jobs = jobs_.jobs();
    ASSERT_THAT(jobs, SizeIs(2));
    const auto runs = queued_runs(jobs, {{"12", 1, "R", "None", "/elsewhere"},
                                         {"12", 9, "R", "None", "/elsewhere"},
                                         {"13", 1, "PD", "Resources", (second / job_script_name).string()},
                                         {"14", 1, "R", "None", "/other/job.sh"}});
    EXPECT_THAT(runs, SizeIs(3));
    EXPECT_EQ(runs.at("0002_b").element, 1);
    EXPECT_EQ(runs.at("0004_d").job, "13") << "whose number was never noted: by its script";
}

TEST_F(SlurmFolders, KeepHowRunsEnded) {
    EXPECT_THAT(jobs_.ends_of("0001_a"), IsEmpty());
    jobs_.add_end("0001_a", {exit_user_signal, 60.5, 59, 1e6, "12_1", 400, ""});
    jobs_.add_end("0001_a", {exit_diverged, 1, 1, 2e6, "12_1", -1, "scene.toml:1:2: \"odd\", with a comma"});
    EXPECT_THAT(jobs_.ended_runs(), ElementsAre("0001_a"));
    const std::vector<JobEnd> ends = jobs_.ends_of("0001_a");
    ASSERT_THAT(ends, SizeIs(2));
    EXPECT_TRUE(ends[0].is_unfinished());
    EXPECT_EQ(ends[0].wall_s, 60.5);
    EXPECT_EQ(ends[0].checkpoint, 400);
    EXPECT_FALSE(ends[1].is_unfinished());
    EXPECT_EQ(ends[1].peak_memory, 2e6);
    EXPECT_EQ(ends[1].job, "12_1");
    EXPECT_EQ(ends[1].error, "scene.toml:1:2: \"odd\", with a comma");
    jobs_.remove_ends("0001_a");
    EXPECT_THAT(jobs_.ended_runs(), IsEmpty());
}

TEST_F(SlurmFolders, AreRemovedWithoutOthersFiles) {
    const fs::path job = jobs_.add_job({{"0001_a"}});
    write_file(job / job_script_name, "");
    write_file(job / "element_1.log", "");
    jobs_.add_end("0001_a", {});
    write_file(folder_.path() / "slurm/mine.txt", "x");
    jobs_.remove();
    EXPECT_THAT(files_in(folder_.path() / "slurm"), ElementsAre("mine.txt"));
    fs::remove(folder_.path() / "slurm/mine.txt");
    static_cast<void>(jobs_.add_job({{"0001_a"}}));
    jobs_.remove();
    EXPECT_FALSE(fs::exists(folder_.path() / "slurm"));
}

TEST(StoppedRuns, AreThoseThatASignalAskedToStop) {
    for (const int code : {129, 130, 138, 141, 143}) EXPECT_TRUE(is_stopped(code)) << code;
    for (const int code : {0, 1, 2, 3, 4, 5, 137, 139}) EXPECT_FALSE(is_stopped(code)) << code;
}

TEST(OtherPrograms, AreFoundAndHeard) {
    EXPECT_THAT(program_path("sh"), Not(IsEmpty()));
    EXPECT_EQ(program_path("no-such-program-here"), "");
    const ProgramOutput said = output_of({"sh", "-c", "echo out; echo err >&2; cat; exit 3"});
    EXPECT_EQ(said.output, "out\n");
    EXPECT_EQ(said.errors, "err\n");
    EXPECT_EQ(said.exit_code, 3);
    EXPECT_EQ(output_of({"sh", "-c", "kill -TERM $$"}).exit_code, 143);
    EXPECT_THAT(output_of({"sh", "-c", "head -c 300000 /dev/zero | tr '\\0' x"}).output, SizeIs(300000))
        << "more than a pipe holds";
    EXPECT_THAT(text_thrown<ResourceError>([] { static_cast<void>(output_of({"no-such-program-here"})); }),
                HasSubstr("'no-such-program-here' cannot be started: No such file or directory"));
}

}  // namespace
}  // namespace dmp::tests::slurm_tests
