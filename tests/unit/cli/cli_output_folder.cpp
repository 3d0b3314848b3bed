// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <fstream>

#include <gmock/gmock.h>

#include "base/folder_lock.hpp"
#include "base/safe_file.hpp"
#include "cli/output_folder.hpp"
#include "tests/modules.hpp"

namespace dmp::tests::cli_output_folder_tests {

namespace {

namespace fs = std::filesystem;
using namespace cli;
using enum FolderContents::Kind;

class OutputFolder : public testing::Test {
  protected:
    void SetUp() override {
        std::string name = (fs::temp_directory_path() / "dmp_output_XXXXXX").string();
        folder_ = mkdtemp(name.data());
    }
    void TearDown() override { fs::remove_all(folder_); }

    void put(const std::string& name, const std::string& text = "text") const {
        fs::create_directories((folder_ / name).parent_path());
        std::ofstream(folder_ / name) << text;
    }
    [[nodiscard]] FolderContents::Kind kind() const { return contents_of(folder_).kind; }
    [[nodiscard]] bool has(const std::string& name) const { return fs::exists(folder_ / name); }

    fs::path folder_;
};

TEST_F(OutputFolder, DefaultsToOutAndTheName) {
    EXPECT_EQ(output_folder("", "valve"), fs::path("out/valve"));
    EXPECT_EQ(output_folder("there", "valve"), fs::path("there"));
}

TEST_F(OutputFolder, HoldsNothingWhereARunWasKilledBeforeItsFirstFrame) {
    EXPECT_EQ(kind(), nothing);
    fs::create_directories(folder_ / "frames");
    fs::create_directories(folder_ / "checkpoints");
    put(lock_file_name);
    EXPECT_EQ(kind(), nothing);
    put(unfinished_name("scene.resolved.toml"));
    EXPECT_EQ(kind(), nothing);
    put("scene.resolved.toml");
    EXPECT_EQ(kind(), nothing);
    put("frames/fluid_000000.vtp");
    put("walls.vtp");
    EXPECT_EQ(kind(), unfinished);
    EXPECT_EQ(contents_of(folder_ / "none").kind, nothing);
}

TEST_F(OutputFolder, WithFilesOfOthersOnlyIsForeign) {
    put("thesis.tex");
    EXPECT_EQ(kind(), foreign);
    fs::remove(folder_ / "thesis.tex");
    put("frames/thesis.tex");
    EXPECT_EQ(kind(), foreign) << "somebody else's frames";
    put("fluid.pvd");
    EXPECT_EQ(kind(), unfinished);
}

TEST_F(OutputFolder, HoldsAFinishedRunWhereItsSummarySaysSo) {
    put("fluid.pvd");
    put("scene.resolved.toml", "title = \"a\"\n");
    EXPECT_EQ(kind(), unfinished);
    put("summary.json", R"({"interrupted": true, "simulated_s": 0.25})");
    EXPECT_EQ(kind(), unfinished);
    EXPECT_FALSE(contents_of(folder_).has_checkpoint);
    put("checkpoints/step_000000007.h5");
    EXPECT_TRUE(contents_of(folder_).has_checkpoint);
    put("summary.json", R"({"interrupted": false, "simulated_s": 0.5})");
    const FolderContents contents = contents_of(folder_);
    EXPECT_EQ(contents.kind, finished);
    EXPECT_EQ(contents.simulated_s, 0.5);
    EXPECT_EQ(contents.scene, "title = \"a\"\n");
    put("summary.json", "{");
    EXPECT_EQ(kind(), unfinished);
}

TEST_F(OutputFolder, OfSpheresOrInHdf5IsARunToo) {
    put("spheres.pvd");
    EXPECT_EQ(kind(), unfinished);
    fs::remove(folder_ / "spheres.pvd");
    put("frames.json");
    EXPECT_EQ(kind(), unfinished);
}

TEST_F(OutputFolder, HoldsAMeshWhereThereIsAReportAndNoRun) {
    for (const char* name : {"mesh_report.json", "scene.resolved.toml", "fluid.pvd"}) put(name);
    EXPECT_EQ(kind(), mesh);
    put("checkpoints/step_000000007.h5");
    EXPECT_EQ(kind(), unfinished);
}

TEST_F(OutputFolder, OfAnEarlierRunLosesThatRunsFilesOnly) {
    for (const char* name : {"fluid.pvd", "summary.json", "measures.csv", "cycle.png", "frames/fluid_000001.vtp",
                             "frames/solid_000001.vtp", "notes.txt", "my_plot.png", "frames/other.vtp"}) {
        put(name);
    }
    EXPECT_THAT(remove_results(folder_), testing::HasSubstr("Removed 6 files of an earlier run"));
    for (const char* name : {"fluid.pvd", "summary.json", "measures.csv", "cycle.png", "frames/fluid_000001.vtp",
                             "frames/solid_000001.vtp"}) {
        EXPECT_FALSE(has(name)) << name;
    }
    for (const char* name : {"notes.txt", "my_plot.png", "frames/other.vtp"}) EXPECT_TRUE(has(name)) << name;
}

TEST_F(OutputFolder, OfAnEarlierRunLosesItsHdf5Frames) {
    for (const char* name : {"frames.json", "frames/frame_000000.h5", "frames/frame_000001.h5", "frames/mine.h5"})
        put(name);
    EXPECT_THAT(remove_results(folder_), testing::HasSubstr("Removed 3 files of an earlier run"));
    for (const char* name : {"frames.json", "frames/frame_000000.h5", "frames/frame_000001.h5"})
        EXPECT_FALSE(has(name)) << name;
    EXPECT_TRUE(has("frames/mine.h5"));
}

TEST_F(OutputFolder, OfAnEarlierRunLosesItsCheckpoints) {
    for (const char* name : {"fluid.pvd", "checkpoints/step_000000123.h5", "checkpoints/step_000000456.h5"}) put(name);
    put(unfinished_name("checkpoints/step_000000789.h5"));
    EXPECT_THAT(remove_results(folder_), testing::HasSubstr("Removed 4 files of an earlier run"));
    EXPECT_FALSE(has("checkpoints"));
}

TEST_F(OutputFolder, KeepsWhatElseIsBesideTheCheckpoints) {
    for (const char* name : {"fluid.pvd", "checkpoints/step_000000123.h5", "checkpoints/step_copy.h5"}) put(name);
    remove_results(folder_);
    EXPECT_FALSE(has("checkpoints/step_000000123.h5"));
    EXPECT_TRUE(has("checkpoints/step_copy.h5"));
}

TEST_F(OutputFolder, OfAKilledRunLosesWhatItLeftUnfinished) {
    put("fluid.pvd");
    put(unfinished_name("frames/fluid_000001.vtp"));
    put(unfinished_name("measures.csv"));
    EXPECT_THAT(remove_results(folder_), testing::HasSubstr("Removed 3 files of an earlier run"));
    EXPECT_TRUE(fs::is_empty(folder_ / "frames"));
    EXPECT_FALSE(has("fluid.pvd") || has(unfinished_name("measures.csv")));
}

TEST_F(OutputFolder, OfSpheresLosesThatRunsFiles) {
    for (const char* name :
         {"spheres.pvd", "moving_walls.pvd", "frames/spheres_000001.vtp", "frames/moving_walls_000001.vtp"})
        put(name);
    EXPECT_THAT(remove_results(folder_), testing::HasSubstr("Removed 4 files of an earlier run"));
    EXPECT_EQ(remove_results(folder_), "");
}

TEST_F(OutputFolder, KeepsItsLock) {
    put("fluid.pvd");
    put(lock_file_name);
    remove_results(folder_);
    EXPECT_TRUE(has(lock_file_name));
}

}  // namespace

}  // namespace dmp::tests::cli_output_folder_tests
