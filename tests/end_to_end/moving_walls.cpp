// Copyright the dmp developers. SPDX-License-Identifier: GPL-3.0-or-later
// Walls that move are in every frame, those at rest once: as ParaView's files, through HDF5, and of a run that goes on.
#include <filesystem>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "tests/end_to_end/program.hpp"

namespace dmp::tests::moving_walls_tests {

namespace {

using testing::HasSubstr;
using Words = std::vector<std::string>;

/// Couette flow whose lid rocks; frames at 0, 10, ... 50 ms.
class RockingLid : public testing::Test {
  protected:
    RockingLid() { folder_.copy_case("verification/couette"); }

    [[nodiscard]] Outcome run(const std::string& out, const Words& more = {}, const Surroundings& with = {}) const {
        Words words{"run",       ".",
                    "--threads", "1",
                    "--out",     out,
                    "--set",     "flow.largest_speed=\"1 mm/s\"",
                    "--set",     "part.lid.velocity=[\"5e-4 m/s * sin(t / 20 ms)\", 0]",
                    "--set",     "run.duration=\"0.05 s\"",
                    "--set",     "output.every=\"10 ms\"",
                    "--set",     "output.pictures=false"};
        words.insert(words.end(), more.begin(), more.end());
        return run_dmp(folder_.path(), words, with);
    }
    [[nodiscard]] std::string hash(const std::string& out) const {
        return nlohmann::json::parse(folder_.read(out + "/summary.json"))["state_hash"];
    }
    void expect_same_paraview_files(const std::string& out, const std::string& expected) const {
        Words names{"fluid.pvd", "moving_walls.pvd", "walls.vtp"};
        for (int frame = 0; frame < 6; ++frame)
            names.push_back("frames/moving_walls_00000" + std::to_string(frame) + ".vtp");
        for (const std::string& name : names)
            EXPECT_EQ(folder_.read(out + "/" + name), folder_.read(expected + "/" + name)) << name;
    }

    CaseFolder folder_;
};

TEST_F(RockingLid, IsInEveryFrameThroughHdf5Too) {
    const auto outcome = run("vtk");
    ASSERT_EQ(outcome.code, 0) << outcome.errors;
    EXPECT_THAT(outcome.output, HasSubstr("moving_walls.pvd"));
    EXPECT_NE(folder_.read("vtk/frames/moving_walls_000000.vtp"), folder_.read("vtk/frames/moving_walls_000005.vtp"));
    ASSERT_EQ(run("out", {"--frames", "hdf5"}, {.ranks = 2}).code, 0);
    EXPECT_EQ(hash("out"), hash("vtk"));
    ASSERT_EQ(run_dmp(folder_.path(), {"convert", "out"}).code, 0);
    expect_same_paraview_files("out", "vtk");
}

TEST_F(RockingLid, GoesOnWhereItWasStopped) {
    ASSERT_EQ(run("whole").code, 0);
    ASSERT_EQ(run("parts", {}, {.interrupt_at = "parts/frames/moving_walls_000002.vtp", .signal = SIGTERM}).code, 143);
    const auto resumed = run("parts", {"--resume"});
    ASSERT_EQ(resumed.code, 0) << resumed.errors;
    EXPECT_EQ(hash("parts"), hash("whole"));
    expect_same_paraview_files("parts", "whole");
}

}  // namespace

}  // namespace dmp::tests::moving_walls_tests
