// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <fstream>
#include <optional>

#include <gmock/gmock.h>

#include "base/safe_file.hpp"
#include "cli/results_folder.hpp"
#include "tests/modules.hpp"
#include "tests/unit/temporary_files.hpp"
#include "tests/unit/thrown.hpp"

namespace dmp::tests::cli_results_folder_tests {
namespace {

namespace fs = std::filesystem;
using namespace cli;
using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using enum FolderContents::Kind;

const std::string scene = "title = \"a\"\n\n[particles]\nspacing = \"1 mm\"\n";
const std::string other_scene = "title = \"a\"\n\n[particles]\nspacing = \"2 mm\"\n";
const TypedCommand typed({"dmp", "run", "x"});

class Results : public testing::Test {
  protected:
    void put(const std::string& name, const std::string& text = "text") const {
        fs::create_directories((out() / name).parent_path());
        std::ofstream(out() / name) << text;
    }
    /// A run that got to `until` = 1 s.
    void put_run(bool finished) const {
        for (const char* name : {"fluid.pvd", "frames/fluid_000000.vtp", "checkpoints/step_000000001.h5"}) put(name);
        put("scene.resolved.toml", scene);
        put("summary.json", finished ? R"({"interrupted": false, "simulated_s": 1.0})"
                                     : R"({"interrupted": true, "simulated_s": 0.5})");
    }
    [[nodiscard]] fs::path out() const { return folder_.path() / "a/out"; }
    [[nodiscard]] std::string refused(const NewRun& run) const {
        return text_thrown<InputError>([&] { ResultsFolder(out(), run, typed); });
    }
    [[nodiscard]] std::string beside() const { return "\n  dmp run x --out " + out().string() + "_2"; }

    TemporaryFolder folder_;
};

TEST_F(Results, FolderIsMadeAndLockedAndGoesWhenItStaysEmpty) {
    {
        const ResultsFolder results(out(), {scene, 1}, typed);
        EXPECT_THAT(files_in(out()), testing::ElementsAre(lock_file_name));
        EXPECT_EQ(results.note(), "");
    }
    EXPECT_THAT(files_in(folder_.path()), IsEmpty());
    {
        const ResultsFolder results(out(), {scene, 1}, typed);
        put("fluid.pvd");
    }
    EXPECT_THAT(files_in(out()), testing::ElementsAre("fluid.pvd"));
}

TEST_F(Results, FolderThatWasThereStays) {
    fs::create_directories(out());
    { const ResultsFolder results(out(), {scene, 1}, typed); }
    EXPECT_TRUE(fs::exists(out()));
}

TEST_F(Results, OfAnUnfinishedRunAreKeptAndBothWaysOffered) {
    put_run(false);
    const auto before = files_in(out());
    EXPECT_THAT(refused({scene, 1}), AllOf(HasSubstr(out().string() + ": it holds this run, unfinished"),
                                           HasSubstr("\n  dmp run x --resume"), HasSubstr("\n  dmp run x --overwrite"),
                                           HasSubstr(beside())));
    EXPECT_EQ(files_in(out()), before);
}

TEST_F(Results, OfAnUnfinishedRunOfOtherValuesCannotBeResumed) {
    put_run(false);
    EXPECT_THAT(refused({other_scene, 1}),
                AllOf(HasSubstr("unfinished run of another scene or other values:\n  particles.spacing: was \"1 mm\", "
                                "is \"2 mm\""),
                      HasSubstr("dmp run x --overwrite"), HasSubstr(beside()), Not(HasSubstr("--resume"))));
}

TEST_F(Results, OfARunWithoutACheckpointCannotBeResumed) {
    put_run(false);
    fs::remove_all(out() / "checkpoints");
    EXPECT_THAT(refused({scene, 1}),
                AllOf(HasSubstr("no checkpoint"), HasSubstr("dmp run x --overwrite"), Not(HasSubstr("--resume"))));
}

TEST_F(Results, OfAFinishedRunAreKept) {
    put_run(true);
    EXPECT_THAT(refused({scene, 1}),
                AllOf(HasSubstr("it holds this run already, finished at t = 1 s"), HasSubstr("dmp run x --overwrite"),
                      HasSubstr(beside()), Not(HasSubstr("--resume"))));
    EXPECT_THAT(refused({scene, 2}), AllOf(HasSubstr("finished at t = 1 s; this one would end at 2 s"),
                                           HasSubstr("To go on with it:\n  dmp run x --resume\n")));
    EXPECT_THAT(refused({scene + "\n[output]\nevery = \"1 s\"\n", 2}),
                AllOf(HasSubstr("may change as it goes on:\n  output.every: was not set, is \"1 s\""),
                      HasSubstr("dmp run x --resume")));
    for (const double until : {1.0, 0.5})
        EXPECT_THAT(refused({.scene = scene, .until = until, .resume = true}),
                    AllOf(HasSubstr("it holds a run that is finished at t = 1 s, and is asked to end at "),
                          HasSubstr("later --until"), HasSubstr("'dmp report ")));
    EXPECT_THAT(refused({other_scene, 1}),
                AllOf(HasSubstr("finished run of another scene or other values:\n  particles.spacing: was"),
                      HasSubstr("dmp run x --overwrite"), HasSubstr(beside())));
}

TEST_F(Results, AreNotRemovedByTakingTheFolder) {
    put_run(true);
    const auto before = files_in(out());
    { const ResultsFolder results(out(), {.scene = other_scene, .until = 1, .overwrite = true}, typed); }
    { const ResultsFolder results(out(), {.scene = scene, .until = 2, .resume = true}, typed); }
    EXPECT_EQ(files_in(out()), before);
}

TEST_F(Results, OfAMeshAreReplacedByAMeshOnly) {
    for (const char* name : {"mesh_report.json", "fluid.pvd", "scene.resolved.toml"}) put(name);
    EXPECT_THAT(refused({scene, 1}), HasSubstr("particles that 'dmp mesh' made"));
    { const ResultsFolder results(out(), typed); }
    put_run(true);
    EXPECT_THAT(text_thrown<InputError>([&] { ResultsFolder(out(), typed); }),
                AllOf(HasSubstr("it holds the results of a run"), HasSubstr(beside())));
}

TEST_F(Results, AmongFilesOfOthersAreRefusedEvenIfTheyMayBeOverwritten) {
    put("thesis.tex");
    EXPECT_THAT(refused({.scene = scene, .until = 1, .overwrite = true}), HasSubstr("holds files that are not dmp's"));
    EXPECT_THAT(files_in(out()), testing::ElementsAre("thesis.tex"));
}

TEST_F(Results, ThatAnotherWritesAreRefusedWithWhoItIs) {
    put_run(false);
    const ResultsFolder first(out(), {.scene = scene, .until = 1, .resume = true}, typed);
    for (const bool overwrite : {false, true})
        EXPECT_THAT(refused({.scene = scene, .until = 1, .overwrite = overwrite}),
                    AllOf(HasSubstr("another dmp is writing here: process " + std::to_string(getpid()) + " on "),
                          HasSubstr(", since "), HasSubstr(beside()), Not(HasSubstr("sign of life"))));
    EXPECT_THAT(text_thrown<InputError>([&] { ResultsFolder(out(), typed); }), HasSubstr("another dmp is writing"));
}

TEST_F(Results, ThatAnotherMachineWritesAreRefusedWithItsSignOfLife) {
    put(lock_file_name, "host = node17\nmachine = m\npid = 12\nstarted = 3\nsince = some time\ntoken = ab\n");
    EXPECT_THAT(refused({scene, 1}),
                AllOf(HasSubstr("process 12 on node17, since some time"), HasSubstr("Its last sign of life came "),
                      HasSubstr("; after 5 min without one")));
    fs::last_write_time(out() / lock_file_name, fs::file_time_type::clock::now() - std::chrono::minutes(6));
    const ResultsFolder results(out(), {scene, 1}, typed);
    EXPECT_THAT(results.note(), HasSubstr("process 12 on node17, since some time"));
}

TEST_F(Results, BelowAFileAreAnInputError) {
    std::ofstream(folder_.path() / "a") << "a file";
    EXPECT_THAT(refused({scene, 1}), HasSubstr("is a file"));
    EXPECT_THAT(text_thrown<InputError>([&] { ResultsFolder(folder_.path() / "a", typed); }), HasSubstr("is a file"));
}

}  // namespace
}  // namespace dmp::tests::cli_results_folder_tests
