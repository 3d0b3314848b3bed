// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// `dmp convert`: the files that ParaView opens, from frames in HDF5.
#include <algorithm>
#include <map>

#include <gmock/gmock.h>

#include "postproc/vtk_sink.hpp"
#include "solver/output/frame_file.hpp"
#include "solver/output/hdf5_sink.hpp"
#include "tests/end_to_end/program.hpp"
#include "tests/modules.hpp"
#include "tests/unit/postproc/synthetic_run.hpp"

namespace dmp::tests::convert_tests {

namespace {

using testing::HasSubstr;

namespace fs = std::filesystem;

const RunLabel label{"Channel with a flap", "0123456789abcdef", "0.2.0"};

class Convert : public testing::Test {
  protected:
    /// Three frames, as a run hands them over.
    static void write_run(FrameSink&& sink) {
        for (int n = 0; n < 3; ++n) sink.write(channel_frame(0.1 * n, n == 0));
    }
    void write_hdf5_run() const { write_run(Hdf5Sink(out(), label)); }

    [[nodiscard]] fs::path out() const { return folder_.path() / "out"; }
    [[nodiscard]] Outcome convert(const std::string& folder = "out", const Surroundings& surroundings = {}) const {
        return run_dmp(folder_.path(), {"convert", folder}, surroundings);
    }
    /// The files below a folder and what is in them, without those in HDF5 and their index.
    [[nodiscard]] std::map<std::string, std::string> contents(const std::string& folder) const {
        std::map<std::string, std::string> files;
        for (const auto& entry : fs::recursive_directory_iterator(folder_.path() / folder)) {
            const std::string name = entry.path().lexically_relative(folder_.path() / folder).string();
            if (entry.is_regular_file() && !name.ends_with(".h5") && name != frame_index_name)
                files[name] = folder_.read(folder + "/" + name);
        }
        return files;
    }

    CaseFolder folder_;
};

TEST_F(Convert, LeavesWhatARunWouldHaveWritten) {
    write_hdf5_run();
    write_run(VtkSink(folder_.path() / "vtk", label));
    const auto outcome = convert();
    ASSERT_EQ(outcome.code, 0) << outcome.errors;
    EXPECT_EQ(outcome.errors, "") << "off a terminal it is quiet";
    EXPECT_THAT(outcome.output, testing::AllOf(HasSubstr("Converted 3 frames."), HasSubstr("Results in out"),
                                               HasSubstr("paraview --script=out/open_in_paraview.py")));
    const auto converted = contents("out");
    EXPECT_THAT(converted, testing::Contains(testing::Key("frames/solid_000002.vtp")));
    EXPECT_EQ(converted, contents("vtk"));
    EXPECT_TRUE(fs::exists(frame_path(out(), 2))) << "the frames stay";
}

TEST_F(Convert, TheSecondTimeReplacesTheFirst) {
    write_hdf5_run();
    ASSERT_EQ(convert().code, 0);
    const auto first = contents("out");
    fs::remove(frame_path(out(), 2));
    ASSERT_EQ(convert().code, 0);
    EXPECT_EQ(contents("out").size(), first.size() - 2);
    EXPECT_FALSE(fs::exists(out() / "frames/fluid_000002.vtp"));
}

TEST_F(Convert, FramesThatAreMissingAreNamed) {
    write_hdf5_run();
    fs::remove(frame_path(out(), 1));
    const auto outcome = convert();
    EXPECT_EQ(outcome.code, 0) << outcome.errors;
    EXPECT_THAT(outcome.output, testing::AllOf(HasSubstr("warning: frames that are not there are left out: 1\n"),
                                               HasSubstr("Converted 2 frames.")));
}

TEST_F(Convert, ADamagedFrameEndsItWithTwoAndKeepsThoseBefore) {
    write_hdf5_run();
    const fs::path damaged = frame_path(out(), 1);
    fs::resize_file(damaged, 1000);
    const auto outcome = convert();
    EXPECT_EQ(outcome.code, 2);
    EXPECT_THAT(
        outcome.errors,
        testing::AllOf(testing::StartsWith("error: out/frames/frame_000001.h5: truncated: 1000 of "),
                       HasSubstr("move it away to convert the others"), HasSubstr("Converted before it: 1 frame.")));
    EXPECT_TRUE(fs::exists(out() / "frames/fluid_000000.vtp"));
    EXPECT_THAT(folder_.read("out/fluid.pvd"), HasSubstr("fluid_000000.vtp"));

    fs::remove(damaged);
    EXPECT_EQ(convert().code, 0);
}

TEST_F(Convert, ADamagedFirstFrameLeavesTheFolderAsItWas) {
    write_hdf5_run();
    ASSERT_EQ(convert().code, 0);
    const auto before = contents("out");
    fs::resize_file(frame_path(out(), 0), 0);
    EXPECT_EQ(convert().code, 2);
    EXPECT_EQ(contents("out"), before);
}

TEST_F(Convert, NoSuchFolderAndNoFramesInItEndWithTwo) {
    const auto nowhere = convert("nowhere");
    EXPECT_EQ(nowhere.code, 2);
    EXPECT_THAT(nowhere.errors, testing::StartsWith("error: nowhere: there is no such folder\n  "));

    write_run(VtkSink(out(), label));
    const auto before = contents("out");
    const auto without = convert();
    EXPECT_EQ(without.code, 2);
    EXPECT_THAT(without.errors, testing::AllOf(testing::StartsWith("error: out: there are no frames in it to convert"),
                                               HasSubstr("frames.json")));
    EXPECT_EQ(contents("out"), before);

    folder_.write("file", "x");
    EXPECT_EQ(convert("file").code, 2);
}

TEST_F(Convert, AFullDiskEndsWithFourAndNamesTheFile) {
    write_hdf5_run();
    const auto outcome = convert("out", {.largest_file = 9000});  // frames are larger, the script for ParaView is not
    EXPECT_EQ(outcome.code, 4);
    EXPECT_THAT(outcome.errors,
                testing::AllOf(testing::StartsWith("error: "), HasSubstr("out/frames/fluid_000000.vtp")));
}

TEST_F(Convert, HelpSaysWhatItTakes) {
    const auto outcome = run_dmp(folder_.path(), {"convert", "--help"});
    EXPECT_EQ(outcome.code, 0);
    EXPECT_THAT(outcome.output, testing::AllOf(HasSubstr("DIR"), HasSubstr("dmp convert out/vein_valve")));
    EXPECT_EQ(run_dmp(folder_.path(), {"convert"}).code, 2);
}

}  // namespace

}  // namespace dmp::tests::convert_tests
