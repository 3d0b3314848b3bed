// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <csignal>

#include <gmock/gmock.h>
#include <sys/resource.h>

#include "base/folder_lock.hpp"
#include "base/safe_file.hpp"
#include "cli/sweep/sweep_folder.hpp"
#include "study/points.hpp"
#include "tests/modules.hpp"
#include "tests/unit/study/study_text.hpp"
#include "tests/unit/thrown.hpp"

namespace dmp::tests::sweep_folder_tests {
namespace {

namespace fs = std::filesystem;
using namespace cli;
using testing::HasSubstr;

const TypedCommand typed({"dmp", "sweep", "study.toml"});

class SweepFolders : public testing::Test {
  protected:
    SweepFolders() {
        Folder::write(good_scene);
        Folder::write(good_study, "study.toml");
        Folder::write(study_with("3e-6", "4e-6"), "other.toml");
    }
    static void make(const std::string& study, bool resume = false, bool overwrite = false) {
        const Study read = read_study(study);
        const SweepFolder folder("out", {read, 6, resume, overwrite}, typed);
    }
    [[nodiscard]] static std::string refused(const std::string& study, bool resume = false) {
        return text_thrown<InputError>([&] { make(study, resume); });
    }
    static void put_finished_run(const std::string& run) {
        make_folder("out/runs/" + run);
        write_file("out/runs/" + run + "/summary.json", R"({"interrupted": false, "simulated_s": 4})");
        write_file("out/runs/" + run + "/mine.txt", "x");
        write_file("out/runs/" + run + ".log", "x");
    }

    Folder folder_;
};

TEST_F(SweepFolders, HoldsCopiesOfStudyAndScene) {
    make("study.toml");
    EXPECT_EQ(read_file("out/study.toml"), good_study);
    EXPECT_EQ(read_file("out/scene.toml"), good_scene);
    EXPECT_EQ(sweep_contents_of("out").kind, SweepContents::Kind::study);
    EXPECT_FALSE(fs::exists("out/dmp.lock"));
}

TEST_F(SweepFolders, SaysHowToGoOnWithTheStudyInIt) {
    make("study.toml");
    put_finished_run("0001_0123abcd");
    EXPECT_EQ(refused("study.toml"),
              "out: it holds this study, 1 of 6 runs done\n"
              "  To go on with it:\n  dmp sweep study.toml --resume\n"
              "To remove it and run in its place:\n  dmp sweep study.toml --overwrite\n"
              "To keep it and write beside it:\n  dmp sweep study.toml --out out_2");
    make("study.toml", true);
}

TEST_F(SweepFolders, RefusesAnotherStudyOrNoneToGoOnWith) {
    EXPECT_THAT(refused("study.toml", true), HasSubstr("out: there is no study to go on with\n"));
    EXPECT_FALSE(fs::exists("out"));
    make("other.toml");
    put_finished_run("0001_0123abcd");
    EXPECT_THAT(refused("study.toml"), HasSubstr("out: it holds another study, or this one with another scene or other "
                                                 "values: 'other'"));
    EXPECT_THAT(refused("study.toml", true), HasSubstr("it holds another study"));
    write_file("out/sweep.toml", "damaged = ");
    EXPECT_THAT(refused("study.toml", true), HasSubstr("it holds another study"));
}

TEST_F(SweepFolders, OneWithoutRunsIsStartedAnew) {
    make("other.toml");
    // As 'dmp sweep --slurm' leaves it where sbatch refuses the job.
    write_file("out/results.csv", "run,exit_code,error\n");
    make_folder("out/slurm/ends");
    make("study.toml");
    EXPECT_EQ(read_file("out/study.toml"), good_study);
    EXPECT_FALSE(fs::exists("out/results.csv") || fs::exists("out/slurm"));
    for (const char* file :
         {"out/runs/0001_0123abcd.log", "out/slurm/1/runs.txt", "out/slurm/ends/0001_0123abcd.csv"}) {
        make_folder(fs::path(file).parent_path());
        write_file(file, "x");
        EXPECT_THAT(refused("study.toml"), HasSubstr("it holds this study")) << file;
        fs::remove(file);
    }
    write_file("out/results.csv", "run,exit_code,error\n0001_0123abcd,4,no memory\n");
    EXPECT_THAT(refused("other.toml"), HasSubstr("it holds another study"));
}

TEST_F(SweepFolders, RefusesFilesOfOthers) {
    make_folder("out");
    write_file("out/thesis.txt", "x");
    EXPECT_THAT(refused("study.toml"), HasSubstr("out: the output folder holds files that are not dmp's"));
    EXPECT_FALSE(fs::exists("out/dmp.lock"));
}

TEST_F(SweepFolders, OverwritingRemovesItsOwnFilesOnly) {
    make("other.toml");
    put_finished_run("0001_0123abcd");
    write_file("out/results.csv", "run\n");
    write_file("out/notes.txt", "x");
    make("study.toml", false, true);
    EXPECT_FALSE(fs::exists("out/results.csv") || fs::exists("out/runs/0001_0123abcd.log") ||
                 fs::exists("out/runs/0001_0123abcd/summary.json"));
    EXPECT_TRUE(fs::exists("out/notes.txt") && fs::exists("out/runs/0001_0123abcd/mine.txt"));
    EXPECT_EQ(read_file("out/study.toml"), good_study);
}

TEST_F(SweepFolders, OverwritingLeavesLinksAndOtherNamesAlone) {
    make("other.toml");
    make_folder("elsewhere");
    for (const std::string file : {"elsewhere/summary.json", "out/runs/mine.log", "out/runs/0001_0123abcd.log"})
        write_file(file, "x");
    fs::create_directory_symlink(fs::absolute("elsewhere"), "out/runs/0002_0123abcd");
    make_folder("out/runs/archive");
    write_file("out/runs/archive/summary.json", "x");
    make("study.toml", false, true);
    EXPECT_TRUE(fs::exists("elsewhere/summary.json") && fs::exists("out/runs/mine.log") &&
                fs::exists("out/runs/archive/summary.json"));
    EXPECT_FALSE(fs::exists("out/runs/0001_0123abcd.log"));
    fs::rename("out/runs", "runs_of_before");
    fs::create_directory_symlink(fs::absolute("runs_of_before"), "out/runs");
    EXPECT_THAT(text_thrown<InputError>([] { make("study.toml", false, true); }),
                HasSubstr("out/runs: it is a link: the runs of the earlier study are elsewhere"));
}

TEST_F(SweepFolders, OverwritingRefusesARunThatIsWritten) {
    make("other.toml");
    put_finished_run("0001_0123abcd");
    const auto held = FolderLock::take("out/runs/0001_0123abcd");
    EXPECT_THAT(text_thrown<InputError>([] { make("study.toml", false, true); }),
                HasSubstr("out/runs/0001_0123abcd: another dmp is writing here: process "));
    EXPECT_TRUE(fs::exists("out/runs/0001_0123abcd/summary.json"));
}

TEST_F(SweepFolders, GoesOnWithTheSameFilesOnly) {
    const std::string geometry = *read_study("study.toml").scene.geometry.file;
    make("study.toml");
    write_file(geometry, "one");
    make("study.toml", true);  // what could not be read has made no runs
    make("study.toml", true);
    write_file(geometry, "two");
    EXPECT_THAT(refused("study.toml", true), HasSubstr("out: its runs were made with other contents of '" + geometry +
                                                       "'\n  To go on with it, put back what was in there."));
    write_file(geometry, "one");
    make("study.toml", true);
}

TEST_F(SweepFolders, SaysWhichVersionWroteAnotherStudy) {
    make("study.toml");
    write_file("out/sweep.toml", "study = \"study\"\nidentity = \"0\"\nversion = \"0.0.1\"\n");
    EXPECT_THAT(refused("study.toml", true), HasSubstr("It was written by dmp 0.0.1, and this is dmp "));
}

TEST_F(SweepFolders, WhatDoesNotActOnRunsMayChange) {
    make("study.toml");
    std::string scene = good_scene;
    Folder::write(scene.replace(scene.find("\"Test\""), 6, "\"another\""));
    ASSERT_EQ(*read_study("study.toml").scene.title, "another");
    make("study.toml", true);
}

TEST_F(SweepFolders, LeavesNothingWhereItCannotBeLocked) {
    rlimit before{};
    getrlimit(RLIMIT_FSIZE, &before);
    auto* const handler = std::signal(SIGXFSZ, SIG_IGN);
    const rlimit nothing{0, before.rlim_max};  // no lock can be written
    setrlimit(RLIMIT_FSIZE, &nothing);
    EXPECT_THROW(LockedFolder("new/folder", ""), ResourceError);
    setrlimit(RLIMIT_FSIZE, &before);
    std::signal(SIGXFSZ, handler);
    EXPECT_FALSE(fs::exists("new"));
}

TEST_F(SweepFolders, ARunCannotGetOutOfTheFolder) {
    const Study study = read_study("study.toml");
    for (std::size_t index = 0; index < 6; ++index)
        EXPECT_EQ(run_folder("out", Points(study).at(index).name).lexically_normal().parent_path(), "out/runs");
}

}  // namespace
}  // namespace dmp::tests::sweep_folder_tests
