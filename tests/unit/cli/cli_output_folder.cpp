// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
#include <fstream>

#include <gmock/gmock.h>

#include "base/errors.hpp"
#include "base/safe_file.hpp"
#include "cli/output_folder.hpp"
#include "tests/modules.hpp"

namespace dmp::tests::cli_output_folder_tests {

namespace {

namespace fs = std::filesystem;
using namespace cli;

class OutputFolder : public testing::Test {
  protected:
    void SetUp() override {
        std::string name = (fs::temp_directory_path() / "dmp_output_XXXXXX").string();
        folder_ = mkdtemp(name.data());
    }
    void TearDown() override { fs::remove_all(folder_); }

    void put(const std::string& name) const {
        fs::create_directories((folder_ / name).parent_path());
        std::ofstream(folder_ / name) << "text";
    }
    [[nodiscard]] bool has(const std::string& name) const { return fs::exists(folder_ / name); }

    fs::path folder_;
};

TEST_F(OutputFolder, DefaultsToOutAndTheName) {
    EXPECT_EQ(output_folder("", "valve"), fs::path("out/valve"));
    EXPECT_EQ(output_folder("there", "valve"), fs::path("there"));
}

TEST_F(OutputFolder, IsMadeWithThoseAboveIt) {
    EXPECT_EQ(prepare_folder(folder_ / "a/b"), "");
    EXPECT_TRUE(fs::is_directory(folder_ / "a/b"));
}

TEST_F(OutputFolder, WithFilesOfOthersIsRefusedAndLeftAlone) {
    put("thesis.tex");
    try {
        prepare_folder(folder_);
        FAIL() << "a folder with other people's files was taken";
    } catch (const InputError& error) {
        EXPECT_EQ(error.where().file, folder_.string());
        EXPECT_THAT(error.what_to_do(), testing::HasSubstr("--out"));
    }
    EXPECT_TRUE(has("thesis.tex"));
}

TEST_F(OutputFolder, OfARunKilledBeforeItsFirstFileIsTakenAgain) {
    fs::create_directories(folder_ / "frames");
    EXPECT_EQ(prepare_folder(folder_), "");
    put(unfinished_name("scene.resolved.toml"));
    EXPECT_THAT(prepare_folder(folder_), testing::HasSubstr("Removed 1 file of an earlier run"));
    EXPECT_TRUE(fs::is_empty(folder_));
    put("frames/thesis.tex");
    EXPECT_THROW(prepare_folder(folder_), InputError) << "somebody else's frames";
}

TEST_F(OutputFolder, OfAnEarlierRunLosesThatRunsFilesOnly) {
    for (const char* name : {"fluid.pvd", "summary.json", "measures.csv", "cycle.png", "frames/fluid_000001.vtp",
                             "frames/solid_000001.vtp", "notes.txt", "my_plot.png", "frames/other.vtp"}) {
        put(name);
    }
    EXPECT_THAT(prepare_folder(folder_), testing::HasSubstr("Removed 6 files of an earlier run"));
    for (const char* name : {"fluid.pvd", "summary.json", "measures.csv", "cycle.png", "frames/fluid_000001.vtp",
                             "frames/solid_000001.vtp"}) {
        EXPECT_FALSE(has(name)) << name;
    }
    for (const char* name : {"notes.txt", "my_plot.png", "frames/other.vtp"}) EXPECT_TRUE(has(name)) << name;
}

TEST_F(OutputFolder, OfAnEarlierRunLosesItsHdf5Frames) {
    for (const char* name : {"frames.json", "frames/frame_000000.h5", "frames/frame_000001.h5", "frames/mine.h5"})
        put(name);
    EXPECT_THAT(prepare_folder(folder_), testing::HasSubstr("Removed 3 files of an earlier run"));
    for (const char* name : {"frames.json", "frames/frame_000000.h5", "frames/frame_000001.h5"})
        EXPECT_FALSE(has(name)) << name;
    EXPECT_TRUE(has("frames/mine.h5"));
}

TEST_F(OutputFolder, OfAnEarlierRunLosesItsCheckpoints) {
    for (const char* name : {"fluid.pvd", "checkpoints/step_000000123.h5", "checkpoints/step_000000456.h5"}) put(name);
    put(unfinished_name("checkpoints/step_000000789.h5"));
    EXPECT_THAT(prepare_folder(folder_), testing::HasSubstr("Removed 4 files of an earlier run"));
    EXPECT_FALSE(has("checkpoints"));
}

TEST_F(OutputFolder, KeepsWhatElseIsBesideTheCheckpoints) {
    for (const char* name : {"fluid.pvd", "checkpoints/step_000000123.h5", "checkpoints/step_copy.h5"}) put(name);
    prepare_folder(folder_);
    EXPECT_FALSE(has("checkpoints/step_000000123.h5"));
    EXPECT_TRUE(has("checkpoints/step_copy.h5"));
}

TEST_F(OutputFolder, OfAKilledRunLosesWhatItLeftUnfinished) {
    put("fluid.pvd");
    put(unfinished_name("frames/fluid_000001.vtp"));
    put(unfinished_name("measures.csv"));
    EXPECT_THAT(prepare_folder(folder_), testing::HasSubstr("Removed 3 files of an earlier run"));
    EXPECT_TRUE(fs::is_empty(folder_));
}

TEST_F(OutputFolder, OfAnEarlierRunLosesItsEmptyFramesFolder) {
    put("fluid.pvd");
    put("frames/fluid_000001.vtp");
    prepare_folder(folder_);
    EXPECT_FALSE(has("frames"));
}

TEST_F(OutputFolder, BelowAFileIsAnInputError) {
    put("file");
    EXPECT_THROW(prepare_folder(folder_ / "file/below"), InputError);
    EXPECT_THROW(prepare_folder(folder_ / "file"), InputError);
}

}  // namespace

}  // namespace dmp::tests::cli_output_folder_tests
