// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Runs that write their frames in HDF5, and ParaView's files made of them.
#include <filesystem>

#include <gmock/gmock.h>

#include "tests/end_to_end/small_valve.hpp"

namespace {

using namespace dmp::end_to_end;
using testing::AllOf;
using testing::Contains;
using testing::Each;
using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;

class FramesInHdf5 : public SmallValve {
  protected:
    void convert(const std::string& out) const {
        const auto converted = run_dmp(folder_.path(), {"convert", out});
        ASSERT_EQ(converted.code, 0) << converted.errors;
        EXPECT_THAT(converted.output, Not(HasSubstr("warning")));
    }
    /// ParaView's files of a run and those of another, which has no others beside them.
    void expect_same_paraview_files(const std::string& out, const std::string& expected) const {
        Words found;
        for (const auto& name : files(out + "/frames"))
            if (name.ends_with(".vtp")) found.push_back(name);
        EXPECT_EQ(found, files(expected + "/frames"));
        for (const auto& name : files(expected + "/frames"))
            EXPECT_EQ(folder_.read(out + "/frames/" + name), folder_.read(expected + "/frames/" + name)) << name;
        for (const std::string name : {"fluid.pvd", "solid.pvd", "walls.vtp"})
            EXPECT_EQ(folder_.read(out + "/" + name), folder_.read(expected + "/" + name)) << name;
    }
};

TEST_F(FramesInHdf5, AreConvertedToWhatTheRunWouldHaveWritten) {
    ASSERT_EQ(run("vtk").code, 0);
    const auto outcome = run("out", {"--frames", "hdf5"});
    ASSERT_EQ(outcome.code, 0) << outcome.errors;
    EXPECT_EQ(hash("out"), hash("vtk"));
    EXPECT_THAT(files("out/frames"), Each(EndsWith(".h5")));
    EXPECT_THAT(files("out"), AllOf(Contains("frames.json"), Contains("measures.csv"), Contains("summary.json"),
                                    Contains("scene.resolved.toml"), Not(Contains("fluid.pvd"))));
    EXPECT_THAT(summary("out")["files"], Contains("frames.json"));
    convert("out");
    expect_same_paraview_files("out", "vtk");
}

TEST_F(FramesInHdf5, OfAStoppedRunGoOn) {
    ASSERT_EQ(run("vtk").code, 0);
    ASSERT_EQ(stopped_run("out", {"--frames", "hdf5"}, 0, SIGTERM, "frame_000005.h5").code, 143);
    const auto resumed = run("out", {"--frames", "hdf5", "--resume"});
    ASSERT_EQ(resumed.code, 0) << resumed.errors;
    EXPECT_EQ(hash("out"), hash("vtk"));
    convert("out");
    expect_same_paraview_files("out", "vtk");
}

TEST_F(FramesInHdf5, DoNotGoOnInTheOtherFormat) {
    ASSERT_EQ(stopped_run("out", {"--frames", "hdf5"}, 0, SIGTERM, "frame_000005.h5").code, 143);
    const auto before = files("out/frames");
    const auto refused = run("out", {"--resume"});
    EXPECT_EQ(refused.code, 2);
    EXPECT_THAT(refused.errors, HasSubstr("--frames"));
    EXPECT_EQ(files("out/frames"), before);

    ASSERT_EQ(stopped_run("vtk").code, 143);
    EXPECT_EQ(run("vtk", {"--resume", "--frames", "hdf5"}).code, 2);
}

}  // namespace
