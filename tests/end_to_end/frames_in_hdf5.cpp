// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Runs that write their frames in HDF5, and ParaView's files made of them.
#include <filesystem>

#include <gmock/gmock.h>

#include "tests/end_to_end/small_valve.hpp"

namespace dmp::tests::frames_in_hdf5_tests {

namespace {

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

TEST_F(FramesInHdf5, OfSeveralRanksAreConvertedToTheSame) {
    Words briefly = all_fields();
    briefly.insert(briefly.end(), {"--until", "0.03 s"});
    Words hdf5 = briefly;
    hdf5.insert(hdf5.end(), {"--frames", "hdf5", "--overwrite"});
    ASSERT_EQ(run("vtk", briefly).code, 0);
    for (const int ranks : {1, 2, 3}) {
        const auto outcome = run("out", hdf5, {.ranks = ranks});
        ASSERT_EQ(outcome.code, 0) << outcome.errors;
        EXPECT_THAT(files("out/frames"), Contains(ranks == 1 ? "frame_000003.h5" : "frame_000003"));
        EXPECT_EQ(files("out/frames/frame_000003").size(), ranks == 1 ? 0U : static_cast<std::size_t>(ranks));
        convert("out");
        expect_same_paraview_files("out", "vtk");
    }
}

TEST_F(FramesInHdf5, GoOnWithAnotherNumberOfRanks) {
    ASSERT_EQ(run("vtk", {"--until", "0.15 s"}).code, 0);
    const auto part = [&](const std::string& until, const Words& more, int ranks) {
        Words words{"--until", until, "--frames", "hdf5"};
        words.insert(words.end(), more.begin(), more.end());
        return run("out", words, {.ranks = ranks}).code;
    };
    ASSERT_EQ(part("0.05 s", {}, 2), 0);
    ASSERT_EQ(part("0.1 s", {"--resume"}, 3), 0);
    ASSERT_EQ(part("0.15 s", {"--resume"}, 1), 0);
    EXPECT_EQ(hash("out"), hash("vtk"));
    const auto index = nlohmann::json::parse(folder_.read("out/frames.json"))["frames"];
    ASSERT_EQ(index.size(), 16U);
    EXPECT_EQ(index.front()["pieces"], 2);
    EXPECT_EQ(index.back()["file"], "frames/frame_000015.h5");
    convert("out");
    expect_same_paraview_files("out", "vtk");
}

TEST_F(FramesInHdf5, OfWhichAPieceIsMissingAreLeftOut) {
    ASSERT_EQ(run("out", {"--until", "0.03 s", "--frames", "hdf5"}, {.ranks = 2}).code, 0);
    std::filesystem::remove(folder_.path() / "out/frames/frame_000002/piece_001.h5");
    const auto converted = run_dmp(folder_.path(), {"convert", "out"});
    EXPECT_EQ(converted.code, 0) << converted.errors;
    EXPECT_THAT(converted.output,
                AllOf(HasSubstr("frames that are not there are left out: 2\n"), HasSubstr("Converted 3 frames.")));
}

TEST_F(FramesInHdf5, ThatCannotBeWrittenEndAllRanksAndThoseBeforeStay) {
    folder_.write("out/summary.json", "{}");
    folder_.write("out/frames/frame_000001", "in the way of a folder");
    const auto outcome = run("out", {"--until", "0.03 s", "--frames", "hdf5", "--overwrite"}, {.ranks = 2});
    EXPECT_EQ(outcome.code, 2);
    EXPECT_THAT(outcome.errors, AllOf(HasSubstr("error: "), HasSubstr("frames/frame_000001")));
    EXPECT_EQ(outcome.errors.find("error: "), outcome.errors.rfind("error: ")) << outcome.errors;
    EXPECT_EQ(nlohmann::json::parse(folder_.read("out/frames.json"))["frames"].size(), 1U);
    const auto converted = run_dmp(folder_.path(), {"convert", "out"});
    EXPECT_THAT(converted.output, HasSubstr("Converted 1 frame."));
}

TEST_F(FramesInHdf5, OfAnEarlierRunDoNotMixWithTheNew) {
    ASSERT_EQ(run("out", {"--until", "0.03 s", "--frames", "hdf5"}, {.ranks = 2}).code, 0);
    ASSERT_EQ(run("out", {"--until", "0.02 s", "--frames", "hdf5", "--overwrite"}).code, 0);
    EXPECT_THAT(files("out/frames"), testing::ElementsAre("frame_000000.h5", "frame_000001.h5", "frame_000002.h5"));
    ASSERT_EQ(run("out", {"--until", "0.02 s", "--overwrite"}, {.ranks = 2}).code, 0);
    EXPECT_THAT(files("out"), AllOf(Not(Contains("frames.json")), Contains("fluid.pvd")));
    EXPECT_THAT(files("out/frames"), Each(EndsWith(".vtp")));
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

}  // namespace dmp::tests::frames_in_hdf5_tests
